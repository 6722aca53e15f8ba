"""Tendons of an MJCF: weighted sums of joints' coordinates, and lines between two sites; and the
effects on them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, decimals
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals

if TYPE_CHECKING:
    import mujoco


@dataclass(frozen=True)
class Tendons:
    """The tendons: effects that they declare, by effect and label; those for which a scene chooses
    further numbers; those that pull as no effect does; and what is not used of others."""

    effects: dict[str, dict[str, Mapping[str, object]]]
    offered: dict[str, dict[str, Mapping[str, object]]]
    refused: list[tuple[str, str]]  # group and element
    notices: list[Notice]


def weights(model: "mujoco.MjModel", names: MjcfNames, t: int, gear: float = 1.0
            ) -> dict[str, Decimals] | None:
    """The weights of the joints in a tendon's length, times a gear; None for another tendon."""
    import mujoco

    places = range(int(model.tendon_adr[t]), int(model.tendon_adr[t] + model.tendon_num[t]))
    if any(int(model.wrap_type[w]) != int(mujoco.mjtWrap.mjWRAP_JOINT) for w in places):
        return None
    by_joint: dict[str, float] = {}
    for w in places:
        name = names.joint(int(model.wrap_objid[w]))
        by_joint[name] = by_joint.get(name, 0.0) + gear * float(model.wrap_prm[w])
    return {name: decimals([x])[0] for name, x in by_joint.items() if x}


def tendons(model: "mujoco.MjModel", names: MjcfNames) -> Tendons:
    """Returns the tendons of a model."""
    result = Tendons({"armature": {}, "spring": {}, "spring_damper": {}, "viscous": {}}, {}, [], [])
    for t in range(model.ntendon):
        joints, ends = weights(model, names, t), _ends(model, t)
        element, two_lengths = f"tendon {model.tendon(t).name or t!r}", model.tendon_stiffness[
            t] and len({*model.tendon_lengthspring[t]}) > 1
        if not (joints or ends) or two_lengths or ends and model.tendon_armature[t]:
            if any(x[t] for x in (model.tendon_stiffness, model.tendon_damping,
                                  model.tendon_armature, model.tendon_frictionloss,
                                  model.tendon_limited)):
                result.refused.append(("tendons", element))
            continue
        if model.tendon_stiffnesspoly[t].any() or model.tendon_dampingpoly[t].any() or (
                model.tendon_plasticadr[t] >= 0):
            result.refused.append(("polynomials", f"damping or stiffness of {element}"))
        if joints:
            _act_on_sum(model, names, t, joints, result)
        else:
            _act_on_line(model, names, t, ends, result)
    return result


def _act_on_sum(model: "mujoco.MjModel", names: MjcfNames, t: int, joints: Mapping[str, object],
                result: Tendons) -> None:
    """Enter the effects of a tendon on a sum of coordinates."""
    label = names.tendon(t)
    k, q0, d, inertia = decimals([model.tendon_stiffness[t], model.tendon_lengthspring[t][0],
                                  model.tendon_damping[t], model.tendon_armature[t]])
    for effect, values in (("spring", {"k": k, "q0": q0}), ("viscous", {"d": d}),
                           ("armature", {"inertia": inertia})):
        if float(next(iter(values.values()))):
            result.effects[effect][label] = {"joints": joints, **values}
    for effect, offered in _offered(model, t, joints):
        result.offered.setdefault(effect, {})[label] = offered


def _ends(model: "mujoco.MjModel", t: int) -> tuple[int, ...]:
    """The two sites between which a tendon is a straight line; () of another tendon."""
    import mujoco

    first, count = int(model.tendon_adr[t]), int(model.tendon_num[t])
    sites = {int(x) for x in model.wrap_type[first:first + count]}
    return tuple(int(x) for x in model.wrap_objid[first:first + 2]) if count == 2 and sites == {
        int(mujoco.mjtWrap.mjWRAP_SITE)} else ()


def _act_on_line(model: "mujoco.MjModel", names: MjcfNames, t: int, sites: tuple[int, ...],
                 result: Tendons) -> None:
    """Enter the spring and damper between the bodies of two sites that can move against each
    other; tell of friction and range, as which no effect acts there."""
    label, bodies = names.tendon(t), [int(model.site_bodyid[x]) for x in sites]
    if len({int(model.body_weldid[x]) for x in bodies}) == 1:
        return
    points = [decimals(model.site_pos[x]) for x in sites]
    k, length, d = decimals([model.tendon_stiffness[t], model.tendon_lengthspring[t][0],
                             model.tendon_damping[t]])
    if float(k) or float(d):
        result.effects["spring_damper"][label] = {
            "bodies": [names.body(x) for x in bodies], "first": points[0], "second": points[1],
            "k": k, "d": d, "length": length if float(k) else Decimals("0")}
    for what, there in (("friction", model.tendon_frictionloss[t]),
                        ("range", model.tendon_limited[t])):
        if there:
            result.notices.append(Notice("other tools' numbers", f"tendon {label}", f"tendon "
                                         f"{label}: its {what} is used by no effect"))


def _offered(model: "mujoco.MjModel", t: int, joints: Mapping[str, object]
             ) -> Iterator[tuple[str, dict[str, object]]]:
    """Friction and range as effects, with numbers that MuJoCo does not have."""
    if model.tendon_frictionloss[t]:
        yield "coulomb", {"joints": joints, "tau_c": decimals([model.tendon_frictionloss[t]])[0],
                          "eps": Decimals("0.01")}
    if model.tendon_limited[t]:
        lower, upper = decimals(model.tendon_range[t])
        yield "limit", {"joints": joints, "lower": lower, "upper": upper, "k": Decimals("1e4")}
