"""Energy that bristles store, and power that their effects take from the motion."""

from coscrew_codegen.scene.scene_function import Array, Depends, SceneFunction, SceneQuantity
from coscrew_codegen.scene.situation import SWITCHES, has_switches

FUNCTION = SceneFunction(
    "bristles", 72, "stored, the energy of bristles: k_t |z|²/2 of a contact, k z²/2 of stiction, "
    "z within its bounds; and P, the power of their effects less that of potential energies: "
    "-P - stored' is dissipated", "q v",
    (Array("stored", (), ("J",), "energy in J"), Array("P", (), ("W",), "power in W")),
    lambda x: x.bristles(), Depends.EFFECTS,
    recorded=(SceneQuantity("bristles", components=("energy", "power"), expected="energy"),),
    recorded_in=has_switches, needs=SWITCHES)
