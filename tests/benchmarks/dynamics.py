"""Dynamics of real robots compared with Pinocchio's and MuJoCo's: times of single calls.

From C++, against the wheel's library (needs a C++ compiler, Eigen and the headers of urdfdom); from
Python, a call of each; and a step of MuJoCo's, of the same model and effects.
"""

import csv
import io
import re
import shutil
import subprocess
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin
from tabulate import tabulate

from coscrew_codegen.effects import EFFECTS
from coscrew_codegen.mechanics import derive
from coscrew_codegen.native.timing import Timing, timed_calls
from coscrew_codegen.program import Op
from coscrew_codegen.scene.scene import Applied, Scene
from coscrew_codegen.simulate.load import Kernels, kernels_of
from coscrew_codegen.targets import scene_c
from tests.benchmarks.words import said
from tests.support.scenes.robots import FOLDER, path_of, robot, scene_of

ROBOTS = {"ur5": ("ur_description/urdf/ur5_robot.urdf", False),
          "panda": ("panda_description/urdf/panda.urdf", False),
          "g1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True)}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
BUILD = Path(__file__).parents[2] / "build"
DEFINED = ("BOOST_MPL_LIMIT_LIST_SIZE=30", "BOOST_MPL_LIMIT_VECTOR_SIZE=30",
           "BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "BOOST_FUSION_INVOKE_MAX_ARITY=12",
           "PINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION", "PINOCCHIO_WITH_URDFDOM")
SECONDS = 1.0  # of each comparison from Python
PASSIVE = (("viscous", "d", Fraction(1, 2)), ("armature", "inertia", Fraction(1, 10)))
FLAGS = ("-std=c11", "-O3", "-march=native", "-ffp-contract=off", "-DKSL_CONTRACT_OFF",
         "-shared", "-fPIC")


def main() -> None:
    """Print what a call costs, and the ratios."""
    kernels = {name: kernels_of(replace(robot(file, free, False).functions, name=name))
               for name, (file, free) in ROBOTS.items()}
    print("\nOperations (sums, products, quotients, choices), and pairs of sine and cosine")
    print(tabulate([(name, *map(_operations, _programs(x))) for name, x in kernels.items()],
                   ("robot", *FUNCTIONS)))
    if program := _program():
        print("\nFrom C++, ns a call, median (95 % interval) of rounds in which all take turns; "
              "ratio: time of Pinocchio's wheel / ours in double, in the same round")
        print(tabulate([row for name, x in kernels.items() for row in _from_c(program, name, x)],
                       ("robot", "function", "compiler", "double", "single", "pinocchio", "ratio"),
                       disable_numparse=True))
    print("\nFrom Python, µs a call; ratio: time of Pinocchio's / ours")
    print(tabulate([row for name, x in kernels.items() for row in _from_python(name, x)],
                   ("robot", "function", "ours", "pinocchio", "ratio"), disable_numparse=True))
    print("\nA step of 1 ms, µs, semi-implicit under gravity alone, linearly implicit with damping "
          "and armature, too;\nMuJoCo: mj_step without contacts")
    print(tabulate([_step(name, effects) for name in ("ur5", "panda") for effects in ((), PASSIVE)],
                   ("robot", "effects", "ours", "mujoco", "ratio"), disable_numparse=True))


def _programs(x: Kernels):
    found = {f.name: f.program for f in x.functions.functions}
    return [found[name] for name in FUNCTIONS]


def _operations(program) -> str:
    counts = program.counts
    return f"{sum(counts.values()) - counts[Op.SIN] - counts[Op.COS]} + {counts[Op.SIN]}"


def _program() -> Path | None:
    """The C++ program, compiled if it does not exist; None if it cannot be compiled."""
    BUILD.mkdir(exist_ok=True)
    program = BUILD / "dynamics"
    source = Path(__file__).with_suffix(".cpp")
    if program.exists() and program.stat().st_mtime > source.stat().st_mtime:
        return program
    prefix = FOLDER.parents[2]
    command = ["g++", "-std=c++17", "-O3", "-DNDEBUG", "-w", *(f"-D{x}" for x in DEFINED),
               f"-I{prefix}/include", "-I/usr/include/eigen3", str(source), "-o", str(program),
               f"-L{prefix}/lib", f"-Wl,-rpath,{prefix}/lib", "-lpinocchio_default",
               "-lpinocchio_parsers", "-ldl"]
    print("compiling against Pinocchio's headers, about two minutes …")
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        print("no comparison from C++:", done.stderr.strip().splitlines()[:1])
        return None
    return program


def _from_c(program: Path, name: str, x: Kernels):
    file, free = ROBOTS[name]
    sources = scene_c.files(x.functions, "for the benchmark")
    for path, text in sources.items():
        (BUILD / path).write_text(text)
    for compiler in filter(shutil.which, ("gcc", "clang") if x.functions.nv < 20 else ("clang",)):
        library = BUILD / f"{name}-{compiler}.so"
        subprocess.run([compiler, *FLAGS, str(BUILD / f"{name}.c"), "-o", str(library), "-lm"],
                       check=True)
        printed = subprocess.run(
            [program, path_of(file), "free" if free else "fixed", library, name,
             str(x.functions.nq), str(x.functions.nv)], check=True, capture_output=True, text=True)
        rounds: dict[tuple[str, str], list[float]] = {}
        for f, whose, ns in csv.reader(io.StringIO(printed.stdout)):
            rounds.setdefault((f, whose), []).append(float(ns))
        times = {key: Timing(np.array(found)) for key, found in rounds.items()}
        for f in FUNCTIONS:
            ours, single, theirs = (times.get((f, whose))
                                    for whose in ("double", "single", "pinocchio"))
            yield (name, f, compiler, said(ours.time), said(single.time) if single else "",
                   said(theirs.time), said(theirs.ratio(ours)))


def _from_python(name: str, x: Kernels):
    file, free = ROBOTS[name]
    model = robot(file, free, False).model
    data, rng = model.createData(), np.random.default_rng(0)
    theirs_q = pin.randomConfiguration(model, -np.ones(model.nq), np.ones(model.nq))
    q, v, a = np.array(x.functions.neutral), *rng.normal(size=(2, x.functions.nv))
    double = x.double
    pairs = {
        "inverse_dynamics": (lambda: double.inverse_dynamics(q, v, a),
                             lambda: pin.rnea(model, data, theirs_q, v, a)),
        "forward_dynamics": (lambda: double.forward_dynamics(q, v, a),
                             lambda: pin.aba(model, data, theirs_q, v, a)),
        "mass_matrix": (lambda: double.mass_matrix(q), lambda: pin.crba(model, data, theirs_q))}
    for f, (ours, theirs) in pairs.items():
        own, other = timed_calls((ours, theirs), 1e9 * SECONDS)
        yield name, f, said(own.time, 1e-3), said(other.time, 1e-3), said(other.ratio(own))


def _step(name: str, effects: tuple[tuple[str, str, Fraction], ...]):
    """Times of a step: ours, in a loop in C over many states, and MuJoCo's, in its own loop."""
    model = mujoco.MjModel.from_xml_string(_without_meshes(path_of(ROBOTS[name][0]).read_text()))
    model.opt.timestep = 1e-3
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    values = {key: float(value) for _, key, value in effects}
    model.dof_damping[:], model.dof_armature[:] = values.get("d", 0), values.get("inertia", 0)
    model.dof_frictionloss[:], model.jnt_limited[:] = 0, 0
    data = mujoco.MjData(model)
    steps, count = 1000, 100
    x = kernels_of(derive(_with(name, effects)))
    q = np.tile(np.array(x.functions.neutral), (count, 1))
    v = np.zeros((count, x.functions.nv))
    step = x.double.step_linear_implicit_euler if effects else x.double.step_semi_implicit_euler

    def their_steps() -> None:
        mujoco.mj_resetData(model, data)
        mujoco.mj_step(model, data, steps)

    timings = timed_calls((lambda: step(1e-3, q, v), their_steps), 1e9 * SECONDS)
    ours, theirs = (Timing(x.rounds / n) for x, n in zip(timings, (count, steps), strict=True))
    names = ", ".join(("gravity", *(effect for effect, _, _ in effects)))
    return name, names, said(ours.time, 1e-3), said(theirs.time, 1e-3), said(theirs.ratio(ours))


def _with(name: str, effects: tuple[tuple[str, str, Fraction], ...]) -> Scene:
    """The robot's scene with these effects on each of its joints."""
    scene = replace(scene_of(ROBOTS[name][0]), name=name)
    known = {effect.name: effect for effect in EFFECTS}
    joints = [c.joint for c in robot(ROBOTS[name][0], False, False).functions.coordinates]
    applied = []
    for effect, key, value in effects:
        unset = {p.name: Fraction(p.default) if isinstance(p.default, int) else p.default
                 for p in known[effect].parameters}
        applied += [Applied(known[effect], joint, {**unset, key: value}) for joint in joints]
    return replace(scene, effects=(*scene.effects, *applied))


def _without_meshes(text: str) -> str:
    """The robot's file as MuJoCo reads it without its meshes."""
    text = re.sub(r"<(visual|collision)\b[^>]*>.*?</\1>", "", text, flags=re.DOTALL)
    return text.replace("</robot>", '<mujoco><compiler discardvisual="true" fusestatic="true"/>'
                        "</mujoco></robot>")


if __name__ == "__main__":
    main()
