# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""The steps of scenes' integrators by name, as `load_scene` returns them; for type checkers."""

from typing import Generic, TypeVar

import numpy as np

from coscrew_codegen.runtime.callables import Step

Real = TypeVar("Real", bound=np.floating, covariant=True)

class Steps(Generic[Real]):
    step_leapfrog: Step[Real]
    step_linear_implicit_euler: Step[Real]
    step_semi_implicit_euler: Step[Real]
    step_rk4: Step[Real]
