"""Content of an MJCF that scenes lack: refused by name, unless the scene leaves it out; elements
that move nothing by themselves, as actuators and contact, are reported."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.mjcf.mjcf_effects import decimals, follows, one_coordinate
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_text import joined, toml_pairs

if TYPE_CHECKING:
    import mujoco

GROUPS: Mapping[str, str] = {
    "loops": "closes a loop of bodies",
    "equalities": "is no line between two joints of one coordinate, or the second of a joint",
    "tendons": "pulls by its stiffness, damping, armature, friction or range",
    "actuators": "moves the joint by its own armature or damping",
    "ball_joints": "is of a free or ball joint, for which no effect takes it",
    "polynomials": "is no line in velocity or position, or yields",
    "fluid": "makes forces of a fluid",
    "flexes": "is not rigid",
    "plugins": "runs code"}
"""What `leave_out` may name, and why it is not kept."""

_OTHER = "other tools' numbers"


def refused(source: ModelSource, model: "mujoco.MjModel", names: MjcfNames) -> Iterator[Notice]:
    """Notices of what the scene leaves out.  Raises SceneError for the first that it does not."""
    for group, element in _unkept(model, names):
        if group not in source.leave_out:
            raise SceneError(source.path, element, f"{GROUPS[group]}; leave_out = [\"{group}\"] in "
                             f"the scene, or --leave-out {group}, leaves it out")
        yield Notice(_OTHER, element, f"{element}: left out ({group})")


def _unkept(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[tuple[str, str]]:
    """Group and element."""
    yield from _equalities(model)
    for t in range(model.ntendon):
        if any(x[t] for x in (model.tendon_stiffness, model.tendon_damping, model.tendon_armature,
                              model.tendon_frictionloss, model.tendon_limited)):
            yield "tendons", f"tendon {model.tendon(t).name or t!r}"
    for i in range(model.nu):
        if model.actuator_armature[i] or model.actuator_damping[i]:
            yield "actuators", f"actuator {model.actuator(i).name or i!r}"
    yield from _of_joints(model, names)
    if model.opt.density or model.opt.viscosity or model.opt.wind.any():
        yield "fluid", "option density, viscosity or wind"
    if model.nflex:
        yield "flexes", "flex"
    if model.nplugin:
        yield "plugins", "plugin"


def _equalities(model: "mujoco.MjModel") -> Iterator[tuple[str, str]]:
    import mujoco

    loops = (int(mujoco.mjtEq.mjEQ_CONNECT), int(mujoco.mjtEq.mjEQ_WELD))
    led: set[int] = set()
    for e in range(model.neq):
        if follows(model, e) and (y := int(model.eq_obj1id[e])) not in led:
            led.add(y)
        elif model.eq_active0[e]:
            group = "loops" if int(model.eq_type[e]) in loops else "equalities"
            kind = mujoco.mjtEq(int(model.eq_type[e])).name.removeprefix("mjEQ_").lower()
            yield group, f"equality {kind} {model.equality(e).name or e!r}"


def _of_joints(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[tuple[str, str]]:
    simple = one_coordinate(model)
    for j in range(model.njnt):
        name = names.joint(j)
        first = int(model.jnt_dofadr[j])
        dofs = slice(first, first + (1 if j in simple else 3 if model.jnt_type[j] else 6))
        if model.dof_dampingpoly[dofs].any() or model.jnt_stiffnesspoly[j].any() or (
                model.jnt_plasticadr[j] >= 0):
            yield "polynomials", f"damping or stiffness of joint {name!r}"
        of = [word for word, there in (
            ("damping", model.dof_damping[dofs].any()),
            ("armature", model.dof_armature[dofs].any()),
            ("frictionloss", model.dof_frictionloss[dofs].any()),
            ("stiffness", model.jnt_stiffness[j]), ("range", model.jnt_limited[j])) if there]
        if j not in simple and of:
            yield "ball_joints", f"{joined(of)} of joint {name!r}"


def ignored(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[Notice]:
    """Notices of what a scene chooses: actuators; and of what is not read: contact, mocap."""
    for i in range(model.nu):
        yield _actuator(model, names, i)
    for b in range(1, model.nbody):
        if model.body_mocapid[b] >= 0:
            yield Notice(_OTHER, f"body {names.body(b)}", f"body {names.body(b)}: is moved by hand "
                         "in MuJoCo (mocap), and fixed here")
    for e in range(model.neq):
        if not model.eq_active0[e]:
            yield Notice(_OTHER, f"equality {e}", f"equality {model.equality(e).name or e!r}: is "
                         "not active at the start, and not used")
    count = int(((model.geom_contype != 0) | (model.geom_conaffinity != 0)).sum())
    if count:
        yield Notice(_OTHER, "model", f"{count} geoms may touch others in MuJoCo: contact is not "
                     "used")


def _actuator(model: "mujoco.MjModel", names: MjcfNames, i: int) -> Notice:
    """A notice with the effect to write, if an effect does what the actuator does."""
    name = model.actuator(i).name or str(i)
    on = int(model.actuator_trnid[i][0])
    by_joint = int(model.actuator_trntype[i]) in (0, 1) and on in one_coordinate(model)
    values = _drive(model, i) if by_joint else {}
    if not values:
        return Notice("actuator", f"actuator {name}", f"actuator {name}: is not used, and no "
                      "effect does the same")
    joint = names.joint(on)
    remedy = f"add [effects.actuator.{toml_key(joint)}] with {joined(toml_pairs(values))}"
    return Notice("actuator", f"joint {joint}", f"joint {joint}: actuator {name} is not used: "
                  f"{remedy}", remedy, ("actuator", joint))


def _drive(model: "mujoco.MjModel", i: int) -> dict[str, object]:
    """The effect's values for ctrl = 0: a torque, or a spring and damper towards a target; {} for
    others."""
    gear, (b0, b1, b2) = float(model.actuator_gear[i][0]), model.actuator_biasprm[i][:3]
    plain = not (model.actuator_dyntype[i] or model.actuator_gaintype[i])
    if not plain or int(model.actuator_biastype[i]) not in (0, 1):
        return {}
    limited, (low, high) = model.actuator_forcelimited[i], model.actuator_forcerange[i]
    if limited and low != -high:
        return {}
    limit = {"limit": decimals([abs(gear) * high])[0]} if limited else {}
    if int(model.actuator_biastype[i]) == 0:
        return {"kind": "torque", "torque": 0, **limit}
    if b0 or b1 > 0 or b2 > 0:
        return {}
    kp, kd = decimals([0.0 - b1 * gear**2, 0.0 - b2 * gear**2])
    return {"kind": "pd", "kp": kp, "kd": kd, "target": 0, **limit}
