"""Steps of a quadruped that stands on four feet against MuJoCo's mj_step of the same robot, with
both cones of friction that MuJoCo has; what a contact costs; and how well both stand."""

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import mujoco
import numpy as np
from tabulate import tabulate

from coscrew_codegen import load_scene, run
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.timing.loop_timing import timed_loops
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.mujoco_steps import STATES, loop_of_mujoco
from tests.benchmarks.scene_loops import compiled, compilers
from tests.benchmarks.words import span

SCENE = Path(__file__).parents[2] / "examples/scenes/landing.toml"
NAME, STEP = "step_leapfrog", 1e-3
WANTED = {"one": 6, "many": 30}
"""MuJoCo's time / ours."""
CONES = {"pyramidal, impratio 1 (default)": 'cone="pyramidal" impratio="1"',
         "elliptic, impratio 100": 'cone="elliptic" impratio="100"'}
FEET, SECONDS, MINUTE = ("fl_shank", "fr_shank", "rl_shank", "rr_shank"), 1.0, 60.0
TARGETS = {"swing": 0.9, "knee": -1.6}
KP, KD, ARMATURE, MU = 200, 5, 1.2e-4 * 81, 0.7


def standing() -> tuple[np.ndarray, np.ndarray]:
    """q and v after ten seconds."""
    result = run(SCENE, until=10, every=10, precision="double")
    return result.q[-1], result.v[-1]


def model_of(cone: str) -> mujoco.MjModel:
    """MuJoCo's model of the scene: the same feet and motors, whose torques have the same limits."""
    text = re.sub(r"<(visual|collision)\b[^>]*>.*?</\1>", "", SCENE.with_name(
        "quadruped.urdf").read_text(), flags=re.DOTALL)
    spec = mujoco.MjSpec.from_string(text.replace("</robot>", (
        f'<mujoco><option timestep="{STEP}" {cone} integrator="implicitfast"/></mujoco></robot>')))
    trunk = spec.worldbody.first_body()
    trunk.add_freejoint()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 1], friction=[MU, 0, 0])
    for name in FEET:
        spec.body(name).add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.02, 0, 0],
                                 pos=[0, 0, -0.21], friction=[MU, 0, 0], mass=0)
    for joint in spec.joints[1:]:
        motor = spec.add_actuator(name=joint.name, target=joint.name,
                                  trntype=mujoco.mjtTrn.mjTRN_JOINT)
        motor.set_to_position(kp=KP, kv=KD)
    model = spec.compile()
    model.dof_armature[6:] = ARMATURE
    model.jnt_limited[:], model.dof_frictionloss[:] = 0, 0
    assert model.jnt_actfrclimited[1:].all() and set(model.jnt_actfrcrange[1:, 1]) == {30, 45}
    return model


def start(model: mujoco.MjModel, q: Sequence[float]) -> mujoco.MjData:
    """MuJoCo's state with these coordinates; the joints' order is that of both."""
    data = mujoco.MjData(model)
    data.qpos[:] = [*q[:3], q[6], *q[3:6], *q[7:19]]
    data.ctrl[:] = [TARGETS.get(model.actuator(k).name.split("_")[-1], 0) for k in range(model.nu)]
    mujoco.mj_forward(model, data)
    return data


def _stands(model: mujoco.MjModel, q: Sequence[float]) -> tuple[float, float, float]:
    """The largest way of MuJoCo's feet in a minute, their depth, the largest speed."""
    data = start(model, q)
    mujoco.mj_step(model, data, round(2 / STEP))

    def feet() -> np.ndarray:
        return np.array([x.xpos + x.xmat.reshape(3, 3) @ (0, 0, -0.21)
                         for x in map(data.body, FEET)])

    before = feet()
    mujoco.mj_step(model, data, round(MINUTE / STEP))
    depth = max((-data.contact[k].dist for k in range(data.ncon)), default=math.nan)
    return float(abs(feet() - before)[:, :2].max()), float(depth), float(
        abs(data.qvel).max())


def _ours(q: np.ndarray, v: np.ndarray) -> tuple[float, float, float]:
    """The largest way of our feet in a minute, their depth, the largest speed."""
    kernels = load_scene(SCENE, functions=["default", "contacts"])
    later = run(kernels, until=MINUTE, every=MINUTE, q0=q, v0=v, precision="double")
    before, after = (kernels.double.contacts(x, y) for x, y in (
        (q, v), (later.q[-1], later.v[-1])))
    return (float(abs(after[0] - before[0])[:, :2].max()), float(-min(after[0][:, 2])),
            float(abs(later.v[-1]).max()))


def main() -> list[Bar]:
    """Print the tables."""
    q, v = standing()
    read = read_scene(SCENE)
    scene = derive(read, (NAME,))
    bare = derive(replace(read, effects=tuple(
        x for x in read.effects if not x.effect.parts)), (NAME,))
    models = {words: model_of(cone) for words, cone in CONES.items()}
    rows, bars, costs = [], [], []
    for compiler in compilers():
        with TemporaryDirectory() as folder, TemporaryDirectory() as other:
            without = compiled(bare, (NAME,), Path(other), compiler, "-march=native", many=True)
            loops = compiled(scene, (NAME,), Path(folder), compiler, "-march=native", many=True)
            keys = [(kind, p) for kind in WANTED for p in PRECISIONS]
            made = [loops.loop(kind, NAME, p, [np.tile(x, (STATES, 1)).astype(p.numpy_type)
                                               for x in (q, v)]) for kind, p in keys]
            made += [without.loop(kind, NAME, p, [np.tile(x, (STATES, 1)).astype(p.numpy_type)
                                                  for x in (q[:len(q) - 3 * len(FEET)], v)])
                     for kind, p in keys]
            rivals = [loop_of_mujoco(model, start(model, q), Path(folder), keep=True)
                      for model in models.values()]
            times = timed_loops(loops.library, [*made, *rivals], 1e9 * SECONDS)
        ours, free, theirs = (times[:len(keys)], times[len(keys):len(made)], times[len(made):])
        costs.append((compiler, *(f"{(x.minimum - y.minimum) / len(FEET):.0f}"
                                  for x, y in zip(ours, free, strict=True))))
        for words, rival in zip(models, theirs, strict=True):
            rows.append((compiler, words, span(rival.time), *(span(x.time) for x in ours),
                         *(span(rival.ratio(x)) for x in ours)))
            bars += [(x.minimum, Bar(f"{kind}: mj_step / step of a standing quadruped, {words}",
                                     WANTED[kind], rival.ratio(x), note=compiler))
                     for (kind, p), x in zip(keys, ours, strict=True) if p.name == "double"]
    names = [f"{kind} {p.name}" for kind, p in keys]
    print("\nA step of 1 ms of a quadruped that stands on four feet, ns")
    print(tabulate(rows, ("compiler", "MuJoCo's cone", "MuJoCo", *names, *(
        f"ratio, {x}" for x in names)), disable_numparse=True))
    print("\nA contact in such a step, ns: the fastest step less the fastest without contacts")
    print(tabulate(costs, ("compiler", *names), disable_numparse=True))
    print("\nA minute of standing: largest way of a foot, depth in m, largest speed")
    print(tabulate([("coscrew", *_ours(q, v)), *((words, *_stands(model, q))
                                                 for words, model in models.items())],
                   ("", "foot, m", "depth, m", "speed, SI"), floatfmt=".2g"))
    return fastest(bars)


if __name__ == "__main__":
    show(main())
