"""A scene in fixed point as C: arm_fixed.h; arm_fixed.c with full products and arm_fixed_high.c
with high ones; arm_fixed_double.c converts from and to double.  They need coscrew_fixed.h alone."""

import re
from collections.abc import Iterable, Iterator, Sequence

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.accuracy.scene_tiers import headings_in
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.fixed import c_integers, scene_c_fixed_runtime
from coscrew_codegen.backends.fixed import scene_c_fixed_double as in_double
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_symbols, scene_text
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.fixed.fixed_value import FixedValue
from coscrew_codegen.program.program import counts_in_words
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import Precision

MARK = {Products.FULL: "", Products.HIGH: "_high"}
"""Endings of names: full products, which are more accurate, have none."""
_DECLARED = re.compile(r"(\w+) = ")
TITLES = {Products.FULL: "products of 64 bits", Products.HIGH: "the upper 32 bits of products"}
"""Products in words."""


@uncollected()
def files(made: FixedScene, banner: str) -> Files:
    """All files.  Raises ValueError for names that C cannot use."""
    scene_text.check_names(made.plain)
    written = {x: [_function(made, f, x) for f in made.functions] for x in Products}
    fits = [_fits(made, f) for f in made.functions if f.plain.inputs]
    conversions = [*in_double.from_double(made),
                   *(in_double.to_double(made, f, x, c_name(made, f, x))
                     for f in made.functions for x in Products)]
    public = [*written[Products.FULL], *written[Products.HIGH], *fits, *conversions]
    sources = {"": (*written[Products.FULL], *fits), "_high": written[Products.HIGH],
               "_double": conversions}
    about = {mark: f"The functions of {made.stem}.h with {TITLES[x]}."
             for x, mark in MARK.items()}
    about["_double"] = f"Conversions of {made.stem}.h from double to integers, and back."
    return {f"{made.stem}.h": render(
                "scene/fixed.h", banner=banner, about=comment_of([*_about(made)]),
                guard=made.stem.upper(), formats=list(formats(made)), functions=public),
            **{f"{made.stem}{mark}.c": _source(made, about[mark], functions, banner,
                                               mark == "_double")
               for mark, functions in sources.items()}, **scene_c_fixed_runtime.files()}


def c_name(made: FixedScene, f: FixedFunction, products: Products) -> str:
    """arm_inverse_dynamics_fixed, arm_inverse_dynamics_fixed_high."""
    return f"{made.plain.name}_{f.plain.name}_{made.tier.mark}{MARK[products]}"


def _source(made: FixedScene, title: str, functions: Sequence[CFunction], banner: str,
            converts: bool) -> str:
    return render("scene/fixed.c", banner=banner, title=title, header=made.stem,
                  names=legend(x.body for x in functions), functions=functions,
                  converts=converts, fingerprint=scene_c_fixed_runtime.fingerprint())


def legend(bodies: Iterable[str]) -> list[str]:
    """The comment that explains the names in these bodies of functions, if they have any."""
    names = scene_symbols.legend(x for body in bodies for x in _DECLARED.findall(body))
    return [comment_of(names)] if names else []


def _about(made: FixedScene) -> Iterator[str]:
    """Returns the comment at the top of the header, in paragraphs."""
    plain = made.plain.name
    yield f"{plain}: dynamics of a scene in fixed point."
    yield made.tier.title
    yield " ".join(made.tier.promise.split())
    yield (f"A number x is the integer x 2^bits; {plain.upper()}_…_BITS have the bits of each "
           f"component of arguments and results, {plain.upper()}_FIXED_…_LARGEST the largest size "
           "of integers in the ranges.  Outside them results are wrong without notice: "
           f"{plain}_…_fixed_fits returns 0 there, else 1.")
    yield ("Names that end in _fixed have products of 64 bits; those that end in _fixed_high take "
           "the upper 32 bits of products, which is faster where that is one instruction "
           "(ARMv7E-M) and less accurate.  Arguments have the same bits in both.")
    yield (f"Arrays are plain, matrices row by row.  Coordinates and units are those of {plain}.h. "
           "Outputs may overlap inputs.  No heap, no state, no floating point but in "
           f"{made.stem}_double.c.")
    for name, reason in made.left_out:
        yield f"Left out: {name}: {scene_text.printable(reason)}."


