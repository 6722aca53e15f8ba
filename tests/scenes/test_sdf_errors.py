"""SDF files: what is not understood is refused, with the line and what was wanted."""

import pytest

from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.sdf_texts import chain, hinge, inertial


@pytest.fixture
def read(tmp_path):
    def read(text, **overrides):
        (tmp_path / "arm.sdf").write_text(text)
        return read_scene(tmp_path / "arm.sdf", overrides=SceneOverrides(**overrides))

    return read


REFUSED = {
    "other version": (chain(hinge(), "2.0"), "line 1: version '2.0' of SDF; wanted 1.3 to 1.12"),
    "root": ("<robot/>", "line 1: the root is <robot>; wanted <sdf>"),
    "empty": ("", "is empty; wanted an SDF"),
    "two models": ('<sdf version="1.9"><model name="m"/><model name="n"/></sdf>',
                   "holds 2 models and 0 worlds; wanted one model"),
    "none": ('<sdf version="1.9"/>', "holds 0 models and 0 worlds"),
    "static": (chain(hinge(), more="<static>1</static>"), "model 'm': is static: nothing moves"),
    "include": (chain(hinge(), more="<include><uri>x</uri></include>"), "in another file; wanted"),
    "element": (chain(hinge().replace("axis>", "axes>")), "unknown element <axes> in <joint>; did "
                "you mean 'axis'?"),
    "attribute": (chain(hinge(pose='<pose relativ_to="a"/>')), "unknown attribute 'relativ_to' of "
                  "<pose>; did you mean 'relative_to'?"),
    "element in a text": (chain(hinge("<xyz><x>1</x></xyz>")), "unknown element <x> in <xyz>"),
    "text among elements": (chain(hinge("0 0 1")), "<axis> holds the text '0 0 1'"),
    "type": (chain(hinge(kind="hinge")), "joint 'j': type 'hinge'; wanted one of revolute, contin"),
    "screw": (chain(hinge(kind="screw")), "type 'screw'; wanted one of revolute"),
    "gearbox": (chain(hinge(kind="gearbox")), "<joint> lacks <gearbox_reference_body>"),
    "parent": (chain(hinge(parent="aa")), "no frame 'aa'; did you mean 'a'?"),
    "frame": (chain(hinge(pose='<pose relative_to="c">0 0 0 0 0 0</pose>')), "no frame 'c'"),
    "circle": (chain(hinge(pose='<pose relative_to="f"/>'), more='<frame name="f"><pose relative_to'
                     '="j"/></frame>'), "are relative to one another; wanted one that is not"),
    "attached in a circle": (chain(hinge(), more='<frame name="f" attached_to="g"/><frame name="g" '
                                   'attached_to="f"/>'), "attached to one another; wanted a link"),
    "zero axis": (chain(hinge("<xyz>0 0 0</xyz>")), "the axis is zero; wanted a direction"),
    "no axis": (chain(hinge().replace("<axis><xyz>0 0 1</xyz></axis>", "")), "lacks <axis>"),
    "too many axes": (chain(hinge().replace("</joint>", "<axis2/></joint>")), "<axis2> of a "
                      "revolute joint; wanted none"),
    "numbers": (chain(hinge("<xyz>0 1</xyz>")), "<xyz> of <axis>: '0 1'; wanted 3 numbers"),
    "no number": (chain(hinge("<xyz>0 x 1</xyz>")), "<xyz> of <axis>: 'x' is no number"),
    "negative": (chain(hinge("<xyz>0 0 1</xyz><dynamics><damping>-1</damping></dynamics>")),
                 "<damping> of <dynamics> is -1; wanted 0 or more"),
    "limits": (chain(hinge("<xyz>0 0 1</xyz><limit><lower>2</lower><upper>1</upper></limit>")),
               "lower, 2, is above upper, 1"),
    "mass": (chain(hinge()).replace("<mass>1<", "<mass>0<", 1), "mass 0 kg, for which other "
             'programs take 1 kg, or none; wanted a positive mass, or implausible = "warn": none'),
    "negative mass": (chain(hinge()).replace("<mass>1<", "<mass>-1<", 1), "wanted a positive mass"),
    "twice": (chain(hinge()).replace("<mass>1</mass>", "<mass>1</mass>" * 2, 1), "<mass> occurs "
              "twice in <inertial>"),
    "weightless": (chain(hinge()).replace("</link>", "<gravity>0</gravity></link>", 1),
                   "link 'a': <gravity> is 0; wanted true"),
    "decay": (chain(hinge()).replace("</link>", "<velocity_decay><linear>1</linear>"
                                     "</velocity_decay></link>", 1),
              "<velocity_decay> is not supported"),
    "moments by shape": (chain(hinge()).replace("<inertial>", '<inertial auto="true">', 1),
                         "(auto)"),
    "pose of masses": (chain(hinge()).replace("<inertial><pose>", "<inertial><pose relative_to="
                                              "'b'>", 1), "relative to its link; wanted no rel"),
    "frame of a pose": (chain(hinge(pose='<pose frame="a">0 0 0 0 0 0</pose>')), "frame 'a' of "
                        "<pose>; wanted relative_to"),
    "form": (chain(hinge(pose='<pose rotation_format="wxyz">0 0 0 0 0 0</pose>')),
             "rotation_format 'wxyz'; wanted euler_rpy or quat_xyzw"),
    "quaternion": (chain(hinge(pose='<pose rotation_format="quat_xyzw">0 0 0 0 0 0 0</pose>')),
                   "quaternion that is zero"),
    "reserved": (chain(hinge(name="world")), "name 'world' of <joint>; wanted one line of text"),
    "two of one name": (chain(hinge() + hinge()), "joint 'j': the <joint> in line 1 has this name, "
                        "too; wanted another one"),
    "link and joint": (chain(hinge(name="a")), "joint 'a': the <link> in line 1 has this"),
    "world": (chain(hinge()).replace('"a"', '"world"'), "name 'world' of <link>; wanted one line"),
    "one link": (chain(hinge(parent="b")), "joint 'j': parent and child are the same body, 'b'"),
    "several roots": (chain(""), "several roots ('a', 'b')"),
    "flag": (chain(hinge(), more="<static>no</static>"), "static 'no' of <model>; wanted true "),
    "impossible": (chain(hinge()).replace("<ixx>0.05", "<ixx>5"), "line 1, body 'a': "),
    "mimic": (chain(hinge('<mimic joint="k"><multiplier>1</multiplier></mimic>')), "no frame 'k'"),
}


