"""URDF files as models: links, joints, inertias, limits, dynamics, mimics.

Elements without influence on the dynamics (collision, transmission, those of simulators) are not
read, except for visuals, which pictures show.  Lengths in m, masses in kg, angles in rad.
"""

from fractions import Fraction

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.inertia_checks import WARN
from coscrew_codegen.scene.mechanism.model import Body, Inertia
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.urdf.urdf_gazebo import of_gazebo
from coscrew_codegen.scene.readers.urdf.urdf_joints import Joints
from coscrew_codegen.scene.readers.urdf.urdf_schema import MIRRORED, MOMENTS
from coscrew_codegen.scene.readers.urdf.urdf_shapes import shapes_of
from coscrew_codegen.scene.readers.xml_files.xml import Element


class _Urdf(Joints):
    """Reads one file.

    Raises SceneError, naming file, line and element, for files that are not URDF, numbers that are
    not finite, inertias without mass or moments unless these are accepted, and unknown names."""

    def __init__(self, source: ModelSource, contents: bytes | None) -> None:
        super().__init__(source.path, contents)
        self.lenient = source.lenient
        self.shapes = shapes_of(self.root, source)
        self.lacking: list[str] = []  # incomplete inertias that were accepted

    def parts(self) -> Parts:
        links, joints = self.root.all("link"), self.root.all("joint")
        lines = {"": self.root.line}
        lines |= {f"body {e.attributes.get('name')!r}": e.line for e in reversed(links)}
        lines |= {f"joint {e.attributes.get('name')!r}": e.line for e in reversed(joints)}
        name = self.root.attributes.get("name", self.path.stem)
        bodies, moves = tuple(map(self._body, links)), tuple(map(self._joint, joints))
        return Parts(name, bodies, moves, {x: f"line {line}" for x, line in lines.items()},
                     {joint.attributes["name"]: f"line {mimic.line}" for joint in joints
                      for mimic in joint.all("mimic")[:1]},
                     implausible=tuple(self.lacking),
                     notices=(*self.notices, *of_gazebo(self.root)),
                     collisions=tuple(
                         x for link in links for x in self.shapes.collisions(
                             link, link.attributes.get("name", ""))))

    def _body(self, link: Element) -> Body:
        name = self._name(link)
        element = f"body {name!r}"
        self._check(link, element)
        inertial = self._only(link, "inertial", element)
        return Body(name, self._inertia(inertial, element) if inertial else None,
                    self.shapes.visuals(link))

    def _inertia(self, inertial: Element, body: str) -> Inertia | None:
        """The inertia; None if mass and moments are zero, as in links that are only frames."""
        placement = self._placement(inertial, body)
        mass = self._mass(inertial, body)
        moments = self._moments(inertial, body)
        if not mass and not any(moments):
            return None
        return Inertia(mass, placement.t, rotations.rotated(placement.R, moments))

    def _moments(self, inertial: Element, body: str) -> tuple[Fraction, ...]:
        element = self._of_inertial(inertial, "inertia", body, "its moments are taken for zero")
        if element is None:
            return (Fraction(0),) * 6
        moments = tuple(self._number(element, name, body) for name in MOMENTS)
        for mirrored, name in MIRRORED.items():
            moment = moments[MOMENTS.index(name)]
            if self._number(element, mirrored, body, moment) != moment:
                self._refuse(element, body, f"{mirrored!r} of <inertia> is not {name!r}; wanted a "
                                            "symmetric matrix")
        return moments

    def _mass(self, inertial: Element, body: str) -> Fraction:
        element = self._of_inertial(inertial, "mass", body, "it is taken for zero")
        return Fraction(0) if element is None else self._number(element, "value", body)

    def _of_inertial(self, inertial: Element, tag: str, body: str, taken: str) -> Element | None:
        """The element with this tag; None if it is missing and that is accepted."""
        element = self._only(inertial, tag, body)
        if element is None and not self.lenient:
            self._refuse(inertial, body,
                         f'<inertial> lacks <{tag}>; implausible = "{WARN}" accepts it')
        if element is None:
            self.lacking.append(f"{body}: <inertial> lacks <{tag}>; {taken}")
        return element


def urdf_parts(source: ModelSource, contents: bytes | None = None) -> Parts:
    """The parts of a URDF: of the file, or of these contents, which the file has written."""
    return _Urdf(source, contents).parts()


READER = ModelReader(
    "URDF", (".urdf",), "a robot of ROS: its links and joints, with inertias, limits, dynamics and "
    "mimics, visual shapes for pictures, and collision shapes for [effects.contact]",
    urdf_parts, takes_packages=True)
