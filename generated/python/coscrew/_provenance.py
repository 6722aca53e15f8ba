# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Checks that an extension module exists and was built from these kernels."""

import importlib
import warnings


def is_compiled(extension: str, provenance: str) -> bool:
    """Whether it does; if it exists but cannot be used, warns at the import of the caller."""
    try:
        module = importlib.import_module(extension)
    except ModuleNotFoundError:
        return False
    except ImportError as error:
        reason = f"it cannot be loaded ({error})"
    else:
        if getattr(module, "PROVENANCE", None) == provenance:
            return True
        reason = "it was built from other kernels than these"
    package = extension.rpartition(".")[0]
    warnings.warn(f"{package} runs in pure NumPy and not in its compiled extension: {reason}; "
                  "reinstall coscrew or, in its source tree, run `make`", RuntimeWarning,
                  stacklevel=3)
    return False
