"""Static torques by coscrew operations alone: against Pinocchio, and the example in C and Python.

Errors are relative to the joint's scale S_i = Σ_k (|f_k||v_i| + |τ_k||ω_i|), summed over all bodies
k beyond joint i: an upper bound of the sum of the absolute values of the terms of τ_i = Σ_k c_k ·
h_i.
"""

import importlib.metadata
import importlib.util
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

import coscrew
from tests.support.compiled.c_harness import C11, EXACT, INCLUDE, STRICT, run
from tests.support.each import each_compiler

if sys.platform != "win32":
    import pinocchio

Array = NDArray[np.floating]

needs_pinocchio = pytest.mark.skipif(sys.platform == "win32", reason="no Pinocchio for Windows")
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
ROBOTS = {  # a serial arm; one with a gripper; a mobile manipulator and a humanoid, both branching
    "ur5": "ur_description/urdf/ur5_robot.urdf",
    "panda": "panda_description/urdf/panda.urdf",
    "pr2": "pr2_description/urdf/pr2.urdf",
    "icub": "icub_description/robots/icub.urdf",
}
CONFIGURATIONS = 50
PRECISIONS = (np.float64, np.float32)
PEER_BOUND = 50  # u S_i: 5.6e-15 S_i in double, 3.0e-6 S_i in single; Pinocchio is always in double
ULPS = 16  # of the largest torque, between C and Python, whose sines may differ in the last bit
MOTIONS = {"RX": coscrew.product_ddrx, "RY": coscrew.product_ddry, "RZ": coscrew.product_ddrz,
           "PX": coscrew.product_ddtx, "PY": coscrew.product_ddty, "PZ": coscrew.product_ddtz}
SCREWS = {"RX": coscrew.hsrx, "RY": coscrew.hsry, "RZ": coscrew.hsrz,
          "PX": coscrew.hstx, "PY": coscrew.hsty, "PZ": coscrew.hstz}


