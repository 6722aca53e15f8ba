"""All contacts of bodies at once: where they are, what they exert, and how deep they are."""

from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.situation import CONTACTS

_N = AxisLength.CONTACTS
FUNCTION = SceneFunction(
    "contacts", 86, "point, force, depth, share, normal: of each contact, in the order of the "
    "scene's effects; the force on its body, of two the first", "q v",
    (Array("point", (_N, 3), ("m",), "in m, in the world's frame"),
     Array("force", (_N, 3), ("N",), "in N, in the world's frame"),
     Array("depth", (_N,), ("1",), "over that at rest"),
     Array("share", (_N,), ("1",), "of mu N that friction takes: 1 where it slips"),
     Array("normal", (_N, 3), ("1",), "along which N pushes the body, in the world's frame")),
    lambda x: x.contacts(), Depends.EFFECTS, needs=CONTACTS)
