"""States how results of forward dynamics can be judged, which have no proved bound: by the residual
of the equation that they solve."""

from dataclasses import replace

from coscrew_codegen.accuracy.range_proofs import of_plain
from coscrew_codegen.accuracy.range_statements import domain
from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.dynamics.ranges.argument_ranges import argument_ranges
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import named
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.functions.whole_scene import forward_dynamics, inverse_dynamics

_SOLVES, _SOLVED = forward_dynamics.FUNCTION.name, inverse_dynamics.FUNCTION.name


def residual(its: Derivation, function: FunctionProgram) -> str:
    """The statement for forward dynamics, by the bound of inverse dynamics; "" for others."""
    solved = next((x for x in functions_of(its.scene) if x.name == _SOLVED), None)
    ranges = its.scene.ranges
    if function.name != _SOLVES or ranges is None or solved is None or solved.absent(its):
        return ""
    inverse = its.made(solved)
    inverse = replace(inverse, ranges=argument_ranges(inverse.program, ranges))
    bounds = [f"{two_digits_up(max(x.error for x in of_plain(inverse, p)))} in {p.name}"
              for p in named(its.scene.precisions)]
    tier = ("The certified tier returns a bound of a at each state; "
            f"{_SOLVED} of the result judges it")
    if any(x.startswith("inf") for x in bounds):
        return f"{tier}, to within a proved bound where [ranges] states ranges of q, v and a."
    arguments = ", ".join(a.name for a in inverse.inputs)
    return (f"{tier}: the residual tau - {_SOLVED}({arguments}) is known to within "
            f"{' and '.join(bounds)} precision and its own rounding, for every {domain(inverse)}.")
