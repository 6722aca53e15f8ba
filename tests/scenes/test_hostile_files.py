"""Hostile and broken files cause one clear error, with little memory."""

import contextlib
import resource

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.example_effects import CATALOGUE
from tests.support.scenes.reading import ARM, MODEL

DEEP = 10**6

BOMB = ('<?xml version="1.0"?><!DOCTYPE robot [<!ENTITY a "ha">'
        + "".join(f'<!ENTITY {chr(98 + i)} "{f"&{chr(97 + i)};" * 10}">' for i in range(12))
        + ']><robot name="&m;"/>')
QUADRATIC = ('<!DOCTYPE robot [<!ENTITY a "' + "x" * 10**5 + '">]><robot name="'
             + "&a;" * 10**4 + '"/>')

XML = {
    "empty": b"",
    "no XML": b"solid cube",
    "binary": bytes(range(256)),
    "zeros": b"\0" * 1000,
    "entity bomb": BOMB.encode(),
    "quadratic bomb": QUADRATIC.encode(),
    "external entity": b'<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>',
    "external DTD": b'<!DOCTYPE robot SYSTEM "http://localhost:1/x.dtd"><robot/>',
    "unknown entity": b'<robot name="&nothing;"/>',
    "deep": b"<robot>" + b"<link>" * DEEP,
    "deep in what is ignored": b"<robot><gazebo>" + b"<a>" * DEEP,
    "long name": b"<robot><" + b"a" * DEEP,
    "long tag": b"<" + b"a" * DEEP + b"/>",
    "long number": b'<robot><link name="a"><inertial><mass value="' + b"1" * DEEP
                   + b'"/></inertial></link></robot>',
    "wrong encoding": b'<?xml version="1.0" encoding="utf-8"?><robot name="\xff\xfe"/>',
    "unknown encoding": b'<?xml version="1.0" encoding="klingon"?><robot/>',
    "same attribute twice": b'<robot name="a" name="b"/>',
    "two roots": b"<robot/><robot/>",
    "crossing": b"<robot><link></robot></link>",
    "html": b"<html><body>404</body></html>",
    "no links": b"<robot/>",
    "nothing but what is ignored": b"<visual><robot/></visual>",
    "newline in a name": b'<robot><link name="a&#10;b"/></robot>',
    "two giant loops": b"<robot>" + b"".join(
        b'<link name="%d"/><joint name="%d" type="fixed"><parent link="%d"/><child link="%d"/>'
        b"</joint>" % (i, i, (i + 1) % 2000, i) for i in range(2000)) + b"</robot>",
}

TOML = {
    "no TOML": b"<robot/>",
    "binary": bytes(range(256)),
    "latin-1": "name = 'é'".encode("latin-1"),
    "empty": b"",
    "deep list": b"runtime = " + b"[" * 10**5,
    "deep inline table": b"start = " + b"{a=" * 10**5,
    "deep key": b"a." * 10**5 + b"a = 1",
    "deep header": b"[" + b"a." * 10**5 + b"a]",
    "deep quoted key": b'"a".' * 10**5 + b"a = 1",
    "huge integer": b"every = " + b"9" * 10**5,
    "huge hexadecimal": b"every = 0x" + b"9" * 10**5,
    "huge hexadecimal for a text": b"precision = 0x" + b"9" * 10**5,
    "huge float": MODEL.encode() + b"[outputs]\nevery = 0." + b"9" * 10**5,
    "huge exponent": MODEL.encode() + b"[outputs]\nevery = 1e999999999999",
    "long key": b"a" * 10**5 + b" = 1",
    "long text": b"precision = '" + b"a" * 10**5 + b"'",
    "same key twice": b"model = 'a.urdf'\nmodel = 'b.urdf'",
    "a file of itself": b"model = 'hostile.toml'",
    "a folder": b"model = '/'",
    "a device": b"model = '/dev/zero'",
    "zero in a path": b'model = "a\\u0000.urdf"',
    "deep formula": MODEL.encode() + b"[effects.motor.elbow]\nu = '" + b"(" * 900 + b"'",
    "long formula": MODEL.encode() + b"[effects.motor.elbow]\nu = '" + b"1+" * 10**5 + b"1'",
    "tower": MODEL.encode() + b"[effects.motor.elbow]\nu = '9**9**9**9**9'",
    "exploding": MODEL.encode() + b"[effects.motor.elbow]\nu = 'exp(exp(exp(exp(9))))'",
    "code": MODEL.encode() + b"[effects.motor.elbow]\nu = '__import__(\"os\").getpid()'",
}


