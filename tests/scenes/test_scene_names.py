"""Names of instructions in scenes' text: as the legend describes them, numbered without gaps."""

import re
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

import pytest

from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.backends.c.c_nested import language
from coscrew_codegen.backends.numpy import scene_python
from coscrew_codegen.backends.scene import scene_c, scene_symbols, scene_text
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Op
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.scene.mechanism.model import Body, Joint, Model
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.effect_scenes import PLACES, arm, effects, mechanism
from tests.support.scenes.generated_scenes import Writer, argument
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, applied, gravity, inertia, scene

SCENES: dict[str, Scene] = {
    "falling": scene(mechanism(), gravity()),
    "all effects": scene(mechanism(), *effects(*PLACES)), "arm": scene(arm(), *effects(*PLACES))}
FREE = re.compile(r"(total|solution|speeds|wind|parts|rows|later|part|[a-z0-9_]+_"
                  rf"({'|'.join(PLACES)}))_[0-9]+|(sin|cos)_[a-z]+[0-9]*")
"""Names that belong to no link: solutions, wind, rows, effects, sines of arguments."""


@pytest.fixture(scope="module", params=SCENES)
def functions(request: pytest.FixtureRequest) -> SceneFunctions:
    return derive(SCENES[request.param])


def test_every_name_has_a_symbol_of_the_legend(functions: SceneFunctions) -> None:
    for f in functions.functions:
        for step in f.program.instructions:
            symbol, *_ = scene_symbols.reading(step.name)
            assert symbol or FREE.fullmatch(step.name), f"{f.name}: {step.name}"


def test_numbers_of_steps_have_no_gaps(functions: SceneFunctions) -> None:
    for f in functions.functions:
        results = defaultdict(set)
        for step in f.program.instructions:
            if match := re.fullmatch(r"(.+)_([0-9]+)", step.name):
                results[match[1]].add(int(match[2]))
        for stem, numbers in results.items():
            if scene_symbols.reading(f"{stem}_1")[0]:
                assert numbers == set(range(1, len(numbers) + 1)), f"{f.name}: {stem}"


def test_legends_tell_the_symbols_that_occur_and_no_others(functions: SceneFunctions) -> None:
    name = functions.name
    for text in (scene_c.files(functions, "x")[f"{name}.c"],
                 scene_python.files(functions, "x")[f"{name}/double.py"]):
        code = re.sub(r"/\*.*?\*/|\"\"\".*?\"\"\"", "", text, flags=re.DOTALL)
        code = re.sub(r"^void \w+_step_[^{]*\{.*?^\}", "", code, flags=re.DOTALL | re.MULTILINE)
        words = set(re.findall(r"\w+", code))
        rows = re.findall(r"^ *([A-Za-z]+(?:, [A-Za-z]+)*): (?![0-9]+ ×)", text, re.MULTILINE)
        messages = {x for row in rows for x in row.split(", ")}
        messages &= {x for xs in scene_symbols.SYMBOLS for x in xs}
        used = {scene_symbols.reading(x)[0] for plan in scene_text.plans(functions)
                for x in (*plan.assigned, *plan.constants) if x in words} - {""}
        assert messages == used


def test_values_keep_their_names_and_what_is_left_out_leaves_no_gap() -> None:
    recorder = Recorder((array("x", (3,)),))
    x, y, z = recorder.argument("x")
    with recorder.part("3", "w", "arm"):
        unused = x * y
        product, shared = x * z, y + z
        value = (product + shared, -(shared * x), shared + unused)
        recorder.label("w", value)
        results = value[0], value[1] - 1
    program = recorder.program("f", [(array("out", (2,)), results)])
    assert [step.name for step in program.instructions] == [
        "w3x_1", "w3_1", "w3x", "w3yn", "w3_2", "w3_3"]


def test_the_second_value_of_a_name_is_numbered() -> None:
    recorder = Recorder((array("x", (2,)),))
    x, y = recorder.argument("x")
    with recorder.part("arm", "T"):
        for value in (x + y, x * y):
            recorder.label("T", value)
    program = recorder.program("f", [(array("out", (2,)), (x + y, x * y))])
    assert [step.name for step in program.instructions] == ["arm_T", "arm_Tv2"]


def example(name: str) -> SceneFunctions:
    """The functions of an example scene."""
    from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

    return derive(read_scene(Path(__file__).parents[2] / "examples" / "scenes" / f"{name}.toml"))


