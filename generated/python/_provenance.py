# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Whether an extension module is there, and was built from these very kernels."""

import importlib
import warnings


def is_compiled(extension: str, provenance: str) -> bool:
    """Whether it is; warns, as a message to whoever imports the caller, where it is a wrong one."""
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
