"""Content and layout of scenes' files."""

import ast
import os
import re
import subprocess
import sys
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from coscrew_codegen.backends.scene import scene_c, scene_c_runtime, scene_runtime_header
from coscrew_codegen.program import Constant, Op, counts_in_words
from coscrew_codegen.program.scene_functions import Coordinate, SceneFunctions
from coscrew_codegen.scene.identifiers import numbered
from tests.support.scenes.generated_scenes import (
    BANNER,
    CASES,
    Writer,
    argument,
    files,
    imported,
    robot,
)
from tests.support.work import calls_of

ALL = [*(made() for made in CASES.values()), robot(12, 1500),
       replace(CASES["slider"](), name="a_name_as_long_as_scene_files_may_give_it")]


@pytest.fixture(params=ALL, ids=lambda x: x.name)
def texts(request: pytest.FixtureRequest) -> dict[str, str]:
    """All files of a scene, by path."""
    return files(request.param)


def test_files_are_those_promised():
    assert list(files(CASES["slider"]())) == [
        "slider.h", "slider.c", "sliderf.c", "coscrew_runtime.h", "slider/__init__.py",
        "slider/_arrays.py", "slider/double.py",
        "slider/single.py"]


def test_first_lines_name_the_command(texts: dict[str, str]):
    for path, text in texts.items():
        first = text.splitlines()[0]
        if path == scene_c_runtime.NAME:
            assert first == f"/* {scene_runtime_header.BANNER} */"
            continue
        assert first == (f"# {BANNER}" if path.endswith(".py") else f"/* {BANNER} */")


def test_lines_are_short_and_clean(texts: dict[str, str]):
    for path, text in texts.items():
        assert text.endswith("\n") and not text.endswith("\n\n")
        for number, line in enumerate(text.splitlines(), 1):
            assert len(line) <= 100 and line == line.rstrip(), f"{path}:{number}: {line}"


def test_text_is_the_same_in_every_process():
    program = ("import sys; from tests.support.scenes.generated_scenes import *; "
               "sys.stdout.write(''.join(''.join(files(made()).values()) "
               "for made in CASES.values()))")
    results = set()
    for seed in ("0", "4711"):
        done = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, check=True, encoding="utf-8",
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONIOENCODING": "utf-8"},
            cwd=Path(__file__).parents[2])
        results.add(done.stdout)
    assert len(results) == 1 and results.pop()


def test_single_precision_has_no_literal_and_no_function_of_double():
    for functions in ALL:
        text = files(functions)[f"{functions.name}f.c"]
        code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        assert not re.search(r"\bdouble\b", code)
        assert not re.search(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+e-?\d+)(?:e[-+]?\d+)?(?![\w.])", code)
        assert not re.search(r"\b(?:sin|cos|sqrt|fabs|atan2|exp|tanh)\(", code)


def test_header_tells_order_units_sizes_and_defaults():
    text = files(_walker())["walker.h"]
    for line in ("  q 0-6   v 0-5  free       root", "  q 7     v 6    revolute   knee",
                 "  q 8-11  v 7-9  spherical  hip", "  q 12    v 10   prismatic  foot"):
        assert line in text
    assert "free: q: position in m, then quaternion (x, y, z, w)" in text
    assert "prismatic: q in m; v in m/s." in text
    assert "0 trunk, 1 shank" in text
    assert "Parameters p: 0 tool.mass = 0.1." in text
    for macro in ("WALKER_NQ 13", "WALKER_NV 11", "WALKER_NP 1", "WALKER_DEFAULT_P {0.1}",
                  "WALKER_DEFAULT_PF {0.1f}",
                  "WALKER_NEUTRAL_Q {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1"):
        assert f"#define {macro}" in text
    for enumerator in ("Q_KNEE = 7", "V_HIP = 7", "TAU_HIP = 7", "TAU_FOOT = 10", "P_TOOL_MASS = 0",
                       "BODY_SHANK = 1"):
        assert re.search(rf"\bWALKER_{enumerator}\b", text)
    assert "as in q[WALKER_Q_FOOT]." in text


