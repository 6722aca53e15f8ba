"""Scenes in notebooks: tree, effects, functions and sizes, as HTML."""

from collections.abc import Iterable, Iterator

from markupsafe import Markup

from coscrew_codegen.program.scene_functions import Arrays, SceneInterface
from coscrew_codegen.scene.mechanism.model import WORLD, Model, value
from coscrew_codegen.scene.scene import Scene

_FOLDED = Markup("<details{}><summary>{}</summary>{}</details>")
_LIST = Markup("<ul>{}</ul>")


def html(scene: Scene | None, interface: SceneInterface, compiler: str) -> str:
    """The scene and its functions; the functions alone if they are of no scene."""
    head = (f"{interface.name}: NQ = {interface.nq}, NV = {interface.nv}, bodies: "
            f"{len(interface.bodies)}; {', '.join(interface.precisions)} precision; "
            f"{compiler or 'not compiled, in NumPy'}")
    parts = [Markup("<p>{}</p>").format(head)]
    if scene:
        parts.append(_folded("tree", _bodies(scene.model, WORLD), True))
        parts.append(_folded("effects", [*_effects(scene)]))
    if interface.parameters:
        parts.append(_folded("p: parameters", [f"{name} = {x:g}"
                                               for name, x in interface.parameters]))
    parts.append(_folded("functions", [
        f"{x.name}({_shapes(x.inputs)}) → {_shapes(x.outputs)}" for x in interface.signatures]))
    return str(Markup("<div>{}</div>").format(Markup().join(parts)))


def _folded(title: str, items: list[str] | Markup, opened: bool = False) -> Markup:
    count = "" if isinstance(items, Markup) else f" ({len(items)})"
    inside = items if isinstance(items, Markup) else _list(items)
    return _FOLDED.format(Markup(" open" if opened else ""), title + count, inside)


def _list(items: Iterable[str | Markup]) -> Markup:
    return _LIST.format(Markup().join(Markup("<li>{}</li>").format(x) for x in items))


def _bodies(model: Model, parent: str) -> Markup:
    """The bodies beyond a body, each with its joint and mass; and those beyond them."""
    masses = {x.name: value(x.inertia.mass) for x in model.bodies if x.inertia}
    items = []
    for joint in (x for x in model.joints if x.parent == parent):
        mass = f", {float(masses[joint.child]):.4g} kg" if joint.child in masses else ""
        follows = f", follows {joint.mimic.joint}" if joint.mimic else ""
        items.append(Markup("<b>{}</b>{}: {} {}{}{}").format(
            joint.child, mass, joint.kind.name, joint.name, follows, _bodies(model, joint.child)))
    return _list(items) if items else Markup()


def _effects(scene: Scene) -> Iterator[str]:
    """Each effect with the places where it acts."""
    places: dict[str, list[str]] = {}
    for x in scene.effects:
        places.setdefault(x.effect.name, []).append(x.label or x.on)
    for name, of in places.items():
        yield f"{name}: {', '.join(of)}" if any(of) else name


def _shapes(arrays: Arrays) -> str:
    return ", ".join(f"{name} {'×'.join(map(str, shape))}".strip() for name, shape in arrays)
