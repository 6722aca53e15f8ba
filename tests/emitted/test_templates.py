"""Templates compute nothing: a file's arithmetic comes from Programs, through holes.

Comparisons are free: templates may loop and choose."""

from pathlib import Path

import jinja2
import pytest
from jinja2 import nodes

from tests.support.operators import operators

ROOT = Path(__file__).parents[2] / "templates"

PRIMITIVES = "what Programs' instructions are made of where a language has no such operation"
CHECKS = "asks the compiler or the machine whether it rounds as it must, from outside of Programs"
KSL = "functions KSL declares beside formulas: integers, sequences of axes, arrays, angles"
PLACES = "indices, strides, shapes and counts: where numbers stand, not what they are"
MEASURES = "a measuring program of the reports, not emitted for users"
EXEMPT = {
    "c/products.jinja": PRIMITIVES, "c/power.jinja": PRIMITIVES, "c/two_over_pi.jinja": PRIMITIVES,
    "c/product_error.jinja": PRIMITIVES, "c/product_errorf.jinja": PRIMITIVES,
    "c/product_rest.jinja": PRIMITIVES, "c/product_restf.jinja": PRIMITIVES,
    "python/elementary.jinja": PRIMITIVES, "python/exact.jinja": PRIMITIVES,
    "c/vectors.jinja": PRIMITIVES, "c/states.jinja": PRIMITIVES,
    "c/ksl_selfcheck.h.jinja": CHECKS, "python/_selfcheck.py.jinja": CHECKS,
    **{f"c/ksl/{x}.jinja": KSL for x in (
        "array.h", "euler.h", "inertia.h", "next_angles", "quaternion.h", "trig.h")},
    "c/ksl_types.h.jinja": "a version's number as an integer",
    "c/ksl_exact.h.jinja": PRIMITIVES,
    **{f"scene/{x}.jinja": PRIMITIVES for x in (
        "coscrew_fixed.h", "fixed.py", "fixed_products", "fixed_products_states", "fixed_sine",
        "fixed_sine_states", "fixed_states")},
    "scene/fixed.c.jinja": "rounds arguments to integers, which have no Program",
    **{f"{x}.jinja": PLACES for x in (
        "gufunc/module.c", "gufunc/lanes", "gufunc/checks",
        "gufunc/_lanes.h", "python/_arrays.py",
        "python/_kernel.py", "scene/arrays.py", "scene/out",
        "scene/many_states", "scene/step_of_states", "c/rows", "c/blocks", "c/tiles",
        "c/tiles_of_32_bytes", "c/tiles_of_64_bytes", "c/halves", "c/ksl_states.h",
        "c/many_of_states", "cuda/threads",
        "cuda/kernel", "cuda/two_over_pi", "c/tables", "scene/tables.py")},
    "cuda/elementary.jinja": PRIMITIVES,
    "cuda/headers.jinja": "the type of a difference of pointers",
    "report/drift.c.jinja": MEASURES}
"""Templates that compute, and why they may.  Pages are not kernels and are left out."""

TEMPLATES = sorted(p.relative_to(ROOT).as_posix() for p in ROOT.rglob("*.jinja")
                   if not {".html", ".css", ".md"} & set(p.suffixes))

def language_of(name: str) -> str:
    """C or Python, by the template's name."""
    python = name.startswith("python/") or ".py" in name or name == "scene/out.jinja"
    return "python" if python else "c"


@pytest.mark.parametrize("name", [x for x in TEMPLATES if x not in EXEMPT])
def test_templates_compute_nothing(name: str):
    result = operators((ROOT / name).read_text(encoding="utf-8"), language_of(name))
    assert not result, (f"{name} computes; let a Program do it, or exempt the template with a "
                        "reason:\n" + "\n".join(result))


@pytest.mark.parametrize("name", EXEMPT)
def test_exempt_templates_are_there_and_compute(name: str):
    assert name in TEMPLATES, f"{name} is gone: so should its exemption be"
    assert operators((ROOT / name).read_text(encoding="utf-8"), language_of(name)), (
        f"{name} computes nothing: it needs no exemption")


@pytest.mark.parametrize("name", TEMPLATES)
def test_holes_compute_nothing(name: str):
    tree = jinja2.Environment().parse((ROOT / name).read_text(encoding="utf-8"))
    arithmetic = (nodes.Add, nodes.Sub, nodes.Mul, nodes.Div, nodes.FloorDiv, nodes.Mod, nodes.Pow)
    results = [x.lineno for kind in arithmetic for x in tree.find_all(kind)]
    assert not results, f"{name}: computed within a hole or a loop, in lines {results}"


@pytest.mark.parametrize("name", ("scene/step.c.jinja", "scene/step.py.jinja"))
def test_templates_of_steps_call_nothing_back(name: str):
    """They print the calls of steps and do not call back into the generator."""
    tree = jinja2.Environment().parse((ROOT / name).read_text(encoding="utf-8"))
    assert not list(tree.find_all(nodes.Call))


@pytest.mark.parametrize("line", (
    "v[i] += phi[i];", "phi[i] = h * v[i];", "x = {{ a }} - {{ b }};", "x = (a)/(b);", "y = 2*x;",
    "z = f(x) % 3;", "w = a -b;", "const {{ real }} half = h / 2, sixth = h / 6;"))
def test_computing_is_seen_in_c(line: str):
    assert len(operators(line, "c")) == 1


@pytest.mark.parametrize("line", (
    "v = v + dt * a", "phi = {{ part }} * {{ speeds }}", "x **= y", "q //= h", "a = b[0]-c"))
def test_computing_is_seen_in_python(line: str):
    assert len(operators(line, "python")) == 1


@pytest.mark.parametrize("line", (
    "for (int k = 0; k < (int){{ count }}; k++) { f(&t, *p, -1.5e-3, x->y); } /* a + b */",
    "const {{ real }} *x, **y = \"a + b\";", "return -1;", "static void f(double *q);",
    "if (n > 0)", "#include <a-b/c.h>"))
def test_loops_calls_and_pointers_are_free_in_c(line: str):
    assert not operators(line, "c")


@pytest.mark.parametrize("line", (
    "def f(x, *, out=None, **more):", "q, v = spread(lead, q, v)  # a + b", "f(*x, **y)",
    '"""a + b"""', "def f() -> int:", "return f(-1, x)"))
def test_loops_calls_and_stars_are_free_in_python(line: str):
    assert not operators(line, "python")
