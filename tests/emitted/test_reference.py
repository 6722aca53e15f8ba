"""The reference is correct: its formulas are those of the kernels, its calls work."""

import ast
import inspect
import math
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from docutils.utils.math.latex2mathml import tex2mathml

import coscrew
from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, Operation
from coscrew_codegen.reports.reference.notation import markdown
from coscrew_codegen.scene.effects import EFFECTS
from tests.support.cases import for_all

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "generated/docs"
PAGES = {family: (FOLDER / f"operations/{family}.md").read_text(encoding="utf-8")
         for family in FAMILIES}
ENTRIES = {entry.split("\n", 1)[0]: entry for page in PAGES.values()
           for entry in page.split("\n## ")[1:]}
BLOCK = re.compile(r"^```math\n(.*?)\n```$", re.MULTILINE | re.DOTALL)
INLINE = re.compile(r"\$`(.+?)`\$")


def test_every_operation_has_an_entry():
    assert sum(page.count("\n## ") for page in PAGES.values()) == len(OPERATIONS)
    for operation in OPERATIONS:
        assert f"`{operation.signature}`" in ENTRIES[operation.name]


def test_all_formulas_are_latex_that_docutils_knows():
    for path in sorted(FOLDER.rglob("*.md")):
        text = path.read_text(encoding="utf-8")
        for formula in BLOCK.findall(text):
            tex2mathml(formula, as_block=True)
        for formula in INLINE.findall(text):
            tex2mathml(formula)


def test_prototypes_are_those_of_the_headers(tmp_path):
    """C allows a function to be declared twice if both declarations are the same."""
    prototypes = [prototype for page in PAGES.values()
                  for prototype in re.findall(r"```c\n(.*?)```", page, re.DOTALL)]
    text = "".join(prototypes)
    assert text.count(";") == 2 * len(OPERATIONS)
    (tmp_path / "all.c").write_text(f'#include "ksl/ksl.h"\n{text}')
    subprocess.run(["cc", "-std=c11", "-Wall", "-Werror", "-fsyntax-only", "-I",
                    str(ROOT / "generated/c/include"), "all.c"], cwd=tmp_path, check=True)


def test_calls_are_those_of_the_modules():
    for operation in OPERATIONS:
        call, modules = re.search(r"^- Python: `(.*)` of (.*)\.$", ENTRIES[operation.name],
                                  re.MULTILINE).groups()
        name, arguments = re.fullmatch(r"(\w+)\((.*), out=None\)", call).groups()
        twin = getattr(coscrew.double, name)
        names = [x for x in inspect.signature(inspect.unwrap(twin)).parameters if x != "out"]
        assert arguments.split(", ") == names or not names or names == ["args", "kwargs"], name
        for module in re.findall(r"`([\w.]+)`", modules):
            assert hasattr(__import__(module, fromlist=["_"]), name), (module, name)
        assert len(arguments.split(", ")) == len(operation.inputs)


def test_costs_and_bounds_are_those_of_the_docstrings():
    for operation in OPERATIONS:
        rows = re.findall(r"^\| (\w+) \| (.*?) \| ((?:\\\||[^|])*) \|$", ENTRIES[operation.name],
                          re.MULTILINE)
        assert [row[0] for row in rows[:2]] == ["tier", "plain"]
        for tier, cost, error in rows[1:]:
            module = coscrew.double if tier == "plain" else __import__(
                f"coscrew.{tier}.double", fromlist=["_"])
            message = " ".join(inspect.getdoc(getattr(module, operation.name)).split())
            assert cost.capitalize() in message, (operation.name, tier)
            wanted = " ".join(re.sub(r"\\(?=[|<>*_\[\]])", "", error).split())
            assert wanted in message or "returned" in error, (operation.name, tier)


def shown(operation: Operation) -> list[str]:
    return BLOCK.findall(ENTRIES[operation.name])


@for_all(operation=[op for op in OPERATIONS if shown(op)])
def test_formulas_shown_are_what_kernels_compute(operation):
    """The LaTeX, read back and evaluated, gives the kernel's result except for rounding."""
    draw = np.random.default_rng(5)
    inputs = [draw.uniform(0.5, 2, argument.quantity.shape) for argument in operation.inputs]
    results = getattr(coscrew.double, operation.name)(*inputs)
    results = results if len(operation.outputs) > 1 else (results,)
    values = {name: float(number) for argument, array in zip(operation.inputs, inputs, strict=True)
              for name, number in components(argument, array)}
    formulas = shown(operation)
    assert len(formulas) == len(operation.outputs)
    for formula, wanted in zip(formulas, results, strict=True):
        right = re.split(r"=|\\leftarrow", formula, maxsplit=1)[1]
        outcomes = [evaluated(x, values) for x in entries(right)]
        assert np.allclose(outcomes, np.ravel(wanted), rtol=1e-13, atol=1e-13)


