"""Weighted sums of joints' coordinates: joints = { one = 1, other = -0.5, "base.2" = 3 }."""

from coscrew_codegen.scene.mechanism.loop import WeightedCoordinate
from coscrew_codegen.scene.mechanism.model import Joint, Model
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable


def read_terms(table: TomlTable, model: Model) -> tuple[WeightedCoordinate, ...]:
    """The terms, in the model's order.  Raises SceneError for names that are no coordinates, and
    for weights of zero."""
    if not table.values:
        table.refuse("", "an empty table; wanted weights by joint, as { elbow = 1 }")
    places = {name: place for place, name in enumerate(x.name for x in model.joints)}
    terms = [_term(table, key, model) for key in table.values]
    return tuple(sorted(terms, key=lambda x: (places[x.joint], x.coordinate)))


def _term(table: TomlTable, key: str, model: Model) -> WeightedCoordinate:
    joint, coordinate = _coordinate(table, key, model)
    weight = table.number(key)
    if not weight:
        table.refuse(key, "0; wanted another weight, or no such joint")
    return WeightedCoordinate(joint.name, coordinate, weight)


def _coordinate(table: TomlTable, key: str, model: Model) -> tuple[Joint, int]:
    """A joint, and the number of its coordinate: elbow, or base.2 of a joint with several."""
    moving = {x.name: x for x in model.joints if x.kind.moves}
    name, _, number = key.rpartition(".")
    joint = moving.get(key) or (moving.get(name) if number.isdecimal() else None)
    if joint is None:
        table.known(key, key, "joint that moves", tuple(moving))
        raise AssertionError(key)
    if joint.kind.manifold:
        table.refuse(key, f"is {joint.kind.name}, and a quaternion is in no sum; wanted joints "
                          "whose coordinates are angles and lengths")
    count = joint.kind.nq
    chosen = int(number[:3]) if joint.name != key else 0
    if joint.name == key and count > 1 or chosen >= count:
        table.refuse(key, f"is {joint.kind.name}; wanted one of its coordinates, "
                          f"{joint.name}.0 to {joint.name}.{count - 1}")
    return joint, chosen
