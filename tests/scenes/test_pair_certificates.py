"""Certificates of pairs hi + lo: checkers that know nothing of the generator accept them, and
refuse each whose numbers are smaller by 1e-9 of themselves at any line; and no instruction breaks
the bounds of its line."""

import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache

import mpmath
import numpy as np
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.certificate import of_pairs
from coscrew_codegen.accuracy.precision_tuning.array_evaluation import evaluator
from coscrew_codegen.accuracy.range_proofs import of_mixture
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs
from coscrew_codegen.accuracy.tiers.mixed import mixed
from coscrew_codegen.program import Op, Program, Ref
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import PRECISIONS, SINGLE, Precision
from tests.support.scenes.certificate_checks import BOUNDS, checker, refuses
from tests.support.scenes.certified_functions import function, mixture, plain
from tests.support.scenes.generated_scenes import argument
from tests.support.scenes.ranged import PANDA

MANY = 23  # of so many lines one is changed
ANGLE = {"sin": mpmath.sin, "cos": mpmath.cos}
FREE = """
base = "free"
falling = "accept"
[effects.gravity]
[ranges]
v = 5
a = 20
[ranges.q]
base = 2
"""


@cache
def lines(scene: str, name: str, precision: Precision, seed: int | None = None) -> list[str]:
    its = function(scene, name)
    return of_pairs(its, precision, None if seed is None else mixture(its, seed)).splitlines()


def tier(its: FunctionProgram, seed: int | None) -> Program:
    """The function in pairs of single precision, or in a mixture."""
    return in_pairs(plain(its), SINGLE) if seed is None else mixed(plain(its), mixture(its, seed))


def errors(its: Sequence[str], program: Program) -> list[float]:
    """The bounds of the results' errors."""
    names = {f"{a.name}[{k}]" for a in program.outputs for k in range(a.quantity.size)}
    copies = (x.split() for x in its if x.startswith("copy "))
    return [float.fromhex(x[-2]) for x in copies if x[1] in names]


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
@pytest.mark.parametrize("scene, name", (
    ("panda", "body_poses"), ("panda", "inverse_dynamics"), ("UR5", "inverse_dynamics"),
    ("floating", "body_poses"), ("floating", "inverse_dynamics")))
def test_certificates_prove_the_stated_bounds(scene, name, precision):
    its, made = function(scene, name), lines(scene, name, precision)
    checker(BOUNDS)(made)
    proved, stated = errors(made, plain(its)), of_mixture(plain(its), its.ranges, precision)
    assert len(proved) == len(stated)
    for mine, bound in zip(proved, stated, strict=True):
        assert mine <= bound.error * (1 + 1e-8)
    assert max(x / y.error for x, y in zip(proved, stated, strict=True) if y.error) > 0.99


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("scene, name", (("panda", "body_poses"), ("floating", "inverse_dynamics")))
def test_mixtures_have_certificates(scene, name, seed):
    its, made = function(scene, name), lines(scene, name, SINGLE, seed)
    checker(BOUNDS)(made)
    stated = of_mixture(plain(its), its.ranges, SINGLE, mixture(its, seed))
    for mine, bound in zip(errors(made, plain(its)), stated, strict=True):
        assert mine <= bound.error * (1 + 1e-7)


@pytest.mark.parametrize("scene, precision, seed", (
    ("panda", PRECISIONS[0], None), ("panda", SINGLE, 2), ("floating", SINGLE, None)))
def test_smaller_figures_are_refused_at_every_line(scene, precision, seed):
    its, accepted, count = lines(scene, "body_poses", precision, seed), [], 0
    for number in range(0, len(its), MANY):
        words = its[number].rstrip().split(" ")
        if its[number][0] == "#" or words[0] == "input":
            continue
        for place, word in enumerate(words):
            if word[:2] != "0x" or (less := float.fromhex(word) * (1 - 1e-9)) == \
                    float.fromhex(word):
                continue
            changed = " ".join([*words[:place], less.hex(), *words[place + 1:]])
            count += 1
            if not refuses([*its[:number], changed, *its[number + 1:number + 200]]):
                accepted.append((its[number], place))
    assert not accepted and count > 50


@pytest.mark.parametrize("scene, seed", (("panda", None), ("panda", 2), ("floating", None)))
def test_other_operands_are_refused(scene, seed):
    its, accepted, count = lines(scene, "body_poses", SINGLE, seed), [], 0
    others = [x.split()[1] for x in its if x.startswith("input ")][:2]
    for number in range(0, len(its), MANY):
        words = its[number].rstrip().split(" ")
        first = 3 if words[0] == "" else 2
        if its[number][0] == "#" or words[0] == "input" or first + 1 >= len(words):
            continue
        other = others[words[first] == others[0]]
        changed = " ".join([*words[:first], other, *words[first + 1:]])
        count += 1
        if not refuses([*its[:number], changed, *its[number + 1:]]):
            accepted.append(its[number])
    assert not accepted and count > 20


@pytest.mark.parametrize("seed", (None, 2))
def test_a_certificate_lists_the_instructions_of_the_tier(seed):
    its = function("panda", "inverse_dynamics")
    emitted = tier(its, seed)
    made = [x.split()[1] for x in lines("panda", "inverse_dynamics", SINGLE, seed)
            if x[0] == " " and x.split()[0] != "is"]
    assert made == [x.name for x in emitted.instructions if x.op not in (Op.EQUAL, Op.SELECT)]


@pytest.mark.parametrize("scene, name, seed", (
    ("panda", "body_poses", None), ("floating", "inverse_dynamics", None),
    ("floating", "inverse_dynamics", 2)))
