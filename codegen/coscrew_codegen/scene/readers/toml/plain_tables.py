"""Writes a model and effects as a scene file of plain tables, which needs no other file."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Context, Decimal
from fractions import Fraction

from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.inertia_checks import WARN
from coscrew_codegen.scene.mechanism.loop import HINGE, ROD, ClosedLoop
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Body, Joint, Model, Placement, value
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals
from coscrew_codegen.scene.readers.toml.toml_text import toml_pairs

_DIGITS = Context(prec=40)
"""Numbers with more digits, such as entries of rotations, are rounded to so many: far below the
rounding of double precision."""


def scene_text(name: str, model: Model, runtime: Sequence[str], effects: Mapping[str, object],
               start: Mapping[str, object], comments: Iterable[str]) -> str:
    """The text of a scene; each comment is a line at its beginning."""
    lines = [f"# {' '.join(x.split())}" for x in comments]
    lines += ["", *toml_pairs({"name": name})]
    if runtime:
        lines += toml_pairs({"runtime": runtime})
    if model.implausible:
        lines += toml_pairs({"implausible": WARN})
    lines += ["", "[bodies]", *toml_pairs({x.name: _body(x) for x in model.bodies})]
    lines += ["", "[joints]", *toml_pairs({x.name: _joint(x) for x in model.joints})]
    for loop in model.loops:
        lines += ["", f"[loops.{toml_key(loop.name)}]", *toml_pairs(_loop(loop))]
    for effect, table in effects.items():
        lines += ["", *_effect(effect, table)]
    if start:
        lines += ["", "[start.q]", *toml_pairs(start)]
    return "\n".join(lines).lstrip("\n") + "\n"


def _effect(effect: str, table: object) -> Iterator[str]:
    """The table of an effect, or its tables by joint, body or label."""
    assert isinstance(table, Mapping)
    if not table or not all(isinstance(x, Mapping) for x in table.values()):
        yield from (f"[effects.{effect}]", *toml_pairs(table))
        return
    for on, values in table.items():
        yield from (f"[effects.{effect}.{toml_key(on)}]", *toml_pairs(values))


def _body(body: Body) -> dict[str, object]:
    inertia = body.inertia
    if inertia is None:
        return {}
    moments = inertia.moments if any(map(value, inertia.moments[3:])) else inertia.moments[:3]
    return {"mass": _number(inertia.mass), "com": _numbers(inertia.com),
            "inertia": _numbers(moments)}


def _joint(joint: Joint) -> dict[str, object]:
    """The keys that are not the defaults."""
    table: dict[str, object] = {"type": joint.kind.name}
    if joint.parent != WORLD:
        table["parent"] = joint.parent
    table["child"] = joint.child
    if joint.placement != HERE:
        table["origin"] = _origin(joint.placement)
    table |= {key: _numbers(axis) for key, axis in zip(("axis", "axis2"), joint.axes, strict=False)}
    limits = {key: _number(x) for key in ("lower", "upper", "effort", "velocity")
              if (x := getattr(joint, key)) is not None}
    if limits:
        table["limits"] = limits
    table |= {key: _number(x) for key in ("damping", "friction")
              if (x := getattr(joint, key)) is not None}
    if joint.mimic:
        table["mimic"] = {"joint": joint.mimic.joint, "multiplier": _number(
            joint.mimic.multiplier), "offset": _number(joint.mimic.offset)}
    return table


def _loop(loop: ClosedLoop) -> dict[str, object]:
    """The keys of a loop whose frames are those of their bodies, and of a law of joints with one
    coordinate, as all that files have."""
    first, second, law = loop.first, loop.second, loop.law
    if law:
        joints, leaders = ({x.joint: _number(x.weight) for x in of}
                           for of in (law.joints, law.leaders))
        return {"kind": loop.kind.name, "joints": joints, **({"leaders": leaders} if leaders else {}
                ), "polynomial": _numbers(law.polynomial)}
    table: dict[str, object] = {"kind": loop.kind.name, "bodies": list(loop.bodies)}
    table |= {key: _numbers(x.point) for key, x in (("first", first), ("second", second))
              if any(x.point)}
    if loop.kind is HINGE:
        table |= {"axis": _numbers(first.axis), "axis2": _numbers(second.axis)}
    if loop.kind is ROD:
        table["length"] = _number(loop.length)
    return table


def _origin(placement: Placement) -> dict[str, object]:
    table: dict[str, object] = {}
    if any(placement.t):
        table["xyz"] = _numbers(placement.t)
    if placement.R != HERE.R:
        table["quaternion"] = _numbers(rotations.quaternion(placement.R))
    return table


def _numbers(numbers: Sequence[Scalar]) -> list[Decimals]:
    return [_number(x) for x in numbers]


def _number(x: Scalar) -> Decimals:
    """The number in decimals: exact if it has at most 40 digits."""
    number: Fraction = value(x)
    decimal = _DIGITS.divide(Decimal(number.numerator), Decimal(number.denominator))
    return Decimals(str(decimal.normalize(_DIGITS)))


