"""Searches the worst errors of functions in fixed point, against accurate results in double."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedFunction
from coscrew_codegen.program.fixed.fixed_arithmetic import ARITHMETIC
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.interpreter import evaluate
from coscrew_codegen.reports.cost.error_states import Box, Reals, Values, searched
from coscrew_codegen.reports.cost.measured import NEAREST, Measured


@dataclass(frozen=True)
class FixedErrors:
    """A function in fixed point, beside the same function in floating point."""

    function: Measured
    fixed: FixedFunction
    products: Products

    def worst(self, box: Box) -> dict[str, float]:
        """The largest error of each unit that a search in the box finds."""
        results = {}
        for unit in self.function.different_units:
            score = partial(self._errors, unit)
            results[unit] = float(score(searched(box, score, 1))[0])
        return results

    def _errors(self, unit: str, states: Values) -> Reals:
        """The largest error of a component with this unit, at the integers nearest to each state.
        """
        program, integers, rounded = self.fixed.programs[self.products], [], dict(states)
        count = len(states["t"])
        for a, values, x in zip(self.fixed.plain.inputs, self.fixed.inputs,
                                self.function.inputs(states), strict=True):
            scale, most = np.array([(2.0**y.bits, np.floor(y.largest)) for y in values]).T
            nearest = np.clip(np.rint(np.reshape(x, (count, -1)) * scale), -most, most)
            integers.append([*nearest.T.astype(np.int64)])
            rounded[a.name] = np.reshape(nearest / scale, x.shape)
        made = np.stack([np.broadcast_to(x, count) / 2.0**value.bits for x, value in zip(
            evaluate(program.program, integers, ARITHMETIC), program.results, strict=True)], 1)
        errors = np.abs(made - self.function.values(NEAREST, rounded)[0])
        worst: Reals = errors[:, [x == unit for x in self.function.units]].max(axis=1)
        return worst
