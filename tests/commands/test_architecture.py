"""The generator's packages: few, in an order in which imports run, with names that differ."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "codegen/coscrew_codegen"
GUIDE = ROOT / "docs/architecture.md"
TABLE = GUIDE.read_text(encoding="utf-8").partition("| package | what it does |\n|---|---|\n")[2]
ROWS = dict(re.findall(r"^\| `(\w+)/` \| (.+) \|$", TABLE.partition("\n\n")[0], re.MULTILINE))
ORDER = tuple(ROWS)
"""The packages, in the order of their imports."""

FILES = 18
"""The most modules of a folder: one family of operations, one effect, one tier a file."""


@cache
def modules() -> dict[str, Path]:
    """Every module by its name without the package's: program, program.ops, …"""
    paths = sorted(PACKAGE.rglob("*.py"))
    names = (path.relative_to(PACKAGE).with_suffix("").parts for path in paths)
    return {".".join(x[:-1] if x[-1] == "__init__" else x): path
            for x, path in zip(names, paths, strict=True)}


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def imported(name: str) -> Iterator[str]:
    """The modules that a module imports: at its top, in functions, for types."""
    path = modules()[name]
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{path}: a relative import"
            for alias in node.names:
                inner = f"{node.module}.{alias.name}".removeprefix("coscrew_codegen.")
                yield f"coscrew_codegen.{inner}" if inner in modules() else str(node.module)


def own(name: str) -> set[str]:
    """The generator's modules among these, without the generator's name."""
    return {x.removeprefix("coscrew_codegen").removeprefix(".") for x in imported(name)
            if x.split(".")[0] == "coscrew_codegen"}


def test_there_are_at_most_ten_packages_each_with_a_sentence():
    there = {x.name for x in PACKAGE.iterdir() if x.name != "__pycache__"}
    assert there == {*ORDER, "__init__.py", "__main__.py", "py.typed"}
    assert len(ORDER) <= 10
    for name, sentence in ROWS.items():
        assert sentence.endswith(".") and len(sentence.split()) > 3, name


def test_packages_import_only_those_above_them():
    """Imports in functions and for types, too; so there is no cycle of packages."""
    for name in modules():
        here = name.split(".")[0]
        if here not in ORDER:  # __init__, which finds its names on first use; __main__
            continue
        for other in own(name):
            there = other.split(".")[0]
            assert there in ORDER, f"{name} imports coscrew_codegen itself"
            assert ORDER.index(there) <= ORDER.index(here), f"{name} imports {other}"


def test_what_is_generated_is_imported_where_it_is_measured_or_run():
    for name in modules():
        if "coscrew" in {x.split(".")[0] for x in imported(name)}:
            assert name.split(".")[0] in ("reports", "runtime", "simulation"), name


ARGUMENTS = "program.values.quantity"
"""Names the symbols of arguments, when formulas ask for them."""


def test_sympy_is_known_where_formulas_are():
    for name in modules():
        if "sympy" in {x.split(".")[0] for x in imported(name)} and name != ARGUMENTS:
            assert name.startswith(("algebra.", "accuracy.tiers.", "reports.reference.",
                                    "reports.kernels.")), name


def test_values_are_pickled_in_one_module():
    assert {name for name in modules() if {x.split(".")[0] for x in imported(name)}
            & {"pickle", "marshal", "shelve"}} == {"runtime.cache"}


def test_texts_become_python_by_imports_and_no_stack_is_walked():
    for name, path in modules().items():
        for node in ast.walk(tree(path)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                assert node.func.id not in ("exec", "eval", "compile", "__import__"), name
            if isinstance(node, ast.Attribute):
                assert node.attr not in ("_getframe", "f_back", "currentframe"), name


_DERIVES = ("dynamics", "scene.scene", "scene.mechanism", "scene.readers", "scene.effects",
            "algebra.lowering.kernel", "algebra.lowering.schedule")
_LANGUAGES = ("backends.c", "backends.cuda", "backends.numpy", "backends.python_extension",
              "backends.scene")
MUST_NOT_KNOW = {
    "algebra.operations": ("algebra.lowering", "algebra.recording"),
    "scene.mechanism": ("scene.effects", "scene.readers"),
    "scene.effects": ("scene.readers",),
    **dict.fromkeys(_LANGUAGES, _DERIVES),
    "simulation.sweep": ("dynamics", *_LANGUAGES),
    "simulation.check": ("simulation.sweep",), "simulation.recordings": ("simulation.sweep",),
    "reports.cost": ("simulation.sweep", "reports.kernels", "reports.reference"),
    "reports.kernels": ("simulation", "reports.cost", "reports.reference"),
    "reports.reference": ("simulation", "reports.cost", "reports.kernels")}
"""Beyond the order."""


def within(name: str, package: str) -> bool:
    return f"{name}.".startswith(f"{package}.")


@pytest.mark.parametrize("package", MUST_NOT_KNOW)
def test_packages_do_not_know_what_is_not_theirs(package: str):
    inside = [x for x in modules() if within(x, package)]
    assert inside
    for name in inside:
        for other in own(name):
            assert not any(within(other, x) for x in MUST_NOT_KNOW[package]), (
                f"{name} imports {other}")


def test_no_effect_knows_another():
    for name in modules():
        if within(name, "scene.effects") and name != "scene.effects":
            assert not any(within(x, "scene.effects") for x in own(name)), name


def test_folders_are_surveyed_at_a_glance():
    count = defaultdict(int)
    for path in modules().values():
        count[path.parent] += path.name != "__init__.py"
    over = {folder.relative_to(PACKAGE).as_posix(): n for folder, n in count.items() if n > FILES}
    assert not over, f"more than {FILES} modules: make folders in it: {over}"


def test_no_two_modules_have_one_name():
    count = defaultdict(list)
    for name, path in modules().items():
        if path.name != "__init__.py":
            count[path.stem].append(name)
    twice = {stem: names for stem, names in count.items() if len(names) > 1}
    assert not twice


SAME_IDEA = {"_Writer": "of the statements of one kernel, in C, in C on many elements, in NumPy"}


def test_no_two_classes_have_one_name():
    """Unless they are one idea in two languages."""
    count = defaultdict(list)
    for name, path in modules().items():
        for node in tree(path).body:
            if isinstance(node, ast.ClassDef):
                count[node.name].append(name)
    twice = {x: names for x, names in count.items() if len(names) > 1 and x not in SAME_IDEA}
    assert not twice
    for name in SAME_IDEA:
        assert len(count[name]) > 1 and all(within(x, "backends") for x in count[name]), name
