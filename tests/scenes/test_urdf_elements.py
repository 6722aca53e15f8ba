"""Text in elements, misspelt and misplaced elements and names of URDF are refused by their line."""

import pytest

from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.urdf.urdf_schema import ATTRIBUTES, CHILDREN
from tests.support.scenes.reading import read_urdf

ARM = """<robot name="arm">
<link name="a"/>
<link name="b"><inertial>
<origin xyz="0 0 1"/>
<mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
</inertial></link>
<joint name="j" type="revolute">
<parent link="a"/>
<child link="b"/>
<axis xyz="0 0 1"/>
<limit lower="-1" upper="1"/>
<dynamics damping="1"/>
<mimic joint="k"/>
<calibration rising="0"/>
<safety_controller k_velocity="0"/>
</joint>
<link name="c"/>
<joint name="k" type="revolute"><parent link="a"/><child link="c"/></joint>
</robot>"""


@pytest.fixture
def read(tmp_path):
    def read(text):
        path = tmp_path / "arm.urdf"
        path.write_text(text)
        return read_urdf(path)

    return read


@pytest.fixture
def refused(read):
    """Reads a file; returns the place and the problem for which it is refused."""

    def refused(text):
        with pytest.raises(SceneError) as caught:
            read(text)
        assert "\n" not in str(caught.value)
        return caught.value.where, caught.value.problem

    return refused


def line_of(text, part):
    return f"line {1 + text.count(chr(10), 0, text.index(part))}"


# text

@pytest.mark.parametrize("tag", sorted(ATTRIBUTES.keys() - CHILDREN.keys()))
def test_text_in_elements_is_refused_with_the_attributes(refused, tag):
    element = next(line for line in ARM.splitlines() if line.startswith(f"<{tag} "))
    for inside in ("0 7 1", "\n 0 7 1 \n", "<![CDATA[0 7 1]]>", "<!-- here:\n --> 0 7 1"):
        text = ARM.replace(element, f"{element[:-2]}>{inside}</{tag}>")
        where, problem = refused(text)
        assert where.startswith(f"{line_of(text, '0 7 1')}, ")
        assert problem.startswith(f"<{tag}> holds the text '0 7 1'; wanted it in ")
        assert problem.endswith(", ".join(ATTRIBUTES[tag]))


@pytest.mark.parametrize("after, tag", [
    ('<link name="a"/>', "robot"), ("<inertial>", "inertial"), ('<mass value="1"/>', "inertial"),
    ("</inertial>", "link"), ('<parent link="a"/>', "joint")])
def test_text_between_elements_is_refused_if_it_holds_a_number(refused, tmp_path, after, tag):
    """Other texts, as comments that have lost their marks, are told."""
    text = ARM.replace(after, f"{after}\n\n mass 0.5\n", 1)
    where, problem = refused(text)
    assert where.split(",")[0] == line_of(text, "mass 0.5")
    assert problem.startswith(f"<{tag}> holds the text 'mass 0.5'; wanted elements: <")
    path = tmp_path / "comment.urdf"
    path.write_text(text.replace("mass 0.5", "# soft limits"))
    assert f"the text '# soft limits' in {line_of(text, 'mass 0.5')} is not used" in \
        "\n".join(x.text for x in read_urdf(path).notices)


@pytest.mark.parametrize("old, new", [
    ("</robot>", "<sensor>text</sensor><gazebo>text</gazebo>\n</robot>"),
    ("</inertial>", "</inertial><visual><name>text</name>text</visual><contact>text</contact>"),
    ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"> <!-- text -->\n\t</axis><friction_model>text'
     "</friction_model>")])
def test_text_of_other_tools_and_comments_are_free(read, old, new):
    assert read(ARM.replace(old, new)) == read(ARM)


# names that look like numbers

@pytest.mark.parametrize("tag, one, other", [
    ("parent", 'link="1"', 'link="1.0"'), ("child", 'link="1"', 'link="01"'),
    ("mimic", 'joint="1"', 'joint="1e0"')])
