"""States proved bounds of a plain function's rounding errors for all states within the joints'
limits; nothing where a bound is infinite or too large to be of use."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf, isfinite, nextafter

from coscrew_codegen.dynamics.ranges.rounding_rules import RoundedRange, moved
from coscrew_codegen.program import Program
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Scene

USEFUL = 1000
"""Largest bound that is stated, in units u of the largest size that an output's components can
have."""


def statement(program: Program, scene: Scene, tree: Tree) -> str:
    """The bounds of a plain function's outputs in the scene's precisions, for all arguments in
    limits; "" without any."""
    words: dict[str, list[str]] = {}
    for precision in named(scene.precisions):
        sizes = [_sizes(a.name, a.quantity.size, scene, tree, precision) for a in program.inputs]
        components = moved(program, precision, sizes,
                           _above(SINCOS.error(precision)))
        for name, bound in _bounds(program, components or (), precision):
            words.setdefault(name, []).append(f"{two_digits_up(bound)} in {precision.name}")
    if not words:
        return ""
    bounds = "; ".join(f"{name} by at most {' and '.join(texts)}" for name, texts in words.items())
    domain = _domain(program, tree)
    return f"Proved: rounding moves {bounds} precision{f', for every {domain}' if domain else ''}."


def _bounds(program: Program, components: Sequence[RoundedRange], precision: Precision
            ) -> Iterator[tuple[str, float]]:
    """The outputs with a useful bound."""
    start = 0
    for a in program.outputs if components else ():
        parts = components[start:start + a.quantity.size]
        start += a.quantity.size
        bound, size = max(x.error for x in parts), max(x.size for x in parts)
        if 0 < bound <= USEFUL * precision.u * Fraction(size if isfinite(size) else 0):
            yield a.name, bound


def _sizes(name: str, count: int, scene: Scene, tree: Tree, precision: Precision
           ) -> Sequence[float]:
    """Bounds of the sizes of an argument's components; inf for a, tau, t, states of effects at the
    end of q, and all without limits."""
    if name == "p":
        return [abs(float(precision.rounded(p.value))) for p in scene.parameters]
    if name not in ("q", "v"):
        return [inf] * count
    results: list[float] = []
    for link in tree.links:
        if link.driver is None:
            number = len(link.q if name == "q" else link.v)
            results += [_largest(link.joint, name)] * number
    return results + [inf] * (count - len(results))


def _largest(joint: Joint, name: str) -> float:
    if not joint.kind.one_coordinate:
        return inf
    ends = (joint.lower, joint.upper) if name == "q" else (joint.velocity,)
    given = [abs(x) for x in ends if x is not None]
    return _above(max(given)) if len(given) == len(ends) else inf


def _above(x: Fraction) -> float:
    return nextafter(float(x), inf)


def _domain(program: Program, tree: Tree) -> str:
    taken = {a.name for a in program.inputs}
    words = [f"{name} within the joints' {limits}" for name, limits in (
        ("q", "limits"), ("v", "velocities")) if name in taken]
    if "q" in taken and not any(link.joint.lower is not None for link in tree.links):
        words[0] = "q"
    if "p" in taken:
        words.append("parameters up to the scene's in size")
    return " and ".join(words)
