# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""The functions of scenes by name, as `load_scene` returns them; for type checkers."""

from typing import TypeVar

import numpy as np

from coscrew._steps import Steps
from coscrew_codegen.runtime.callables import Function

Real = TypeVar("Real", bound=np.floating, covariant=True)

class NamedFunctions(Steps[Real]):
    inverse_dynamics: Function[Real]
    inverse_dynamics_derivatives: Function[Real]
    torque_regressor: Function[Real]
    linear_parameters: Function[Real]
    base_regressor: Function[Real]
    base_parameters: Function[Real]
    forward_dynamics: Function[Real]
    forward_dynamics_derivatives: Function[Real]
    mass_matrix: Function[Real]
    coriolis_matrix: Function[Real]
    bias_torques: Function[Real]
    gravity_torques: Function[Real]
    energy: Function[Real]
    energy_gradients: Function[Real]
    power: Function[Real]
    momentum: Function[Real]
    centroidal_momentum_matrix: Function[Real]
    centroidal_momentum_rate: Function[Real]
    center_of_mass: Function[Real]
    center_of_mass_velocity: Function[Real]
    center_of_mass_jacobian: Function[Real]
    body_poses: Function[Real]
    body_twists: Function[Real]
    integrated: Function[Real]
    difference: Function[Real]
    chart: Function[Real]
