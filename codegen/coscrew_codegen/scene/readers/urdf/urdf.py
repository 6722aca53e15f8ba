"""URDF files as models: links, joints, inertias, limits, dynamics, mimics.

Elements without influence on the dynamics (visual, collision, transmission, those of simulators)
are not read.  Lengths in m, masses in kg, angles in rad.
"""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.assembly import ModelError, assembled
from coscrew_codegen.scene.mechanism.inertia_checks import ERROR, WARN, judged
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.mimics import without_chains, wrong_mimics
from coscrew_codegen.scene.mechanism.model import Body, Fault, Inertia, Model
from coscrew_codegen.scene.mechanism.roundoff_cleanup import without_residues
from coscrew_codegen.scene.readers.urdf.urdf_joints import Joints
from coscrew_codegen.scene.readers.urdf.urdf_schema import MIRRORED, MOMENTS
from coscrew_codegen.scene.readers.urdf.xml import Element


def read_urdf(path: Path | str, base: JointKind = FIXED, implausible: str = ERROR) -> Model:
    """The model in a URDF file, its root joined to the world by a joint of the kind `base`.

    With `implausible` "warn", inertias that are impossible, massless or incomplete are accepted and
    listed in the model's `implausible`.  Raises SceneError, naming file, line and element, for
    files that are not URDF, numbers that are not finite, impossible inertias, unknown names and
    joints that do not form a tree."""
    return _Urdf(Path(path), implausible).model(base)



class _Urdf(Joints):
    """Reads one file."""

    def __init__(self, path: Path, implausible: str) -> None:
        super().__init__(path)
        self.implausible = implausible
        self.lacking: list[str] = []  # incomplete inertias that were accepted

    def model(self, base: JointKind) -> Model:
        links, joints = self.root.all("link"), self.root.all("joint")
        lines = {f"body {e.attributes.get('name')!r}": e for e in reversed(links)}
        lines |= {f"joint {e.attributes.get('name')!r}": e for e in reversed(joints)}
        try:
            model = without_residues(without_chains(self._without_wrong_mimics(assembled(
                self.root.attributes.get("name", self.path.stem), tuple(map(self._body, links)),
                tuple(map(self._joint, joints)), base))))
            return judged(replace(model, implausible=tuple(self.lacking),
                                  notices=tuple(self.notices)), self.implausible)
        except ModelError as error:
            self._refuse(lines.get(error.element, self.root), error.element, error.problem)

    def _without_wrong_mimics(self, model: Model) -> Model:
        """The model with faults in place of mimics that cannot be followed."""
        wrong = wrong_mimics(model)
        lines = {joint.attributes["name"]: mimic.line for joint in self.root.all("joint")
                 for mimic in joint.all("mimic")[:1]}
        return replace(model, joints=tuple(
            replace(joint, mimic=None, faults=(*joint.faults, Fault(
                "mimic", wrong[joint.name], f"{self.path.name}, line {lines[joint.name]}")))
            if joint.name in wrong else joint for joint in model.joints))

    def _body(self, link: Element) -> Body:
        name = self._name(link)
        element = f"body {name!r}"
        self._check(link, element)
        inertial = self._only(link, "inertial", element)
        return Body(name, self._inertia(inertial, element) if inertial else None)

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
        found = self._only(inertial, tag, body)
        if found is None and self.implausible == ERROR:
            self._refuse(inertial, body,
                         f'<inertial> lacks <{tag}>; implausible = "{WARN}" accepts it')
        if found is None:
            self.lacking.append(f"{body}: <inertial> lacks <{tag}>; {taken}")
        return found
