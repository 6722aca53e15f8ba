"""Steps of arms against MuJoCo's mj_step, of the same model and effects, both in loops in C: one
state's steps after another's, and steps in lanes.

MuJoCo's motion is compared with ours first.  Contacts are switched off.
"""

import ctypes
import re
import subprocess
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import mujoco
import numpy as np
from tabulate import tabulate

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.timing.loop_timing import Loop, Timing, timed_loops
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.scene import Applied, Scene
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.pinocchio_loops import ROBOTS, scene_named
from tests.benchmarks.scene_loops import compiled, compilers
from tests.benchmarks.words import span
from tests.support.scenes.kinds import Kind
from tests.support.scenes.robots import path_of

ARMS = ("ur5", "panda7")
PASSIVE = (("viscous", "d", Fraction(1, 2)), ("armature", "inertia", Fraction(1, 10)))
INTEGRATORS = {(): "step_semi_implicit_euler", PASSIVE: "step_linear_implicit_euler"}
"""What MuJoCo's Euler is with these effects: it is implicit in damping."""
WORDS = {"one": "one step", "many": "steps in lanes"}
WANTED = {"one": 5, "many": 30}
"""MuJoCo's time / ours."""
STEP, STEPS, STATES = 1e-3, 200, 256
SECONDS = 2.0  # of each comparison
LOOP = """
/* x: mj_resetData or null, mj_step, model, data */
typedef void (*function)(const void *model, void *data);
void mujoco_steps(long n, void *const *x);
void mujoco_steps(long n, void *const *x) {
  if (x[0]) ((function)x[0])(x[2], x[3]);
  for (long i = 0; i < n; i++) ((function)x[1])(x[2], x[3]);
}
"""

Effects = tuple[tuple[str, str, Fraction], ...]


def model_of(name: str, effects: Effects = ()) -> mujoco.MjModel:
    """MuJoCo's model of a robot, without contacts, friction and limits."""
    model = mujoco.MjModel.from_xml_string(_text(path_of(ROBOTS[name][0]).read_text()))
    values = {key: float(value) for _, key, value in effects}
    model.opt.timestep = STEP
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    model.dof_damping[:], model.dof_armature[:] = values.get("d", 0), values.get("inertia", 0)
    model.dof_frictionloss[:], model.jnt_limited[:] = 0, 0
    return model


def _text(text: str) -> str:
    """The robot's file as MuJoCo reads it without its meshes, a Panda's fingers fixed."""
    text = re.sub(r"<(visual|collision)\b[^>]*>.*?</\1>", "", text, flags=re.DOTALL)
    text = re.sub(r'(<joint name="panda_finger_joint\d" type=)"prismatic"', r'\1"fixed"', text)
    return text.replace("</robot>", '<mujoco><compiler discardvisual="true" fusestatic="true"/>'
                        "</mujoco></robot>")


def scene_with(name: str, effects: Effects) -> Scene:
    """The robot's scene with these effects on each of its joints."""
    scene, known = scene_named(name), {effect.name: effect for effect in EFFECTS}
    joints = [x.name for x in scene.model.joints if x.kind is not Kind.FIXED]
    applied = []
    for effect, key, value in effects:
        unset = {p.name: Fraction(p.default) if isinstance(p.default, int) else p.default
                 for p in known[effect].parameters}
        applied += [Applied(known[effect], joint, {**unset, key: value}) for joint in joints]
    return replace(scene, effects=(*scene.effects, *applied))


@dataclass(frozen=True)
class Measured:
    """Times of a step of an arm, by kind and precision, and MuJoCo's."""

    arm: str
    effects: Effects
    compiler: str
    ours: dict[tuple[str, str], Timing]  # ("many", "double")
    mujoco: Timing

    @property
    def names(self) -> str:
        """Its effects."""
        return ", ".join(("gravity", *(effect for effect, _, _ in self.effects)))


