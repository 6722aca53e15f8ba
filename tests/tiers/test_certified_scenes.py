"""The certified tier of scenes' functions: no bound is broken, in formats with so few digits that
neglected terms matter; and each part of the proof is needed."""

import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType

import pytest

from coscrew_codegen.accuracy.tiers import certified_scene, sizes
from coscrew_codegen.accuracy.tiers.certified_wide import SIZES_ALONE
from coscrew_codegen.accuracy.tiers.splits import scalings, splits
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Op, Operand, Program, Ref
from coscrew_codegen.program.elementary import ERRORS, Elementary
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.generated_scenes import Writer, argument
from tests.support.truth.toys import Toy, climbs, judge

TOYS = Toy(11, -40), Toy(16, -200)
NAMES = "abcd"
Build = Callable[[Writer, Operand, Operand, Operand, Operand], Operand]


def _close(w: Writer, a: Operand, b: Operand, name: str) -> Operand:
    """a/3 + b, which cancels."""
    return w.do(name, Op.ADD, w.do(f"{name}_third", Op.MUL, "1/3", a), b)


def _difference(w: Writer, a: Operand, b: Operand, c: Operand) -> Operand:
    """((a/3) c) c + (b c) (c/3), whose errors may exceed the result."""
    left = w.do("acc", Op.MUL, w.do("ac", Op.MUL, w.do("a_third", Op.MUL, "1/3", a), c), c)
    right = w.do("bcc", Op.MUL, w.do("bc", Op.MUL, b, c), w.do("c_third", Op.MUL, "1/3", c))
    return w.do("x", Op.ADD, left, right)


def _power(w: Writer, x: Operand, name: str, times: int = 3) -> Operand:
    for n in range(times):
        x = w.do(f"{name}{n}", Op.MUL, x, x)
    return x


def _mean(w: Writer, a: Operand, b: Operand, c: Operand, d: Operand) -> Operand:
    x, y = _close(w, a, b, "x"), _close(w, c, d, "y")
    return w.do("m", Op.ADD, w.do("xx", Op.MUL, x, x), w.do("yy", Op.MUL, y, y))


def _far(w: Writer, a: Operand, b: Operand, c: Operand, d: Operand) -> Operand:
    """A product of two values of many roundings, each with a large relative error."""
    x, y = _close(w, a, b, "x"), _close(w, c, d, "y")
    for n in range(8):
        x = w.do(f"x{n}", Op.SUB if n % 2 else Op.ADD, x, a)
        y = w.do(f"y{n}", Op.SUB if n % 2 else Op.ADD, y, c)
    return w.do("r", Op.MUL, x, y)


def _quotient(w: Writer, a: Operand, b: Operand, c: Operand, d: Operand) -> Operand:
    return w.do("r", Op.DIV, _close(w, a, b, "x"), _close(w, c, d, "y"))


def _wide(w: Writer, a: Operand, b: Operand, c: Operand, d: Operand) -> Operand:
    """√|x| x (x < 0 ? -v : v), where x may have either sign: errors are most of each factor."""
    x, v = _difference(w, a, b, c), _close(w, d, b, "v")
    root = w.do("root", Op.SQRT, w.do("size", Op.ABS, x))
    signed = w.do("signed", Op.SELECT, w.do("t", Op.LESS, x, "0"), w.do("n", Op.NEG, v), v)
    return w.do("r", Op.MUL, w.do("elastic", Op.MUL, root, x), signed)


def _scale(w: Writer, x: Operand) -> Operand:
    """2^-9 or 2^5."""
    return w.do("s", Op.SELECT, w.do("large", Op.LESS, "2", x), "1/512", "32")


