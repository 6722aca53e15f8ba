"""Certificates of bounds over stated ranges: checkers that know nothing of the generator accept
them, and refuse each whose error, size or rounding is smaller by 1e-9 of itself at any line."""

import json
import subprocess
import sys
from dataclasses import replace
from functools import cache

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.certificate import certificate
from coscrew_codegen.accuracy.range_proofs import of_plain
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.scenes.certificate_checks import BOUNDS, FIXED, checker, is_short, refuses
from tests.support.scenes.ranged import PANDA, floating, panda

BOX = "\n[ranges]\nv = 0.5\na = 1\n"
SCENES = {"panda": panda, "floating": floating}
CASES = [(scene, name, p) for scene, name in (
    ("panda", "body_poses"), ("panda", "inverse_dynamics"), ("floating", "body_poses"),
    ("floating", "inverse_dynamics")) for p in PRECISIONS]
NAMES = [f"{scene}, {name}, {p.name}" for scene, name, p in CASES]
EVERY = {"body_poses": 1, "inverse_dynamics": 23}  # all lines; some of longer certificates
SIZE, ERROR, ROUNDING = -3, -2, -1


@cache
def function(scene: str, name: str) -> FunctionProgram:
    return derive(replace(SCENES[scene](), functions=(name,))).named(name)


@cache
def lines(scene: str, name: str, precision: Precision) -> list[str]:
    return certificate(function(scene, name), precision).splitlines()


@pytest.mark.parametrize("path, most", ((BOUNDS, 225), (FIXED, 40)), ids=lambda x: str(x)[-9:])
def test_checkers_are_short_and_import_fractions_alone(path, most):
    assert is_short(path, most)


@pytest.mark.parametrize("scene, name, precision", CASES, ids=NAMES)
def test_certificates_end_with_the_stated_bounds(scene, name, precision):
    its = lines(scene, name, precision)
    checker(BOUNDS)(its)
    figures = {x.split()[1]: [float.fromhex(y) for y in x.split()[-3:]] for x in its
               if not x.startswith("#") and len(x.split()) > 3}
    bounds, program = of_plain(function(scene, name), precision), function(scene, name).program
    places = [f"{a.name}[{k}]" for a in program.outputs for k in range(a.quantity.size)]
    results = dict(x[2:].split(" is ") for x in its if x.startswith("#") and " is " in x)
    assert [*results] == places
    for place, bound in zip(places, bounds, strict=True):
        if results[place] in figures:
            assert figures[results[place]][:2] == [bound.size, bound.error], place


@pytest.mark.parametrize("scene, name, precision", CASES, ids=NAMES)
def test_smaller_figures_are_refused_at_every_line(scene, name, precision):
    its, accepted, count = lines(scene, name, precision), [], 0
    for number, line in enumerate(its[::EVERY[name]]):
        words = line.split()
        if line.startswith("#") or len(words) < 5 or words[0] == "input":
            continue
        for place in (SIZE, ERROR, ROUNDING):
            figure = float.fromhex(words[place])
            if (less := figure * (1 - 1e-9)) == figure:  # zero, or the least number
                continue
            other = [*words[:place], less.hex(), *words[len(words) + place + 1:]]
            count += 1
            if not refuses([*its[:number * EVERY[name]], " ".join(other)]):
                accepted.append((line, place))
    assert not accepted and count > 50


@pytest.mark.parametrize("steps", (
    ["add y x z 0x1p1 0x1p0 0x1p0"],  # of an unknown value
    ["sqrt y x 0x1p1 0x1p0 0x1p0"],  # an unknown operation
    ["div y 1 x 0x1p9 0x1p0 0x1p0"],  # by a number that may be zero
    ["sub d x y 0x1p0 0x1p-52 0x1p-53", "div z 1 d 0x1p99 0x1p0 0x1p0"],
    ["sin s x 0x1p0 0x1p-52 0x1p-52", "cos c y 0x1p0 0x1p-52 0x1p-52",  # of other angles
     "mul a s x 0x1p0 0x1p-50 0x1p-53", "mul b c x 0x1p0 0x1p-50 0x1p-53",
     "add t a b 0x1.7p0 0x1p-48 0x1p-52"],
    ["mul a x x 0x1p0 0x1p-53 0x1p-53", "mul b y y 0x1p0 0x1p-53 0x1p-53",  # of no quaternion
     "add t a b 0x1.1p0 0x1p-50 0x1p-52"]), ids=lambda x: x[-1])
def test_steps_without_a_proof_are_refused(steps):
    given = ["53 -1022 103/125", "input x 0x1p0 0x0p0 0x0p0", "input y 0x1p0 0x0p0 0x0p0"]
    assert not refuses(given) and refuses([*given, *steps])


def test_the_command_writes_certificates_their_checker_and_bounds(tmp_path, capsys):
    scene, folder = tmp_path / "box.toml", tmp_path / "proofs"
    scene.write_text(PANDA.read_text(encoding="utf-8") + BOX, encoding="utf-8")
    words = ["--functions", "mass_matrix", "forward_dynamics"]
    assert main(["certificate", str(scene), "-o", str(folder), *words]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "forward_dynamics: no bound: [ranges] states no range of tau",
        "mass_matrix: 2 certificates of 566 lines"]
    for p in PRECISIONS:
        run = subprocess.run([sys.executable, "-I", folder / BOUNDS.name], check=True, text=True,
                             stdin=(folder / f"mass_matrix_{p.name}.txt").open(),
                             capture_output=True)
        assert run.stdout == "proved\n"
    bounds = json.loads((folder / "bounds.json").read_text(encoding="utf-8"))
    plain = of_plain(function("panda", "mass_matrix"), PRECISIONS[0])
    assert bounds["mass_matrix"]["double"]["M"]["error"] == [x.error for x in plain]
    assert bounds["forward_dynamics"]["single"]["a"]["error"] == [None] * 7


def test_scenes_without_ranges_are_refused(tmp_path, capsys):
    assert main(["certificate", str(PANDA), "-o", str(tmp_path)]) == 2
    assert capsys.readouterr().err == (
        f"coscrew: {PANDA}: states no ranges, over which bounds could be proved; wanted a table, "
        "as [ranges] with v = 3 and a = 20\n")
    assert not [*tmp_path.iterdir()]