@pytest.mark.parametrize(("text", "words"), REFUSED.values(), ids=REFUSED)
def test_what_is_not_understood_is_refused_with_its_line(read, text, words):
    with pytest.raises(ValueError, match="arm.sdf: ") as caught:
        read(text)
    assert words in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(("old", "lacks", "taken"), (
    (inertial(1), "inertial", "1 kg and 1 kg m²"), ("<mass>1</mass>", "mass", "1 kg"),
    ("<inertia>" + inertial(1).partition("<inertia>")[2].partition("</inertial>")[0], "inertia",
     "1 kg m²")))
def test_defaults_of_inertias_are_taken_on_demand(read, old, lacks, taken):
    text = chain(hinge()).replace(old, "", 1)
    with pytest.raises(ValueError, match=f"lacks <{lacks}>, for which SDF takes {taken}; wanted "):
        read(text)
    model = read(text, implausible="warn").model
    assert model.implausible[0] == f"body 'a': lacks <{lacks}>; SDF takes {taken}"
    inertia = model.bodies[0].inertia
    assert lacks == "inertia" or inertia.mass == 1
    assert lacks == "mass" or inertia.moments == (1, 1, 1, 0, 0, 0)


def test_a_mass_of_zero_is_none_on_demand(read):
    scene = read(chain(hinge()).replace("<mass>1<", "<mass>0<", 1), implausible="warn")
    assert scene.model.bodies[0].inertia is None
    assert scene.model.implausible == (
        "body 'a': mass 0 kg; taken as a frame without inertia",)