def test_numbers_of_the_model_and_torques_of_effects_have_names() -> None:
    """A rotor behind its gear, 100^2 7e-5; a mass; an offset: each named once in a function that
    uses it."""
    functions = example("arm6")
    c, single_c, double, single = (
        text for files in (scene_c.files(functions, "x"), scene_python.files(functions, "x"))
        for path, text in files.items() if path.endswith((".c", "/double.py", "/single.py")))
    for name, value in (("pan_armature_I", 0.7), ("Bm2", 2.4), ("t2x", 0.41)):
        assert f"{name} = {value}\n" in double and f"{name} = {value}\n" in single
        for text, f in ((c, ""), (single_c, "f")):
            body = text[text.index(f"void arm6_inverse_dynamics{f}("):]
            body = body[:body.index("\n}")]
            literal = f"{value}{f}"
            assert len(re.findall(rf"\b{name} = {literal}[,;]", body)) == 1
    assert "elbow_viscous_taun = RN(4.0 * v[2]);" in c
    assert "elbow_viscous_taun = 4.0 * v[2]\n" in double


def test_a_name_that_two_numbers_have_is_the_firsts() -> None:
    """The second number is written as a literal; so is one whose name is already taken."""
    w = Writer(argument("q", 3))
    named = [Constant(Fraction(n), Fraction(n), name)
             for n, name in ((3, "mass"), (5, "mass"), (7, "q"), (3, "mass"))]
    results = [w.do(f"y_{n}", Op.ADD, w.at("q", n % 3), x) for n, x in enumerate(named)]
    plan, = scene_text.plans(SceneFunctions(
        "x", 3, 3, (), (), (), (), (w.function("f", "f", (argument("y", 4),), results),)))
    text = plan.printed(language(plan.program, DOUBLE), scene_text.access(plan.program), {})
    assert [(x.step.name, x.expression) for x in text.assigned if not isinstance(x, str)] == [
        ("mass", "3.0"), ("y_1", "q[0] + mass"), ("y_2", "q[1] + 5.0"), ("y_3", "q[2] + 7.0"),
        ("y_4", "q[0] + mass")]


def test_example_scenes_headings_say_how_links_move() -> None:
    result = example("pendulum")
    assert "/* 0 rod: pivot turns about z */" in scene_c.files(result, "x")["pendulum.c"]


NAMES = ("column", "arm", "hand", "lift", "hinge", "ball")
CONFUSING = ("total", "speeds", "a: b", "total", "hinge at total", "speeds")
"""Of bodies, then of joints: what the text calls sums, stages and effects, and each other."""


def headings_of(names: tuple[str, ...]) -> list[tuple[str, list[str]]]:
    """Each function's headings, in a scene whose bodies and joints have these names."""
    column, arm, hand, *joints = names
    chained = zip(("world", column, arm), (column, arm, hand), joints,
                  (Kind.PRISMATIC, Kind.REVOLUTE, Kind.SPHERICAL), strict=True)
    model = Model("x", tuple(Body(x, inertia(1, moments=(1, 1, 1, 0, 0, 0)))
                             for x in (column, arm, hand)),
                  tuple(Joint(joint, kind, parent, child, axis=Y)
                        for parent, child, joint, kind in chained))
    lift, hinge, _ = joints
    effects = (gravity(), applied("limit", lift, lower=0, k=100), applied("viscous", hinge, d=1),
               applied("spring_damper", "tie", bodies=("world", hand), k=1))
    made = derive(scene(model, *effects))
    return [(f.name, [words for _, words in f.headings]) for f in made.functions]


def test_headings_are_the_same_whatever_bodies_and_joints_are_called() -> None:
    """Except for the names in them."""
    plain, confusing = headings_of(NAMES), headings_of(CONFUSING)
    bodies = "".join(words for _, result in plain for words in result)
    assert all(x in bodies for x in ("0 column: lift", "joint 'ball'", "total", "speeds",
                                     "limit at lift", "forces between bodies"))
    patterns = {f"{n} {NAMES[n]}": f"{n} {CONFUSING[n]}" for n in range(3)}
    patterns |= {f": {x} ": f": {y} " for x, y in zip(NAMES[3:], CONFUSING[3:], strict=True)}
    patterns |= {f"joint {x!r}": f"joint {y!r}"
                 for x, y in zip(NAMES[3:], CONFUSING[3:], strict=True)}
    patterns |= {f" at {x}": f" at {y}" for x, y in zip(NAMES[3:], CONFUSING[3:], strict=True)}
    any_name = re.compile("|".join(map(re.escape, patterns)))
    named = [[any_name.sub(lambda x: patterns[x[0]], words) for words in headings]
             for _, headings in plain]
    assert [headings for _, headings in confusing] == named
