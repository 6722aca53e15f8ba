"""The names in docs/glossary.md and in the guides for users of other libraries exist."""

import re
from pathlib import Path

import mujoco
import pinocchio as pin
import pytest

import coscrew
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.functions import FUNCTIONS
from coscrew_codegen.scene.readers.toml.keys import TYPES

ROOT = Path(__file__).parents[2]
GLOSSARY = (ROOT / "docs/glossary.md").read_text(encoding="utf-8").split("\nWords of our own")[0]
ROWS = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        for line in GLOSSARY.splitlines() if line.startswith("|")]
HEADERS = "".join(path.read_text(encoding="utf-8")
                  for path in sorted((ROOT / "generated/c/include/ksl").glob("*.h")))
SCENES = {*(x.name for x in FUNCTIONS), "q", "v", "tau"}


def named(column: str) -> list[str]:
    place = ROWS[0].index(column)
    results = [name for row in ROWS[2:] for name in re.findall(r"`([^`]+)`", row[place])]
    assert len(results) > 10
    return results


def of_scenes(name: str) -> bool:
    return name in SCENES or name.startswith(("jacobian_", "reaction_"))


def test_the_table_is_whole():
    assert {len(row) for row in ROWS} == {7} and len(ROWS) > 30


def test_our_names_exist():
    known = {effect.name for effect in EFFECTS} | set(TYPES) | {"[R \\| t]", 'base = "free"'}
    keys = (ROOT / "generated/docs/scene_keys.md").read_text(encoding="utf-8")
    for name in named("here"):
        assert hasattr(coscrew, name) or of_scenes(name) or name in known \
            or f"## {name}\n" in keys, name


def test_our_c_names_exist():
    for name in named("C"):
        if name.startswith("ksl_"):
            assert re.search(rf"\b{name}\b", HEADERS), name
        else:
            assert of_scenes(name.removeprefix("arm_")), name


def test_ksls_names_exist():
    known = (ROOT / "tests/references/ksl_prototypes.txt").read_text()
    for name in named("KSL"):
        bare = name.removeprefix("ksl_").removesuffix("_t")
        assert name.startswith("[") or re.search(rf"\b(ksl_)?{bare}\b", known), name


def in_pinocchio(name: str) -> bool:
    """Returns whether Pinocchio has `SE3.action`, `model.armature`, `exp6`, `JointModelRevolute…`.
    """
    first, *rest = re.sub(r"\(.*\)$", "", name).split(".")
    model = pin.Model()
    roots = {"model": model, "data": model.createData(), "coeffs": pin.Quaternion.coeffs}
    if first.endswith("…"):
        return any(x.startswith(first[:-1]) for x in dir(pin))
    result = roots.get(first, getattr(pin, first, None))
    for attribute in rest:
        result = getattr(result, attribute, None)
    return result is not None


def test_pinocchios_names_exist():
    for name in named("Pinocchio"):
        assert name in ("q", "v", "tau", "LOCAL") and hasattr(pin, "LOCAL") or in_pinocchio(name), \
            name
    assert not in_pinocchio("SE3.nonsense") and not in_pinocchio("nonsense")


@pytest.fixture(scope="module")
def mujocos() -> set[str]:
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><freejoint/><geom size="1"/><body><joint type="ball"/>'
        '<geom size="1"/><body><joint type="slide"/><geom size="1"/><body><joint type="hinge" '
        'armature="1"/><geom size="1"/></body></body></body></body></worldbody></mujoco>')
    return {*dir(mujoco), *dir(model), *dir(mujoco.MjData(model)),
            "freejoint", "ball", "slide", "hinge", "armature"}  # which the model above has


def test_mujocos_names_exist(mujocos):
    for name in named("MuJoCo"):
        assert name in mujocos, name


@pytest.mark.parametrize("guide, column", (("from_pinocchio", 1), ("from_mujoco", 2)))
def test_guides_name_operations_and_effects_there_are(guide, column):
    """In our column of the table, whatever looks like a name of ours is one."""
    text = (ROOT / f"docs/{guide}.md").read_text(encoding="utf-8")
    cells = [re.split(r"(?<!\\)\|", line)[1 + column] for line in text.splitlines()
             if line.startswith("|")]
    names = {name for cell in cells for name in re.findall(r"`(\w+)(?:`|\()", cell)}
    effects = {effect.name for effect in EFFECTS}
    parameters = {parameter.name for effect in EFFECTS for parameter in effect.parameters}
    others = {"model", "leapfrog", "inertia", "spherical", "NEUTRAL_Q", "neutral_q", "T"}
    for name in names - effects - parameters - others:
        assert hasattr(coscrew, name) or of_scenes(name), name
    assert len(names) > 8
