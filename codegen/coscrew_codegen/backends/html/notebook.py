"""Scenes in notebooks: tree, effects, functions and sizes, as HTML."""

from collections.abc import Iterable

from coscrew_codegen.backends.render import render
from coscrew_codegen.program.scene_functions import Arrays, SceneInterface
from coscrew_codegen.scene.mechanism.model import WORLD, Model, value
from coscrew_codegen.scene.scene import Scene

Items = list[tuple[str, "Items"]]  # texts, each with those beyond it


def html(scene: Scene | None, interface: SceneInterface, compiler: str) -> str:
    """The scene and its functions; the functions alone if they are of no scene."""
    lists: dict[str, Items] = {
        "effects": _effects(scene) if scene else [],
        "p: parameters": _items(f"{name} = {x:g}" for name, x in interface.parameters),
        "functions": _items(f"{x.name}({_shapes(x.inputs)}) → {_shapes(x.outputs)}"
                            for x in interface.signatures)}
    return render(
        "page/notebook.html",
        head=f"{interface.name}: NQ = {interface.nq}, NV = {interface.nv}, bodies: "
        f"{len(interface.bodies)}; {', '.join(interface.precisions)} precision; "
        f"{compiler or 'not compiled, in NumPy'}",
        parts={**({"tree": _bodies(scene.model, WORLD)} if scene else {}),
               **{f"{title} ({len(x)})": x for title, x in lists.items() if x}})


def _items(texts: Iterable[str]) -> Items:
    return [(x, []) for x in texts]


def _bodies(model: Model, parent: str) -> Items:
    """The bodies beyond a body, each with its joint and mass; and those beyond them."""
    masses = {x.name: f", {float(value(x.inertia.mass)):.4g} kg" for x in model.bodies if x.inertia}
    return [(f"{x.child}{masses.get(x.child, '')}: {x.kind.name} {x.name}"
             + (f", follows {x.mimic.joint}" if x.mimic else ""), _bodies(model, x.child))
            for x in model.joints if x.parent == parent]


def _effects(scene: Scene) -> Items:
    """Each effect with the places where it acts."""
    places: dict[str, list[str]] = {}
    for x in scene.effects:
        places.setdefault(x.effect.name, []).append(x.label or x.on)
    return _items(f"{name}: {', '.join(of)}" if any(of) else name for name, of in places.items())


def _shapes(arrays: Arrays) -> str:
    return ", ".join(f"{name} {'×'.join(map(str, shape))}".strip() for name, shape in arrays)