def _norm(w: Writer, x: Operand, y: Operand) -> Operand:
    """sqrt(x² + y²), scaled by a power of two that may be wrong."""
    s = _scale(w, w.do("size", Op.ABS, x))
    back = w.do("back", Op.SELECT, w.do("down", Op.LESS, s, "1"), "512", "1/32")
    x, y = (w.do(f"s{n}", Op.SCALE, z, s) for n, z in enumerate((x, y)))
    square = w.do("square", Op.ADD, w.do("xx", Op.MUL, x, x), w.do("yy", Op.MUL, y, y))
    return w.do("r", Op.SCALE, w.do("root", Op.SQRT, square), back)


def _series(w: Writer, x: Operand) -> Operand:
    """1 + x (1 + x (1 + x/4)); the truth takes x³/12 for the truncated terms."""
    total: Operand = Constant(Fraction(1, 4), Fraction(1, 4), tail=Fraction(1, 12))
    for n in range(3):
        total = w.do(f"h{n}", Op.ADD, "1", w.do(f"m{n}", Op.MUL, x, total))
    return total


FORMULAS: dict[str, Build] = {
    "sum": lambda w, a, b, c, d: w.do("r", Op.ADD, _close(w, a, b, "x"), _close(w, c, d, "y")),
    "product": lambda w, a, b, c, d: w.do("r", Op.MUL, _close(w, a, b, "x"), _close(w, c, d, "y")),
    "products": lambda w, a, b, c, d: w.do("r", Op.SUB, w.do("ab", Op.MUL, a, b),
                                          w.do("cd", Op.MUL, c, d)),
    "chain": lambda w, a, b, c, d: w.do("r", Op.MUL, d, w.do("abc", Op.MUL, c, w.do(
        "ab", Op.MUL, a, b))),
    "squares": _mean,
    "power": lambda w, a, b, c, d: _power(w, _close(w, a, b, "x"), "p"),
    "far product": _far,
    "wide product": _wide,
    "wide square": lambda w, a, b, c, d: _power(w, w.do(
        "s", Op.ABS, _difference(w, a, b, c)), "p", 1),
    "exact quotient": lambda w, a, b, c, d: w.do("r", Op.DIV, a, b),
    "quotient": _quotient,
    "square of a quotient": lambda w, a, b, c, d: _power(w, _quotient(w, a, b, c, d), "p", 1),
    "exact root": lambda w, a, b, c, d: w.do("r", Op.SQRT, w.do("s", Op.ABS, a)),
    "root": lambda w, a, b, c, d: w.do("r", Op.SQRT, _mean(w, a, b, c, d)),
    "divisor": lambda w, a, b, c, d: w.do("r", Op.DIV, d, _difference(w, a, b, c)),
    "size": lambda w, a, b, c, d: w.do("r", Op.ADD, c, w.do("s", Op.ABS, _close(w, a, b, "x"))),
    "positive part": lambda w, a, b, c, d: w.do("r", Op.ADD, w.do(
        "s", Op.ABS, _difference(w, a, b, c)), Ref("x")),
    "limit": lambda w, a, b, c, d: w.do("r", Op.SELECT, w.do("t", Op.LESS, a, "1/3"), c, w.do(
        "o", Op.SELECT, w.do("l", Op.LESS, "1/3", a), d, b)),
    "square of a difference": lambda w, a, b, c, d: _power(w, _difference(w, a, b, c), "p", 1),
    "step": lambda w, a, b, c, d: w.do("r", Op.SELECT, w.do("t", Op.LESS, w.do(
        "x", Op.MUL, "1/3", a), b), d, w.do("n", Op.NEG, d)),
    "smaller": lambda w, a, b, c, d: w.do("r", Op.SELECT, w.do("t", Op.LESS, _close(
        w, a, b, "x"), _close(w, c, d, "y")), _close(w, a, b, "x2"), _close(w, c, d, "y2")),
    "equal": lambda w, a, b, c, d: w.do("r", Op.SELECT, w.do("t", Op.EQUAL, _close(
        w, a, b, "x"), "1/3"), c, d),
    "sine": lambda w, a, b, c, d: w.do("r", Op.SIN, _close(w, a, b, "x")),
    "circle": lambda w, a, b, c, d: w.do("r", Op.ADD, w.do("ac", Op.MUL, a, w.do(
        "c", Op.COS, c)), w.do("bs", Op.MUL, b, w.do("s", Op.SIN, c))),
    "tanh": lambda w, a, b, c, d: w.do("r", Op.MUL, d, w.do("t", Op.TANH, _close(w, a, b, "x"))),
    "exp": lambda w, a, b, c, d: w.do("r", Op.EXP, _close(w, a, b, "x")),
    "exact arctangent": lambda w, a, b, c, d: w.do("r", Op.ATAN2, a, b),
    "arctangent": lambda w, a, b, c, d: w.do("r", Op.ATAN2, _close(w, a, b, "x"), _close(
        w, c, d, "y")),
    "bearing": lambda w, a, b, c, d: w.do("r", Op.ATAN2, _difference(w, a, b, c), d),
    "scaled": lambda w, a, b, c, d: w.do("r", Op.SCALE, _close(w, a, b, "x"), _scale(w, c)),
    "sign of a scaled number": lambda w, a, b, c, d: w.do("r", Op.SELECT, w.do(
        "t", Op.LESS, w.do("p", Op.SCALE, a, _scale(w, c)), "0"), d, w.do("n", Op.NEG, d)),
    "norm": lambda w, a, b, c, d: _norm(w, _close(w, a, b, "x"), _close(w, c, d, "y")),
    "series": lambda w, a, b, c, d: _series(w, w.do("s", Op.SCALE, a, "1/4")),
    "root of a series": lambda w, a, b, c, d: w.do("r", Op.SQRT, _series(
        w, w.do("s", Op.SCALE, a, "1/4"))),
}


