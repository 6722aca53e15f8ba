"""Declarations in files of kinds of joints are true of every kind: of the shipped ones, and of
another that is put beside them."""

import ast
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import mpmath
import pytest

from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms.recorded_joint import RecordedJoint
from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import by_operation, evaluate, exactly
from coscrew_codegen.scene import joints
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism.joint_in_reals import JointInReals
from coscrew_codegen.scene.mechanism.joint_kind import ROTATION, JointKind, numbers
from coscrew_codegen.scene.mechanism.rotations import unit
from tests.support.scenes.kinds import Kind

ROOT = Path(__file__).parents[2]
MOVING = pytest.mark.parametrize(
    "kind", [x for x in KINDS if x.moves], ids=lambda kind: kind.name)
AXES = unit(map(Fraction, (1, 2, 3))), unit(map(Fraction, (3, 0, -1)))
"""Perpendicular; exact to 50 digits."""
H = mpmath.mpf("1e-15")
CLOSE = mpmath.mpf("1e-25")
"""The error of central differences with H is of the order of H²."""

Reals = Sequence[mpmath.mpf]


@pytest.fixture(autouse=True)
def digits():
    with mpmath.workdps(60):
        yield


def real(x: Fraction) -> mpmath.mpf:
    return mpmath.mpf(x.numerator) / x.denominator


def directions(kind: JointKind) -> tuple[tuple[mpmath.mpf, ...], ...]:
    return tuple(tuple(map(real, axis)) for axis in kind.frame(AXES[:len(kind.axes)]))


def state(kind: JointKind, q: Reals) -> JointInReals:
    return JointInReals(directions(kind), tuple(q), mpmath.sin, mpmath.cos)


def coordinates(kind: JointKind) -> list[mpmath.mpf]:
    """Some coordinates; quaternions of norm 1."""
    q = [mpmath.mpf(k * k - 3 * k + 1) / 7 + mpmath.mpf("0.3") for k in range(kind.nq)]
    for places in kind.quaternions:
        norm = mpmath.sqrt(sum(x * x for x in q[places]))
        q[places] = [x / norm for x in q[places]]
    return q


def velocities(kind: JointKind) -> list[mpmath.mpf]:
    return [mpmath.mpf(2 * k - 3) / 5 for k in range(kind.nv)]


def rates(kind: JointKind, q: Reals, v: Reals) -> Reals:
    return kind.manifold.rates(state(kind, q), q, v) if kind.manifold else v


def later(kind: JointKind, by: mpmath.mpf) -> list[mpmath.mpf]:
    """The coordinates after a short time."""
    q = coordinates(kind)
    return [x + by * u for x, u in zip(q, rates(kind, q, velocities(kind)), strict=True)]


def displaced(kind: JointKind, q: Reals) -> Reals:
    """D of the child in the joint's frame."""
    return kind.displacement(state(kind, q), (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0))


def matrix(D: Reals) -> mpmath.matrix:
    return mpmath.matrix([*(D[4 * i:4 * i + 4] for i in range(3)), (0, 0, 0, 1)])


def combined(screws: Sequence[Reals], v: Reals) -> list[mpmath.mpf]:
    return [sum(x * screw[i] for x, screw in zip(v, screws, strict=True)) for i in range(6)]


def assert_near(result: Reals, wanted: Reals, within: mpmath.mpf = CLOSE) -> None:
    assert len(result) == len(wanted)
    assert all(abs(x - y) < within for x, y in zip(result, wanted, strict=True)), (result, wanted)


def central(after: Reals, before: Reals) -> list[mpmath.mpf]:
    return [(x - y) / (2 * H) for x, y in zip(after, before, strict=True)]


@MOVING
def test_at_the_neutral_coordinates_nothing_is_displaced(kind):
    assert len(kind.neutral) == kind.nq
    assert_near(displaced(kind, [mpmath.mpf(x) for x in kind.neutral]),
                (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0))


@MOVING
def test_displacements_are_rigid(kind):
    R = matrix(displaced(kind, coordinates(kind)))[:3, :3]
    assert mpmath.norm(R * R.T - mpmath.eye(3)) < 1e-40 and abs(mpmath.det(R) - 1) < 1e-40


@MOVING
def test_the_subspace_is_the_rate_of_the_displacement(kind):
    """[[ω~, v], [0, 0]] of S v is D^-1 D'."""
    D = matrix(displaced(kind, coordinates(kind)))
    rate = matrix(displaced(kind, later(kind, H))) - matrix(displaced(kind, later(kind, -H)))
    s = D**-1 * rate / (2 * H)
    result = combined(kind.subspace(state(kind, coordinates(kind))), velocities(kind))
    assert_near(result, [*s[:3, 3], s[2, 1], s[0, 2], s[1, 0]])