@pytest.fixture
def refused(tmp_path):
    """Reads a hostile file; returns the line with which it is refused."""

    def refused(name, contents):
        path = tmp_path / name
        path.write_bytes(contents)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        with pytest.raises(SceneError) as caught:
            read_scene(path, CATALOGUE)
        assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory < 200 * 2**10  # KiB
        message = str(caught.value)
        assert "\n" not in message and len(message) < 1000 + len(str(path))
        assert message.startswith(str(path))
        return message

    return refused


@pytest.mark.parametrize("name", XML)
def test_hostile_xml(refused, name):
    refused("hostile.urdf", XML[name])


@pytest.mark.parametrize("name", TOML)
def test_hostile_toml(refused, name):
    refused("hostile.toml", TOML[name])


def test_document_types_are_named_as_the_reason(refused):
    for name in ("entity bomb", "external entity", "external DTD"):
        assert "<!DOCTYPE" in refused("bomb.urdf", XML[name])
    assert "line 1" in refused("deep.urdf", XML["deep"])


@pytest.mark.parametrize("end", range(1, len(ARM) - 1, 41))
def test_truncated_xml(refused, end):
    assert "line " in refused("arm.urdf", ARM.encode()[:end])


def test_truncated_toml(tmp_path):
    """A truncated TOML file may still be valid; otherwise it causes a SceneError."""
    text = MODEL + '[effects.viscous]\njoints = "all"\nd = "model"\n'
    path = tmp_path / "arm.toml"
    reads = 0
    for end in range(0, len(text), 2):
        path.write_text(text[:end])
        try:
            read_scene(path, CATALOGUE)
            reads += 1
        except SceneError as error:
            assert str(error).startswith(str(path)) and "\n" not in str(error)
    assert 0 < reads < len(text) // 4


@pytest.mark.parametrize("suffix", [".urdf", ".toml"])
def test_files_that_cannot_be_read(tmp_path, suffix):
    with pytest.raises(SceneError, match="cannot be read"):
        read_scene(tmp_path / f"none{suffix}", CATALOGUE)
    (tmp_path / f"folder{suffix}").mkdir()
    with pytest.raises(SceneError, match="cannot be read"):
        read_scene(tmp_path / f"folder{suffix}", CATALOGUE)
    with pytest.raises(SceneError, match=r"wanted a scene \(.toml\) or a model \(.*\.urdf"):
        read_scene(tmp_path / "arm.yaml", CATALOGUE)


def test_huge_files_are_not_read(tmp_path):
    path = tmp_path / "huge.urdf"
    with path.open("wb") as file:
        file.truncate(10**10)
    with pytest.raises(SceneError, match="larger than 64 MiB"):
        read_scene(path, CATALOGUE)


def test_every_byte_of_a_file_may_be_wrong(tmp_path):
    """Each of these can be read, or raises a SceneError and no other error."""
    path = tmp_path / "arm.urdf"
    for place in range(0, len(ARM), 11):
        for byte in (b"\0", b"<", b'"', b"&", b"\xff", b"9"):
            path.write_bytes(ARM.encode()[:place] + byte + ARM.encode()[place + 1:])
            with contextlib.suppress(SceneError):
                read_scene(path, CATALOGUE)


NUMBERS = ("nan", "inf", "-inf", "1e400", "-1e400", "9" * 400, "0x" + "f" * 300, "1e-400", "true",
           "[]", "{}", "''", "1979-05-27", "'nan'", "'1/0'", "'sqrt(-1)'", "'2'")
