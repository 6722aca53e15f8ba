"""Runs a scene's steps, call by call, on any kind of numbers."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import accumulate
from typing import Any, TypeAlias

import numpy as np

from coscrew_codegen.program.in_python import in_python
from coscrew_codegen.program.interpreter import Arithmetic
from coscrew_codegen.program.scene_functions import Call, IntegratorStep, SceneFunctions, Split

Number: TypeAlias = Any  # of MPFR, or a float
Numbers: TypeAlias = Sequence[Number] | np.ndarray
State = tuple[Numbers, Numbers]
Functions = Mapping[str, Callable[[Sequence[Any]], Numbers]]
"""Functions by name, from the components of each input to those of all results."""


def functions_on(scene: SceneFunctions, step: IntegratorStep,
                 arithmetic: Arithmetic[Number]) -> Functions:
    """The functions that the step calls, on these numbers."""
    return {x.function: in_python(scene.named(x.function).program, arithmetic)
            for x in step.calls}


class StepRun:
    """A run by these functions from q and v at t = 0, in steps of h, and the instructions of plain
    functions that it took so far."""

    def __init__(self, scene: SceneFunctions, step: IntegratorStep, functions: Functions,
                 number: Callable[[Number], Number], p: Mapping[str, float]):
        self._step, self._number = step, number
        self._calls = {id(x): _called(scene, x, functions[x.function]) for x in step.calls}
        self._p = [number(p[x]) for x, _ in scene.parameters]
        self.instructions = 0

    def states(self, start: State, h: Number, marks: Sequence[int]) -> Iterator[State]:
        """(q, v) after each of these numbers of steps."""
        q, v = ([self._number(x) for x in part] for part in start)
        values: dict[str, Numbers] = {
            "h": [self._number(h)], "p": self._p, "q": q, "v": v,
            **{x: [self._number(0)] * len(v) for x in self._step.zeros}}
        wanted = set(marks)
        for n in range(marks[-1]):
            values["t"] = [self._number(h * n)]
            for part in self._step.body:
                if isinstance(part, Call):
                    self._call(part, values)
                else:
                    self._split(part, values)
            if n + 1 in wanted:
                yield values["q"], values["v"]

    def _call(self, call: Call, values: dict[str, Numbers]) -> None:
        function, given, results, instructions = self._calls[id(call)]
        self.instructions += instructions
        result = function([values[x] for x in given])
        for name, part in results:
            values[name] = result[part]

    def _split(self, split: Split, values: dict[str, Numbers]) -> None:
        count, length = split.parts.results
        values |= {count: [self._number(1)], length: values["h"]}
        if split.test:
            self._call(split.test, values)
        if not split.test or values[split.test.results[0]][0]:
            self._call(split.parts, values)
        times = values[count][0]
        for _ in range(int(times) if times == times else 0):  # NaN: the run has stopped
            for call in split.calls:
                self._call(call, values)


def _called(scene: SceneFunctions, call: Call, function: Callable[[Sequence[Numbers]], Numbers]
            ) -> tuple[Callable[[Sequence[Numbers]], Numbers], list[str], list[tuple[str, slice]],
                       int]:
    """The function, its input variables, its result variables, and its number of instructions."""
    program, given = scene.named(call.function).program, dict(call.given)
    ends = accumulate(a.quantity.size for a in program.outputs)
    results = [(name, slice(end - a.quantity.size, end)) for name, a, end in zip(
        call.results, program.outputs, ends, strict=True)]
    return (function, [given.get(a.name, a.name) for a in program.inputs], results,
            len(program.instructions))
