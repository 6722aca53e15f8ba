"""Derivatives of steps of integrators with respect to the state, to torques of joints and to
run-time parameters.

Coordinates are differentiated along velocities, before the step and after it: of q ⊕ φ."""

from itertools import accumulate, pairwise

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms import coordinates
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.scene_function import Results, SceneFunction

BY = ("q", "v", "tau", "p")
"""The inputs by which steps are differentiated."""


def of_step(x: FunctionRecording, step: SceneFunction, program: Program) -> Results:
    """q, v, and the derivatives of both by q and v, by tau and by p, row by row."""
    given = step.given(x.scene)
    widths = {name: _width(x, name) for name in BY if any(a.name == name for a in given)}
    duals = [_seeded(x, a.name, widths) for a in given]
    with x.recorder.part("derivatives"):
        results = derivatives.along(x.recorder.form(program), x.recorder, duals)
    nq, nv = x.tree.nq, x.tree.nv
    q, v = ([y.value for y in part] for part in (results[:nq], results[nq:]))
    zero = x.recorder.number(0)
    columns = [[zero if s is None else s for s in column]
               for column in zip(*(y.slopes for y in results), strict=True)]
    columns = [[*coordinates.velocities(x.recorder, x.tree, x.names, q, column[:nq]), *column[nq:]]
               for column in columns]
    edges = [0, *accumulate((2 * nv, *list(widths.values())[2:]))]
    return [q, v, *([column[i] for i in range(2 * nv) for column in columns[a:b]]
                    for a, b in pairwise(edges))]


def _width(x: FunctionRecording, name: str) -> int:
    """The number of directions by an input."""
    return len(x.scene.parameters) if name == "p" else x.tree.nv


def _seeded(x: FunctionRecording, name: str, widths: dict[str, int]) -> list[Dual[Number]]:
    """An input's components with their derivatives along all directions."""
    numbers, count = x.recorder.argument(name), sum(widths.values())
    if name not in widths:
        return [Dual(n, (None,) * count) for n in numbers]
    one, width = x.recorder.number(1), widths[name]
    rows = coordinates.chart(x.motion(moving=False, accelerating=False)) if name == "q" else [
        [one if i == j else None for j in range(width)] for i in range(width)]
    before = sum(w for other, w in widths.items() if BY.index(other) < BY.index(name))
    return [Dual(n, (*[None] * before, *row, *[None] * (count - before - width)))
            for n, row in zip(numbers, rows, strict=True)]
