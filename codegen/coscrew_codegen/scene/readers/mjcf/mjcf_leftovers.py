"""Content of an MJCF that scenes lack: refused by name, unless the scene leaves it out; what moves
nothing by itself, or is not read, as contact, is reported."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.notices import COLLISION, Notice
from coscrew_codegen.scene.readers.mjcf.mjcf_actuators import actuators, unkept_rotors
from coscrew_codegen.scene.readers.mjcf.mjcf_collisions import touching
from coscrew_codegen.scene.readers.mjcf.mjcf_effects import following
from coscrew_codegen.scene.readers.mjcf.mjcf_laws import lawful
from coscrew_codegen.scene.readers.mjcf.mjcf_loops import closings, idle
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, one_coordinate
from coscrew_codegen.scene.readers.mjcf.mjcf_tendons import tendons
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.scene_error import SceneError

if TYPE_CHECKING:
    import mujoco

GROUPS: Mapping[str, str] = {
    "loops": "closes a loop, or is a law of joints, and is kept unless it is named here",
    "equalities": "is no equality of bodies, of joints or of fixed tendons",
    "tendons": "pulls, and is no sum of joints' coordinates, nor a line between two sites, with "
               "one length at rest",
    "actuators": "exerts forces of its own as no effect does",
    "polynomials": "is no line in velocity or position, or yields",
    "fluid": "makes forces of a fluid",
    "flexes": "is not rigid",
    "plugins": "runs code"}
"""What `leave_out` may name, and why it is not kept."""

_OTHER = "other tools' numbers"
_MANY = 5
"""Keyframes that a message lists."""


def refused(source: ModelSource, model: "mujoco.MjModel", names: MjcfNames) -> Iterator[Notice]:
    """Notices of what the scene leaves out.  Raises SceneError for the first that it does not."""
    for group, element in _unkept(model, names):
        if group == "loops" and group not in source.leave_out:
            continue  # they are kept
        if group not in source.leave_out:
            raise SceneError(source.path, element, f"{GROUPS[group]}; leave_out = [\"{group}\"] in "
                             f"the scene, or --leave-out {group}, leaves it out")
        yield Notice(_OTHER, element, f"{element}: left out ({group})")


def _unkept(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[tuple[str, str]]:
    """Group and element."""
    yield from _equalities(model, names)
    yield from tendons(model, names).refused
    for name in actuators(model, names).refused:
        yield "actuators", name
    yield from unkept_rotors(model, names)
    yield from _of_joints(model, names)
    if of := _fluid(model):
        yield "fluid", f"option {' and '.join(of)}"
    if model.nflex:
        yield "flexes", "flex"
    if model.nplugin:
        yield "plugins", "plugin"


def _fluid(model: "mujoco.MjModel") -> list[str]:
    """The options of the fluid around all bodies; without them, wind pushes nothing."""
    given = {"density": model.opt.density, "viscosity": model.opt.viscosity}
    return [name for name, number in given.items() if number]


def _equalities(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[tuple[str, str]]:
    import mujoco

    loops, led = {*closings(model), *lawful(model, names)}, {*following(model).values()}
    for e in range(model.neq):
        if e in loops or e not in led and model.eq_active0[e] and not idle(model, e):
            group = "loops" if e in loops else "equalities"
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


def ignored(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[Notice]:
    """Yields notices of actuators, tendons, and elements that are not read: contact, mocap."""
    yield from actuators(model, names).notices
    yield from tendons(model, names).notices
    for b in range(1, model.nbody):
        if model.body_mocapid[b] >= 0:
            yield Notice(_OTHER, f"body {names.body(b)}", f"body {names.body(b)}: is moved by hand "
                         "in MuJoCo (mocap), and fixed here")
    for e in range(model.neq):
        if not model.eq_active0[e]:
            yield Notice(_OTHER, f"equality {e}", f"equality {model.equality(e).name or e!r}: is "
                         "not active at the start, and not used")
        elif idle(model, e):
            yield Notice(_OTHER, f"equality {e}", f"equality {model.equality(e).name or e!r}: "
                         "holds bodies that cannot move against each other, and is not used")
    if model.opt.wind.any() and not _fluid(model):
        yield Notice(_OTHER, "option wind", "option wind: pushes nothing, in MuJoCo either, "
                     "without density or viscosity of a fluid, and is not used")
    yield from _unlike_efforts(model, names)
    for i in range(model.npair):
        pair = " and ".join(model.geom(int(g)).name or f"geom {g}"
                            for g in (model.pair_geom1[i], model.pair_geom2[i]))
        yield Notice(_OTHER, "model", f"pair of {pair}: its friction and stiffness are not used; "
                     "[effects.contact_pair.LABEL] lets two bodies touch")
    if count := len(touching(model)):
        remedy = "add [effects.contact] with mu"
        yield Notice(COLLISION, "model", f"{count} geom{'s' * (count > 1)} may touch others in "
                     f"MuJoCo, and nothing here: {remedy}", remedy, ("contact", ""))
    if model.nkey:
        keys = [model.key(k).name or str(k) for k in range(model.nkey)]
        yield Notice(_OTHER, "model", f"keyframe{'s' * (len(keys) > 1)} {', '.join(keys[:_MANY])}"
                     f"{', …' * (len(keys) > _MANY)}: not used; [start.q] of a scene sets a start")


def _unlike_efforts(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[Notice]:
    """Yields notices of ranges of actuators' forces that are no effort of a joint: of tendons, and
    of joints where they are not the same in both directions."""
    held = [(f"joint {names.joint(j)}", model.jnt_actfrcrange[j]) for j in range(model.njnt)
            if model.jnt_actfrclimited[j] and sum(model.jnt_actfrcrange[j])]
    held += [(f"tendon {names.tendon(t)}", model.tendon_actfrcrange[t])
             for t in range(model.ntendon) if model.tendon_actfrclimited[t]]
    for element, (low, high) in held:
        yield Notice(_OTHER, element, f"{element}: what its actuators exert is held between "
                     f"{low:g} and {high:g} in MuJoCo, and not here")
