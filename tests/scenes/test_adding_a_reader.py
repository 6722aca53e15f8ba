"""A reader of models is one file: CONTRIBUTING's tables of Denavit and Hartenberg's parameters, in
a copy of the generator, are models of scenes, and in messages and the reference."""

import json
import math
from pathlib import Path

import mpmath
import pytest

from coscrew_codegen.scene.mechanism.model import Body, Joint
from coscrew_codegen.scene.readers.model_formats import by_suffix, reader_of, readers, stem
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.scene_error import SceneError
from tests.support.scenes.kinds import Kind
from tests.support.walks import command, copied, run_in_copy, walk

CHAIN = """# joint kind a alpha d theta mass x y z xx yy zz
shoulder revolute 0 0 0.25 0 2 0.25 0 0 0.01 0.02 0.02

elbow revolute 0.5 0 0 0.5 1 0.125 0 0 0.01 0.01 0.01  # its angle counts from 0.5
rod prismatic 0.25 1.5707963267948966 0.75 0 0.5 0 0 0.125 0.001 0.001 0.001
"""
SCENE = 'model = "chain.dh"\nfunctions = ["gravity_torques", "body_poses"]\n' \
        "[effects.gravity]\ng = [0, -10, 0]\n"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the generator that has the reader, and a scene whose model it reads."""
    folder = tmp_path_factory.mktemp("site")
    assert [x.name for x in walk(copied(folder), "dh_table")] == ["dh_table.py"]
    (folder / "chain.dh").write_text(CHAIN)
    (folder / "chain.toml").write_text(SCENE)
    return folder


def torques(q1: float, q2: float, q3: float) -> list[mpmath.mpf]:
    """m g times horizontal distances: the rod slides along -y of the elbow's frame, 0.25 from its
    axis."""
    with mpmath.workdps(50):
        one, both = mpmath.mpf(q1), mpmath.mpf(q1) + q2 + mpmath.mpf("0.5")
        c1, c12, s12 = mpmath.cos(one), mpmath.cos(both), mpmath.sin(both)
        out = mpmath.mpf("0.75") + q3 + mpmath.mpf("0.125")  # from the elbow to the rod's centre
        elbow = 10 * (c12 / 8 + (c12 / 4 + out * s12) / 2)
        return [10 * (2 * c1 / 4 + c1 / 2 + c1 / 4) + elbow, elbow, -10 * c12 / 2]


@pytest.fixture(scope="module")
def read(site: Path) -> dict[str, object]:
    """Results and messages of the copy."""
    (site / "wrong.dh").write_text(CHAIN.replace("rod prismatic", "rod slider"))
    (site / "heavy.dh").write_text(CHAIN.replace("0.5 1 0.125", "0.5 -1 0.125"))
    (site / "twice.dh").write_text(CHAIN.replace("elbow", "shoulder"))
    (site / "short.dh").write_text("shoulder revolute 0 0\n")
    (site / "number.dh").write_text(CHAIN.replace("0.25 0 2", "0.25 0 two"))
    return json.loads(run_in_copy(site, (
        "import json\nfrom coscrew_codegen import load_scene\n"
        "from coscrew_codegen.scene.readers.toml.toml_scene import read_scene\n"
        "from coscrew_codegen.reports.reference.scene_pages import keys_page\n"
        "its = load_scene('chain.toml').double\nq = [0.375, -1.25, 0.5]\n"
        "def said(file):\n"
        "    try:\n        return repr(read_scene(file))\n"
        "    except ValueError as error:\n        return str(error)\n"
        "print(json.dumps({'torques': its.gravity_torques(q).tolist(),\n"
        "  'rod': its.body_poses(q)[2].tolist(), 'page': keys_page('banner'),\n"
        "  'joints': [x.name for x in read_scene('chain.dh').model.joints],\n"
        "  'said': {x: said(x) for x in ('wrong.dh', 'heavy.dh', 'twice.dh', 'short.dh',\n"
        "                                'number.dh', 'none.dh', 'chain.dhh')}}))\n")))


def test_its_model_moves_as_the_parameters_say(read):
    assert read["joints"] == ["shoulder", "elbow", "rod"]
    for x, y in zip(read["torques"], torques(0.375, -1.25, 0.5), strict=True):
        assert abs(mpmath.mpf(x) - y) <= 8 * math.ulp(20.0), (x.hex(), y)


@pytest.mark.parametrize(("file", "words"), (
    ("wrong.dh", "wrong.dh: line 5: kind 'slider'; wanted one of revolute, prismatic; did you mean "
                 "'prismatic'?"),
    ("heavy.dh", "heavy.dh: line 4, body 'elbow link': mass -1 kg; wanted a positive mass"),
    ("twice.dh", "twice.dh: line 4, body 'shoulder link': this name is given to two of them"),
    ("short.dh", "short.dh: line 1: 4 columns; wanted 13: joint, kind, a, alpha, "),
    ("number.dh", "number.dh: line 2: 'two' is no number; wanted a decimal number"),
    ("none.dh", "none.dh: cannot be read"),
    ("chain.dhh", "has the suffix '.dhh'; wanted a scene (.toml) or a model (.dh, "),
    ("chain.dhh", "; did you mean '.dh'?")))
def test_its_errors_name_the_place(read, file, words):
    assert words in read["said"][file]


def test_it_is_in_the_reference(read):
    assert "| DH table | `.dh` | a chain: for each joint the parameters in Craig's" in read["page"]


def test_commands_take_it_alone(site):
    done = command(site, "generate", "chain.dh", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert (site / "out/chain.h").is_file()


def of(name: str, *suffixes: str, **others: object) -> ModelReader:
    """A format whose files all hold one wheel."""
    parts = Parts(name, (Body("wheel"),), (Joint("pin", Kind.REVOLUTE, "world", "wheel"),))
    return ModelReader(name, suffixes, "a wheel", lambda source: parts, **others)


def test_the_extra_that_it_needs_is_named(tmp_path):
    wheel = of("Wheel", ".wheel", modules=("json", "no_such_package"), extra="wheels")
    with pytest.raises(SceneError, match=r"a.wheel: is Wheel, which needs no_such_package; run "
                                         r"`pip install \"coscrew\[wheels\]\"`"):
        wheel.read(ModelSource(tmp_path / "a.wheel"))
    model = of("Wheel", ".wheel", modules=("json",)).read(ModelSource(tmp_path / "a.wheel"))
    assert [x.name for x in model.joints] == ["pin"]


@pytest.mark.parametrize(("formats", "words"), (
    ((of("A", ".a"), of("B", ".b", ".a")), "A and B both read files with the suffix '.a'"),
    ((of("A", "a"),), "the format A has the suffix 'a'; wanted a dot and small letters"),
    ((of("A", ".A"),), "has the suffix '.A'; wanted a dot and small letters"),
    ((of("A", ".toml"),), "has the suffix '.toml'; wanted a dot and small letters, and not .toml")))
def test_suffixes_that_cannot_be_are_refused(formats, words):
    with pytest.raises(ValueError, match=words):
        by_suffix(formats)


def test_the_longest_suffix_counts(monkeypatch):
    """In small or capital letters."""
    short, long = of("Short", ".arm"), of("Long", ".left.arm")
    monkeypatch.setattr("coscrew_codegen.scene.readers.model_formats.readers",
                        lambda: (short, long, *readers()))
    assert reader_of(Path("x/my.left.arm")) is long and stem(Path("x/my.left.arm")) == "my"
    assert reader_of(Path("my.Arm")) is short and stem(Path("my.Arm")) == "my"
    assert reader_of(Path("my.arms")) is None and stem(Path("my.arms")) == "my"
