"""Parameters on which torques depend linearly."""

from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction, Situation

_WORDS = (
    "pi of torque_regressor: mass, first and second moments of each link about its origin, in its "
    "frame, then numbers of effects")


def _words(its: Situation) -> str:
    names = ", ".join(f"[{n}] {name}" for n, name in enumerate(its.linear.names))
    return f"{_WORDS}: {names}"


FUNCTION = SceneFunction(
    "linear_parameters", 16, _WORDS, "",
    (Array("pi", (AxisLength.LINEAR,), (), "parameters"),),
    lambda x: [x.linear_parameters()], words_in=_words, units_in=lambda its: its.linear.units,
    of_tree=True)
