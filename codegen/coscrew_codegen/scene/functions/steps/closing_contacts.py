"""The number of contacts of limits."""

from coscrew_codegen.scene.scene_function import COUNT, Default, SceneFunction, Situation

BY_DEFAULT = Default("by default, if the scene has limits", lambda scene, target: True)


def lacks(its: Situation) -> str:
    """Says why a scene has no contacts of limits."""
    return "" if its.closes else "no limit closes"


FUNCTION = SceneFunction(
    "closing_contacts", 190, "count: the number of limits that are closed, or would be after "
    "moving with v for h", "h q v", (COUNT,), lambda x: [[x.closing()]], default=BY_DEFAULT,
    divides=True, lacks=lacks)
