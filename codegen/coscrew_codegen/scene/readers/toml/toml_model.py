"""A model in a scene file itself: tables [bodies.NAME] and [joints.NAME]."""

from fractions import Fraction
from math import acos, degrees

from coscrew_codegen.scene.joints import KINDS, called
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.joint_kind import Direction, JointKind
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Inertia,
    Joint,
    Limits,
    Mimic,
    Placement,
)
from coscrew_codegen.scene.readers.model_reader import ModelSource, Parts
from coscrew_codegen.scene.readers.toml.keys import (
    AXES,
    BODY,
    CYLINDER,
    JOINT,
    LIMITS,
    MIMIC,
    ORIGIN,
    SHAPE,
    TYPES,
)
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described

_ZERO = (Fraction(0),) * 3
_INERTIA = "a list of 3 or 6 numbers: xx, yy, zz, xy, xz, yz; or a symmetric 3×3 matrix"
_TOLERANCE = Fraction(1, 10**6)  # of a quaternion's norm, of right angles: people write six digits


def parts_of_tables(file: TomlTable, name: str, source: ModelSource) -> Parts:
    """The parts in the tables `bodies` and `joints`.  If the source is lenient, massless bodies are
    accepted and listed.  Raises SceneError."""
    massless: list[str] | None = [] if source.lenient else None
    bodies = tuple(body(name, table, massless) for name, table in file.tables("bodies"))
    joints = tuple(joint(name, table) for name, table in file.tables("joints"))
    return Parts(name, bodies, joints, implausible=tuple(massless or ()))


def body(name: str, table: TomlTable, massless: list[str] | None) -> Body:
    """The body.  A mass of zero is refused or, if `massless` is a list, reported there."""
    table.only(*BODY.names)
    if name == WORLD:
        table.refuse("", "this name is the world's; wanted another one")
    if "mass" not in table:
        if table.values:
            table.missing("mass", "the mass in kg")
        return Body(name)
    mass = table.positive("mass", Fraction(0)) if massless is None else \
        table.nonnegative("mass", Fraction(0))
    inertia = Inertia(mass, table.numbers("com", (3,), _ZERO), _inertia(table, mass))
    if massless is None or mass or any(inertia.moments):
        return Body(name, inertia)
    massless.append(f"body {name!r}: its mass is zero, and so are its moments")
    return Body(name)


def _inertia(table: TomlTable, mass: Fraction) -> tuple[Fraction, ...]:
    """The moments that `inertia` gives, or `shape` with the mass."""
    if "shape" not in table:
        return _moments(table)
    if "inertia" in table:
        table.refuse("shape", "`inertia` gives the moments already; wanted one of both")
    shape = table.table("shape")
    shape.only(*SHAPE.names)
    if len(shape.values) != 1:
        shape.refuse("", f"has {len(shape.values)} keys; wanted one of {', '.join(SHAPE.names)}")
    return (*(mass * x for x in _radii(shape)), *_ZERO)


def _radii(shape: TomlTable) -> tuple[Fraction, ...]:
    """The squares of the radii of gyration of a homogeneous solid, about x, y, z, in m²."""
    if "sphere" in shape:
        square = shape.positive("sphere")**2 * Fraction(2, 5)
        return square, square, square
    if "cylinder" in shape:
        cylinder = shape.table("cylinder")
        cylinder.only(*CYLINDER.names)
        radius, length = (cylinder.positive(key) for key in CYLINDER.names)
        across = radius**2 / 4 + length**2 / 12
        return across, across, radius**2 / 2
    edges = shape.numbers("box", (3,))
    if min(edges) <= 0:
        shape.refuse("box", f"an edge of {float(min(edges)):g} m; wanted positive lengths")
    x, y, z = (edge**2 / 12 for edge in edges)
    return y + z, x + z, x + y


def _moments(table: TomlTable) -> tuple[Fraction, ...]:
    """xx, yy, zz, xy, xz, yz, from three or six numbers in this order or a symmetric matrix."""
    rows = table.values.get("inertia", [0, 0, 0])
    if isinstance(rows, list) and any(isinstance(row, list) for row in rows):
        if [len(row) if isinstance(row, list) else 0 for row in rows] != [3, 3, 3]:
            table.refuse("inertia", f"a list of {len(rows)} with lists in it; wanted {_INERTIA}")
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = (table.as_numbers("inertia", row, (3,))
                                                    for row in rows)
        for name, above, below in (("xy", xy, yx), ("xz", xz, zx), ("yz", yz, zy)):
            if above != below:
                table.refuse("inertia", f"{name} is {float(above):.17g} above the diagonal and "
                                        f"{float(below):.17g} below; wanted {_INERTIA}")
        return xx, yy, zz, xy, xz, yz
    if not isinstance(rows, list) or len(rows) not in (3, 6):
        table.refuse("inertia", f"{described(rows)}; wanted {_INERTIA}")
    moments = table.as_numbers("inertia", rows, (3, 6))
    return moments if len(moments) == 6 else (*moments, *_ZERO)