@pytest.fixture(scope="session")
def example() -> ModuleType:
    """examples/static_torques.py as a module."""
    spec = importlib.util.spec_from_file_location("static_torques", EXAMPLES / "static_torques.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def urdf(robot: str) -> Path:
    """The robot's description, wherever example-robot-data is installed."""
    files = importlib.metadata.files("example-robot-data")
    return Path(next(f for f in files if f.as_posix().endswith(ROBOTS[robot])).locate())


def joints(model: "pinocchio.Model") -> list["pinocchio.JointModel"]:
    """All joints except the universe, which is Pinocchio's joint 0."""
    return list(model.joints)[1:]


def kind(joint: "pinocchio.JointModel") -> str:
    """RX, PZ, RevoluteUnaligned, ...; RUBX turns about x as RX does, q being (cos θ, sin θ)."""
    return joint.shortname().removeprefix("JointModel")


def configurations(model: "pinocchio.Model", real: type[np.floating]) -> Array:
    """Random angles, and shifts within half a metre. (CONFIGURATIONS, nq)"""
    random, columns = np.random.default_rng(20190), []
    for joint in joints(model):
        x = random.uniform(-1, 1, CONFIGURATIONS)
        angle = np.pi * x
        columns += ([np.cos(angle), np.sin(angle)] if kind(joint).startswith("RUB")
                    else [angle if kind(joint).startswith("R") else 0.5 * x])
    return np.stack(columns, axis=-1).astype(real)


def moved(D: Array, joint: "pinocchio.JointModel", q: Array) -> tuple[Array, Array]:
    """The joint's frame after its motion, and its screw.  (…,3,4), (…,nq) -> (…,3,4), (…,6)."""
    name, x = kind(joint).replace("RUB", "R"), q[..., joint.idx_q]
    if name in MOTIONS:
        if name.startswith("R"):
            x = q[..., [joint.idx_q + 1, joint.idx_q]] if joint.nq == 2 else coscrew.dc(x)
        return MOTIONS[name](D, x), SCREWS[name](D)
    axis = joint.extract().axis.astype(q.dtype)
    if name == "PrismaticUnaligned":
        return coscrew.product_ddt(D, coscrew.product_av(x, axis)), coscrew.hsta(D, axis)
    assert name == "RevoluteUnaligned"
    R = whose_z_is(axis)
    turned = coscrew.product_ddrz(coscrew.product_ddr(D, R), coscrew.dc(x))
    return coscrew.product_ddrinv(turned, R), coscrew.hsra(D, axis)


def whose_z_is(axis: Array) -> Array:
    """A rotation with the unit vector `axis` as its last column.  (3)->(3,3)"""
    least = np.eye(3, dtype=axis.dtype)[np.abs(axis).argmin()]
    x = coscrew.vec3_normalized(coscrew.cross_vv(least, axis))
    return coscrew.mat3x3_setFromVectors(x, coscrew.cross_vv(axis, x), axis)


def tree(model: "pinocchio.Model", q: Array,
         example: ModuleType) -> tuple[list[Array], list[Array], list[int]]:
    """Screws, supports and parents of the joints, all screws and coscrews at the base's origin."""
    frames, screws, supports = [np.eye(3, 4, dtype=q.dtype)], [], []
    for i in range(1, model.njoints):
        placement = model.jointPlacements[i].homogeneous[:3].astype(q.dtype)
        D = coscrew.product_dd(frames[model.parents[i]], placement)
        D, screw = moved(D, model.joints[i], q)
        body = model.inertias[i]
        frames.append(D)
        screws.append(screw)
        supports.append(example.support(D, q.dtype.type(body.mass), body.lever.astype(q.dtype)))
    return screws, supports, [parent - 1 for parent in list(model.parents)[1:]]


def by_pinocchio(model: "pinocchio.Model", q: Array) -> Array:
    """computeGeneralizedGravity, in double, of each configuration.  (n,nq)->(n,nv)"""
    data, q = model.createData(), q.astype(np.float64)
    return np.array([pinocchio.computeGeneralizedGravity(model, data, row) for row in q])


def scales(screws: Sequence[Array], supports: Sequence[Array], parents: Sequence[int],
           example: ModuleType) -> Array:
    """S_i: the torques' own sum, of coscrews (|f|, 0, 0; |τ|, 0, 0) and screws likewise."""
    def sizes(x: Array) -> Array:
        result = np.zeros_like(x)
        result[..., 0] = coscrew.vec3_l2norm(x[..., :3])
        result[..., 3] = coscrew.vec3_l2norm(x[..., 3:])
        return result

    sized = [[sizes(x) for x in xs] for xs in (screws, supports)]
    return example.holding_torques(*sized, parents)


def assert_within_bound(torques: Array, truth: Array, scale: Array) -> None:
    """|torques - truth| <= PEER_BOUND u S_i; fails with the largest error, in u S_i."""
    u = np.finfo(torques.dtype).eps / 2
    errors = np.abs(torques - truth) / (u * scale.astype(np.float64))
    worst = np.unravel_index(errors.argmax(), errors.shape)
    assert errors.max() <= PEER_BOUND, (
        f"configuration, joint {worst}: {float(torques[worst]).hex()} instead of "
        f"{float(truth[worst]).hex()}, {errors.max():.3g} u S_i apart")


@needs_pinocchio
@pytest.mark.parametrize("real", PRECISIONS)
@pytest.mark.parametrize("robot", ROBOTS)
def test_static_torques_are_pinocchios_generalized_gravity(robot, real, example):
    model = pinocchio.buildModelFromUrdf(str(urdf(robot)))
    q = configurations(model, real)
    inward = tree(model, q, example)
    torques = example.holding_torques(*inward)
    assert torques.dtype == real
    assert_within_bound(torques, by_pinocchio(model, q), scales(*inward, example))


@needs_pinocchio
@pytest.mark.parametrize("real", PRECISIONS)
def test_example_is_the_panda_without_hand_and_with_the_payload(real, example):
    robot = ElementTree.parse(urdf("panda")).getroot()
    for part in list(robot):
        if re.search("hand|finger", part.get("name")):
            robot.remove(part)
    model = pinocchio.buildModelFromXML(ElementTree.tostring(robot, encoding="unicode"))
    payload = pinocchio.Inertia(example.PAYLOAD_MASS, np.array(example.PAYLOAD_CENTRE), np.eye(3))
    flange = pinocchio.SE3(np.eye(3), np.array([0, 0, example.FLANGE]))
    model.appendBodyToJoint(7, payload, flange)
    assert model.nv == 7

    q = np.vstack([np.array(example.POSTURE, real), configurations(model, real)])
    torques = example.static_torques(q)
    assert torques.dtype == real
    assert_within_bound(torques, by_pinocchio(model, q), scales(*tree(model, q, example), example))


@each_compiler
def test_example_agrees_in_c_and_python(compiler, example, tmp_path):
    program = tmp_path / "static_torques"
    run((compiler, *C11, "-O2", EXACT, *STRICT, "-I", INCLUDE, EXAMPLES / "static_torques.c",
         "-o", program, "-lm"))
    for in_c in example.torques_in_c(program):
        in_python = example.static_torques(np.array(example.POSTURE, in_c.dtype))
        ulps = np.abs(in_c - in_python) / np.spacing(np.abs(in_python).max())
        assert ulps.max() <= ULPS, f"{compiler}: {in_c.dtype} torques differ by {ulps} ulps"

    shown = run((sys.executable, EXAMPLES / "static_torques.py", program))
    for column in ("Python double", "C double", "Python single", "C single", "C - Python, single"):
        assert column in shown


def test_example_runs_without_the_c_program(example):
    shown = run((sys.executable, EXAMPLES / "static_torques.py"))
    assert "C program not given" in shown
    for real in PRECISIONS:
        for torque in example.static_torques(np.array(example.POSTURE, real)):
            assert f" {torque:.15f}" in shown
