"""Fixed tendons of an MJCF: weighted sums of joints' coordinates, and the effects on them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, decimals
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals

if TYPE_CHECKING:
    import mujoco


@dataclass(frozen=True)
class Tendons:
    """The tendons: effects that they declare, by effect and label; those for which a scene chooses
    further numbers; and those that are no sums of coordinates, but pull."""

    effects: Mapping[str, Mapping[str, Mapping[str, object]]]
    offered: Mapping[str, Mapping[str, Mapping[str, object]]]
    refused: tuple[tuple[str, str], ...]  # group and element


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
    effects: dict[str, dict[str, Mapping[str, object]]] = {
        "armature": {}, "spring": {}, "viscous": {}}
    offered: dict[str, dict[str, Mapping[str, object]]] = {}
    refused: list[tuple[str, str]] = []
    for t in range(model.ntendon):
        joints, (low, high) = weights(model, names, t), model.tendon_lengthspring[t]
        element, pulls = f"tendon {model.tendon(t).name or t!r}", model.tendon_stiffness[t]
        if not joints or pulls and low != high:
            if any(x[t] for x in (model.tendon_stiffness, model.tendon_damping,
                                  model.tendon_armature, model.tendon_frictionloss,
                                  model.tendon_limited)):
                refused.append(("tendons", element))
            continue
        if model.tendon_stiffnesspoly[t].any() or model.tendon_dampingpoly[t].any() or (
                model.tendon_plasticadr[t] >= 0):
            refused.append(("polynomials", f"damping or stiffness of {element}"))
        label = names.tendon(t)
        if pulls:
            k, q0 = decimals([pulls, low])
            effects["spring"][label] = {"joints": joints, "k": k, "q0": q0}
        if model.tendon_damping[t]:
            effects["viscous"][label] = {"joints": joints,
                                         "d": decimals([model.tendon_damping[t]])[0]}
        if model.tendon_armature[t]:
            effects["armature"][label] = {"joints": joints,
                                          "inertia": decimals([model.tendon_armature[t]])[0]}
        for effect, values in _offered(model, t, joints):
            offered.setdefault(effect, {})[label] = values
    return Tendons(effects, offered, tuple(refused))


def _offered(model: "mujoco.MjModel", t: int, joints: Mapping[str, object]
             ) -> Iterator[tuple[str, dict[str, object]]]:
    """Friction and range as effects, with numbers that MuJoCo does not have."""
    if model.tendon_frictionloss[t]:
        yield "coulomb", {"joints": joints, "tau_c": decimals([model.tendon_frictionloss[t]])[0],
                          "eps": Decimals("0.01")}
    if model.tendon_limited[t]:
        lower, upper = decimals(model.tendon_range[t])
        yield "limit", {"joints": joints, "lower": lower, "upper": upper, "k": Decimals("1e4")}
