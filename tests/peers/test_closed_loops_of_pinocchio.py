"""A Delta robot accelerates as Pinocchio's constrained dynamics say, along its motion."""

from pathlib import Path

import numpy as np
import pinocchio as pin

from coscrew_codegen import load_scene
from coscrew_codegen.simulation.system import system
from tests.support.scenes import delta_robot as delta

FUNCTIONS = ["closure", "with_closed_loops", "forward_dynamics", "step_leapfrog"]


def peer() -> "tuple[pin.Model, pin.StdVec_RigidConstraintModel]":
    """Pinocchio's robot, with joints in our order, and the six points that are closed."""
    model = pin.Model()
    rods = {}
    for n in range(3):  # depth first, as its algorithms require
        R = delta.turn(n)
        arm = model.addJoint(0, pin.JointModelRY(), pin.SE3(R, R @ (delta.BASE, 0, 0)),
                             f"shoulder{n}")
        _body(model, arm, delta.ARM_MASS, delta.ARM, delta.ARM_MOMENTS)
        for x in (x for x in delta.RODS if x.arm == n):
            at = pin.SE3(np.eye(3), np.array(x.begin))
            rods[x] = model.addJoint(arm, pin.JointModelSpherical(), at, x.name)
            _body(model, rods[x], delta.ROD_MASS, delta.ROD, delta.ROD_MOMENTS)
    plate = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "plate")
    _body(model, plate, delta.PLATFORM_MASS, 0, delta.PLATFORM_MOMENTS)
    closed = pin.StdVec_RigidConstraintModel()
    for x in delta.RODS:
        tip = pin.SE3(np.eye(3), np.array([delta.ROD, 0, 0]))
        closed.append(pin.RigidConstraintModel(
            pin.ContactType.CONTACT_3D, model, rods[x], tip, plate, pin.SE3(np.eye(3), x.end),
            pin.ReferenceFrame.LOCAL))
    return model, closed


def _body(model: "pin.Model", joint: int, mass: float, length: float,
          moments: tuple[float, ...]) -> None:
    com = np.array([length / 2, 0, 0])
    model.appendBodyToJoint(joint, pin.Inertia(mass, com, np.diag(moments)), pin.SE3.Identity())


def test_a_delta_robot_accelerates_alike(tmp_path: Path) -> None:
    path = tmp_path / "delta.toml"
    path.write_text(delta.scene(), encoding="utf-8")
    its = system(load_scene(path, functions=FUNCTIONS), "double")
    model, closed = peer()
    assert [model.names[k + 1] for k in range(len(its.functions.coordinates))] == [
        c.joint for c in its.functions.coordinates]
    data, datas = model.createData(), pin.StdVec_RigidConstraintData()
    for x in closed:
        datas.append(x.createData())
    pin.initConstraintDynamics(model, data, closed, datas)
    settings = pin.ProximalSettings(1e-13, 1e-12, 50)
    rng, (q, v) = np.random.default_rng(1), its.start()
    v = its.outputs("with_closed_loops", q=q, v=rng.normal(size=len(v)))[1]
    step = its.stepper("step_leapfrog")
    for _ in range(10):
        q, v = its.outputs("with_closed_loops", **dict(zip("qv", step(20, 0.0, 1e-3, q, v),
                                                            strict=True)))
        tau = rng.normal(size=len(v)) / 10
        tau[[k for c in its.functions.coordinates if c.kind == "spherical" for k in c.v]] = 0
        a = its.call("forward_dynamics", t=0.0, q=q, v=v, tau=tau)
        other = pin.constraintDynamics(model, data, q, v, tau, closed, datas, settings)
        assert abs(a).max() > 1
        assert np.allclose(a, other, rtol=0, atol=1e-9)
        assert abs(its.outputs("closure", q=q)[0]).max() < 1e-9
