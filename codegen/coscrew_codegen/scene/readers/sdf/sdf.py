"""SDF files as models: links, frames and joints of one model, and of the models in it.

What Gazebo senses is not read, only pictures show what it draws, and shapes that touch move
nothing.  Numbers are in SI units; names in a model that is in another begin with its own,
`hand::palm`.
"""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.joints.free import JOINT as FREE
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.collision import PLANE, Friction
from coscrew_codegen.scene.mechanism.inertia_checks import WARN
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Inertia, Joint
from coscrew_codegen.scene.readers.declared_effects import Effects
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.sdf.sdf_gears import GROUP, gears
from coscrew_codegen.scene.readers.sdf.sdf_loops import SdfLoops
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals
from coscrew_codegen.scene.readers.urdf.urdf_schema import MOMENTS
from coscrew_codegen.scene.readers.xml_files.xml import Element
from coscrew_codegen.scene.readers.xml_files.xml_shapes import SIZES, Shapes, colour, numbers

_ONE: tuple[Fraction, ...] = (Fraction(1),) * 3
_NONE: tuple[Fraction, ...] = (Fraction(0),) * 3
_DEFAULTS = {"inertial": "1 kg and 1 kg m²", "mass": "1 kg", "inertia": "1 kg m²"}
"""What SDF takes where elements are missing."""


