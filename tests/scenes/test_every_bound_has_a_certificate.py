"""Every bound over stated ranges that a comment of generated C states has a certificate, which its
checker accepts, and which proves no larger an error: of each tier and precision, for each kind of
joint."""

import json
import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import PRECISIONS
from tests.support.scenes.certificate_checks import BOUNDS, FIXED, checker

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
KINDS = {"revolute": "axis = [0, 1, 0]", "continuous": "axis = [0, 0.6, 0.8]",
         "prismatic": "axis = [1, 0, 0]", "universal": "axis = [1, 0, 0]\naxis2 = [0, 1, 0]",
         "planar": "axis = [0, 0, 1]", "spherical": "", "free": "", "mimic": "axis = [0, 1, 0]"}
FLOATING = ("continuous", "spherical", "free")
"""Kinds without fixed point: with quaternions, or without ranges of q."""
SCENE = """
name = "robot"
functions = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "body_poses",
             "jacobian_b", "momentum"]
tiers = ["accurate", "certified", "pairs", "mixed"{fixed}]
{falling}
[bodies]
a = {{ mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }}
b = {{ mass = 1.3, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }}
[joints.one]
type = "{type}"
child = "a"
{axis}
[joints.two]
type = "revolute"
child = "b"
parent = "a"
axis = [0, 1, 0]
origin = {{ xyz = [0, 0, -0.5] }}
{mimic}
[effects.gravity]
{torque}
[accuracy]
mass_matrix = 1e-5
[ranges]
v = 2.1
a = 10
t = 2
[ranges.q]
{q}
"""
COMMENT = re.compile(r"/\*((?:(?!\*/).)*)\*/\s*void (\w+)\(", re.S)
CLAIM = re.compile(r"rounding moves (.*?)(?:\.  |\.$|, for all)")
PART = re.compile(r"(\w+) by at most (\S+?)(?: in (\w+)(?: and (\S+) in (\w+))? precision| \(asked"
                  r"|;|$)")
TIERS = {"": "", "_accurate": "accurate", "_certified": "", "_pairs": "pairs", "_mixed": "mixed",
         "_fixed": "fixed", "_fixed_high": "fixed_high"}
"""Certificates by the ends of functions' names: a certified function has the plain one's bounds."""


def scene(kind: str) -> str:
    q = {"spherical": "two = 3", "free": "one = 2\ntwo = 3", "planar": "one = [1, 1, 3]\ntwo = 3",
         "mimic": "one = 3", "continuous": ""}.get(kind, "one = 3\ntwo = 3")
    return SCENE.format(
        type="revolute" if kind == "mimic" else kind, axis=KINDS[kind], q=q,
        mimic='mimic = { joint = "one", multiplier = -0.7, offset = 0.1 }\n'
              '[effects.mimic]' if kind == "mimic" else "",
        fixed="" if kind in FLOATING else ', "fixed"', torque="" if kind == "mimic" else
        '[effects.actuator.two]\nkind = "torque"\ntorque = "sin(7*t)"',
        falling='falling = "accept"' if kind == "free" else "")


def stated(header: str, stem: str) -> Iterator[tuple[str, str, str, str, str]]:
    """The function, the end of its name, an output, a precision and a bound, of each statement."""
    for comment, symbol in COMMENT.findall(header):
        name = symbol.removeprefix(f"{stem}_")
        end = next(x for x in sorted(TIERS, key=len, reverse=True) if name.rstrip("f").endswith(x)
                   or name.endswith(x))
        name = name.removesuffix("f") if name.endswith(f"{end}f") and end else name
        for claim in CLAIM.findall(re.sub(r"\s+", " ", comment.replace(".  ", ".\0")
                                          ).replace(".\0", ".  ").strip()):
            for output, one, first, two, second in PART.findall(claim):
                yield name.removesuffix(end), end, output, first or "single", one
                if second:
                    yield name.removesuffix(end), end, output, second, two


