"""Files of other kinds and encodings are read where that is safe, or named with what to do."""

import codecs
import os

import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.readers.model_formats import readers
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.example_effects import CATALOGUE
from tests.support.scenes.reading import ARM, read_urdf

BODY = ARM.removeprefix('<?xml version="1.0"?>\n')
GREEK = BODY.replace('"tip"', '"ώμος"')
CHINESE = BODY.replace('"tip"', '"肩关节"')
LFS = (b"version https://git-lfs.github.com/spec/v1\n"
       b"oid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n")


def declared(encoding, text=BODY):
    return f'<?xml version="1.0" encoding="{encoding}"?>\n{text}'


READ = {
    "blank lines before the declaration": f"\n \r\n{ARM}".encode(),
    "byte order mark": b"\xef\xbb\xbf" + ARM.encode(),
    "byte order mark and blank line": b"\xef\xbb\xbf\n" + ARM.encode(),
    "no declaration": BODY.encode(),
    "UTF-16 of PowerShell": codecs.BOM_UTF16_LE + declared("utf-8").encode("utf-16-le"),
    "UTF-16, high byte first": codecs.BOM_UTF16_BE + ARM.encode("utf-16-be"),
    "UTF-16 without a mark": ARM.encode("utf-16-le"),
    "UTF-32": codecs.BOM_UTF32_LE + ARM.encode("utf-32-le"),
    "UTF-32 without a mark": ARM.encode("utf-32-le"),
    "UTF-32 without a mark, high byte first": ARM.encode("utf-32-be"),
    "comment before the root": f"<!-- xacro ${{x}} & more -->\n{BODY}".encode(),
    "lines of other systems": ARM.replace("\n", "\r\n").encode()}


@pytest.mark.parametrize("contents", READ.values(), ids=READ)
def test_what_is_unambiguous_is_read(tmp_path, contents):
    plain, path = tmp_path / "plain.urdf", tmp_path / "arm.urdf"
    plain.write_text(ARM)
    path.write_bytes(contents)
    assert read_urdf(path) == read_urdf(plain)


@pytest.mark.parametrize("encoding, text, name", [
    ("GBK", CHINESE, "肩关节"), ("gb18030", CHINESE, "肩关节"), ("Big5", CHINESE.replace(
        "关节", "節"), "肩節"), ("shift_jis", CHINESE.replace("肩关节", "肩"), "肩"),
    ("ISO-8859-7", GREEK, "ώμος"), ("windows-1253", GREEK, "ώμος"), ("utf-8", GREEK, "ώμος"),
    ("iso-8859-1", BODY.replace('"tip"', '"été"'), "été")])
def test_declared_encodings_are_read(tmp_path, encoding, text, name):
    path = tmp_path / "arm.urdf"
    path.write_bytes(declared(encoding, text).encode(encoding))
    assert read_urdf(path).joints[-1].name == name


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
def test_names_beyond_ascii_need_no_byte_order_mark(tmp_path, encoding):
    path = tmp_path / "arm.urdf"
    path.write_bytes(GREEK.encode(encoding))
    assert read_urdf(path).joints[-1].name == "ώμος"