PLACES = {"mass": "mass = 1.5", "com": "com = [0, 0, 0.25]",
          "inertia": "inertia = [0.1, 0.1, 0.01]",
          "axis": "axis = [1, 0, 0]", "damping": "damping = 0.25", "lower": "lower = -1",
          "xyz": "xyz = [0, 0, 0.5]", "rpy": "rpy = [1.57079632679, 0, 0]",
          "multiplier": "multiplier = 0.5"}


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("number", NUMBERS, ids=lambda text: text[:12])
def test_what_is_no_number_is_refused_wherever_one_is_wanted(refused, place, number):
    old = PLACES[place]
    assert old in MODEL
    for new in (f"{place} = {number}", f"{place} = [{number}, {number}, {number}]"):
        refused("arm.toml", MODEL.replace(old, new, 1).encode())


@pytest.mark.parametrize("contents, words", [
    (MODEL.encode("utf-16"), "is not UTF-8"), (b"# \xe9\n" + MODEL.encode(), "is not UTF-8"),
    (MODEL.replace("\n", "\r").encode(), "wanted a TOML file"),
    (MODEL.encode() + b"\0", "wanted a TOML file"),
    (MODEL.encode() + b"[bodies.tool]\nmass = 1\n", "wanted a TOML file"),
    (MODEL.replace("mass = 1.5", "mass = 1.5\nmass = 2").encode(), "wanted a TOML file")])
def test_files_of_other_encodings_and_doubled_keys(refused, contents, words):
    assert words in refused("arm.toml", contents)


def test_marks_of_byte_order_and_of_other_systems_lines_are_read(tmp_path):
    path = tmp_path / "arm.toml"
    for contents in (b"\xef\xbb\xbf" + MODEL.encode(), MODEL.replace("\n", "\r\n").encode()):
        path.write_bytes(contents)
        assert len(read_scene(path, CATALOGUE).model.bodies) == 3


@pytest.mark.parametrize("words", [
    "generate SCENE -o FILE", "generate SCENE -o FILE/x", "generate SCENE -o /dev/null/x",
    "generate SCENE", "generate FOLDER -o OUT", "generate none.toml -o OUT",
    "generate SCENE -o OUT --family vec3",
    "generate --family nope",
    "generate --precision nope", "generate --language nope", "simulate FOLDER",
    "simulate /dev/zero",
    "simulate none.toml", "simulate SCENE --output /none/x.csv", "simulate SCENE --output x.txt",
    "simulate SCENE --plot FOLDER", "simulate SCENE --view /none/x.html", "check none.toml",
    "cost none.toml", "cost SCENE --function nope", "cost SCENE --function step_rk4",
    "cost SCENE --function free_momentum", "cost SCENE --json /none/x.json",
    "cost SCENE --json x.txt", "cost SCENE --page FOLDER", "cost SCENE --plot x.pdf",
    "nope", "effects nope", "report --op nope", "report --minutes nan",
    "report --seed -1", "report --output /dev/null/x", "report --compare /none",
    "report --compare FILE", "report --hard-cases /none"])
def test_commands_end_in_one_line_and_write_nothing(tmp_path, capsys, words):
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "scene.toml").write_text(MODEL)
    (folder / "file").write_text("x")
    names = {"SCENE": folder / "scene.toml", "FILE": folder / "file", "FOLDER": folder,
             "OUT": tmp_path / "out"}
    given = [next((word.replace(x, str(path)) for x, path in names.items() if x in word), word)
             for word in words.split()]
    assert main(given) == 2
    captured = capsys.readouterr()
    lines = [x for x in captured.err.splitlines() if not x.startswith("scene.toml: joint ")]
    assert captured.out == "" and len(lines) == 1 and lines[0].startswith("coscrew: ")
    assert sorted(x.name for x in tmp_path.rglob("*")) == ["file", "in", "scene.toml"]


@pytest.mark.parametrize("words", [
    "simulate S --until nan", "simulate S --until -1", "simulate S --until 1e400",
    "simulate S --step 0", "simulate S --set x", "simulate S --set x=nan", "simulate S --set =1",
    "simulate S --precision half", "simulate S --implausible maybe", "simulate S more", "cost S "
    "--digits 5", "cost S --states 3", "", "--nope", "report --minutes x"])
def test_options_that_mean_nothing_end_in_usage_and_one_line(capsys, words):
    with pytest.raises(SystemExit) as ended:
        main(words.split())
    *usage, last = capsys.readouterr().err.splitlines()
    assert ended.value.code == 2 and usage[0].startswith("usage: coscrew") and "error: " in last
