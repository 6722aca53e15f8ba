"""Actuators of an MJCF as effects on joints and on sums of coordinates.

An actuator of MuJoCo without a state of its own exerts, along its length l, the force

    f = g ctrl + b0 + b1 l + b2 l',   within a range,   l = gear q, or gear times a tendon's length

A motor's torque, a servo's target or its target_v is ctrl itself; of others the torque is
g ctrl + b0.  These numbers stay arguments of the scene's functions, and are by default what MuJoCo
has for ctrl = 0."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, decimals, one_coordinate
from coscrew_codegen.scene.readers.mjcf.mjcf_tendons import weights
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals

if TYPE_CHECKING:
    import mujoco

_OTHER = "other tools' numbers"


@dataclass(frozen=True)
class Actuators:
    """The actuators: tables by joint or label, the numbers that stay arguments, notices of those
    that no effect is like and that exert nothing by themselves, and the others, by name."""

    tables: Mapping[str, Mapping[str, object]]
    inputs: tuple[str, ...]
    notices: tuple[Notice, ...]
    refused: tuple[str, ...]


def rotors(model: "mujoco.MjModel", names: MjcfNames) -> dict[str, dict[str, object]]:
    """The armature and the damping of actuators, which act on their lengths, by effect and label.
    """
    tables: dict[str, dict[str, object]] = {"armature": {}, "viscous": {}}
    for i in range(model.nu):
        if joints := _joints(model, names, i):
            for effect, key, of in (("armature", "inertia", model.actuator_armature),
                                    ("viscous", "d", model.actuator_damping)):
                if of[i]:
                    tables[effect][f"rotor of {names.actuator(i)}"] = {
                        "joints": joints, key: decimals([of[i]])[0]}
    return tables


def unkept_rotors(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[tuple[str, str]]:
    """Group and element of actuators whose armature or damping no effect is like."""
    for i in range(model.nu):
        element = f"actuator {model.actuator(i).name or i!r}"
        if model.actuator_dampingpoly[i].any():
            yield "polynomials", f"damping of {element}"
        if (model.actuator_armature[i] or model.actuator_damping[i]) and not _joints(
                model, names, i):
            yield "actuators", element


@dataclass(frozen=True)
class _Drive:
    """The values of the effect, and which of them ctrl sets."""

    values: Mapping[str, object]
    driven: str  # "torque"
    words: tuple[str, ...] = ()  # how, if it is not ctrl itself, and what holds ctrl in MuJoCo


def actuators(model: "mujoco.MjModel", names: MjcfNames) -> Actuators:
    """Returns the actuators of a model, none of those that it switches off."""
    import mujoco

    tables: dict[str, Mapping[str, object]] = {}
    inputs: list[str] = []
    notices: list[Notice] = []
    refused: list[str] = []
    off = model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_ACTUATION)
    for i in range(model.nu):
        element = f"actuator {model.actuator(i).name or i}"
        if off or model.opt.disableactuator & 1 << int(model.actuator_group[i]):
            notices.append(Notice(_OTHER, element, f"{element}: is switched off in MuJoCo"))
            continue
        joints, drive = _joints(model, names, i), _drive(model, i)
        if joints and drive:
            label, on = _place(model, names, i, joints)
            tables[label] = {**on, **drive.values}
            inputs.append(f"actuator.{label}.{drive.driven}")
            notices += [Notice("actuator", element, f"{element}: {x}") for x in drive.words]
        elif _passive(model, i):
            refused.append(element)
        else:
            notices.append(Notice("actuator", element, f"{element}: is not used, and no effect "
                                                       "does the same"))
    return Actuators(tables, tuple(inputs), tuple(notices), tuple(refused))


def _passive(model: "mujoco.MjModel", i: int) -> bool:
    """Returns whether an actuator exerts forces by itself."""
    return bool(model.actuator_biastype[i])


def _joints(model: "mujoco.MjModel", names: MjcfNames, i: int) -> dict[str, Decimals]:
    """The weights of the joints in an actuator's length; {} if it is no sum of coordinates."""
    import mujoco

    on, gear = int(model.actuator_trnid[i][0]), float(model.actuator_gear[i][0])
    kind, kinds = int(model.actuator_trntype[i]), mujoco.mjtTrn
    if kind == int(kinds.mjTRN_TENDON):
        return weights(model, names, on, gear) or {}
    at_joint = kind in (int(kinds.mjTRN_JOINT), int(kinds.mjTRN_JOINTINPARENT))
    return {names.joint(on): decimals([gear])[0]} if (
        at_joint and gear and on in one_coordinate(model)) else {}