@MOVING
def test_the_subspace_s_rate_is_its_derivative(kind):
    """S' v, by differences; zero where the kind gives none."""
    v = velocities(kind)
    after, before = (combined(kind.subspace(state(kind, later(kind, h))), v) for h in (H, -H))
    result = kind.subspace_rate(state(kind, coordinates(kind)), v) if kind.subspace_rate \
        else [0] * 6
    assert_near(result, central(after, before))


@MOVING
def test_velocities_move_coordinates_by_their_rates(kind):
    """(q ⊕ h v - q ⊕ -h v) / 2 h = q'; and q ⊕ 0 = q."""
    q, v = coordinates(kind), velocities(kind)
    assert_near(rates(kind, q, v), central(*(moved(kind, q, [h * x for x in v])
                                             for h in (H, -H))))
    assert_near(moved(kind, q, [mpmath.mpf(0)] * kind.nv), q)


def moved(kind: JointKind, q: Reals, phi: Reals) -> Reals:
    if not kind.manifold:
        return [x + y for x, y in zip(q, phi, strict=True)]
    recorder = Recorder((array("q", (kind.nq,)), array("phi", (kind.nv,))))
    result = kind.manifold.integrated(recorder.argument("q"), recorder.argument("phi"))
    return exact(recorder.program("moved", [(array("next", (kind.nq,)), result)]), q, phi)


def exact(program: Program, *inputs: Reals) -> list[mpmath.mpf]:
    return evaluate(program, inputs, by_operation(lambda x: real(x.double), exactly(mpmath)))


@MOVING
def test_recorded_numbers_are_the_real_ones(kind):
    """The library's operations compute what the formulas in real numbers do."""
    recorder = Recorder((array("q", (kind.nq,)), array("v", (kind.nv,))))
    q, v = recorder.argument("q"), recorder.argument("v")
    axes = tuple(map(recorder.numbers, kind.frame(AXES[:len(kind.axes)])))
    recorded, real_state = RecordedJoint(axes, q, recorder), state(kind, coordinates(kind))
    results = []
    for joint, speeds, one in ((recorded, v, recorder.numbers),
                               (real_state, velocities(kind), tuple)):
        D = kind.displacement(joint, one((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)))
        results.append([*D, *(x for screw in kind.subspace(joint) for x in screw),
                        *(kind.subspace_rate(joint, speeds) if kind.subspace_rate else ()),
                        *(kind.manifold.rates(joint, joint.q, speeds) if kind.manifold else ())])
    program = recorder.program("all", [(array("x", (len(results[0]),)), results[0])])
    assert_near(exact(program, coordinates(kind), velocities(kind)), results[1],
                mpmath.mpf("1e-45"))


def test_the_plane_s_axes_are_right_handed_and_those_of_the_frame_where_it_can_be():
    """x, y of the normal z; y, z of x; z, x of y; and x along the same axis for -z."""
    X, Y, Z = (tuple(Fraction(int(i == k)) for i in range(3)) for k in range(3))
    frame = Kind.PLANAR.frame
    assert frame((Z,)) == (X, Y, Z) and frame((X,)) == (Y, Z, X) and frame((Y,)) == (Z, X, Y)
    assert frame((tuple(-x for x in Z),))[0] == X
    for axis in (*AXES, unit((Fraction(1), Fraction(1), Fraction(1)))):
        R = mpmath.matrix([list(map(real, x)) for x in frame((axis,))])
        assert mpmath.norm(R * R.T - mpmath.eye(3)) < 1e-45 and abs(mpmath.det(R) - 1) < 1e-45


# the catalogue


def test_each_kind_is_a_file_of_its_name():
    result = {x.stem for x in Path(joints.__file__).parent.glob("*.py")} - {"__init__"}
    assert result == {kind.name for kind in KINDS}
    assert len({kind.place for kind in KINDS}) == len(KINDS)


def test_names_of_kinds_stand_in_their_files_alone():
    """Elsewhere the kinds are asked: no text of the generator is the name of one, except where
    readers of other formats translate the words of these, and of the tier in fixed point."""
    names = {kind.name for kind in KINDS}
    for path in sorted((ROOT / "codegen").rglob("*.py")):
        if path.parent.name not in ("joints", "mjcf", "sdf"):
            texts = {x.value for x in ast.walk(ast.parse(path.read_text()))
                     if isinstance(x, ast.Constant) and isinstance(x.value, str)}
            tier = {"fixed"} if path.parent.name in ("tiers", "fixed") else set()
            assert not (names - tier) & texts, path


def test_wrong_kinds_are_refused_where_they_are_made():
    with pytest.raises(ValueError, match="'eel' and has 7 velocities; wanted at most 6"):
        JointKind("eel", 1, "", (numbers("position", "m", 7),), "", "", lambda x, D: D,
                  lambda x: ())
    with pytest.raises(ValueError, match="has a quaternion; wanted a manifold"):
        JointKind("eel", 1, "", (ROTATION,), "", "", lambda x, D: D, lambda x: ())