def test_operations_are_counted_above_each_function():
    functions = CASES["pendulum"]()
    text = files(functions)
    for f in functions.functions:
        words = counts_in_words(f.program).capitalize()
        declared = [] if f.internal else ["pendulum.h"]
        for path in (*declared, "pendulum.c", "pendulum/double.py"):
            assert f"{words}." in text[path]
    assert "1 exp, 1 tanh" in text["pendulum.h"]


def test_headings_stand_above_their_bodies():
    text = files(CASES["slider"]())["slider.c"]
    body = text[text.index("slider_forward_dynamics"):]
    places = [body.index(x)
              for x in ("/* carriage */", "friction_0a =", "/* load: its spring", "late =")]
    assert places == sorted(places)


def test_python_knows_the_same_as_the_header(tmp_path: Path):
    package = imported(CASES["slider"](), tmp_path)
    assert (package.NQ, package.NV) == (2, 2)
    assert package.JOINTS == ("class", "load */ x\\")
    assert package.BODIES == ("carriage", 'lambda """')
    assert package.PARAMETERS == {"carriage.mass": 1.5, "unused": 0.1}
    assert package.NEUTRAL_Q == (0.0, 0.25)
    with pytest.raises(AttributeError, match="'triple'"):
        package.triple
    only = imported(CASES["pendulum"](), tmp_path)
    assert (only.JOINTS, only.BODIES, only.PARAMETERS) == (("hinge",), ("rod",), {"length": 0.7})


def test_internal_functions_are_not_offered():
    text = files(CASES["slider"]())
    assert "implicit_acceleration" not in text["slider.h"]
    assert "static void slider_implicit_acceleration(" in text["slider.c"]
    names = {node.name for node in ast.parse(text["slider/double.py"]).body
             if isinstance(node, ast.FunctionDef)}
    assert "_implicit_acceleration" in names and "implicit_acceleration" not in names


@pytest.mark.parametrize("name", ("class", "lambda", "two words", "1st", "", "größe", "a-b"))
def test_names_no_file_can_have_are_refused(name: str):
    with pytest.raises(ValueError, match="a name that C and Python can import is wanted"):
        files(replace(CASES["pendulum"](), name=name))


@pytest.mark.parametrize("name", ("int", "lambda", "template", "sin", "sqrtf", "where", "_x", "x y",
                                  "nan", "NAN", "float64"))
def test_instructions_cannot_have_keywords_as_names(name: str):
    with pytest.raises(ValueError, match=re.escape(f"{name!r} cannot be a name in C and Python")):
        files(_one(name))


@pytest.mark.parametrize("name", ("q", "x"))
def test_instructions_cannot_have_names_of_arguments(name: str):
    with pytest.raises(ValueError, match=f"{name!r} is given twice"):
        files(_one(name))


def test_outputs_that_have_an_inputs_name_get_another():
    text = files(CASES["slider"]())["slider.h"]
    assert "void slider_integrated(const double q[2], const double phi[2], double qo[2]);" in text


def test_words_of_models_cannot_leave_their_comments():
    hostile = 'x */ int y; /* ??/ """ \\ \n#error \x07 '
    scene = replace(CASES["pendulum"](), bodies=(hostile,), coordinates=(
        Coordinate(hostile, "revolute", range(1), range(1)),))
    scene = replace(scene, functions=tuple(
        replace(f, words=hostile, headings=((0, hostile),)) for f in scene.functions))
    text = files(scene)
    plain = files(CASES["pendulum"]())
    for path in ("pendulum.h", "pendulum.c"):
        assert _code(text[path]) == _code(plain[path])
    module, names = ast.parse(text["pendulum/__init__.py"]), {}
    for node in module.body:
        if isinstance(node, ast.Assign):
            names[node.targets[0].id] = ast.literal_eval(node.value)
    assert names["BODIES"] == names["JOINTS"] == (hostile,)
    for path in ("pendulum/double.py", "pendulum/single.py"):
        result, wanted = (ast.parse(x[path]) for x in (text, plain))
        for tree in (result, wanted):
            for node in ast.walk(tree):
                if isinstance(node, ast.FunctionDef):
                    node.body.pop(0)  # the docstring
        assert ast.dump(result) == ast.dump(wanted)


