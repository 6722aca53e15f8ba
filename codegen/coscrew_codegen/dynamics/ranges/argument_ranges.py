"""Ranges that a scene states, as those of a function's arguments."""

from coscrew_codegen.program import Input, Program
from coscrew_codegen.program.scene_functions import ArgumentRanges
from coscrew_codegen.scene.mechanism.ranges import Intervals, Ranges

_DIRECTIONS = ("d_", "w_")
"""Beginnings of the names of directions and weights, on which results depend linearly."""
_SAME = {"q1": "q"}
"""Arguments that have the range of another."""


def argument_ranges(program: Program, ranges: Ranges) -> ArgumentRanges:
    """The ranges of the function's inputs; directions and weights are up to 1."""
    intervals: list[Intervals] = []
    quaternions: list[tuple[Input, ...]] = []
    for number, a in enumerate(program.inputs):
        name, count = _SAME.get(a.name, a.name), a.quantity.size
        intervals.append(((-1.0, 1.0),) * count if name.startswith(_DIRECTIONS)
                         else ranges.of(name, count))
        if name == "q":
            quaternions += [tuple(Input(number, first + k) for k in range(4))
                            for first in ranges.quaternions]
    return ArgumentRanges(tuple(intervals), tuple(quaternions))