def _place(model: "mujoco.MjModel", names: MjcfNames, i: int, joints: Mapping[str, Decimals]
           ) -> tuple[str, dict[str, object]]:
    """The joint on which it acts by a gear of 1, if it is the only one there; else a label, and the
    weights."""
    on, alone = model.actuator_trnid[i][0], len(joints) == 1 and int(model.actuator_trntype[i]) < 2
    several = sum(int(model.actuator_trntype[k]) < 2 and model.actuator_trnid[k][0] == on
                  for k in range(model.nu))
    (joint, weight), *_ = joints.items()
    if alone and several == 1 and float(weight) == 1:
        return joint, {}
    return names.actuator(i), {"joints": dict(joints)}


def _drive(model: "mujoco.MjModel", i: int) -> _Drive | None:
    """The values of the effect that does the same; None if there is none."""
    g, (b0, b1, b2) = float(model.actuator_gainprm[i][0]), map(
        float, model.actuator_biasprm[i][:3])
    if not int(model.actuator_biastype[i]):
        b0 = b1 = b2 = 0.0
    limit, held = _limit(model, i), _range(model, i)
    if limit is None or not _plain(model, i) or b1 > 0 or b2 > 0:
        return None
    if held and held[0] == -held[1] and g and not (b0 or b1 or b2):  # |g ctrl| has a limit, too
        limit, held = min(limit, abs(g) * held[1]), None
    within = {"limit": decimals([limit])[0]} if limit < inf else {}
    clamped = (f"ctrl is held between {held[0]:g} and {held[1]:g} in MuJoCo, and not here",) \
        if held else ()
    ctrl = min(max(0.0, held[0]), held[1]) if held else 0.0
    kp, kd = decimals([0.0 - b1, 0.0 - b2])
    if b0 == 0 and b1 and g == -b1:
        return _Drive({"kind": "pd", "kp": kp, "kd": kd, "target": _number(ctrl), **within},
                      "target", clamped)
    if b0 == b1 == 0 and b2 and g == -b2:
        return _Drive({"kind": "pd", "kp": kp, "kd": kd, "target": 0, "target_v": _number(ctrl),
                       **within}, "target_v", clamped)
    servo = {"kind": "pd", "kp": kp, "kd": kd, "target": 0} if b1 or b2 else {"kind": "torque"}
    words = () if g == 1 and not b0 else (
        f"torque = {g:g} ctrl" + (f" + {b0:g}" if b0 else ""),)
    return _Drive({**servo, "torque": _number(g * ctrl + b0), **within}, "torque",
                  (*words, *clamped))


def _plain(model: "mujoco.MjModel", i: int) -> bool:
    """Returns whether it has no state, one control, a constant gain, and at most an affine bias."""
    import mujoco

    bias, affine = int(model.actuator_biastype[i]), int(mujoco.mjtBias.mjBIAS_AFFINE)
    return not (model.actuator_dyntype[i] or model.actuator_gaintype[i] or bias not in (0, affine)
                or model.actuator_delay[i] or model.actuator_ctrlnum[i] != 1
                or model.actuator_plugin[i] >= 0)


def _range(model: "mujoco.MjModel", i: int) -> tuple[float, float] | None:
    """The range in which MuJoCo holds ctrl; None if it does not."""
    import mujoco

    free = model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_CLAMPCTRL)
    low, high = map(float, model.actuator_ctrlrange[i])
    return (low, high) if model.actuator_ctrllimited[i] and not free else None


def _limit(model: "mujoco.MjModel", i: int) -> float | None:
    """The largest force, inf if there is none; None if it is not the same in both directions."""
    if not model.actuator_forcelimited[i]:
        return inf
    low, high = map(float, model.actuator_forcerange[i])
    return high if low == -high < 0 else None


def _number(x: float) -> object:
    return decimals([x])[0] if x else 0
