"""Base parameters: combinations that determine the torques."""

from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction, Situation

_WORDS = (
    "beta of base_regressor: the fewest combinations of linear_parameters() that determine "
    "all torques")


def _words(its: Situation) -> str:
    names = ", ".join(f"[{n}] {name}" for n, name in enumerate(its.linear.base_names))
    return f"{_WORDS}: {names}"


FUNCTION = SceneFunction(
    "base_parameters", 19, _WORDS, "",
    (Array("beta", (AxisLength.BASE,), (), "parameters"),),
    lambda x: [x.base_parameters()], words_in=_words,
    units_in=lambda its: its.linear.base_units, of_tree=True)
