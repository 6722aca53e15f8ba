"""A reader of models: a format of files, from its text to bodies and joints.

    text ──▶ tables with places ──▶ Parts ──▶ Model

The reader takes the first two steps, in its own module; the last is the same for all: the parts are
joined into a tree and checked, and an error in it is reported with its place in the file."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism.assembly import (
    ModelError,
    assembled,
    with_faults,
    without_chains,
)
from coscrew_codegen.scene.mechanism.collision import Collision
from coscrew_codegen.scene.mechanism.inertia_checks import ERROR, WARN, judged
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.loop import ClosedLoop
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Joint, Model, Placement
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.tree import without_residues
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.declared_effects import Effects, notices
from coscrew_codegen.scene.readers.scene_error import SceneError


@dataclass(frozen=True)
class ModelSource:
    """The file of a model, and the scene's settings for reading it."""

    path: Path
    base: JointKind | None = None  # of the joint between the world and a root that no joint
    # moves; None: as the file says
    implausible: str = ERROR  # or WARN: accept inertias that no body has
    packages: Mapping[str, Path] = field(default_factory=dict)  # folders of packages of ROS
    arguments: Mapping[str, str] = field(default_factory=dict)  # of a file that is a program
    leave_out: tuple[str, ...] = ()  # what the scene does without, of what no scene can have

    @property
    def lenient(self) -> bool:
        """True if inertias that are impossible, massless or incomplete are accepted."""
        return self.implausible == WARN


@dataclass(frozen=True)
class Parts:
    """The bodies and joints of a file, in its order."""

    name: str
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    places: Mapping[str, str] = field(default_factory=dict)
    # where elements stand: "joint 'elbow'": "line 7"; "" for all that have no entry
    mimic_places: Mapping[str, str] = field(default_factory=dict)
    # where followers do, by joint: a wrong one is then refused only where it is used
    base: JointKind = FIXED  # of that joint, by the file
    roots: Mapping[str, Placement] = field(default_factory=dict)  # where it stands, by body
    start: Mapping[str, tuple[float, ...]] = field(default_factory=dict)  # of the file alone: q
    effects: Effects = field(default_factory=dict)  # effects of the file, as springs of joints
    offered: Effects = field(default_factory=dict)  # those with numbers that the file lacks:
    # a scene chooses them, in the file alone they do not act
    inputs: tuple[str, ...] = ()  # numbers of these that stay arguments, if the file is alone
    implausible: tuple[str, ...] = ()  # inertias that the reader has accepted, a line each
    notices: tuple[Notice, ...] = ()  # content that was read and is not used
    collisions: tuple[Collision, ...] = ()
    loops: tuple[ClosedLoop, ...] = ()
    elsewhere: Mapping[str, tuple[Path, str]] = field(default_factory=dict)  # elements that come
    # from other files, with the place there: "joint 'grip'": (arm.toml, "joints.grip")

    def tree(self, source: ModelSource) -> Model:
        """The bodies and joints as a tree, with a joint of its root.  Raises SceneError."""
        held = any(x.parent == WORLD for x in self.joints)
        base = source.base or (FIXED if held else self.base)
        with self._placing_errors(source):
            return assembled(self.name, self.bodies, self.joints, base, self.roots)

    def model(self, source: ModelSource) -> Model:
        """The tree of these parts, checked.  Raises SceneError for anything but one tree of bodies
        that can exist."""
        tree = self.tree(source)
        with self._placing_errors(source):
            led = without_chains(with_faults(tree, self.mimics_by_file(source)))
            links = led.links()
            idle = [x for x in self.loops if not x.law and len({links[y] for y in x.bodies}) == 1]
            clean = without_residues(replace(led, loops=tuple(
                x for x in self.loops if x not in idle)))
            all_notices = (
                *(notice for declared in (self.effects, self.offered) if declared
                  for notice in notices(declared, clean)), *self.notices,
                *(Notice("other tools' joints", f"joint {x.name}", f"joint {x.name}: holds bodies "
                         "that cannot move against each other, and is not used") for x in idle))
            return judged(replace(clean, implausible=self.implausible, notices=all_notices,
                                  collisions=self.collisions), source.implausible)

    def mimics_by_file(self, source: ModelSource) -> dict[str, str]:
        """The places of followers, with the file's name: "arm.urdf, line 7"."""
        return {name: at if f"joint {name!r}" in self.elsewhere else f"{source.path.name}, {at}"
                for name, at in self.mimic_places.items()}

    def where(self, element: str, source: ModelSource) -> tuple[Path, str]:
        """The file of an element, and its place there: "line 7, joint 'elbow'"."""
        if element in self.elsewhere:
            return self.elsewhere[element]
        place = self.places.get(element, self.places.get("", ""))
        return source.path, f"{place}, {element}" if place else element

    @contextmanager
    def _placing_errors(self, source: ModelSource) -> Iterator[None]:
        """Turns a ModelError into a SceneError with the element's place."""
        try:
            yield
        except ModelError as error:
            raise SceneError(*self.where(error.element, source), error.problem) from None


@dataclass(frozen=True)
class ModelReader:
    """A format in which files hold models.

    `parts` reads one file: everything in it is understood, reported in `notices`, or refused by a
    SceneError that names the place, what came and what was wanted."""

    name: str  # "URDF"
    suffixes: tuple[str, ...]  # ".urdf"; of two that fit a file, the longer one counts
    words: str  # what such a file is, and what is read: "a robot of ROS: its links and joints, …"
    parts: Callable[[ModelSource], Parts]
    modules: tuple[str, ...] = ()  # that it imports, besides the generator's own
    extra: str = ""  # of the project, which installs them
    takes_packages: bool = False  # its files name folders by packages
    takes_arguments: bool = False  # its files are programs
    leaves_out: tuple[str, ...] = ()  # what `leave_out` may name

    def read(self, source: ModelSource) -> Model:
        """The model in a file.  Raises SceneError."""
        return self.parts_of(source).model(source)

    def parts_of(self, source: ModelSource) -> Parts:
        """The parts in a file.  Raises SceneError, also where a package is missing."""
        if missing := [x for x in self.modules if find_spec(x) is None]:
            raise SceneError(source.path, "", f"is {self.name}, which needs {', '.join(missing)}; "
                             f'run `pip install "coscrew[{self.extra}]"`')
        for what, given, taken in (("packages", source.packages, self.takes_packages),
                                   ("arguments", source.arguments, self.takes_arguments)):
            if given and not taken:
                raise SceneError(source.path, "", f"is {self.name}, which takes no {what}; "
                                 "wanted none, or a file of xacro")
        for name in source.leave_out:
            if name not in self.leaves_out:
                wanted = did_you_mean(name, self.leaves_out) if self.leaves_out else \
                    f"{self.name} has nothing to leave out"
                raise SceneError(source.path, "leave_out", f"{name!r}; {wanted}")
        return self.parts(source)