def test_no_instruction_breaks_its_bounds(scene, name, seed):
    its, made = function(scene, name), lines(scene, name, SINGLE, seed)
    emitted = tier(its, seed)
    steps = [x for x in emitted.instructions if x.op not in (Op.EQUAL, Op.SELECT)]
    every = replace(emitted, instructions=tuple(steps), outputs=(argument("y", len(steps)),),
                    results=tuple(Ref(x.name) for x in steps))
    given = states(its, 6)
    values = np.stack([np.broadcast_to(x, 6) for x in evaluator(every, SINGLE)(given)])
    numbers = {x.name: values[k] for k, x in enumerate(steps)}
    numbers |= {f"{a.name}[{k}]": given[n][k] for n, a in enumerate(emitted.inputs)
                for k in range(a.quantity.size)}
    used = 0.0
    for line in (x.split() for x in made if x[0] == " " and x.split()[0] != "is"):
        op, name, *operands, size, lost = line
        for k in range(6):
            x = [Fraction(float(numbers[y][k])) if y in numbers else Fraction(y)
                 for y in operands]
            computed, most = Fraction(float(numbers[name][k])), Fraction(float.fromhex(lost))
            assert abs(computed) <= Fraction(float.fromhex(size)), line
            assert abs(exact(op, *x) - computed) <= most, line
            used = max(used, float(abs(exact(op, *x) - computed) / most) if most else 0)
    assert used > 0.5


def states(its: FunctionProgram, count: int) -> list[list[np.ndarray]]:
    """States at random, and at ends of the ranges."""
    draw, ranges = np.random.default_rng(5), its.ranges
    given = [[np.where(draw.random(count) < 0.3, high, draw.uniform(low, high, count))
              for low, high in each] for each in ranges.intervals]
    for each in ranges.quaternions:
        q = draw.normal(size=(4, count))
        for x, y in zip(each, q / np.linalg.norm(q, axis=0), strict=True):
            given[x.argument][x.index] = y
    return [[x.astype(np.float32) for x in each] for each in given]


def exact(op: str, *x: Fraction) -> Fraction:
    """The value of an instruction, before it is rounded."""
    if op[:3] in ANGLE:
        with mpmath.workdps(60):
            value = ANGLE[op[:3]](mpmath.mpf(x[0].numerator) / x[0].denominator)
            return Fraction(*map(int, mpmath.libmp.to_rational(value._mpf_))) - sum(x[1:])
    return {"add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b,
            "div": lambda a, b: a / b, "neg": lambda a: -a, "error": lambda a, b, p: a * b - p,
            "rest": lambda a, b, p, h: a * b - h}[op](*x)


@pytest.mark.parametrize("steps", (
    [" add s x y 0x1p1 0x0p0"],  # loses nothing
    [" add s x y 0x1p1 0x1p-53", " sub r s y 0x1p1 0x1p-53", " sub l s r 0x1p1 0x0p0"],  # order
    [" mul s x y 0x1p0 0x1p-54", " error e x x s 0x1p-54 0x1p-1075"],  # of another product
    [" sqrt s x 0x1p0 0x1p-54"],  # an unknown operation
    [" add s x 1/3 0x1p1 0x1p-53"],  # no number of the format
    ["add z x y 0x1p1 0x1p-54 0x1p-54", " add z x y 0x1p1 0x1p-53", " is z z"],  # rounded
    ["sub z x y 0x1p1 0x1p-53 0x1p-53", " add z x y 0x1p1 0x1p-53", " is z z"],  # another value
    ["div z x y 1 0x1p0 0x1p-53 0x1p-53", " div z x y 0x1p0 0x1p-54", " is z z"]  # by zero
    ), ids=lambda x: x[-1])
def test_steps_without_a_proof_are_refused(steps):
    given = ["53 -1022 103/125 0x1p-90", "input x 0x1p0 0x0p0 0x0p0", "input y 0x1p0 0x0p0 0x0p0"]
    assert not refuses([*given, "add z x y 0x1p1 0x1p-53 0x1p-53", " add z x y 0x1p1 0x1p-53",
                        " sub r z x 0x1.1p0 0x1p-53", " sub l z r 0x1.8p1 0x0p0", " is z z"])
    assert refuses([*given, *steps])


@pytest.mark.parametrize("model, ranges, words, names", (
    ("panda", "[ranges]\nv = 0.5\na = 1\n[accuracy]\ngravity_torques = 1e-5\n",
     ["gravity_torques", "--tier", "accurate", "pairs", "mixed"],
     ["gravity_torques_accurate_double", "gravity_torques_pairs_single",
      "gravity_torques_mixed_single"]),
    ("quadruped", FREE, ["mass_matrix", "--tier", "pairs"], ["mass_matrix_pairs_single"])))
def test_the_command_writes_certificates_of_pairs(model, ranges, words, names, tmp_path, capsys):
    scene, folder = tmp_path / "box.toml", tmp_path / "proofs"
    urdf = PANDA.parents[1] / "scenes/quadruped.urdf"
    text = PANDA.read_text(encoding="utf-8") if model == "panda" else f'model = "{urdf}"\n'
    scene.write_text(f"{text}\n{ranges}", encoding="utf-8")
    assert main(["certificate", str(scene), "-o", str(folder), "--functions", *words]) == 0
    printed = capsys.readouterr().out
    assert {x.stem for x in folder.glob("*_*_*.txt")} >= {*names}
    for name in names:
        assert f"{name}: 1 certificate of " in printed
        run = subprocess.run([sys.executable, "-I", folder / BOUNDS.name], check=True, text=True,
                             stdin=(folder / f"{name}.txt").open(), capture_output=True)
        assert run.stdout == "proved\n"
