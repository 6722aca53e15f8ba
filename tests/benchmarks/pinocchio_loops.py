"""Pinocchio compiled from its headers for this processor, in loops over states, as a rival.

Its headers and Boost's come with its wheel, Eigen's with the package cmeel-eigen (the extra `peers`)
or Debian's libeigen3-dev.  Nothing of the wheel's library is linked, which other flags have aligned
for another processor.  Where Pinocchio has two algorithms, that of each frame's own coordinates and
that of the world's, both are loops here.
"""

import ctypes
import hashlib
import shutil
import subprocess
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import pinocchio as pin

from coscrew_codegen.console import doing
from coscrew_codegen.machine import processor
from coscrew_codegen.native.timing import Loop
from coscrew_codegen.scene.model import Kind
from tests.support.scenes.robots import FOLDER, Robot, model_of, paired, scene_of

ROBOTS = {"ur5": ("ur_description/urdf/ur5_robot.urdf", False),
          "panda7": ("panda_description/urdf/panda.urdf", False),  # its fingers fixed
          "g1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True)}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
KINDS = ("JointModelRX", "JointModelRY", "JointModelRZ", "JointModelFreeFlyer")
LOOPS = {"inverse_dynamics": ("inverse_dynamics",),
         "forward_dynamics": ("forward_dynamics_local", "forward_dynamics_world"),
         "mass_matrix": ("mass_matrix_local", "mass_matrix_world")}
SOURCE = Path(__file__).with_name("pinocchio.cpp")
BUILD = SOURCE.parents[2] / "build"
INCLUDE = FOLDER.parents[2] / "include"
EIGEN = (INCLUDE / "eigen3", Path("/usr/include/eigen3"))
DEFINED = ("BOOST_MPL_LIMIT_LIST_SIZE=30", "BOOST_MPL_LIMIT_VECTOR_SIZE=30",
           "BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "BOOST_FUSION_INVOKE_MAX_ARITY=12", "NDEBUG")
FLAGS = ("-std=c++17", "-O3", "-march=native", "-w", "-fPIC", "-shared", "-fvisibility=hidden",
         *(f"-D{x}" for x in DEFINED))


class NotThereError(RuntimeError):
    """What is missing of the rival."""


def robot_named(name: str) -> Robot:
    """A robot of ROBOTS in both libraries."""
    file, free = ROBOTS[name]
    scene, model = replace(scene_of(file, free), name=name), model_of(file, free)
    if name == "panda7":
        fingers = [x for x in model.names if "finger" in x]
        joints = tuple(replace(x, kind=Kind.FIXED, mimic=None) if x.name in fingers else x
                       for x in scene.model.joints)
        scene = replace(scene, model=replace(scene.model, joints=joints))
        model = pin.buildReducedModel(model, [model.getJointId(x) for x in fingers],
                                      pin.neutral(model))
    return paired(scene, model, FUNCTIONS)


def compiled(compiler: str) -> ctypes.CDLL:
    """The loops, compiled once for a compiler and a processor.  Raises NotThereError."""
    if not shutil.which(compiler):
        raise NotThereError(f"no {compiler}")
    eigen = next((x for x in EIGEN if (x / "Eigen").is_dir()), None)
    if not eigen:
        raise NotThereError("no Eigen: pip install cmeel-eigen, or apt-get install libeigen3-dev")
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True)
    made_of = (SOURCE.read_text(), version.stdout, processor(), pin.__version__, str(eigen), *FLAGS)
    key = hashlib.sha256("\0".join(made_of).encode()).hexdigest()[:12]
    library = BUILD / f"pinocchio-{compiler}-{key}.so"
    if not library.exists():
        BUILD.mkdir(exist_ok=True)
        new = library.with_suffix(".new")
        with doing(f"compiling Pinocchio with {compiler}, two minutes"):
            done = subprocess.run([compiler, *FLAGS, f"-I{INCLUDE}", f"-I{eigen}", str(SOURCE),
                                   "-Wl,--no-undefined", "-o", str(new)],
                                  capture_output=True, text=True)
        if done.returncode:
            raise NotThereError(f"{compiler} fails: {done.stderr.strip().splitlines()[0]}")
        new.rename(library)
    return ctypes.CDLL(str(library))


@dataclass(frozen=True, eq=False)
class Rival:
    """A robot in such a library, at these states of ours."""

    library: ctypes.CDLL
    robot: Robot
    states: tuple[np.ndarray, ...]  # q, v, and accelerations or torques

    def loops(self, function: str) -> list[Loop]:
        """The loops of a function over all states."""
        return [self._loop(name, None) for name in LOOPS[function]]

    def values(self, function: str) -> list[np.ndarray]:
        """Each loop's results in our order: of vectors, or of symmetric matrices."""
        nv, count, found = self.robot.functions.nv, len(self.states[0]), []
        for name in LOOPS[function]:
            matrices = function == "mass_matrix"
            results = np.zeros((count, nv, nv) if matrices else (count, nv))
            loop = self._loop(name, results)
            loop.function(ctypes.c_long(count), loop.arguments)
            if matrices:  # by columns, the upper triangle
                upper = np.tril(results)
                results = upper + np.tril(results, -1).transpose(0, 2, 1)
                results = self.robot.follow.T @ results @ self.robot.follow
            else:
                results = results @ self.robot.follow
            found.append(results)
        return found

    def _loop(self, name: str, results: np.ndarray | None) -> Loop:
        arrays = [*self._given, *([] if results is None else [results])]
        pointers = (ctypes.c_void_p * 5)(self._handle, *(x.ctypes.data for x in arrays))
        pointers.kept = arrays  # type: ignore[attr-defined]
        return Loop(getattr(self.library, name), len(self.states[0]), pointers)

    @cached_property
    def _given(self) -> list[np.ndarray]:
        """The states in Pinocchio's order."""
        q, v, a = self.states
        follow = self.robot.follow.T
        return [np.array([self.robot.theirs(x) for x in q]),
                *(np.ascontiguousarray(x @ follow) for x in (v, a))]

    @cached_property
    def _handle(self) -> int:
        """The robot in C++, which is never freed."""
        model, parts = self.robot.model, []
        for k in range(1, model.njoints):
            placement, body = model.jointPlacements[k], model.inertias[k]
            parts.append((KINDS.index(model.joints[k].shortname()), model.parents[k],
                          [*placement.rotation.T.ravel(), *placement.translation],
                          [body.mass, *body.lever, *body.inertia.T[np.tril_indices(3)]]))
        kinds, parents, placements, inertias = zip(*parts, strict=True)
        arrays = (np.array(kinds, np.intc), np.array(parents, np.intc), np.array(placements),
                  np.array(inertias))
        self.library.robot_of.restype = ctypes.c_void_p
        return self.library.robot_of(ctypes.c_long(len(parts)), *(
            ctypes.c_void_p(x.ctypes.data) for x in arrays))


def refuse_others(found: np.ndarray, rival: Rival, function: str) -> None:
    """Raise ValueError unless our results are the rival's to rounding: within 1e-12 of the largest
    number of each state, or for accelerations within what rounding moves them by."""
    unit, count = 2.0**-53, len(found)
    bounds = np.full(count, 1e-12)
    if function == "forward_dynamics":
        bounds = np.maximum(bounds, unit * np.linalg.cond(rival.values("mass_matrix")[0]))
    for values in rival.values(function):
        ours, theirs = found.reshape(count, -1), values.reshape(count, -1)
        errors = abs(ours - theirs).max(axis=1) / abs(theirs).max(axis=1)
        if not (errors <= bounds).all():
            raise ValueError(f"{function} of {rival.robot.functions.name}: our results and "
                             f"Pinocchio's differ by {errors.max():.1e} of the largest, not by "
                             "rounding")
