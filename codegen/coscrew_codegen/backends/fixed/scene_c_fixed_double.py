"""Conversions of a scene in fixed point: from double to integers, and back."""

from collections.abc import Iterator

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.program.values.quantity import Argument


def from_double(made: FixedScene) -> Iterator[CFunction]:
    """A function for each argument."""
    head = f"{made.plain.name.upper()}_{made.tier.mark.upper()}"
    for name, values in made.arguments.items():
        macro, count = f"{head}_{name.upper()}", len(values)
        rows = [f"static const int bits[] = {macro}_BITS;",
                f"static const int32_t largest[] = {macro}_LARGEST;",
                f"return ksl_from_double({name}, bits, largest, {count}, result);"]
        yield CFunction(name, comment_of([
            f"Converts {name} to integers, to nearest.  Returns 1 if it is in the ranges; else 0, "
            "with the components outside moved to the nearest end, and 0 for NaN."]),
            f"int {made.plain.name}_{name}_to_{made.tier.mark}(const double {name}[{count}], "
            f"int32_t result[{count}])", "\n".join(f"  {row}" for row in rows))


def to_double(made: FixedScene, f: FixedFunction, products: Products, name: str) -> CFunction:
    """The function that converts a function's results."""
    outputs = scene_text.outputs(f.plain)
    rows = []
    for a in outputs:
        rows += ["{", f"  static const int bits[] = {name.upper()}_{a.name.upper()}_BITS;",
                 f"  ksl_to_double({a.name}, bits, {a.quantity.size}, {a.name}_in_double);", "}"]
    parameters = [*(arguments.read(a, INTEGERS) if a.quantity.shape else
                    f"const int32_t *{a.name}" for a in outputs),
                  *(arguments.written(Argument(f"{a.name}_in_double", a.quantity), DOUBLE)
                    for a in outputs)]
    return CFunction(f.plain.name, comment_of([
        "The same of results with high products." if products is Products.HIGH else
        f"Converts the results of {name} to double, exactly."]),
        arguments.head(f"{name}_to_double", parameters),
        "\n".join(f"  {row}" for row in rows))
