"""Arguments of a scene's C functions: arrays that are plain, matrices row by row."""

from collections.abc import Sequence

from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.scene.scene_text import size
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument


def read(argument: Argument, precision: Precision) -> str:
    """The parameter of an input."""
    if argument.quantity.shape:
        return f"const {precision.c_type} {argument.name}[{size(argument)}]"
    return f"{precision.c_type} {argument.name}"


def written(argument: Argument, precision: Precision) -> str:
    """The parameter of an output."""
    if argument.quantity.shape:
        return f"{precision.c_type} {argument.name}[{size(argument)}]"
    return f"{precision.c_type} *{argument.name}"


def head(name: str, parameters: Sequence[str], storage: str = "") -> str:
    """void name(parameters), behind its storage class."""
    return listed(f"{storage and f'{storage} '}void {name}(", parameters, ")", WIDTH - 2)


def targets(outputs: Sequence[Argument]) -> list[str]:
    """Returns the place where each component of the outputs is stored."""
    return [f"{a.name}[{i}]" if a.quantity.shape else f"*{a.name}"
            for a in outputs for i in range(size(a))]
