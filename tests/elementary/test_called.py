"""Names in Programs of elementary functions; cost of Programs that call them."""

from collections import Counter

import pytest

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.lowering.programs import library_program, program_of
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.program import Constant, Op
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.elementary.evaluation.step_writer import StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument
from coscrew_codegen.program.whole_cost import whole_cost, whole_counts

X = Argument("x", SCALAR, ANY)
FUNCTIONS = {x.name: x for x in (*ELEMENTARY, *ERRORS)}


@pytest.mark.parametrize("second", ("z", "z_1"))
def test_two_steps_cannot_have_the_same_name(second: str):
    steps = StepWriter(X)
    x, = steps.inputs()
    z = steps.named("z", x * x + 1)
    y = steps.named(second, z + x)
    with pytest.raises(ValueError, match=f"^f: two steps are named {second}$"):
        steps.program("f", (Argument("y", SCALAR),), [y])


def test_constants_of_a_name_are_the_same():
    """A name in nested text stands for one constant only."""
    for function in FUNCTIONS.values():
        for of in filter(None, (function.kernel, function.near, function.far)):
            for precision in PRECISIONS:
                named = {(x.name, x) for step in of(precision).instructions for x in step.operands
                         if isinstance(x, Constant) and x.name}
                assert len(named) == len({name for name, _ in named}), function.name


def called(name: str) -> Counter[Op]:
    function = FUNCTIONS[name]
    near = function.near(DOUBLE).counts if function.near else {}
    return Counter(function.kernel(DOUBLE).counts) + Counter(near)


def test_sine_and_cosine_of_an_angle_are_one_call():
    assert whole_counts(library_program("sincos"), DOUBLE) == called("sincos")
    assert whole_counts(library_program("sin"), DOUBLE) == called("sincos")
    turn = library_program("mat3x3_from_axis_angle")  # of the angle, and of half of it
    own = Counter({op: n for op, n in turn.counts.items() if op not in (Op.SIN, Op.COS)})
    assert whole_counts(turn, DOUBLE) == own + called("sincos") + called("sincos")


def test_costs_name_no_function():
    tier = tier_named("accurate")
    for operation in OPERATIONS:
        program = program_of(operation)
        if FUNCTION_OF.keys() & program.counts.keys():
            for precision in PRECISIONS:
                for made in (program, tier.program(program, precision)):
                    assert not FUNCTION_OF.keys() & whole_counts(made, precision).keys()


def test_wide_programs_call_the_functions_of_double():
    wide = tier_named("accurate").program(library_program("exp"), SINGLE)
    assert whole_cost(wide, SINGLE) == whole_cost(library_program("exp"), DOUBLE)
