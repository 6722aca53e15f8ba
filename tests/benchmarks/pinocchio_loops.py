"""Pinocchio compiled from its headers for this processor, in loops over states, as a rival.

Its headers and Boost's come with its wheel, Eigen's with the package cmeel-eigen (the extra
`peers`) or Debian's libeigen3-dev.  Nothing of the wheel's library is linked: Eigen aligns its
objects as the flags say, here to 64 bytes where a processor has AVX-512, there to 16.
"""

import ctypes
import hashlib
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import pinocchio as pin

from coscrew_codegen.reports.processor import processor
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.kinds import Kind
from tests.support.scenes.robots import FOLDER, Robot, model_of, paired, scene_of

ROBOTS = {"ur5": ("ur_description/urdf/ur5_robot.urdf", False),
          "panda7": ("panda_description/urdf/panda.urdf", False),  # its fingers fixed
          "g1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True)}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
DERIVATIVES = ("inverse_dynamics_derivatives", "forward_dynamics_derivatives")
MATRICES = {"mass_matrix": 1, **dict.fromkeys(DERIVATIVES, 3)}
"""The number of square matrices that a function returns."""
_FINGER = "_finger_joint"
KINDS = ("JointModelRX", "JointModelRY", "JointModelRZ", "JointModelFreeFlyer")
SOURCE = Path(__file__).with_name("pinocchio.cpp")
HEADER = Path(__file__).with_name("pinocchio_model.h")
BUILD = SOURCE.parents[2] / "build"
INCLUDE = FOLDER.parents[2] / "include"
EIGEN = (INCLUDE / "eigen3", Path("/usr/include/eigen3"))
DEFINED = ("BOOST_MPL_LIMIT_LIST_SIZE=30", "BOOST_MPL_LIMIT_VECTOR_SIZE=30",
           "BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "BOOST_FUSION_INVOKE_MAX_ARITY=12", "NDEBUG")
OPTIMISED = "-O3 -march=native"
FLAGS = tuple(OPTIMISED.split())
COMMON = ("-std=c++17", "-w", "-fPIC", "-shared", "-fvisibility=hidden",
          *(f"-D{x}" for x in DEFINED))


def scene_named(name: str) -> Scene:
    """A robot of ROBOTS under gravity."""
    scene = replace(scene_of(*ROBOTS[name]), name=name)
    joints = tuple(replace(x, kind=Kind.FIXED, mimic=None) if _FINGER in x.name else x
                   for x in scene.model.joints)
    return replace(scene, model=replace(scene.model, joints=joints))


def robot_named(name: str, functions: Sequence[str] = FUNCTIONS) -> Robot:
    """A robot of ROBOTS in both libraries, with these functions."""
    return paired(scene_named(name), pinocchio_model(name), functions)


def pinocchio_model(name: str) -> pin.Model:
    """A robot of ROBOTS, its fingers locked."""
    model = model_of(*ROBOTS[name])
    fingers = [model.getJointId(x) for x in model.names if _FINGER in x]
    return pin.buildReducedModel(model, fingers, pin.neutral(model)) if fingers else model


def library(compiler: str, source: Path = SOURCE, flags: Sequence[str] = FLAGS
            ) -> tuple[ctypes.CDLL | None, str]:
    """The loops, compiled once for a compiler and a processor; or None, and the missing libraries.
    """
    if not shutil.which(compiler):
        return None, f"no {compiler}"
    eigen = next((x for x in EIGEN if (x / "Eigen").is_dir()), None)
    if not eigen:
        return None, "no Eigen: pip install cmeel-eigen, or apt-get install libeigen3-dev"
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True)
    made_of = (source.read_text(), HEADER.read_text(), version.stdout, processor(),
               pin.__version__, str(eigen), *flags)
    key = hashlib.sha256("\0".join(made_of).encode()).hexdigest()[:12]
    path = BUILD / f"{source.stem}-{compiler}-{key}.so"
    if not path.exists():
        BUILD.mkdir(exist_ok=True)
        print(f"compiling {source.name} with {compiler}, a minute or two …", flush=True)
        command = [compiler, f"-I{INCLUDE}", f"-I{eigen}", str(source), *COMMON, *flags,
                   "-Wl,--no-undefined", "-o", str(path.with_suffix(".new"))]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            return None, f"{compiler} fails: {done.stderr.strip().splitlines()[0]}"
        path.with_suffix(".new").rename(path)
    return ctypes.CDLL(str(path)), ""


def in_their_order(robot: Robot, states: tuple[np.ndarray, ...]) -> list[np.ndarray]:
    """States q, v, a in Pinocchio's order."""
    q, *others = states
    return [aligned(np.array([robot.theirs(x) for x in q])),
            *(aligned(x @ robot.follow.T) for x in others)]


@dataclass(frozen=True, eq=False)
class Pinocchio:
    """A robot in such a library, at these states of ours."""

    library: ctypes.CDLL
    robot: Robot
    states: tuple[np.ndarray, ...]  # q, v, and accelerations or torques

    def loop(self, function: str, results: np.ndarray | None = None) -> Loop:
        """The loop of a function over all states, which keeps no results unless it is given an
        array."""
        arrays = [*self._given, *([] if results is None else [results])]
        pointers = (ctypes.c_void_p * 5)(self._handle, *(x.ctypes.data for x in arrays))
        pointers.kept = arrays  # type: ignore[attr-defined]
        return Loop(getattr(self.library, function), len(self.states[0]), pointers)

    def values(self, function: str) -> np.ndarray:
        """Its results in our order, by state: vectors, or matrices, the last one symmetric."""
        nv, count, follow = self.robot.model.nv, len(self.states[0]), self.robot.follow
        matrices = MATRICES.get(function)
        results = np.zeros((count, matrices, nv, nv) if matrices else (count, nv))
        loop = self.loop(function, results)
        loop.function(ctypes.c_long(count), loop.arguments)
        if not matrices:
            return results @ follow
        upper = np.triu(results[:, -1])
        results[:, -1] = upper + np.triu(upper, 1).transpose(0, 2, 1)
        return follow.T @ results @ follow

    @cached_property
    def _given(self) -> list[np.ndarray]:
        return in_their_order(self.robot, self.states)

    @cached_property
    def _handle(self) -> int:
        """The robot in C++, which is never freed."""
        self.library.robot_of.restype = ctypes.c_void_p
        return int(with_joints(self.robot.model, self.library.robot_of))


def with_joints(model: pin.Model, function: "ctypes._NamedFuncPointer", *given: object) -> object:
    """function(…, joints): what model_of in pinocchio_model.h takes."""
    parts = []
    for k in range(1, model.njoints):
        placement, body = model.jointPlacements[k], model.inertias[k]
        parts.append((KINDS.index(model.joints[k].shortname()), model.parents[k],
                      [*placement.rotation.T.ravel(), *placement.translation],
                      [body.mass, *body.lever, *body.inertia[np.tril_indices(3)]]))
    kinds, parents, placements, inertias = zip(*parts, strict=True)
    arrays = (np.array(kinds, np.intc), np.array(parents, np.intc), np.array(placements),
              np.array(inertias))
    return function(*given, ctypes.c_long(len(parts)),
                    *(ctypes.c_void_p(x.ctypes.data) for x in arrays))


def refuse_others(results: Sequence[np.ndarray], rival: "Pinocchio", function: str) -> None:
    """Raise ValueError unless our results are the rival's to rounding: within 1e-12 of the largest
    number of each state, or for accelerations within what rounding moves them by, times 100 for
    their derivatives."""
    unit, count = 2.0**-53, len(results[0])
    bounds = np.full(count, 1e-12)
    if function.startswith("forward_dynamics"):
        most = unit * np.linalg.cond(rival.values("mass_matrix"))
        bounds = np.maximum(bounds, most * (100 if function in DERIVATIVES else 1))
    ours = np.concatenate([x.reshape(count, -1) for x in results], axis=1)
    theirs = rival.values(function).reshape(count, -1)
    errors = abs(ours - theirs).max(axis=1) / abs(theirs).max(axis=1)
    if not (errors <= bounds).all():
        raise ValueError(f"{function} of {rival.robot.functions.name}: our results and those of "
                         f"{type(rival).__name__} differ by {errors.max():.1e} of the largest, not "
                         "by rounding")
