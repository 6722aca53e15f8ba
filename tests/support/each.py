"""Parametrizations that many tests share."""

import pytest

from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.program.values.formats import PRECISIONS
from tests.support.compiled.c_harness import COMPILERS

each_precision = pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
each_compiler = pytest.mark.parametrize("compiler", COMPILERS)
each_operation = pytest.mark.parametrize("operation", OPERATIONS, ids=lambda op: op.name)