def formats(made: FixedScene) -> Iterator[tuple[str, str, str]]:
    """(comment, name, value) of the macros: formats of arguments, and of the results of each
    function."""
    head = f"{made.plain.name.upper()}_{made.tier.mark.upper()}"
    for name, values in made.arguments.items():
        yield "", f"{head}_{name.upper()}_BITS", _initializer(x.bits for x in values)
        yield "", f"{head}_{name.upper()}_LARGEST", _initializer(int(x.largest) for x in values)
    for f in made.functions:
        for products, program in f.programs.items():
            start = 0
            for a in scene_text.outputs(f.plain):
                values = program.results[start:start + a.quantity.size]
                start += a.quantity.size
                yield ("", f"{c_name(made, f, products)}_{a.name}_bits".upper(),
                       _initializer(x.bits for x in values))


def _initializer(values: Iterable[int]) -> str:
    return listed("{", list(map(str, values)), "}", WIDTH - 2).replace("\n", " \\\n")


def _function(made: FixedScene, f: FixedFunction, products: Products) -> CFunction:
    fixed, outputs = f.programs[products], scene_text.outputs(f.plain)
    parameters = [*(arguments.read(a, INTEGERS) for a in f.plain.inputs),
                  *(arguments.written(a, INTEGERS) for a in outputs)]
    comment = comment_of([
        scene_text.printable(scene_text.sentence(f.plain.words)), bounds_in_words(f, fixed.results),
        f"{counts_in_words(fixed.program).capitalize()}."])
    return CFunction(f.plain.name, comment,
                     arguments.head(c_name(made, f, products), parameters),
                     body(f, products))


def body(f: FixedFunction, products: Products, integers: Precision = INTEGERS) -> str:
    """The lines of a function's body."""
    fixed = f.programs[products].program
    headings = {place: scene_text.printable(words)
                for place, words in headings_in(f.plain, fixed)}
    return c_integers.body(fixed, scene_text.access(fixed),
                           arguments.targets(scene_text.outputs(f.plain)), headings,
                           scene_text.VALUE_WIDTH, integers)


def bounds_in_words(f: FixedFunction, results: Sequence[FixedValue]) -> str:
    """The statement on the errors of a function's results."""
    start, words = 0, []
    for a in f.plain.program.outputs:
        worst = max(x.error for x in results[start:start + a.quantity.size])
        start += a.quantity.size
        words.append(f"{a.name} by at most {two_digits_up(worst)}")
    return f"Proved: rounding moves {'; '.join(words)}, for all arguments in the ranges."


def _fits(made: FixedScene, f: FixedFunction) -> CFunction:
    """The function that says whether arguments are in the ranges."""
    head = f"{made.plain.name.upper()}_{made.tier.mark.upper()}"
    inputs = f.plain.inputs
    tables = [f"static const int32_t most_{a.name}[] = {head}_{a.name.upper()}_LARGEST;"
              for a in inputs]
    tests = [f"ksl_fits({'' if a.quantity.shape else '&'}{a.name}, most_{a.name}, "
             f"{a.quantity.size})" for a in inputs]
    rows = [*tables, f"return {' && '.join(tests)};"]
    return CFunction(f.plain.name, comment_of(["Returns 1 if these arguments are in the ranges, "
                                               "else 0."]),
                     "int " + arguments.head(
                         f"{c_name(made, f, Products.FULL)}_fits",
                         [arguments.read(a, INTEGERS) for a in inputs]).removeprefix("void "),
                     "\n".join(f"  {row}" for row in rows))


TARGET = Target("scene in fixed point in C", ("c",), fixed=files)