@cache
def program_of(formula: str) -> Program:
    w = Writer(*map(argument, NAMES))
    result = FORMULAS[formula](w, *map(w.at, NAMES))
    return w.function("f", "f", (argument("r"),), [result]).program


def _searched(plain: Program, certified: Program, toy: Toy, rounds: int) -> tuple[float, int]:
    """The largest error in bounds, the number of outputs judged."""
    width, worst, outputs = sum(a.quantity.size for a in plain.inputs), 0.0, 0
    for result in climbs(judge(plain, certified, toy), width, toy, 0, rounds):
        assert result.same
        worst, outputs = max(worst, result.worst), outputs + result.outputs
    return worst, outputs


@pytest.mark.parametrize("toy", TOYS, ids=str)
@pytest.mark.parametrize("formula", FORMULAS)
def test_no_bound_is_broken_by_a_formula(formula: str, toy: Toy):
    plain = program_of(formula)
    worst, outputs = _searched(plain, certified_scene.of_scene(plain, toy), toy, 40)
    assert worst <= 1 and outputs > 5000
    assert worst > 0.4  # and the search comes close


@pytest.mark.parametrize("toy", TOYS, ids=str)
@pytest.mark.parametrize("formula", ("sine", "circle"))
def test_no_bound_is_broken_where_sines_are_many(formula: str, toy: Toy,
                                                 monkeypatch: pytest.MonkeyPatch):
    """Then their sizes are their own."""
    monkeypatch.setattr(certified_scene, "MANY", 0)
    test_no_bound_is_broken_by_a_formula(formula, toy)


@pytest.mark.parametrize("toy", TOYS, ids=str)
@pytest.mark.parametrize("formula", FORMULAS)
def test_no_bound_is_broken_without_computed_errors(formula: str, toy: Toy):
    """Double results by which single ones are judged have such bounds; κ is smaller here."""
    plain = program_of(formula)
    certified = certified_scene.extended(plain, toy, replace(SIZES_ALONE, spread=64))
    worst, outputs = _searched(plain, certified, toy, 20)
    assert worst <= 1 and outputs > 1000


