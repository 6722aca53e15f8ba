"""Units of coordinates, velocities and accelerations by joint, and of results made from them."""

from collections.abc import Callable, Sequence

from coscrew_codegen.scene.joints import KINDS

Kinds = Sequence[str]
"""The kinds of the joints with coordinates of their own, in order: revolute, prismatic, …."""
Units = tuple[str, ...] | Callable[[Kinds], tuple[str, ...]]
"""The unit of each component; fewer units than components are repeated."""

UNITS = {of: {kind.name: kind.units(of) for kind in KINDS} for of in "qva"}
"""Units of the components of q, v and a, by the joint's kind."""
SCREW = ("m/s",) * 3 + ("rad/s",) * 3
WRENCH = ("N",) * 3 + ("N m",) * 3
MOMENTUM = ("N s",) * 3 + ("N m s",) * 3
POSE = (("1",) * 3 + ("m",)) * 3


def coordinates(kinds: Kinds) -> tuple[str, ...]:
    """Units of q."""
    return _of_joints("q", kinds)


def velocities(kinds: Kinds) -> tuple[str, ...]:
    """Units of v."""
    return _of_joints("v", kinds)


def accelerations(kinds: Kinds) -> tuple[str, ...]:
    """Units of a."""
    return _of_joints("a", kinds)


def displacements(kinds: Kinds) -> tuple[str, ...]:
    """Units of v times a time."""
    return tuple(unit.removesuffix("/s") for unit in velocities(kinds))


def torques(kinds: Kinds) -> tuple[str, ...]:
    """Units of tau: the unit of power over that of v."""
    return tuple("N m" if unit == "rad/s" else "N" for unit in velocities(kinds))


def masses(kinds: Kinds) -> tuple[str, ...]:
    """Units of the mass matrix, row by row: of energy over two velocities."""
    turns = [unit == "rad/s" for unit in velocities(kinds)]
    return tuple(("kg", "kg m", "kg m^2")[a + b] for a in turns for b in turns)


def torques_by_displacements(kinds: Kinds) -> tuple[str, ...]:
    """Units of ∂tau/∂q, row by row."""
    return over(torques(kinds), displacements(kinds))


def torques_by_velocities(kinds: Kinds) -> tuple[str, ...]:
    """Units of ∂tau/∂v, row by row."""
    return over(torques(kinds), velocities(kinds))


def accelerations_by_displacements(kinds: Kinds) -> tuple[str, ...]:
    """Units of ∂a/∂q, row by row."""
    return over(accelerations(kinds), displacements(kinds))


def accelerations_by_velocities(kinds: Kinds) -> tuple[str, ...]:
    """Units of ∂a/∂v, row by row."""
    return over(accelerations(kinds), velocities(kinds))


def accelerations_by_torques(kinds: Kinds) -> tuple[str, ...]:
    """Units of M⁻¹, row by row."""
    return over(accelerations(kinds), torques(kinds))


def over(rows: Sequence[str], columns: Sequence[str]) -> tuple[str, ...]:
    """Units of a Jacobian, row by row: of results over those of arguments."""
    return tuple(
        "1" if row == column else
        f"{row}/({column})" if " " in column or "/" in column else f"{row}/{column}"
        for row in rows for column in columns)


def jacobian(kinds: Kinds) -> tuple[str, ...]:
    """Units of a Jacobian, row by row: of linear, then of angular velocity over each velocity."""
    of = {"rad/s": ("m", "1"), "m/s": ("1", "1/m")}
    return tuple(of[unit][row // 3] for row in range(6) for unit in velocities(kinds))


def point_jacobian(kinds: Kinds) -> tuple[str, ...]:
    """Units of the Jacobian of a point, row by row."""
    return jacobian(kinds)[:3 * len(velocities(kinds))]


def momenta(kinds: Kinds) -> tuple[str, ...]:
    """Units of M v: of energy over v."""
    return tuple("N m s" if unit == "rad/s" else "N s" for unit in velocities(kinds))


def centroidal(kinds: Kinds) -> tuple[str, ...]:
    """Units of the centroidal momentum matrix, row by row: of momenta over each velocity."""
    of = {"rad/s": ("kg m", "kg m^2"), "m/s": ("kg", "kg m")}
    return tuple(of[unit][row // 3] for row in range(6) for unit in velocities(kinds))


def reciprocals(of: Units) -> Units:
    """The units over which a derivative of a number is: 1/m for m."""
    def inverted(kinds: Kinds) -> tuple[str, ...]:
        return over(("1",), of(kinds) if callable(of) else of)
    return inverted


def _of_joints(which: str, kinds: Kinds) -> tuple[str, ...]:
    return tuple(unit for kind in kinds for unit in UNITS[which][kind])