def components(argument, array: np.ndarray):
    """('ci_0', number): names as `plain` makes them of the LaTeX."""
    numbered = re.fullmatch(r"([^\W\d_]+)(\d\w*)", argument.name)
    base = f"{numbered[1]}_{numbered[2]}_" if numbered else f"{argument.name}_"
    axes = {"vec3": "xyz", "vec4": "xyzw", "quaternion": "xyzw"}.get(argument.quantity.name)
    if not argument.quantity.shape:
        return [(base[:-1], array)]
    return [(base + (axes[index[0]] if axes else "".join(map(str, index))), number)
            for index, number in np.ndenumerate(array)]


def entries(right: str) -> list[str]:
    """The entries of a matrix, row by row, or the one formula."""
    inside = re.fullmatch(r"\s*\\begin\{pmatrix\}(.*)\\end\{pmatrix\}\s*", right, re.DOTALL)
    return re.split(r"\\\\|&", inside[1]) if inside else [right]


def evaluated(latex: str, values: dict[str, float]) -> float:
    tree = ast.parse(plain(latex).strip(), mode="eval")
    return eval(compile(tree, latex, "eval"), {"sqrt": math.sqrt, "sin": math.sin,
                                               "cos": math.cos}, values)


def plain(latex: str) -> str:
    """LaTeX as SymPy writes it, as Python: \\mathrm{ci}_{0} \\left(…\\right) → ci_0*(…)."""
    text = re.sub(r"\\mathrm\{(\w+)\}", r"\1", latex)
    text = re.sub(r"_\{([\w,]+)\}", lambda m: "_" + m[1].replace(",", "_"), text)
    text = text.replace(r"\left(", "(").replace(r"\right)", ")")
    text = re.sub(r"\^\{(\d+)\}", r"**\1", text)
    while (new := re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", text)) != text:
        text = new
    text = re.sub(r"\\(sqrt|sin|cos)\{([^{}]*)\}", r"\1(\2)", text)
    return re.sub(r"(?<=[\w)])\s+(?=[\w(])", "*", text.strip())


@pytest.mark.parametrize("text, wanted", (
    ("co = [ad]*(s) c = (ω×f ; v×f + ω×τ)", r"$`\mathrm{co} = [\mathrm{ad}]^{*}(s)\,c = "
     r"(\omega \times f;\;v \times f + \omega \times \tau)`$"),
    ("|v| = sqrt(v·v)", r"$`|v| = \sqrt{v \cdot v}`$"),
    ("R by a turn, a~ y = a × y", r"$`R`$ by a turn, $`\tilde{a}\,y = a \times y`$"),
    ("M = [[R, t~R], [0, R]] of D = [R | t]", r"$`M = \begin{bmatrix} R & \tilde{t}R \\ "
     r"0 & R \end{bmatrix}`$ of $`D = [R \mid t]`$"),
    ("below 1e-9 (single: 1e-6), with screw_norm", r"below $`10^{-9}`$ (single: $`10^{-6}`$), "
     "with `screw_norm`")))
def test_statements_become_formulas_and_prose(text, wanted):
    result = markdown(text, {"co", "s", "c", "v", "R", "M", "D"}, {"screw_norm"})
    assert re.sub(r"\s", "", result) == re.sub(r"\s", "", wanted)


def test_effects_have_their_equations_and_parameters():
    text = (FOLDER / "effects.md").read_text(encoding="utf-8")
    sections = dict(section.split("\n", 1) for section in text.split("\n## ")[1:])
    assert list(sections) == [effect.name for effect in EFFECTS], (
        "generated/docs/effects.md is out of date: make generate")
    for effect in EFFECTS:
        assert "$" in sections[effect.name], effect.name
        rows = re.findall(r"^\| `(\w+)` \| (.*?) \|", sections[effect.name], re.MULTILINE)
        assert [name for name, _ in rows] == [x.name for x in effect.parameters]
        assert [unit.replace("\\", "") for _, unit in rows] == [x.unit for x in effect.parameters]