def joint(name: str, table: TomlTable) -> Joint:
    """The joint."""
    table.only(*JOINT.names)
    word = table.choice("type", tuple(TYPES))
    kind = TYPES[word]
    ends = table.text("parent", WORLD), table.text("child")
    for key in JOINT.keys:
        if key.joints and key.name in table and not key.joints(kind):
            takers = called(tuple(filter(key.joints, KINDS)))
            table.refuse(key.name, f"is for {takers} joints; {name!r} is {word}")
    place, (axis, axis2) = _placement(table), _axes(table, kind)
    damping, friction = (table.nonnegative(key) for key in ("damping", "friction"))
    if not kind.one_coordinate:
        return Joint(name, kind, *ends, place, axis, upper=_largest_angle(table), axis2=axis2,
                     damping=damping, friction=friction)
    return Joint(name, kind, *ends, place, axis,
                 *_limits(table.table("limits"), word in kind.unlimited),
                 damping=damping, friction=friction,
                 mimic=_mimic(table.table("mimic")) if "mimic" in table else None)


def _axes(table: TomlTable, kind: JointKind) -> tuple[Direction, Direction | None]:
    """The first and the second axis of a joint of this kind."""
    axes = [_direction(table, key) for key in AXES[:len(kind.axes)]]
    if len(axes) < 2:
        return axes[0] if axes else Joint.axis, None
    cosine = sum(x * y for x, y in zip(*axes, strict=True))
    if kind.perpendicular and abs(cosine) > _TOLERANCE:
        table.refuse("axis2", f"makes an angle of {degrees(acos(cosine)):.9g}° with axis; wanted "
                     "90° within 1e-6 rad")
    return axes[0], axes[1]


def _largest_angle(table: TomlTable) -> Fraction | None:
    if "limits" not in table:
        return None
    limits = table.table("limits")
    limits.only("upper")
    return limits.positive("upper")


def _limits(table: TomlTable, continuous: bool) -> Limits:
    table.only(*(key for key in LIMITS.names if not continuous or key not in ("lower", "upper")))
    lower, upper = (table.number(key) if key in table else None for key in ("lower", "upper"))
    if lower is not None and upper is not None and lower > upper:
        table.refuse("lower", f"{float(lower):g} is above upper, {float(upper):g}")
    return lower, upper, table.nonnegative("effort"), table.nonnegative("velocity")


def _mimic(table: TomlTable) -> Mimic:
    table.only(*MIMIC.names)
    return Mimic(table.text("joint"), table.number("multiplier", Fraction(1)),
                 table.number("offset", Fraction(0)))


def _placement(table: TomlTable) -> Placement:
    """origin = { xyz, and one of rpy, quaternion (x, y, z, w), axis with angle }."""
    if "origin" not in table:
        return HERE
    origin = table.table("origin")
    origin.only(*ORIGIN.names)
    return placement(origin)


def placement(origin: TomlTable) -> Placement:
    """The frame that xyz, and one of rpy, quaternion, axis with angle, give."""
    ways = [key for key in ("rpy", "quaternion", "axis") if key in origin]
    if len(ways) > 1:
        origin.refuse(ways[1], f"the rotation is given by {ways[0]} already")
    if "angle" in origin and "axis" not in origin:
        origin.missing("axis", "the axis to turn about")
    return Placement(_rotation(origin), origin.numbers("xyz", (3,), _ZERO))


def _rotation(origin: TomlTable) -> tuple[Fraction, ...]:
    if "quaternion" in origin:
        quaternion = origin.numbers("quaternion", (4,))
        refuse_not_unit(origin, "quaternion", quaternion)
        return rotations.from_quaternion(quaternion)
    if "axis" in origin:
        return rotations.from_axis_angle(_direction(origin, "axis"), origin.number("angle"))
    return rotations.from_rpy(*origin.numbers("rpy", (3,), _ZERO))


def refuse_not_unit(table: TomlTable, key: str, quaternion: tuple[Fraction, ...]) -> None:
    """Refuse quaternions whose norm is not 1 within 1e-6."""
    square = sum(x * x for x in quaternion)
    if not (1 - _TOLERANCE)**2 <= square <= (1 + _TOLERANCE)**2:
        table.refuse(key, f"a quaternion of norm {float(square)**0.5:.9g}; wanted 1 within 1e-6, "
                          "in the order x, y, z, w")


def _direction(table: TomlTable, key: str) -> tuple[Fraction, ...]:
    vector = table.numbers(key, (3,))
    if not any(vector):
        table.refuse(key, "is zero; wanted a direction")
    return rotations.unit(vector)