def test_negated_negative_numbers_are_no_decrements():
    w = Writer(argument("q", 1))
    minus = w.do("minus", Op.NEG, Constant(-3, -3))
    function = w.function("forward_dynamics", "3", (argument("a", 1),), [minus])
    scene = replace(CASES["pendulum"](), functions=(function,), steps=())
    assert "minus = -(-3.0);" in scene_c.files(scene, BANNER)["pendulum.c"]


def test_long_robots_take_work_in_proportion_to_their_length():
    half, whole = (calls_of(partial(files, robot(35, n))) for n in (2000, 4000))
    assert whole < 2.5 * half


def _code(text: str) -> list[str]:
    """Words of C without comments, with the same word for all macros of places, whose identifiers
    depend on names."""
    code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    return re.sub(r"\b([A-Z]+_(?:Q|V|TAU|P|BODY))_[A-Z0-9_]+", r"\1", code).split()


def _one(name: str) -> SceneFunctions:
    """A function with one instruction of this name."""
    w = Writer(argument("q", 1))
    done = w.do(name, Op.ADD, w.at("q"), 1)
    function = w.function("forward_dynamics", "x", (argument("x", 1),), [done])
    return replace(CASES["pendulum"](), functions=(function,), steps=())


def _walker() -> SceneFunctions:
    """A table of every kind of joint; its functions do not matter."""
    kinds = (("root", "free", 7, 6), ("knee", "revolute", 1, 1), ("hip", "spherical", 4, 3),
             ("foot", "prismatic", 1, 1))
    coordinates, nq, nv = [], 0, 0
    for joint, kind, q, v in kinds:
        coordinates.append(Coordinate(joint, kind, range(nq, nq + q), range(nv, nv + v)))
        nq, nv = nq + q, nv + v
    return replace(
        CASES["pendulum"](), name="walker", nq=nq, nv=nv, coordinates=tuple(coordinates), steps=(),
        bodies=("trunk", "shank"), parameters=(("tool.mass", 0.1),),
        neutral=(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0))


def test_every_place_has_a_name_of_its_own_that_the_header_explains():
    """Names that differ only in case or in characters that C's names cannot have are numbered."""
    bodies = ("Tool-1", "tool_1", "TOOL_1_1", "膝", "足", "arm", "Hüfte")
    scene = replace(CASES["slider"](), bodies=bodies)
    header = files(scene)["slider.h"]
    results = dict(re.findall(r"\bSLIDER_BODY_(\w+) = (\d+)", header))
    assert results == {"TOOL_1_2": "0", "TOOL_1_3": "1", "TOOL_1_1": "2", "X_1": "3", "X_2": "4",
                       "ARM": "5", "H_FTE": "6"}
    assert "SLIDER_Q_CLASS = 0" in header
    about = " ".join(header.partition("*/\n#ifndef")[0].split())
    assert ("Of names that differ only in case, or in characters that C's names cannot have: "
            "BODY_TOOL_1_2 Tool-1, BODY_TOOL_1_3 tool_1, BODY_X_1 膝, BODY_X_2 足, BODY_H_FTE "
            "Hüfte.") in about
    assert "differ only" not in files(CASES["slider"]())["slider.h"]


def test_numbered_identifiers_are_all_different():
    names = ["a", "A", "a_1", "a-2", "A_2", "3", "x3", "x3_1", "", "é", "x"] * 2
    result = numbered(names)
    assert len({*result}) == len(result) and all(re.fullmatch("[A-Z][A-Z0-9_]*", x) for x in result)
    assert numbered(["elbow", "Wrist"]) == ("ELBOW", "WRIST")