def test_lines_are_counted_from_the_beginning_of_the_file(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text("\n\n" + ARM.replace('value="1.5"', 'value="x"'))
    with pytest.raises(SceneError, match=r"line 10, body 'upper': 'value' of <mass>"):
        read_urdf(path)


REFUSED = {
    "LFS pointer": (LFS, "is a pointer of Git LFS, not the file itself; run `git lfs pull`"),
    "MJCF": (b"<mujoco model='a'/>", "is MJCF, the format of MuJoCo; wanted a name that "
             "ends in .xml"),
    "SDF": (b"<?xml version='1.0'?><sdf version='1.7'/>", "is SDF, the format of Gazebo; wanted a "
            "name that ends in .sdf"),
    "web page": (b"<!DOCTYPE html><html/>", "is a web page, not the file it shows; wanted the raw"),
    "web page without a type": (b"<html><body>404</body></html>", "is a web page"),
    "launch file": (b"<launch/>", "is a launch file of ROS; wanted the URDF that it loads"),
    "capital root": (b"<Robot/>", "the root is <Robot>; wanted <robot>"),
    "empty": (b"", "is empty; wanted a URDF"), "blank": (b" \n\n", "is empty; wanted a URDF"),
    "no XML": (b"name: arm\njoints: []\n", "'name: arm' is no XML; wanted a URDF"),
    "warnings before": (b"xacro: in-order processing became default\n" + ARM.encode(),
                        "line 1: text stands before the XML, 'xacro: in-order processing became "
                        "default'; wanted <?xml or the root first: delete what precedes it"),
    "comment before the declaration": (b"<!-- arm -->\n" + ARM.encode(), "line 2: <?xml … ?> "
                                       "stands after something else; wanted it at the beginning"),
    "bare &": (ARM.replace('"grey"', '"black & white"').encode(),
               "line 3: a bare &; wanted &amp;"),
    "bare & before a word": (ARM.replace('"grey"', '"R&D"').encode(), "line 3: a bare &"),
    "<": (ARM.replace('"grey"', '"a<b"').encode(), "line 3: a < in an attribute; wanted &lt;"),
    "zero at the end": (ARM.encode() + b"\0", "the character U+0000 is not allowed here; delete"),
    "control character": (ARM.replace("grey", "été\x07").encode(), "line 3: the character U+0007"),
    "unknown entity": (ARM.replace('"grey"', '"&nbsp;"').encode(), "undefined entity"),
    "Latin without declaration": (ARM.replace("grey", "été").encode("latin-1"),
                                  "line 3: the byte 0xe9 is not UTF-8, and the file declares no "
                                  "other encoding; wanted UTF-8, or the encoding in the first"),
    "GBK without declaration": (ARM.replace("grey", "肩").encode("gbk"), "is not UTF-8"),
    "GBK that is declared UTF-8": (declared("utf-8", CHINESE).encode("gbk"),
                                   "is not utf-8, which the file declares"),
    "unknown encoding": (declared("klingon").encode(), "the encoding 'klingon' is unknown"),
    "encoding that is none": (declared("hex").encode(), "the encoding 'hex' is unknown"),
    "encoding without ASCII": (declared("utf-7").encode(), "the encoding 'utf-7' is unknown"),
    "encoding of other letters": (declared("cp037").encode(), "the encoding 'cp037' is unknown"),
    "encoding of escapes": (declared("unicode_escape").encode(), "'unicode_escape' is unknown"),
    "encoding of rarer escapes": (declared("raw_unicode_escape").encode(), "is unknown"),
    "xacro's element": (BODY.replace("<link", "<xacro:macro/><link", 1).encode(),
                        "<xacro:macro>: this is a file of xacro; run `xacro arm.urdf > "
                        "arm_expanded.urdf` and read that"),
    "xacro's element in a link": (BODY.replace("<inertial>", "<xacro:if value='1'/><inertial>", 1)
                                  .encode(), "line 5, body 'upper': <xacro:if>"),
    "xacro's element in an inertial": (BODY.replace("<mass", "<xacro:mass/><mass", 1).encode(),
                                       "body 'upper': <xacro:mass>"),
    "xacro's expression": (BODY.replace('value="1.5"', 'value="${m}"').encode(), "body 'upper': "
                           "'value' of <mass>, '${m}', is for xacro; run `xacro arm.urdf >"),
    "xacro's expression that nothing uses": (BODY.replace('effort="100"', 'effort="${e}"').encode(),
                                             "joint 'shoulder': 'effort' of <limit>, '${e}', is"),
    "UTF-16 that is none": (declared("utf-16").encode(), "'utf-16' is unknown, or not that of"),
    "xacro's name": (BODY.replace('"tool"', '"$(arg prefix)tool"').encode(), "is for xacro"),
}


@pytest.mark.parametrize("contents, words", REFUSED.values(), ids=REFUSED)
def test_other_kinds_are_named_with_what_to_do(tmp_path, contents, words):
    (tmp_path / "arm.urdf").write_bytes(contents)
    scene = tmp_path / "scene.toml"
    scene.write_text('model = "arm.urdf"\n')
    for read in (read_urdf, load_scene):
        for path in (tmp_path / "arm.urdf", scene):
            if (read, path) == (read_urdf, scene):
                continue
            with pytest.raises(SceneError) as caught:
                read(path)
            assert words in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("name, contents, words", [
    ("arm.dae", b"", "is Collada, a format of meshes, which coscrew does not read"),
    ("arm.launch", b"", "is a launch file of ROS"), ("arm.srdf", b"", "belongs to a URDF"),
    ("arm", b"", "has no suffix"), ("arm.yaml", b"", "has the suffix '.yaml'")])
def test_other_suffixes_are_named_with_what_to_do(tmp_path, name, contents, words):
    path, scene = tmp_path / name, tmp_path / "scene.toml"
    path.write_bytes(contents)
    scene.write_text(f'model = "{name}"\n')
    for file, wanted in ((path, "; wanted a scene (.toml) or a model ("), (scene, "a model (")):
        with pytest.raises(SceneError) as caught:
            read_scene(file, CATALOGUE)
        assert words in str(caught.value) and wanted in str(caught.value)
        assert all(x in str(caught.value) for reader in readers() for x in reader.suffixes)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs POSIX")
@pytest.mark.parametrize("name", ["arm.urdf", "arm.toml"])
def test_pipes_are_refused_before_they_are_opened(tmp_path, name):
    scene = tmp_path / "scene.toml"
    scene.write_text('model = "arm.urdf"\n')
    os.mkfifo(tmp_path / name)
    for path in (tmp_path / name, *([scene] if name == "arm.urdf" else [])):
        with pytest.raises(SceneError, match="no regular file"):
            read_scene(path, CATALOGUE)


def test_a_scene_may_be_a_pointer_of_git_lfs(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_bytes(LFS)
    with pytest.raises(SceneError, match="run `git lfs pull` in its repository"):
        read_scene(path, CATALOGUE)
