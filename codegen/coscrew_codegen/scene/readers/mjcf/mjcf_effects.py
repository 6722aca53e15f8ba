"""Effects that an MJCF declares: armature, springs, gravity and its compensation, followers."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.model import Mimic
from coscrew_codegen.scene.readers.declared_effects import Effects
from coscrew_codegen.scene.readers.mjcf.mjcf_actuators import rotors
from coscrew_codegen.scene.readers.mjcf.mjcf_names import (
    MjcfNames,
    decimals,
    exact,
    one_coordinate,
)
from coscrew_codegen.scene.readers.mjcf.mjcf_tendons import tendons
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals

if TYPE_CHECKING:
    import mujoco


def effects(model: "mujoco.MjModel", names: MjcfNames, actuators: Mapping[str, object]) -> Effects:
    """The tables of the effects, with those of actuators; those without entries left out."""
    import mujoco

    weightless = model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)
    g = [0.0 if weightless else float(x) for x in model.opt.gravity]
    tables: dict[str, dict[str, object]] = {
        "actuator": dict(actuators), "armature": {}, "gravity": {"g": decimals(g)}, "spring": {},
        "spring_damper": {}, "viscous": {}, "wrench": {}}
    for j in range(model.njnt):
        name, dof = names.joint(j), int(model.jnt_dofadr[j])
        if model.dof_armature[dof]:
            tables["armature"][name] = {"inertia": decimals([model.dof_armature[dof]])[0]}
        if model.jnt_stiffness[j]:
            tables["spring"][name] = {"k": decimals([model.jnt_stiffness[j]])[0],
                                      "q0": _rest(model, j)}
    for b in range(1, model.nbody):
        if model.body_gravcomp[b] and any(g):
            lift = -model.body_gravcomp[b] * model.body_mass[b]
            tables["wrench"][f"gravcomp of {names.body(b)}"] = {
                "body": names.body(b), "point": decimals(model.body_ipos[b]),
                "force": decimals(lift * x for x in g), "frame": "world"}
    for more in (tendons(model, names).effects, rotors(model, names)):
        for name, table in more.items():
            tables[name] |= table
    return {name: table for name, table in tables.items() if table}


def _rest(model: "mujoco.MjModel", j: int) -> Decimals | list[Decimals]:
    """The coordinates at which a joint's spring is at rest; quaternions have their scalar last."""
    simple, at = j in one_coordinate(model), int(model.jnt_qposadr[j])
    count = 1 if simple else 4 if model.jnt_type[j] else 7
    numbers = decimals(model.qpos_spring[at:at + count])
    return numbers[0] if simple else [*numbers[:-4], *numbers[-3:], numbers[-4]]


def followers(model: "mujoco.MjModel", names: MjcfNames) -> dict[str, Mimic]:
    """The joints that an equality, linear and active, makes follow another, by name:
    q_y - y0 = c0 + c1 (q_x - x0)."""
    mimics: dict[str, Mimic] = {}
    for y, e in following(model).items():
        x = int(model.eq_obj2id[e])
        c0, c1 = exact(model.eq_data[e][:2])
        y0, x0 = exact(model.qpos0[model.jnt_qposadr[[y, x]]])
        mimics[names.joint(y)] = Mimic(names.joint(x), c1, y0 + c0 - c1 * x0)
    return mimics


def following(model: "mujoco.MjModel") -> dict[int, int]:
    """The equalities by which joints follow others, by joint: the first for each, and none by which
    a joint would follow itself."""
    leaders, equalities = dict[int, int](), dict[int, int]()
    for e in range(model.neq):
        y, x = int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
        if follows(model, e) and y not in leaders:
            last = x
            while last in leaders:
                last = leaders[last]
            if last != y:
                leaders[y], equalities[y] = x, e
    return equalities


def follows(model: "mujoco.MjModel", e: int) -> bool:
    """Returns whether an equality is one of two joints with one coordinate, active and linear."""
    import mujoco

    y, x = int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
    return bool(model.eq_active0[e]) and model.eq_type[e] == int(mujoco.mjtEq.mjEQ_JOINT) and (
        x >= 0 and {y, x} <= set(one_coordinate(model)) and not any(model.eq_data[e][2:5]))