def measured(arm: str, effects: Effects, compiler: str) -> Measured:
    """Interleaved rounds of all."""
    name = INTEGRATORS[effects]
    scene = derive(scene_with(arm, effects), (name,))
    model = model_of(arm, effects)
    data = mujoco.MjData(model)
    refuse_others(scene, name, model, data)
    with TemporaryDirectory() as folder:
        loops = compiled(scene, (name,), Path(folder), compiler, "-march=native", many=True)
        rival = loop_of_mujoco(model, data, Path(folder))
    keys = [(kind, p) for kind in ("one", "many") for p in PRECISIONS]
    rng = np.random.default_rng(0)
    states = [rng.uniform(-2, 2, (STATES, n)) for n in (scene.nq, scene.nv)]
    made = [loops.loop(kind, name, p, [x.astype(p.numpy_type) for x in states])
            for kind, p in keys]
    *ours, theirs = timed_loops(loops.library, [*made, rival], 1e9 * SECONDS)
    return Measured(arm, effects, compiler, {
        (kind, p.name): x for (kind, p), x in zip(keys, ours, strict=True)}, theirs)


def loop_of_mujoco(model: mujoco.MjModel, data: mujoco.MjData, folder: Path, keep: bool = False
                   ) -> Loop:
    """STEPS of MuJoCo's from its start; with `keep` from where it is."""
    (folder / "mujoco_steps.c").write_text(LOOP)
    path = folder / "mujoco_steps.so"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", "mujoco_steps.c", "-o", str(path)],
                   cwd=folder, check=True)
    library = _mujoco()
    functions = [ctypes.cast(x, ctypes.c_void_p).value
                 for x in (library.mj_resetData, library.mj_step)]
    functions[0] = None if keep else functions[0]
    arguments = (ctypes.c_void_p * 4)(*functions, model._address, data._address)
    arguments.kept = model, data  # type: ignore[attr-defined]
    return Loop(ctypes.CDLL(str(path)).mujoco_steps, STEPS, arguments)


@cache
def _mujoco() -> ctypes.CDLL:
    """The package's library, which Python has loaded already."""
    return ctypes.CDLL(str(next(Path(mujoco.__file__).parent.glob("libmujoco*"))))


def refuse_others(scene: SceneFunctions, name: str, model: mujoco.MjModel, data: mujoco.MjData
                  ) -> None:
    """Raise ValueError unless both are at the same place after STEPS steps, to 1e-9."""
    step = getattr(kernels_of(scene).double, name)
    rng = np.random.default_rng(1)
    q, v = (rng.uniform(-1, 1, n) for n in (scene.nq, scene.nv))
    mujoco.mj_resetData(model, data)
    data.qpos[:], data.qvel[:] = q, v
    for _ in range(STEPS):
        q, v = step(STEP, q, v)
    mujoco.mj_step(model, data, STEPS)
    if not (error := abs(data.qpos - q).max()) < 1e-9:
        raise ValueError(f"{name} of {scene.name}: after {STEPS} steps MuJoCo's q and ours differ "
                         f"by {error:.1e}")


def main() -> list[Bar]:
    """Print the table."""
    results = [measured(arm, effects, compiler) for arm in ARMS for effects in INTEGRATORS
               for compiler in compilers()]
    print("\nA step of 1 ms from C, ns: median (95 % interval) of rounds in which all take turns; "
          f"-march=native; semi-implicit or, with damping, linearly implicit;\n{STATES} states one "
          "after the other and in lanes; ratios: mj_step / ours")
    keys = [(kind, p.name) for kind in WANTED for p in PRECISIONS]
    print(tabulate([(x.arm, x.names, x.compiler, span(x.mujoco.time),
                     *(span(x.ours[key].time) for key in keys),
                     *(span(x.mujoco.ratio(x.ours[key])) for key in keys)) for x in results],
                   ("arm", "effects", "compiler", "MuJoCo",
                    *(" ".join(key) for key in keys), *(f"ratio, {' '.join(key)}" for key in keys)),
                   disable_numparse=True))
    return fastest((x.ours[kind, "double"].minimum, Bar(
        f"{WORDS[kind]}: mj_step / step of {x.arm}, {x.names}", wanted,
        x.mujoco.ratio(x.ours[kind, "double"]), note=x.compiler))
        for kind, wanted in WANTED.items() for x in results)


if __name__ == "__main__":
    show(main())
