"""Reads one effect's table in a scene file: the effect's targets, and its parameters' values."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import NoReturn, overload

from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.effect import Effect, ParameterOf, Place
from coscrew_codegen.scene.joints import ONE_COORDINATE, called
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Joint, Model, value
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.rotations import unit
from coscrew_codegen.scene.readers.toml import effect_settings
from coscrew_codegen.scene.readers.toml.toml_model import refuse_not_unit
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable
from coscrew_codegen.scene.readers.toml.trajectories.interpolant import Interpolant
from coscrew_codegen.scene.scene import Setting

ALL, MODEL = "all", "model"
MANY = 5
"""Joints or bodies that a message lists."""


@dataclass
class Use:
    """Collects the model's values that effects take while they are read, as (joint, field), and
    notices about values that they cannot take."""

    of_model: set[tuple[str, str]] = field(default_factory=set)
    notices: list[Notice] = field(default_factory=list)


@dataclass(frozen=True)
class EffectTable:
    """The table of an effect, the effect, and the model it acts on."""

    effect: Effect
    table: TomlTable
    model: Model
    use: Use

    @cached_property
    def bodies(self) -> tuple[str, ...]:
        return tuple(body.name for body in self.model.bodies)

    @cached_property
    def links(self) -> Mapping[str, str]:
        return self.model.links()

    @cached_property
    def targets(self) -> Mapping[str, Joint | None]:
        """The joints or bodies that the effect can act on, in the model's order."""
        return {x.name: x if isinstance(x, Joint) else None for x in self.elements
                if not self.obstacle(x)}

    @property
    def elements(self) -> tuple[Joint, ...] | tuple[Body, ...]:
        """The model's joints or bodies, whichever the effect acts on."""
        return self.model.joints if self.effect.place is Place.JOINT else self.model.bodies

    @property
    def what(self) -> str:
        return "joint" if self.effect.place is Place.JOINT else "body"

    @property
    def several(self) -> str:
        return "joints" if self.effect.place is Place.JOINT else "bodies"

    @property
    def sums(self) -> bool:
        """True if the effect can act on a weighted sum of coordinates."""
        return self.effect.on_sums

    @property
    def parameters(self) -> tuple[str, ...]:
        return tuple(parameter.name for parameter in self.effect.parameters)

    def obstacle(self, on: Joint | Body) -> str:
        """Why the effect cannot act on a joint or body: "is free"; "" if it can."""
        if isinstance(on, Body):
            return "has no mass" if self.effect.massive and on.inertia is None else ""
        effect, kind = self.effect, on.kind
        able = kind.moves if effect.reaction else kind.one_coordinate or effect.each and (
            kind.has_rest if effect.rest else kind.moves) or effect.by_angle and kind.by_angle
        return "" if able else f"is {kind.name}"

    @property
    def needs(self) -> str:
        """Sentence on the properties that a joint or body needs for the effect to act on it."""
        if self.effect.place is not Place.JOINT:
            return "has a mass"
        moves = self.effect.reaction or self.effect.each
        return "moves" if moves else f"is {called(ONE_COORDINATE, 'or')}"

    def all_targets(self, given: Mapping[str, object]) -> tuple[str, ...]:
        """The names that "all" stands for.  Joints with several coordinates are among them for an
        effect that acts along each velocity only if it takes numbers of the model."""
        of_model = any(x.model and given.get(x.name, x.default) == MODEL
                       for x in self.effect.parameters)
        return tuple(name for name, joint in self.targets.items() if of_model or not (
            (self.effect.each or self.effect.by_angle) and self._several(name)))

    def refuse_none(self) -> NoReturn:
        """Refuse an effect that can act on no joint or body of the model."""
        reasons = [f"{x.name!r} {self.obstacle(x)}" for x in self.elements]
        listed = ", ".join((*reasons[:MANY], *["…"] * (len(reasons) > MANY))) or "there is none"
        self.table.refuse(self.several, f"no {self.what} of the model {self.needs}, as "
                          f"{self.effect.name} needs: {listed}; wanted such a {self.what}, or no "
                          f"{self.effect.name}")

    def target(self, table: TomlTable, key: str, name: str) -> str:
        """The name, if the effect can act on it."""
        for on in self.elements:
            if on.name == name and (why := self.obstacle(on)):
                table.refuse(key, f"{self.effect.name} cannot act on {self.what} {name!r}, which "
                                  f"{why}")
        named = table.known(key, name, self.what, self.targets)
        if self.effect.place is Place.BODY and self.links[named] == WORLD:
            table.refuse(key, f"{self.effect.name} does nothing to body {name!r}, which is fixed "
                              "to the world; wanted a body that moves")
        return named

    def pair(self, table: TomlTable, names: tuple[str, str]) -> tuple[str, str]:
        """The names, if the effect can act between these two bodies."""
        for name in names:
            table.known("bodies", name, "body", (WORLD, *self.bodies))
        one, other = (self.links[name] for name in names)
        if one == other:
            why = "neither moves" if one == WORLD else "they move as one"
            table.refuse("bodies", f"{self.effect.name} does nothing between {names[0]!r} and "
                                   f"{names[1]!r}: {why}; wanted two bodies that move apart")
        return names

    @overload
    def values(self, table: TomlTable, given: Mapping[str, object], target: str
               ) -> dict[str, Setting]: ...

    @overload
    def values(self, table: TomlTable, given: Mapping[str, object], target: str,
               named: bool) -> dict[str, Setting] | None: ...

    def values(self, table: TomlTable, given: Mapping[str, object], target: str,
               named: bool = True) -> dict[str, Setting] | None:
        """The values of the parameters; None if the model lacks one and the target is one of "all".
        """
        kind = self._kind(table, given)
        values: dict[str, Setting] = {}
        read: set[tuple[str, str]] = set()
        for parameter in self.effect.parameters:
            name = parameter.name
            if parameter.of and kind not in parameter.of:
                if name in given:
                    chosen = self.effect.chosen_by
                    table.refuse(name, f"is for {chosen} = "
                                       f"{' or '.join(map(repr, parameter.of))}; the {chosen} is "
                                       f"{kind!r}")
                values[name] = None
            elif parameter.model and given.get(name, parameter.default) == MODEL:
                number = self._of_model(table, parameter, target, named)
                if number is None and parameter.required:
                    return None
                values[name] = number
                read.add((target, parameter.model))
            elif name not in given and kind in parameter.optional_of:
                values[name] = None
            elif name in given and name == self.effect.rest and self._several(target):
                values[name] = self._rest(table, name, given[name], target)
            elif name in given:
                values[name] = effect_settings.setting(table, parameter, given[name], self.bodies)
            else:
                values[name] = effect_settings.default(table, parameter)
                of = values.get(parameter.rate_of)
                values[name] = of.rate if isinstance(of, Interpolant) else values[name]
        if self.effect.any_of and all(values[name] is None for name in self.effect.any_of):
            if named or not read:
                table.missing(self.effect.any_of[0], f"{' or '.join(self.effect.any_of)}")
            return None
        self._refuse_descent(table, values)
        self._refuse_no_angle(table, values, target)
        read -= self._without_needed(table, values, target, named)
        self.use.of_model |= read | ({(target, "mimic")} if self.effect.mimic else set())
        return values

    def _refuse_no_angle(self, table: TomlTable, values: Mapping[str, Setting], target: str
                         ) -> None:
        """Refuse a range that no angle of a joint that turns about a point can have."""
        if self.effect.by_angle and self.effect.ascending and self._several(target):
            lower, upper = self.effect.ascending
            if values[lower] is not None:
                table.refuse(lower, f"joint {target!r} turns about a point: its angle is 0 or "
                                    f"more; wanted {upper} alone")
            end = values[upper]
            if isinstance(end, Fraction) and end <= 0:
                table.refuse(upper, f"{float(end):g} for joint {target!r}, which turns about a "
                                    "point; wanted an angle above 0")

    def _without_needed(self, table: TomlTable, values: dict[str, Setting], target: str,
                        named: bool) -> set[tuple[str, str]]:
        """Takes out the model's numbers that need others which it lacks, and returns them.  Raises
        SceneError for those that are given, or of a joint that is named."""
        taken = set()
        for p in self.effect.parameters:
            if p.needs and values[p.name] is not None and values[p.needs] is None:
                if named or not p.model:
                    table.missing(p.needs, f"{p.needs}, which {p.name} needs")
                values[p.name] = None
                taken.add((target, p.model))
        return taken

    def _several(self, target: str) -> bool:
        joint = self.targets.get(target)
        return joint is not None and not joint.kind.one_coordinate

    def _rest(self, table: TomlTable, name: str, given: object, target: str) -> Setting:
        """The coordinates of rest of a joint with several; quaternions normalised."""
        joint = self.targets[target]
        assert joint
        q = table.as_numbers(name, given, (joint.kind.nq,))
        for places in joint.kind.quaternions:
            refuse_not_unit(table, name, q[places])
            q = (*q[:places.start], *unit(q[places]), *q[places.stop:])
        return q

    def _refuse_descent(self, table: TomlTable, values: Mapping[str, Setting]) -> None:
        if not self.effect.ascending:
            return
        low, high = (values[name] for name in self.effect.ascending)
        if isinstance(low, Scalar) and isinstance(high, Scalar) and value(low) > value(high):
            table.refuse(self.effect.ascending[0], f"{float(value(low)):g} is above "
                         f"{self.effect.ascending[1]}, {float(value(high)):g}")

    def _kind(self, table: TomlTable, given: Mapping[str, object]) -> str:
        """The choice, as the effect's `kind`, on which the set of parameters depends."""
        chosen = self.effect.chosen_by
        for parameter in self.effect.parameters:
            if parameter.name == chosen and any(other.of for other in self.effect.parameters):
                return str(effect_settings.setting(table, parameter, given[chosen], ())
                           if chosen in given else effect_settings.default(table, parameter))
        return ""

    def _of_model(self, table: TomlTable, parameter: ParameterOf, target: str, named: bool
                  ) -> Fraction | None:
        """The model's number for a parameter, or None.  A missing number that the effect needs is
        an error if the joint was named."""
        joint = self.targets.get(target)
        number = getattr(joint, parameter.model, None)
        fault = joint.fault(parameter.model) if joint else None
        if fault:
            table.refuse(parameter.name, f"{self.what} {target!r} has no {parameter.model} that "
                         f"can be used ({fault}); give {parameter.name} a "
                         f"number for {target!r}, or leave the joint out")
        if number is not None:
            effect_settings.refuse_sign(table, parameter, number, f" of {self.what} {target!r}")
        elif named and parameter.required:
            table.refuse(parameter.name, f"the model has no {parameter.model} for {self.what} "
                                         f"{target!r}; wanted a number")
        return number