def certified(lines: Sequence[str], output: str, precision: str) -> list[float]:
    """The errors of an output's components, as far as they have a bound."""
    figures = {(words := x.split())[1]: words for x in lines if x[0] not in "# "}
    places = dict(x[2:].split(" is ") for x in lines if x.startswith("# ") and "] is " in x)
    places |= {name: name for name, words in figures.items() if words[0] in ("copy", "single")}
    of = next(p for p in PRECISIONS if p.name == precision)
    errors = []
    for place, word in places.items():
        if place.partition("[")[0] != output:
            continue
        name, _, bits = word.partition("@")
        if name in figures:
            shift = Fraction(2)**(int(figures[name][-4]) - int(bits)) if bits else 1
            errors.append(float(float.fromhex(figures[name][-2]) * shift))
        elif bits:
            unit = Fraction(2)**-int(bits)
            errors.append(float(abs(Fraction(name) - round(Fraction(name) / unit) * unit)))
        else:
            near = Fraction(float(of.rounded(Fraction(name))))
            errors.append(float(abs(Fraction(name) - near)))
    return errors


def certify(path: Path, folder: Path) -> set[str]:
    """Compares every statement with its certificate; returns the tiers that state something."""
    assert main(["generate", str(path), "-o", str(folder / "c")]) == 0
    assert main(["certificate", str(path), "-o", str(folder / "proofs")]) == 0
    known: dict[Path, list[str]] = {}
    tiers = set()
    stem = path.stem
    for header in sorted((folder / "c").glob(f"{stem}*.h")):
        for name, end, output, precision, bound in stated(header.read_text("utf-8"), stem):
            mark = TIERS[end]
            file = folder / "proofs" / ("_".join(filter(None, (
                name, mark, "" if "fixed" in mark else precision))) + ".txt")
            if file not in known:
                known[file] = file.read_text("utf-8").splitlines()
                checker(FIXED if "fixed" in mark else BOUNDS)(known[file])
            most = max(certified(known[file], output, precision))
            assert most <= float(bound), (header.name, name, output, precision, most)
            if not mark:
                assert two_digits_up(most) == bound
            tiers.add(end)
    bounds = json.loads((folder / "proofs/bounds.json").read_text("utf-8"))
    for name, of in bounds.items():
        for precision, outputs in of.items():
            for output, each in outputs.items():
                if (some := [x for x in each["error"] if x is not None]):
                    lines = (folder / f"proofs/{name}_{precision}.txt").read_text("utf-8")
                    assert certified(lines.splitlines(), output, precision
                                     ) == pytest.approx(some, rel=1e-15, abs=0)
    return tiers


@pytest.mark.parametrize("kind", KINDS)
def test_every_bound_of_a_comment_is_certified(kind, tmp_path):
    path = tmp_path / "robot.toml"
    path.write_text(scene(kind), encoding="utf-8")
    tiers = certify(path, tmp_path)
    assert tiers >= {*TIERS} - ({"_fixed", "_fixed_high"} if kind in FLOATING else set())


@pytest.mark.parametrize("box", ("q = 0\nv = 0\na = 0", "v = 1e30\na = 1e30", "q = 400\nv = 1",
                                 "q = 1e-40\nv = 1e-20\na = 1"), ids=lambda x: x[:6])
def test_bounds_over_points_huge_and_tiny_ranges_are_certified(box, tmp_path):
    """Single precision overflows at 1e60, so that nothing is stated of torques there."""
    path = tmp_path / "gimbal.toml"
    text = GIMBAL.read_text("utf-8").replace('["fixed"]', '["fixed", "accurate", "pairs"]')
    path.write_text(text.partition("[ranges]")[0] + f"[ranges]\n{box}\n", encoding="utf-8")
    assert "_accurate" in certify(path, tmp_path)


def test_every_bound_of_the_example_is_certified(tmp_path):
    assert certify(GIMBAL, tmp_path) == {"", "_fixed", "_fixed_high"}
