"""What every function of a scene is derived with: inputs, the tree, how it is recorded."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from coscrew_codegen.mechanics import coordinates
from coscrew_codegen.mechanics.ranges import refuse_products, refuse_quotients
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import Argument
from coscrew_codegen.recording.recorder import Recorder, array, headings
from coscrew_codegen.scene.assembly import ModelError
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.tree import Tree, heading_of_body, tree_of
from coscrew_codegen.scene_functions import Function

Makers = dict[str, Callable[[], Function | None]]
"""Name → the method that makes the function, in the order in which they are emitted; it returns
None if the scene does not have the function."""


def is_timed(scene: Scene) -> bool:
    """Whether any effect is a function of time."""
    def timed(value: object) -> bool:
        parts = value if isinstance(value, tuple) else (value,)
        return any(isinstance(x, Formula) and x.timed for x in parts)

    return any(timed(value) for x in scene.effects for value in x.values.values())


def tree_for(scene: Scene) -> Tree:
    """The tree of a scene's model; joints follow others if the scene has the effect mimic."""
    return tree_of(scene.model, any(x.effect.mimic for x in scene.effects))


class Derivation:
    """Records the functions one by one, each from its inputs."""

    def __init__(self, scene: Scene, tell: Callable[[str], None] = lambda name: None):
        self.scene, self.tree, self.tell = scene, tree_for(scene), tell
        self.bodies = {body.name: str(n) for n, body in enumerate(scene.model.bodies)}
        self.names = tuple(self.bodies[link.name] for link in self.tree.links)
        nq, nv, units = self.tree.nq, self.tree.nv, "positions in m, angles in rad"
        self.inputs = {
            "t": array("t", (), "time in s"), "h": array("h", (), "step in s"),
            "p": array("p", (len(scene.parameters),), "parameters"),
            "q": array("q", (nq,), f"coordinates: {units}, unit quaternions (x, y, z, w)"),
            "v": array("v", (nv,), "velocities in m/s, rad/s"),
            "a": array("a", (nv,), "accelerations in m/s^2, rad/s^2"),
            "tau": array("tau", (nv,), "forces and torques of joints in N, N m"),
            "phi": array("phi", (nv,), "displacements along the velocities, in m, rad"),
        }
        self.timed = is_timed(scene)
        self.headings = self._headings()

    def _function(self, name: str, words: str, inputs: str, outputs: Sequence[Argument],
                  compute: Callable[[Recording], Results],
                  dynamic: bool = True, acted: bool = False) -> Function:
        """A function of these inputs, with p if it is `dynamic`, and t if effects act in it."""
        given = [*(["t"] if acted and self.timed or "t" in inputs.split() else []),
                 *(["h"] if "h" in inputs.split() else []),
                 *(["p"] if dynamic and self.scene.parameters else []),
                 *(x for x in inputs.split() if x not in ("t", "h"))]
        self.tell(name)
        program = self._recorded(name, [self.inputs[x] for x in given], outputs, compute)
        function = Function(name, words, program, tuple(
            (place, self.headings.get(words, words)) for place, words in headings(program)))
        refuse_products(self.scene, function)
        refuse_quotients(self.scene, function, self._at_rest())
        return function

    def _recorded(self, name: str, inputs: Sequence[Argument], outputs: Sequence[Argument],
                  compute: Callable[[Recording], Results], fine: bool = False) -> Program:
        """The program that computes these outputs, and the one for twice the digits if that
        differs."""
        recorder = Recorder(inputs, fine)
        try:
            results = compute(Recording(self.scene, self.tree, self.names, recorder))
        except ZeroDivisionError:
            where = recorder.heading or self.scene.model.name
            raise ModelError(f"{self.scene.name}: {where}", "its numbers make a division by zero "
                             f"in {name}, whatever q is: the mass matrix is singular; wanted "
                             "masses or armatures that resist every joint, no joint that mimics "
                             "another with multiplier 0, or functions that do not divide by it, as "
                             '["inverse_dynamics"]') from None
        program = recorder.program(name, list(zip(outputs, results, strict=True)))
        if fine or not recorder.differs:
            return program
        return replace(program, fine=self._recorded(name, inputs, outputs, compute, fine=True))

    def _headings(self) -> dict[str, str]:
        """What text says instead of a body's heading: its number and name, and how it moves if it
        is a link's first: "4 forearm: elbow turns about y"."""
        found = {heading_of_body(x): f"{number} {x}" for x, number in self.bodies.items()}
        for link in self.tree.links:
            found[link.heading] += f": {link.joint.in_words}"
        return found

    def _at_rest(self) -> dict[str, tuple[float, ...]]:
        """Inputs by name, at rest: neutral coordinates, default parameters, zero velocities."""
        zero = {name: (0.0,) * a.quantity.size for name, a in self.inputs.items()}
        return {**zero, "q": coordinates.neutral(self.tree), "h": (self.scene.run.step,),
                "p": tuple(float(x.value) for x in self.scene.parameters)}
