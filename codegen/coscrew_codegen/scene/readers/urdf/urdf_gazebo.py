"""Notices of `<gazebo>` in a URDF: numbers with which the robot moves otherwise in Gazebo.

All else in it is free: sensors, plugins, colours, numbers of its solver and of touching."""

from collections.abc import Iterator

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.xml_files.xml import Element

_USUAL = {"gravity": ("true", "1"), "turnGravityOff": ("false", "0"), "static": ("false", "0"),
          "kinematic": ("false", "0"), "dampingFactor": ("0",)}
"""The texts of elements that change nothing."""


def of_gazebo(root: Element) -> Iterator[Notice]:
    """Notices of springs of joints, with the effects to write, and of other elements that change
    the motion."""
    for tool in root.all("gazebo"):
        of = tool.attributes.get("reference", "")
        texts = {x.tag: x.texts[0].text for x in tool.children if x.texts}
        element = of or "robot"
        for tag, text in texts.items():
            if tag in _USUAL and _meaning(text) not in map(_meaning, _USUAL[tag]):
                yield Notice("other tools' numbers", element, f"{element}: <{tag}> {shown(text)} "
                             "of <gazebo> is not used")
        if _number(texts.get("springStiffness", "0")) != 0:
            k, rest = (_number(texts.get(x, "0")) for x in ("springStiffness", "springReference"))
            remedy = "" if k is None or rest is None else (
                f"add [effects.spring.{toml_key(of)}] with k = {k!r} and q0 = {rest!r}")
            yield Notice("spring", f"joint {of}", f"joint {of}: <springStiffness> of <gazebo> is "
                         f"not used{': ' * bool(remedy)}{remedy}", remedy, ("spring", of))


def _meaning(text: str) -> object:
    """A number, or a word in small letters."""
    number = _number(text)
    return text.lower() if number is None else number


def _number(text: str) -> float | None:
    """The number that a text is; None if it is none."""
    try:
        return float(decimal(text))
    except ValueError:
        return None
