"""Signals of a page: the energies and the recorded columns, a group for each quantity and unit; and
the arrows of recorded forces."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.scene.effect import FIRST, SECOND
from coscrew_codegen.scene.mechanism.loop import ROD
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.recorded_quantities import Recorded, recorded
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.simulation.recordings.recording import Column
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view.page_block import NumberBlock
from coscrew_codegen.simulation.view.part_places import numbers_of

Columns = Mapping[str, np.ndarray]
"""Values by the names of columns, at the times of a run's poses."""
_TITLES = {"q": "Positions q", "v": "Velocities v", "a": "Accelerations a",
           "x": "States x"}
_FIRST = ("q", "energy", "v", "power", "a")  # groups, in the order in which they are shown
_ENERGY = "energy"
_SHOWN = ("q", _ENERGY)  # of each of these the first group is plotted from the start
_NARROW = 0.1  # range, of the values
_FORCE, _REACTION, _CLOSING = "#e5484d", "#f76b15", "#8e4ec6"


@dataclass
class SignalGroup:
    """Signals of one quantity and unit: (name, label, run, values)."""

    quantity: str
    title: str
    unit: str
    signals: list[tuple[str, str, int, np.ndarray]] = field(default_factory=list)

    @property
    def heading(self) -> str:
        """The title with the unit, by which groups differ: "Positions q, rad"."""
        return f"{self.title}, {self.unit}" if self.unit else self.title


def grouped(system: System, columns: Sequence[Column], runs: Sequence[Columns]
            ) -> list[SignalGroup]:
    """The groups with the signals of each run that has them: first coordinates and energies."""
    groups: dict[tuple[str, str], SignalGroup] = {}
    for column in (*_energies(), *columns):
        title, label, quantity = _named(column, system)
        group = groups.setdefault((title, column.unit), SignalGroup(
            quantity, title, _unit(column.unit)))
        if column.name not in {name for name, *_ in group.signals}:
            group.signals += [(column.name, label, number, run[column.name])
                              for number, run in enumerate(runs) if column.name in run]
    order = [*_FIRST, *(x.quantity for x in groups.values())]
    return sorted(groups.values(), key=lambda x: order.index(x.quantity))


def _energies() -> tuple[Column, ...]:
    return tuple(Column(f"{_ENERGY}.{x}", "J", _ENERGY) for x in ("kinetic", "potential", "total"))


def energies(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> Columns:
    """The columns of energies, which every page shows."""
    kinetic, potential = system.energies(t, q, v)
    return {x.name: values for x, values in zip(_energies(), (
        kinetic, potential, kinetic + potential), strict=True)}


def _named(column: Column, system: System) -> tuple[str, str, str]:
    """(title of its group, label in it, quantity) of a column."""
    if column.quantity == _ENERGY and column.name.startswith(f"{_ENERGY}."):
        return "Energy", column.name.partition(".")[2], _ENERGY
    x = recorded(column.name, system.scene)
    if x.quantity in _TITLES:
        return _TITLES[x.quantity], column.name.partition(".")[2], x.quantity
    if x.of_effect:
        return x.quantity.capitalize(), column.name, x.quantity
    whole, _, component = column.name.rpartition(".")
    if x.target and whole != x.quantity:
        words = x.quantity.replace("_", " ").capitalize()
        return f"{words}, {x.target}", _component(x, component, column.unit), x.quantity
    return x.quantity.replace("_", " ").capitalize(), component, x.quantity


def _component(x: Recorded, component: str, unit: str) -> str:
    """x, y, z of positions, forces and moments, velocities and angular velocities."""
    letters = {"m": "x y z", "N": "fx fy fz", "N m": "- - - mx my mz", "m/s": "vx vy vz",
               "rad/s": "- - - ωx ωy ωz"}.get(unit, "").split()
    number = int(component) if component.isdigit() else len(letters)
    return letters[number] if number < len(letters) else component


def _unit(unit: str) -> str:
    """The unit as people write it; "" of a pure number."""
    return "" if unit == "1" else unit.replace("^2", "²").replace("N m", "N·m")


def packed(groups: Sequence[SignalGroup], block: NumberBlock) -> Json:
    """The groups for the page.  Values are single precision, less the middle of a narrow range."""
    first = {x.quantity: x for x in reversed(groups)}
    return [{"heading": x.heading, "shown": first[x.quantity] is x and
             x.quantity in _SHOWN, "signals": [
        {"name": name, "label": label, "run": run, **_values(values, block)}
        for name, label, run, values in x.signals]} for x in groups]


def _values(values: np.ndarray, block: NumberBlock) -> dict[str, Json]:
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    base = low / 2 + high / 2
    if low <= 0 <= high or high - low > _NARROW * abs(base):  # zero stays zero
        base = 0.0
    with np.errstate(over="ignore", invalid="ignore"):
        return {"base": base, "values": block.put(np.asarray(values, float) - base, "f4")}


def arrows(system: System, columns: Columns) -> Iterator[Json]:
    """The arrows of the reactions and forces whose three components are recorded, except
    of contacts, which are drawn whether recorded or not."""
    bodies = {WORLD: -1, **{body.name: n for n, body in enumerate(system.scene.model.bodies)}}
    for joint in system.scene.model.joints:
        names = [f"reaction.{joint.name}.{i}" for i in range(3)]
        if all(x in columns for x in names):
            yield {"body": bodies[joint.child], "point": [0.0] * 3, "signals": names,
                   "turns": True, "colour": _REACTION}
    for loop in system.scene.model.loops:
        names = [f"closing.{loop.name}.{i}" for i in range(3)]
        if all(x in columns for x in names):
            yield {"body": bodies[loop.first.body], "point": [*map(float, loop.first.point)],
                   "signals": names, "turns": True, "colour": _CLOSING}
    for applied in system.scene.effects:
        names = [f"{applied.name}.force.{i}" for i in range(3)]
        touches = applied.effect.parts or applied.effect.bodies_force
        if not touches and all(x in columns for x in names):
            yield {"body": bodies[applied.on], "point": _point(system, applied), "signals": names,
                   "turns": False, "colour": _FORCE}


def _point(system: System, applied: Applied) -> list[float]:
    """The point of its body at which a force acts, where the effect has one."""
    vectors = (numbers_of(system, applied.vector(x)) for x in ("point", "centre")
               if x in applied.values)
    return next((x.tolist() for x in vectors if len(x) == 3), [0.0] * 3)


def ties(system: System) -> Iterator[Json]:
    """The springs between two bodies, the rods and points that close loops, and the rods on which
    bodies slide."""
    model = system.scene.model
    bodies = {WORLD: -1, **{body.name: n for n, body in enumerate(model.bodies)}}
    for applied in system.scene.effects:
        if applied.effect.pair_force:
            ends = [{"body": bodies[name], "point": numbers_of(system, applied.vector(which)
                                                               ).tolist()}
                    for name, which in zip(applied.bodies, (FIRST, SECOND), strict=True)]
            yield {"kind": "spring", "ends": ends}
    for loop in model.loops:
        yield {"kind": "rod" if loop.kind is ROD else "closure", "ends": [
            {"body": bodies[x.body], "point": [*map(float, x.point)]}
            for x in (loop.first, loop.second)]}
    if not any(body.visuals for body in model.bodies):
        for joint in model.joints:
            if joint.kind.moves and not joint.kind.floats and any(
                    not part.turns for part in joint.kind.parts):
                at = numbers_of(system, joint.placement.t).tolist()
                yield {"kind": "rod", "ends": [
                    {"body": bodies[joint.parent], "point": at},
                    {"body": bodies[joint.child], "point": [0.0] * 3}]}
