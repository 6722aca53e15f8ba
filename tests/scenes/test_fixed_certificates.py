"""Certificates of fixed point: a checker that knows nothing of the generator accepts them, and
refuses each that states less of a size, an error or a rounding by 1e-9 of itself, other bits, or
an operand that is not there."""

import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.certificate import of_fixed
from coscrew_codegen.accuracy.fixed_scene import FixedFunction
from coscrew_codegen.program.fixed.fixed_program import Products
from tests.support.scenes import fixed_robots
from tests.support.scenes.certificate_checks import FIXED, checker, refuses

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
FUNCTIONS = ("inverse_dynamics", "gravity_torques", "mass_matrix", "energy")
BITS, SIZE, ERROR, ROUNDING = -4, -3, -2, -1
each_certificate = pytest.mark.parametrize("products", Products, ids=lambda x: x.value)


@cache
def functions(robot: str) -> dict[str, FixedFunction]:
    return {f.plain.name: f for f in fixed_robots.fixed(robot, FUNCTIONS).functions}


@cache
def lines(robot: str, name: str, products: Products) -> list[str]:
    its = functions(robot)[name]
    return of_fixed(its.plain, its.programs[products]).splitlines()


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("robot", fixed_robots.ROBOTS)
@each_certificate
def test_certificates_end_with_the_stated_bounds(robot, name, products):
    its = lines(robot, name, products)
    checker(FIXED)(its)
    made = {x.split()[1]: x.split() for x in its if not x.startswith("#") and len(x.split()) > 5}
    results = dict(x[2:].split(" is ") for x in its if x.startswith("#") and "] is " in x)
    fixed = functions(robot)[name].programs[products]
    assert len(results) == len(fixed.results)
    for word, result in zip(results.values(), fixed.results, strict=True):
        if (words := made.get(word)):
            assert (int(words[BITS]), float.fromhex(words[ERROR])) == (result.bits, result.error)
    assert sum(word in made for word in results.values()) > len(results) / 2
    steps = {x.name for x in fixed.program.instructions}
    assert steps <= made.keys()


@each_certificate
def test_what_states_less_is_refused_at_every_line(products):
    its, accepted, count = lines("Panda", "gravity_torques", products), [], 0
    for number, line in enumerate(its):
        words = line.split()
        if line.startswith("#") or len(words) < 6 or words[0] == "input":
            continue
        changes = [(place, float.hex(less)) for place in (SIZE, ERROR, ROUNDING) if (
            less := (figure := float.fromhex(words[place])) * (1 - 1e-9)) != figure]
        moves = (-1,) if words[0] == "mul" else (-1, 1)  # 64 bits may have room for one more
        changes += [(BITS, str(int(words[BITS]) + more)) for more in moves]
        changes += [(place, "q[9]") for place in range(2, len(words) - 4)]
        for place, word in changes:
            place %= len(words)
            other = " ".join([*words[:place], word, *words[place + 1:]])
            count += 1
            if not refuses([*its[:number], other, *its[number + 1:]], FIXED):
                accepted.append((line, place))
    assert not accepted and count > 500


@pytest.mark.parametrize("step", (
    "add y x z 30 0x1p1 0x0p0 0x0p0",  # of an unknown value
    "sqrt y x 30 0x1p1 0x1p0 0x1p0",  # an unknown operation
    "add y x x 30 0x1p1 0x0p0 0x0p0",  # overflows
    "add y x w 30 0x1p1 0x0p0 0x0p0",  # of other bits
    "high y x m 28 0x1p0 0x1p-9 0x1p-9",  # of 64 bits
    "sin y w 31 0x1p0 0x1p-9 0x1p-9", "sin y x 29 0x1p0 0x1p-9 0x1p-9",
    "shift y x 31 0x1p0 0x0p0 0x0p0", "shift y l 29 0x1p0 0x1p-30 0x1p-30"))  # overflow
def test_steps_without_a_proof_are_refused(step):
    given = ["1/1000000000 1/10000000000", "input x 30 0x1p0 0x0p0 0x0p0",
             "input w 20 0x1p0 0x0p0 0x0p0", "input l 30 0x1.fffffffp0 0x0p0 0x0p0",
             "mul m x x 60 0x1p0 0x0p0 0x0p0"]
    assert not refuses(given, FIXED) and refuses([*given, step], FIXED)


def test_the_command_writes_certificates_of_fixed_point(tmp_path, capsys):
    assert main(["certificate", str(GIMBAL), "-o", str(tmp_path)]) == 0
    printed = capsys.readouterr().out
    for mark in ("", "_high"):
        name = f"inverse_dynamics_fixed{mark}"
        assert f"{name}: 1 certificate of " in printed
        run = subprocess.run([sys.executable, "-I", tmp_path / FIXED.name], check=True,
                             stdin=(tmp_path / f"{name}.txt").open(), capture_output=True,
                             text=True)
        assert run.stdout == "proved\n"
