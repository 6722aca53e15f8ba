"""States that loops close."""

from coscrew_codegen.scene.functions.loops.closure import BY_DEFAULT
from coscrew_codegen.scene.scene_function import Q, SceneFunction, V
from coscrew_codegen.scene.situation import LOOPS

FUNCTION = SceneFunction(
    "with_closed_loops", 175, "q and v moved onto the closures of loops: q by one step of Newton, "
    "v so that E v = 0, both along M⁻¹ E^T, as impulses between the bodies of a loop would move "
    "them", "q v", (Q, V), lambda x: x.with_closed_loops(), default=BY_DEFAULT, divides=True,
    needs=LOOPS)