EXAMPLES = Path(__file__).parents[2] / "examples/scenes"
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "body_poses",
             "body_twists", "integrated", "implicit_acceleration")


@pytest.mark.parametrize("scene", ("arm6", "pendulum", "quadruped", "stick_slip", "wingnut"))
def test_no_bound_is_broken_by_a_scene(scene: str):
    toy, total = Toy(21, -300), 0
    for function in derive(read_scene(EXAMPLES / f"{scene}.toml"), FUNCTIONS).functions:
        plain = function.program
        if plain.instructions:
            worst, outputs = _searched(plain, certified_scene.of_scene(plain, toy), toy, 2)
            total += outputs
            assert worst <= 1, function.name
    assert total > 1000


# The proof needs all its constants: where one is weakened, a search breaks a bound.

MUTATIONS = {
    "slack": ("sizes", "self.slack = 16 *", "self.slack = 0 *", "products"),
    "padding": ("sizes", "self.do(Op.ADD, size.s, constant(self.padding), name=\"padded\")",
                "size.s", "chain"),
    "last factor": ("sizes", "(self.covered(size.k, size.m) + rounding)",
                    "size.m / 2**12 * self.u**2", "products"),
    "reach of factors": ("sizes", "Op.ADD, self.magnitude(x), self.units(x), name=\"reach\"",
                         "Op.ABS, x", "square of a difference"),
    "divisor near zero": ("certified_scene", "constant(Fraction(4))", "ZERO", "divisor"),
    "spread of divisors": ("certified_scene", "total = sizes.do(Op.MUL, total, sizes.reach(y))",
                           "total = sizes.do(Op.MUL, total, divisor)", "quotient"),
    "underflow of a - q b": ("certified_scene", "sizes.padded(x, even_exact=True), sizes.padded(y)",
                             "sizes.padded(x), sizes.padded(y)", "exact quotient"),
    "underflow of a - s s": ("certified_scene", "a = sizes.padded(x, even_exact=True)\n    k",
                             "a = sizes.padded(x)\n    k", "exact root"),
    "root near zero": ("certified_scene", "far = _in_size(sizes, far, k, m)", "far = ZERO", "root"),
    "rest of roots": ("certified_scene", "a.m / 2 + (3", "a.m / 3 + (3", "root of a series"),
    "sign": ("certified_scene", "sizes.do(Op.SUB, sizes.do(Op.ABS, gap), gap)", "ZERO",
             "positive part"),
    "choice": ("certified_scene", "sizes.do(Op.SELECT, certain, ZERO, other)", "ZERO", "step"),
    "distance of options": ("certified_scene", "other = _distance_up(sizes, *options)",
                            "other = ZERO", "step"),
    "functions": ("certified_scene", " + REST", "", "circle"),
    "arctangent near zero": ("certified_scene", "sizes.do(Op.SELECT, near, small, any_other)",
                             "small", "bearing"),
    "bend of the arctangent": ("certified_scene", "sizes.do(Op.MUL, part, part)", "ZERO",
                               "bearing"),
    "cut of the arctangent": ("certified_scene", "if (bound := sizes.bound(y)) is not None:",
                              "if bound := None:", "bearing"),
    "lost by scaling": ("certified_scene", "kept, ZERO, constant(2 * sizes.precision.eta)",
                        "kept, ZERO, ZERO", "sign of a scaled number"),
    "both errors": ("sizes", "second = self.do(Op.ADD, second, self.do(Op.MUL, a, b))",
                    "second = self.do(Op.ADD, second, ZERO)", "wide square"),
    "rests of both": ("sizes", "self.do(Op.MUL, p, self._beyond(y)),\n"
                      "                         self.do(Op.MUL, q, self._beyond(x))",
                      "ZERO, ZERO", "wide product"),
    "series": ("sizes", "abs(near) + x.tail / (TAIL * self.u**2)", "abs(near)", "series"),
}


