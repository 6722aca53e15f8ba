"""Tiers are values that can be read one at a time: no class inherits from another of the project,
no tier's module imports another tier's, and each way of carrying values has a rule for every
operation that tiers carry."""

import ast
from pathlib import Path

import pytest

from coscrew_codegen.accuracy import tiers
from coscrew_codegen.accuracy.tiers.accurate import CAREFUL, QUICK
from coscrew_codegen.accuracy.tiers.accurate_scene import SCENES
from coscrew_codegen.accuracy.tiers.certified_scene import BOUNDED
from coscrew_codegen.accuracy.tiers.compensated import Carrying
from coscrew_codegen.accuracy.tiers.nonlinear import RULES
from coscrew_codegen.accuracy.tiers.sizes import ERRORS

FOLDER = Path(tiers.__file__ or "").parent
MODULES = {path.stem: ast.parse(path.read_text(encoding="utf-8"))
           for path in sorted(FOLDER.glob("*.py"))}
ERROR_CLASSES = {"ReportedError", "ValueError"}


def of_tiers() -> set[str]:
    """The modules that define a tier."""
    return {name for name, tree in MODULES.items()
            if any(isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "TIER"
                   for node in tree.body)}


def imported(tree: ast.Module) -> set[str]:
    """The last words of the names that a module imports from, or imports."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    return {word for node in nodes for word in (
        (node.module or "").rpartition(".")[2], *(alias.name for alias in node.names))}


@pytest.mark.parametrize("module", MODULES)
def test_no_tier_inherits(module: str):
    for node in ast.walk(MODULES[module]):
        if isinstance(node, ast.ClassDef):
            assert {ast.unparse(base) for base in node.bases} <= ERROR_CLASSES, node.name


def test_no_tier_imports_another():
    names = of_tiers()
    assert {"accurate", "certified", "mixed", "pairs"} <= names
    for name in names:
        assert not imported(MODULES[name]) & names, name


@pytest.mark.parametrize("how", (QUICK, CAREFUL, SCENES, ERRORS))
def test_every_operation_has_a_rule(how: Carrying):
    assert how.rules.keys() == RULES.keys() == BOUNDED