class _Sdf(SdfLoops):
    """Reads one file.  Raises SceneError, naming file and line, for what SDF does not have, what
    is not supported, and numbers that cannot be."""

    def __init__(self, source: ModelSource) -> None:
        super().__init__(source.path)
        self.lenient, self.left_out = source.lenient, source.leave_out
        self.shapes = Shapes(source, {**SIZES, "ellipsoid": ("radii",), PLANE: ()}, "uri",
                             self.pose, _colour, _friction)
        self.lacking: list[str] = []  # inertias that were taken as SDF's defaults

    def parts(self) -> Parts:
        model, gravity = self._model()
        self.collect(model, "")
        self.close(opened="loops" in self.left_out)
        mimics = gears(self, left_out=GROUP in self.left_out)
        parts: list[Body | Joint] = []
        links = {full: x for full, x, _ in self.every("link")}
        for full, (element, scope) in self.frames.items():
            if element.tag == "link":
                parts.append(self._body(element, full))
            elif element.tag == "joint" and full not in self.closing:
                parts += (replace(x, mimic=mimics[full]) if x.name == full in mimics
                          and isinstance(x, Joint) else x
                          for x in self.joint(element, full, scope))
            elif element.tag == "frame":
                link = self.link_of(full)
                parts += (Body(full), Joint(f"{full}/frame", FIXED, link, full,
                                            self.within(link, full)))
        parts += self.closures.frames
        effects: Effects = {"gravity": gravity, "spring": self.springs}
        return Parts(
            self.name(model), tuple(x for x in parts if isinstance(x, Body)),
            tuple(x for x in parts if isinstance(x, Joint)), {"": f"line {model.line}"} | {
                f"{'joint' if x.tag == 'joint' else 'body'} {full!r}": f"line {x.line}"
                for full, (x, _) in self.frames.items()},
            effects={name: table for name, table in effects.items() if table},
            implausible=tuple(self.lacking), notices=tuple(self.notices), base=FREE,
            roots={full: self.within(WORLD, full) for full in links},
            loops=tuple(self.closures.loops),
            collisions=tuple(y for full, x in links.items()
                             for y in self.shapes.collisions(x, full)))

    def _model(self) -> tuple[Element, dict[str, object]]:
        """The one model of the file, and the gravity of the world that it stands in, if any."""
        worlds = self.root.all("world")
        for world in worlds:
            self.refuse_includes(world)
        models = [*self.root.all("model"), *(x for world in worlds for x in world.all("model"))]
        if len(models) != 1 or len(worlds) > 1:
            self.refuse(self.root, f"holds {len(models)} models and {len(worlds)} worlds; wanted "
                                   "one model")
        if self.flag(models[0], "static"):
            self.refuse(models[0], "is static: nothing moves; wanted <static>false</static>")
        for world in worlds:
            of = next((x for x in (world, *world.all("physics")) if "gravity" in x.attributes),
                      world)
            self.numbers(of, "gravity", 3, "0 0 -9.8")
            g = self.text(of, "gravity", "0 0 -9.8").split()
            return models[0], {"g": [Decimals(x) for x in g]}
        return models[0], {}

    def _body(self, link: Element, full: str) -> Body:
        """The link, which SDF gives 1 kg and moments of 1 kg m² if the file gives none."""
        for tag, usual in (("gravity", "true"), ("kinematic", "false")):
            if self.flag(link, tag, usual) != (usual == "true"):
                self.refuse(link, f"<{tag}> is {self.text(link, tag)}; wanted {usual}, as without "
                                  f"<{tag}>")
        decay = self.only(link, "velocity_decay")
        if decay and any(self.number(decay, tag, "0") for tag in ("linear", "angular")):
            self.refuse(decay, "<velocity_decay> is not supported; wanted 0, and [effects.drag]")
        inertial = self.only(link, "inertial")
        for tag in ("mass", "inertia") if inertial else ("inertial",):
            if inertial and (tag in inertial.attributes or tag == "inertia" and inertial.all(tag)):
                continue
            if not self.lenient:
                self.refuse(link, f"lacks <{tag}>, for which SDF takes {_DEFAULTS[tag]}; wanted "
                                  f'it, or implausible = "{WARN}" (--implausible {WARN})')
            self.lacking.append(f"body {full!r}: lacks <{tag}>; SDF takes {_DEFAULTS[tag]}")
        return Body(full, self._inertia(inertial, full) if inertial else
                    Inertia(_ONE[0], _NONE, _ONE + _NONE), self.shapes.visuals(link))

    def _inertia(self, inertial: Element, full: str) -> Inertia | None:
        if self.flag(inertial, "auto"):
            self.refuse(inertial, "its inertia follows from shapes (auto); wanted numbers")
        pose, matrix = self.only(inertial, "pose"), self.only(inertial, "inertia")
        if pose and pose.attributes.get("relative_to"):
            self.refuse(pose, "the pose of <inertial> is relative to its link; wanted no "
                              "relative_to")
        mass = self.number(inertial, "mass", "1")
        if mass < 0 or not mass and not self.lenient:
            remedy = f', or implausible = "{WARN}": none' if not mass else ""
            self.refuse(inertial, f"mass {float(mass):g} kg, for which other programs take 1 kg, "
                                  f"or none; wanted a positive mass{remedy}")
        if not mass:
            self.lacking.append(f"body {full!r}: mass 0 kg; taken as a frame without inertia")
            return None
        at = self.pose(inertial)
        moments = _ONE + _NONE if matrix is None else tuple(
            self.number(matrix, tag, "0" if tag in MOMENTS[3:] else None) for tag in MOMENTS)
        return Inertia(mass, at.t, rotations.rotated(at.R, moments))


def _colour(visual: Element) -> tuple[float, ...]:
    return next((colour(x, "diffuse", "ambient") for x in visual.all("material")), ())


def _friction(collision: Element) -> Friction | None:
    """The coefficients mu and mu2 for ODE, which other engines take, too.  Raises ValueError."""
    of = (ode for surface in collision.all("surface") for friction in surface.all("friction")
          for ode in friction.all("ode"))
    return next((Friction(*numbers(x, "mu", 1, _ONE[:1]), *numbers(x, "mu2", 1, _ONE[:1]))
                 for x in of), None)


READER = ModelReader(
    "SDF", (".sdf", ".world"), "one model of Gazebo, alone or in a world, with models in it: "
    "links, frames, joints with damping, friction, springs, limits and mimics, gearboxes, closed "
    "loops, the world's gravity; a root that no joint moves floats",
    lambda source: _Sdf(source).parts(), takes_packages=True, leaves_out=("loops", GROUP))
