"""A table named after a joint or body belongs to it, even if a parameter has the same name; a table
that could be either is refused.  The cases are made from the catalogue: every effect, every
parameter."""

import pytest

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

SEVERAL = {Place.JOINT: "joints", Place.BODY: "bodies"}
CLASHES = [(effect, parameter) for effect in EFFECTS if effect.place in SEVERAL
           for parameter in effect.parameters]
IDS = [f"{effect.name}.{parameter.name}" for effect, parameter in CLASHES]
both = pytest.mark.parametrize("effect, parameter", [x for x in CLASHES if not x[0].parts],
                               ids=lambda x: x.name)
"""Effects with parts have tables of bodies and labels alone."""
WRITTEN = {"vector": "[1, 2, 3]", "formulas": "[1, 2, 't']", "formula": "'2*t'",
           "matrix": str([[2 * int(i == j) for j in range(6)] for i in range(6)])}
INSTEAD = {"k": "depth", "alpha": "restitution"}
"""Parameters of contacts, and those that are given in their place."""
SHARES = ("restitution",)


def value(parameter: ParameterOf, number: int = 2) -> str:
    """A value that a file may give for the parameter."""
    if parameter.name in SHARES:
        return "0.5"
    if parameter.kind == "choice":
        return f'"{parameter.choices[-1]}"'
    return "true" if parameter.kind == "flag" else WRITTEN.get(parameter.kind, str(number))


def given(effect: Effect, of: ParameterOf) -> dict[str, str]:
    """Values for all of the effect's parameters, of the kind that has the parameter `of`."""
    kinds = next((x.choices for x in effect.parameters if x.name == effect.chosen_by), ("",))
    kind = of.of[0] if of.of else kinds[-1]
    results = {x.name: value(x, n + 2) for n, x in enumerate(effect.parameters)
               if not x.of or kind in x.of}
    for name, other in INSTEAD.items() if effect.states else ():
        results.pop(name if of.name == other else other, None)
    return {**results, **({effect.chosen_by: f'"{kind}"'} if kind else {})}


def lines(values: dict[str, str]) -> str:
    return "".join(f"{key} = {text}\n" for key, text in values.items())


@pytest.fixture
def read(tmp_path):
    """The values of these effects on two links, whose joints and bodies have these names."""

    def read(place: Place, first: str, effects: str, second: str = "other"):
        joints, bodies = (first, second), (f"of_{first}", f"of_{second}")
        if place is Place.BODY:
            joints, bodies = bodies, joints
        parents = ("world", bodies[0])
        text = "".join(f'[bodies."{body}"]\nmass = 1\ninertia = [1, 1, 1]\n[joints."{joint}"]\n'
                       f'type = "revolute"\nparent = "{parent}"\nchild = "{body}"\n'
                       "axis = [0, 0, 1]\nlimits = { lower = -1, upper = 1 }\n"
                       for joint, body, parent in zip(joints, bodies, parents, strict=True))
        (tmp_path / "arm.toml").write_text(f"{text}[effects.gravity]\n{effects}")
        return {x.on: dict(x.values) for x in read_scene(tmp_path / "arm.toml").effects if x.on}

    return read


@pytest.mark.parametrize("effect, parameter", CLASHES, ids=IDS)
def test_a_table_under_a_name_that_is_both_is_the_places(read, effect, parameter):
    """It means the same as the table of a place with another name."""
    table = lines(given(effect, parameter))
    if set(given(effect, parameter)) == {parameter.name}:
        return  # of one parameter: the table is refused below
    there = read(effect.place, parameter.name, f"[effects.{effect.name}.{parameter.name}]\n{table}")
    other = read(effect.place, "plain", f"[effects.{effect.name}.plain]\n{table}")
    assert there == {parameter.name: other["plain"]}


@both
def test_a_table_that_could_be_either_is_refused_with_the_way_round(read, effect, parameter):
    name, several = parameter.name, SEVERAL[effect.place]
    table = f"[effects.{effect.name}.{name}]\n{name} = {value(parameter)}\n"
    with pytest.raises(SceneError) as caught:
        read(effect.place, name, table)
    assert caught.value.where == f"effects.{effect.name}.{name}"
    assert f"{name!r} is a {several[:-1].replace('bodie', 'body')} and a parameter" in str(
        caught.value)
    assert f'wanted {several} = ["{name}"] with numbers' in str(caught.value)
    values = lines(given(effect, parameter))
    several_of = f'[effects.{effect.name}]\n{several} = ["{name}"]\n'
    round_ = read(effect.place, name, several_of + values)
    plain = read(effect.place, "plain", f"[effects.{effect.name}.plain]\n{values}")
    assert round_ == {name: plain["plain"]}


@both
def test_a_table_under_a_parameters_name_alone_is_by_places(read, effect, parameter):
    values = {key: text for key, text in given(effect, parameter).items() if key != parameter.name}
    if parameter.name == effect.chosen_by or parameter.kind in WRITTEN:
        return  # the rest depends on it; and lists are given in the tables of their places
    if parameter.name in SHARES:
        return  # none of these numbers
    text = (f"[effects.{effect.name}]\n{lines(values)}"
            f"{parameter.name} = {{ plain = 2, other = 3 }}\n")
    if parameter.kind in ("choice", "flag"):
        word = value(parameter)
        text = text.replace("= 2,", f"= {word},").replace("= 3", f"= {word}")
    result = read(effect.place, "plain", text)
    assert set(result) == {"plain", "other"}
    if parameter.kind == "number":
        assert [result[x][parameter.name] for x in ("plain", "other")] == [2, 3]


def test_labels_are_no_parameters(read):
    push = "[effects.wrench.{0}]\nbody = 'hull'\nforce = [1, 0, 0]\n"
    assert read(Place.BODY, "hull", push.format("gust"))
    with pytest.raises(SceneError, match="'force' is a parameter; wanted another label"):
        read(Place.BODY, "hull", push.format("force"))


def test_joints_and_bodies_may_be_called_as_the_lists_of_them(read):
    drag = "[effects.drag.bodies]\nkind = 'stokes'\nb = 3\n"
    assert read(Place.BODY, "bodies", drag)["bodies"]["b"] == 3
    assert read(Place.JOINT, "joints", "[effects.viscous.joints]\nd = 3\n") == {"joints": {"d": 3}}


def test_the_body_b_has_drag(read):
    drag = "[effects.drag.b]\nkind = 'stokes'\nb = 3\n"
    assert read(Place.BODY, "b", drag)["b"]["b"] == 3
