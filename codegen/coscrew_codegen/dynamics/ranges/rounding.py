"""States proved bounds of a plain function's rounding errors for all states within the joints'
limits; nothing where a bound is infinite or too large to be of use."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isfinite

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds, followed
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.roundoff import RoundedRange
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.scene.mechanism.ranges import ranges_of_model
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Scene

USEFUL = 1000
"""Largest bound that is stated, in units u of the largest size that an output's components can
have."""


def statement(program: Program, scene: Scene, tree: Tree) -> str:
    """The bounds of a plain function's outputs in the scene's precisions, for all arguments in
    limits; "" without any."""
    if not followed(program) or Op.DIV in program.counts:
        return ""
    limits = ranges_of_model(tree, scene.parameters)
    sizes = [[max(map(abs, x)) for x in limits.of(a.name, a.quantity.size)]
             for a in program.inputs]
    words: dict[str, list[str]] = {}
    for precision in named(scene.precisions):
        values = ValueBounds(program, sizes, FloatRounding(precision, plain=True))
        for name, bound in _bounds(program, values.results, precision):
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
    for a in program.outputs:
        parts = components[start:start + a.quantity.size]
        start += a.quantity.size
        bound, size = max(x.error for x in parts), max(x.size for x in parts)
        if 0 < bound <= USEFUL * precision.u * Fraction(size if isfinite(size) else 0):
            yield a.name, bound


def _domain(program: Program, tree: Tree) -> str:
    taken = {a.name for a in program.inputs}
    words = [f"{name} within the joints' {limits}" for name, limits in (
        ("q", "limits"), ("v", "velocities")) if name in taken]
    if "q" in taken and not any(link.joint.lower is not None for link in tree.links):
        words[0] = "q"
    if "p" in taken:
        words.append("parameters up to the scene's in size")
    return " and ".join(words)