def test_names_are_no_numbers(read, refused, tag, one, other):
    links = ARM.replace("</robot>", """<link name="1"/><link name="1.0"/><link name="01"/>
<joint name="1" type="fixed"><parent link="a"/><child link="1.0"/></joint>
<joint name="1e0" type="fixed"><parent link="a"/><child link="01"/></joint></robot>""")
    once = next(line for line in links.splitlines() if line.startswith(f"<{tag} "))
    twice = links.replace(once, f"<{tag} {one}/><{tag} {other}/>", 1)
    if tag == "mimic":  # wrong mimics are refused where an effect takes them
        twice = twice.replace('<link name="1"/>', '').replace(
            'name="1" type="fixed"', 'name="1" type="continuous"')
        fault = next(x for x in read(twice).joints if x.name == "j").fault("mimic")
        assert "occurs twice, with different numbers" in str(fault)
    else:
        where, problem = refused(twice)
        assert where.endswith("joint 'j'")
        assert problem == f"<{tag}> occurs twice; wanted it once"


def test_numbers_are_numbers(read):
    twice = ARM.replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><axis xyz="0.0 0 1e0"/>')
    assert read(twice) == read(ARM)


# misspelt and misplaced elements

PLACES = {"robot": '<link name="a"/>', "link": "</inertial>", "inertial": '<mass value="1"/>',
          "joint": '<parent link="a"/>'}


@pytest.mark.parametrize("owner", PLACES)
@pytest.mark.parametrize("tag", sorted({tag for tags in CHILDREN.values() for tag in tags}))
def test_elements_of_any_case_in_any_place_are_refused(refused, owner, tag):
    """<Mass> in <link>, <Inertial> in <joint>, <Joint> in <inertial>."""
    after = PLACES[owner]
    for wrong in (tag.capitalize(), tag.upper(), tag + tag[-1]):
        text = ARM.replace(after, f'{after}<{wrong} value="3"/>')
        where, problem = refused(text)
        assert where.split(",")[0] == line_of(text, f"<{wrong}")
        assert problem.startswith(f"unknown element <{wrong}>; did you mean <{tag}>")
        places = [place for place, tags in CHILDREN.items() if tag in tags]
        assert tag in CHILDREN[owner] or all(f"<{place}>" in problem for place in places)


@pytest.mark.parametrize("element, words", [
    ('orientation rpy="0 0 1"', "did you mean <origin>, with xyz, rpy, quat_xyzw?"),
    ('rotation rpy="0 0 1"', "did you mean <origin>"), ('Pos xyz="0 0 1"', "did you mean <origin>"),
    ('quat xyzw="0 0 1 0"', "did you mean <origin>"), ("pose", "did you mean <origin>"),
    ('com xyz="0 0 1"', "did you mean <origin>"), ('offset xyz="0 0 1"', "did you mean <origin>"),
    ('way xyz="0 0 1"', "<way> with 'xyz'; it belongs to <origin> or <axis>"),
    ('way rpy="0 0 1"', "<way> with 'rpy'; it belongs to <origin>"),
    ('Damping value="3"', "damping is an attribute of <dynamics>")])
@pytest.mark.parametrize("owner", ["joint", "inertial"])
def test_other_words_for_an_origin_are_refused(refused, owner, element, words):
    _, problem = refused(ARM.replace(PLACES[owner], f"{PLACES[owner]}<{element}/>"))
    assert problem.startswith(f"unknown element <{element.split()[0]}>") and words in problem


def test_robots_in_robots_are_refused(refused):
    where, problem = refused(ARM.replace("</robot>", '<robot name="x"><link name="q"/></robot>'
                                         "\n</robot>"))
    assert where == "line 20" and "wanted one <robot>, around all" in problem


# files of other kinds

def test_an_srdf_with_the_suffix_of_a_urdf_is_named(refused):
    where, problem = refused('<robot name="r"><group name="arm"><link name="a"/></group>\n'
                             '<disable_collisions link1="a" link2="b"/></robot>')
    assert where == "line 1"
    assert problem == "is an SRDF, which belongs to a URDF and has no masses; wanted that URDF"
