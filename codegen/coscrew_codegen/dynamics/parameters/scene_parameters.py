"""The torques as a linear function of parameters: tau = Y pi + tau0."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms import regressor
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.parameters.column_elimination import Base, base_of
from coscrew_codegen.dynamics.parameters.linear_effects import LinearEffects
from coscrew_codegen.program import Program
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Scene


class LinearParameters:
    """The parameters of a scene on which torques depend linearly: ten of each link, and those of
    effects.  `regressor` returns the Program of torque_regressor."""

    def __init__(self, scene: Scene, tree: Tree, names: tuple[str, ...],
                 regressor: Callable[[], Program]):
        self._scene, self._tree, self._names, self._regressor = scene, tree, names, regressor

    @cached_property
    def _effects(self) -> LinearEffects:
        return LinearEffects(self._scene, self._tree, self._names)

    @property
    def names(self) -> tuple[str, ...]:
        """forearm.m, …, viscous.elbow.d."""
        return (*(f"{link.name}.{x}" for link in self._tree.links for x in regressor.NAMES),
                *(x.name for x in self._effects.parameters))

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of each."""
        return (*(regressor.UNITS * len(self._tree.links)),
                *(x.unit for x in self._effects.parameters))

    @property
    def nonnegative(self) -> tuple[bool, ...]:
        """True for each number of effects that must not be negative."""
        return tuple(x.nonnegative for x in self._effects.parameters)

    @property
    def base_names(self) -> tuple[str, ...]:
        """wrist.mx + 0.11 hand.m, …."""
        return self.base.in_words(self.names)

    @property
    def base_units(self) -> tuple[str, ...]:
        """The unit of each combination."""
        return tuple(self.units[k] for k in self.base.places)

    @cached_property
    def base(self) -> Base:
        """The combinations of them that determine the torques."""
        p = [Fraction(x.value) for x in self._scene.parameters]
        return base_of(self._regressor(), len(self.names), self._tree, p)

    def columns(self, x: FunctionRecording, motion: Motion
                ) -> tuple[list[Sequence[Number]], Sequence[Number]]:
        """(the columns of Y, tau0)."""
        of_effects, rest = self._effects.columns(x)
        return [*regressor.columns(motion), *of_effects], rest

    def numbers(self, x: FunctionRecording) -> list[Number]:
        """pi."""
        return [*(n for rigid in x.rigids for n in rigid.numbers),
                *(x.recorder.number(own.number) for own in self._effects.parameters)]

    def base_numbers(self, x: FunctionRecording) -> list[Number]:
        """beta: the base's combinations of pi."""
        pi, results = self.numbers(x), []
        for terms in self.base.combinations:
            total = x.recorder.number(0)
            for place, weight in terms:
                total = total + pi[place] * weight
            results.append(total)
        return results
