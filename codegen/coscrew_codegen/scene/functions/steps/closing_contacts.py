"""The number of contacts of limits."""

from coscrew_codegen.scene.scene_function import COUNT, Default, SceneFunction
from coscrew_codegen.scene.situation import LIMITS

BY_DEFAULT = Default("by default, if the scene has limits", lambda scene, target: True)

FUNCTION = SceneFunction(
    "closing_contacts", 190, "count: the number of limits that are closed, or would be after "
    "moving with v for h", "h q v", (COUNT,), lambda x: [[x.closing()]], default=BY_DEFAULT,
    divides=True, needs=LIMITS)
