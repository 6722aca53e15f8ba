"""Parametrizations that many tests share."""

import pytest

from coscrew_codegen.formats import PRECISIONS
from coscrew_codegen.operations import OPERATIONS
from tests.support.compiled.c_harness import COMPILERS

each_precision = pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
each_compiler = pytest.mark.parametrize("compiler", COMPILERS)
each_operation = pytest.mark.parametrize("operation", OPERATIONS, ids=lambda op: op.name)