def _mutated(module: str, old: str, new: str) -> ModuleType:
    """The tier with one of its two modules changed."""
    changed = {}
    for name, original in (("sizes", sizes), ("certified_scene", certified_scene)):
        source = Path(original.__file__ or "").read_text(encoding="utf-8")
        if name == module:
            assert source.count(old) == 1, old
            source = source.replace(old, new)
        source = source.replace("coscrew_codegen.accuracy.tiers.sizes", "mutated_sizes")
        spec = spec_from_loader(f"mutated_{name}", None)
        assert spec
        changed[name] = sys.modules[spec.name] = module_from_spec(spec)
        exec(compile(source, name, "exec"), vars(changed[name]))
    return changed["certified_scene"]


def test_split_numbers_are_found_where_results_do_not_depend_on_them():
    """x² = h² + (x - h) (x + h) for every h."""
    w = Writer(*map(argument, NAMES))
    a, b = map(w.at, "ab")
    h = w.do("h", Op.SUB, w.do("t", Op.ADD, a, b), b)
    low, total = w.do("low", Op.SUB, a, h), w.do("total", Op.ADD, a, h)
    square = w.do("x", Op.ADD, w.do("hh", Op.MUL, h, h), w.do("rest", Op.MUL, low, total))
    results = [w.function("f", "", (argument("r"),), [x]).program for x in (square, total)]
    assert [splits(program) for program in results] == [{"h"}, frozenset()]


@pytest.mark.parametrize("first", (True, False))
def test_split_numbers_that_one_branch_needs_are_none(first: bool):
    """Whichever it is: the test takes both."""
    w = Writer(*map(argument, NAMES))
    a, b, c, d = map(w.at, NAMES)
    h = w.do("h", Op.SUB, w.do("t", Op.ADD, a, b), b)
    needs, free = w.do("needs", Op.ADD, h, h), w.do("free", Op.ADD, a, a)
    test, options = w.do("test", Op.LESS, c, d), (needs, free) if first else (free, needs)
    results = [w.function("f", "", (argument("r"),), [w.do(name, Op.SELECT, test, *chosen)]).program
               for name, chosen in (("one", options), ("none", (free, free)))]
    assert [splits(program) for program in results] == [frozenset(), {"h"}]


def test_choices_of_scales_are_found_where_results_do_not_depend_on_them():
    plain = program_of("norm")
    root = next(step for step in plain.instructions if step.op is Op.SQRT)
    unscaled = replace(plain, results=(Ref(root.name),))
    assert [scalings(program) for program in (plain, unscaled)] == [{"s"}, frozenset()]


@pytest.mark.parametrize("op", (Op.COPYSIGN, Op.POWER))
def test_an_operation_without_a_rule_is_named(op: Op):
    w = Writer(*map(argument, NAMES))
    plain = w.function("bearing", "", (argument("r"),), [w.do("r", op, *map(w.at, "ab"))]).program
    with pytest.raises(certified_scene.NoRuleError, match=(
            f"^bearing: the certified tier has no rule for {op.value}$")):
        certified_scene.of_scene(plain, DOUBLE)


@pytest.mark.parametrize("function", ERRORS, ids=lambda function: function.name)
def test_functions_err_by_what_the_proof_takes(function: Elementary):
    for precision in PRECISIONS:
        assert function.error(precision) <= certified_scene.REST * precision.u**2


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_weaker_constant_is_noticed(mutation: str, monkeypatch: pytest.MonkeyPatch):
    module, old, new, formula = MUTATIONS[mutation]
    for name in ("sizes", "certified_scene"):
        monkeypatch.setitem(sys.modules, f"mutated_{name}", None)
    plain = program_of(formula)
    weak = _mutated(module, old, new).of_scene
    assert max(_searched(plain, weak(plain, toy), toy, 120)[0] for toy in TOYS) > 1
