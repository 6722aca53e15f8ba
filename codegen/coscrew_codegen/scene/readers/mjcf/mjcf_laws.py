"""Laws of joints and of fixed tendons in an MJCF, as closed loops.

An equality holds y - y0 = c0 + c1 (x - x0) + …, with the coordinates or lengths y0 and x0 of qpos0;
without a second element, y - y0 = c0.  A line between two joints makes the first follow, instead,
if it follows no other."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import comb
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.loop import ClosedLoop, WeightedCoordinate
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.laws import law
from coscrew_codegen.scene.readers.mjcf.mjcf_effects import following
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, exact
from coscrew_codegen.scene.readers.mjcf.mjcf_tendons import weights

if TYPE_CHECKING:
    import mujoco

_Sum = tuple[WeightedCoordinate, ...]


def laws(model: "mujoco.MjModel", names: MjcfNames, joints: Sequence[Joint]
         ) -> Iterator[ClosedLoop]:
    """The laws of a model with these joints."""
    for e in lawful(model, names):
        y, x = (_sum(model, names, e, of) for of in (model.eq_obj1id[e], model.eq_obj2id[e]))
        y0, x0 = (_at_qpos0(model, names, of) for of in (y, x))
        about_x0 = exact(model.eq_data[e][:5]) if x else exact(model.eq_data[e][:1])
        c0, *others = _shifted(about_x0, x0)
        while others and not others[-1]:
            others.pop()
        yield law(names.equality(e), joints, y, x, (c0 + y0, *others))


def lawful(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[int]:
    """The active equalities of joints, or of fixed tendons, except those by which joints follow."""
    import mujoco

    kinds, led = mujoco.mjtEq, {*following(model).values()}
    for e in range(model.neq):
        kind, y = int(model.eq_type[e]), int(model.eq_obj1id[e])
        if e not in led and model.eq_active0[e] and kind in (
                int(kinds.mjEQ_JOINT), int(kinds.mjEQ_TENDON)) and _sum(model, names, e, y) and (
                model.eq_obj2id[e] < 0 or _sum(model, names, e, model.eq_obj2id[e])):
            yield e


def _sum(model: "mujoco.MjModel", names: MjcfNames, e: int, number: int) -> _Sum:
    """The coordinate of a joint, or those in a tendon's length; () of no joint, and of a tendon
    with a path through space."""
    import mujoco

    if number < 0:
        return ()
    if int(model.eq_type[e]) == int(mujoco.mjtEq.mjEQ_JOINT):
        return (WeightedCoordinate(names.joint(int(number)), 0, Fraction(1)),)
    of = weights(model, names, int(number)) or {}
    return tuple(WeightedCoordinate(x, 0, decimal(str(w))) for x, w in of.items())


def _at_qpos0(model: "mujoco.MjModel", names: MjcfNames, terms: _Sum) -> Fraction:
    at = {names.joint(j): float(model.qpos0[model.jnt_qposadr[j]]) for j in range(model.njnt)}
    numbers = exact(at[x.joint] for x in terms)
    return sum((x.weight * q for x, q in zip(terms, numbers, strict=True)), Fraction(0))


def _shifted(coefficients: Sequence[Fraction], x0: Fraction) -> list[Fraction]:
    """The coefficients by powers of x of Σ c_k (x - x0)^k."""
    result = [Fraction(0)] * len(coefficients)
    for k, c in enumerate(coefficients):
        for j in range(k + 1):
            result[j] += c * comb(k, j) * (-x0)**(k - j)
    return result
