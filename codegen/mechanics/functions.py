"""The functions of a scene: each is recorded separately, with only what its outputs need."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import cached_property, partial

from coscrew_codegen.collection import uncollected
from coscrew_codegen.identifiers import identifiers
from coscrew_codegen.integrators import EMITTED
from coscrew_codegen.mechanics import (
    composite,
    coordinates,
    energies,
    floating,
    forward,
    frames,
    inverse,
    leapfrog,
)
from coscrew_codegen.mechanics.acting import Acting
from coscrew_codegen.mechanics.ranges import refuse_numbers, refuse_products, refuse_quotients
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.mechanics.steps import needs, stepped
from coscrew_codegen.quantity import Argument
from coscrew_codegen.recording.numbers import Number
from coscrew_codegen.recording.recorder import Recorder, array, headings
from coscrew_codegen.scene.asked import (
    CONTACTS,
    FREE,
    AskedError,
    asked_for,
    jacobians,
    reactions,
    refuse_many,
    together,
)
from coscrew_codegen.scene.assembly import ModelError
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.tree import Tree, tree_of
from coscrew_codegen.scene_functions import Function, SceneFunctions

_BODY_FRAME = "in the frame of the body, at its origin"


def derive(scene: Scene, functions: Collection[str] = (),
           tell: Callable[[str], None] = lambda name: None) -> SceneFunctions:
    """The functions that a scene selects, or those with these names that it has, and the internal
    functions that their steps call.  `tell` is called with each name before it is derived.

    Raises RangeError for numbers that one of its precisions cannot represent, ModelError for a
    model whose mass matrix is singular at every q, AskedError for functions that it cannot have,
    and for too many joints."""
    refuse_many(scene)
    refuse_numbers(scene)
    with uncollected():
        return _Derivation(scene, tell).functions(functions)


def is_timed(scene: Scene) -> bool:
    """Whether any effect is a function of time."""
    def timed(value: object) -> bool:
        parts = value if isinstance(value, tuple) else (value,)
        return any(isinstance(x, Formula) and x.timed for x in parts)

    return any(timed(value) for x in scene.effects for value in x.values.values())


def tree_for(scene: Scene) -> Tree:
    """The tree of a scene's model; joints follow others if the scene has the effect mimic."""
    return tree_of(scene.model, any(x.effect.mimic for x in scene.effects))


class _Derivation:
    """Records the functions one by one, each from its inputs."""

    def __init__(self, scene: Scene, tell: Callable[[str], None] = lambda name: None):
        self.scene, self.tree, self.tell = scene, tree_for(scene), tell
        self.names = identifiers([link.name.removesuffix("_link") for link in self.tree.links])
        bodies = [body.name for body in scene.model.bodies]
        self.bodies = dict(zip(bodies, identifiers(bodies), strict=True))
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

    def functions(self, names: Collection[str]) -> SceneFunctions:
        """The functions of these names, for targets."""
        scene, tree = self.scene, self.tree
        wanted = names or asked_for(scene)
        steps = [x for x in EMITTED if x.step_name in wanted]
        called = together(*map(needs, steps))
        found = [replace(made, internal=name not in wanted)
                 for name, make in self._makers().items() if name in wanted or name in called
                 if (made := make())]
        if not names:
            self._refuse_absent({f.name for f in found})
        return stepped(SceneFunctions(
            scene.name, tree.nq, tree.nv, tree.coordinates, tuple(self.bodies),
            tuple((p.name, float(p.value)) for p in scene.parameters), coordinates.neutral(tree),
            tuple(found), (), scene.precisions, self.timed), steps)

    def _makers(self) -> dict[str, Callable[[], Function | None]]:
        """Name → the method that makes the function, in the order in which they are emitted; it
        returns None if the scene does not have the function."""
        return {
            "inverse_dynamics": self._inverse, "forward_dynamics": self._forward,
            "mass_matrix": self._mass, "bias_torques": self._bias,
            "gravity_torques": self._gravity, "energy": self._energy, "power": self._power,
            "momentum": self._momentum, "body_poses": self._poses, "body_twists": self._twists,
            **{name: partial(self._jacobian, name, body)
               for name, body in jacobians(self.scene).items()},
            **{name: partial(self._reaction, name, joint)
               for name, joint in reactions(self.scene).items()},
            "integrated": self._integrated, "implicit_acceleration": self._implicit,
            "midpoint_acceleration": self._kick, "chart_rate": self._chart,
            "free_momentum": self._free_momentum, "with_free_momentum": self._with_free_momentum,
            "closing_contacts": self._closing, "parts": self._parts}

    def _refuse_absent(self, found: set[str]) -> None:
        """Raise AskedError for a selected function that only scenes of another kind have."""
        for several, reason in ((FREE, "no base floats"), (CONTACTS, "no limit closes")):
            for name in several:
                if name in self.scene.functions and name not in found:
                    raise AskedError(f"{self.scene.name}: there is no {name}: {reason} in the "
                                     "scene")

    # one function

    def _function(self, name: str, words: str, inputs: str, outputs: Sequence[Argument],
                  compute: Callable[[Recording], Results],
                  dynamic: bool = True, acted: bool = False) -> Function:
        """A function of these inputs, with p if it is `dynamic`, and t if effects act in it."""
        given = [*(["t"] if acted and self.timed or "t" in inputs.split() else []),
                 *(["h"] if "h" in inputs.split() else []),
                 *(["p"] if dynamic and self.scene.parameters else []),
                 *(x for x in inputs.split() if x not in ("t", "h"))]
        self.tell(name)
        recorder = Recorder([self.inputs[x] for x in given])
        try:
            results = compute(Recording(self.scene, self.tree, self.names, recorder))
        except ZeroDivisionError:
            where = recorder.heading or self.scene.model.name
            raise ModelError(f"{self.scene.name}: {where}", "its numbers make a division by zero "
                             f"in {name}, whatever q is: the mass matrix is singular; wanted "
                             "masses or armatures that resist every joint, and no joint that "
                             "mimics another with multiplier 0") from None
        program = recorder.program(name, list(zip(outputs, results, strict=True)))
        function = Function(name, words, program, tuple(
            (place, self._heading(words)) for place, words in headings(program)))
        refuse_products(self.scene, function)
        refuse_quotients(self.scene, function, self._at_rest())
        return function

    def _heading(self, words: str) -> str:
        """A link's name and motion: "forearm: elbow turns about y"."""
        link = next((x for x in self.tree.links if x.name == words), None)
        return f"{words}: {link.joint.in_words}" if link else words

    def _at_rest(self) -> dict[str, tuple[float, ...]]:
        """Inputs by name, at rest: neutral coordinates, default parameters, zero velocities."""
        zero = {name: (0.0,) * a.quantity.size for name, a in self.inputs.items()}
        return {**zero, "q": coordinates.neutral(self.tree), "h": (self.scene.run.step,),
                "p": tuple(float(x.value) for x in self.scene.parameters)}

    def _tau(self) -> Argument:
        return self.inputs["tau"]

    def _inverse(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion()
            return [x.torques(motion, Acting(self.scene, motion).act())]

        return self._function(
            "inverse_dynamics", "tau = M(q) a + bias_torques(q, v): what the joints must supply "
            "for the accelerations a, besides the effects", "q v a", [self._tau()], compute,
            acted=True)

    def _bias(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            return [x.torques(motion, Acting(self.scene, motion).act())]

        return self._function(
            "bias_torques", "tau = inverse_dynamics(q, v, 0): Coriolis, centrifugal, gravity and "
            "all effects' torques", "q v", [self._tau()], compute, acted=True)

    def _gravity(self) -> Function:
        def compute(x: Recording) -> Results:
            return [x.torques(x.motion(moving=False, accelerating=False), None)]

        return self._function("gravity_torques", "tau that holds the model still against gravity "
                              "alone", "q", [self._tau()], compute)

    def _forward(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            acting = Acting(self.scene, motion).act()
            return [forward.accelerations(motion, acting, x.rigids, x.inertias,
                                          x.recorder.argument("tau"))]

        return self._function(
            "forward_dynamics", "a with M(q) a + bias_torques(q, v) = tau", "q v tau",
            [self.inputs["a"]], compute, acted=True)

    def _kick(self) -> Function:
        return self._function(
            "midpoint_acceleration", "a with M(q) a = -bias_torques(q, v + h/2 a) as the default "
            "integrator solves it, in two passes, implicit in damping and stiffness of the effects",
            "h q v", [self.inputs["a"]], lambda x: [leapfrog.kick(x)], acted=True)

    @cached_property
    def _floating(self) -> tuple[int, ...]:
        return floating.floating(self.scene, self.tree)

    @cached_property
    def _momenta(self) -> Argument:
        return array("c", (len(self._floating), 6), "in kg m/s, kg m^2/s")

    def _free_momentum(self) -> Function | None:
        if not self._floating:
            return None
        free = ", ".join(self.tree.links[n].name for n in self._floating)
        return self._function(
            "free_momentum", f"c = (p; L) of each floating tree ({free}, and all bodies on it): "
            "linear momentum, and angular momentum about its centre of mass, in the world's axes",
            "q v", [self._momenta], lambda x: [floating.momentum(x, self._floating)])

    def _with_free_momentum(self) -> Function | None:
        if not self._floating:
            return None
        self.inputs["c"] = self._momenta
        return self._function(
            "with_free_momentum", "v, with the velocity of each floating base corrected so that "
            "the momentum of its tree is (p + m g t; L), c = (p; L) after t seconds of gravity: "
            "after each step it removes the errors of integration and rounding", "t q v c",
            [self.inputs["v"]],
            lambda x: [floating.corrected(x, self._floating)])

    @cached_property
    def _closes(self) -> Function:
        return self._function(
            "closing_contacts", "count: the number of limits that are closed, or would be after "
            "moving with v for h", "h q v", [array("count", ())],
            lambda x: [[leapfrog.closing(x)]])

    def _closing(self) -> Function | None:
        return self._closes if self._closes.program.instructions else None

    def _parts(self) -> Function | None:
        if not self._closes.program.instructions:
            return None
        return self._function(
            "parts", "count, part = h/count: the number and length of the parts in which a step of "
            "h is taken, to resolve contacts of limits; part is NaN if count would exceed "
            f"{leapfrog.MOST}", "h q v", [array("count", ()), array("part", (), "in s")],
            lambda x: [[y] for y in leapfrog.split(x)])

    def _implicit(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            acting = Acting(self.scene, motion).act()
            h, = x.recorder.argument("h")

            def weights(d: Number, k: Number, _: Number) -> tuple[Number, Number]:
                return (d + k * h) * h, k * h

            return [forward.implicit(motion, acting, x.rigids, x.inertias, weights).a]

        return self._function(
            "implicit_acceleration", "a with (M + h d + h^2 k) a = -bias_torques(q, v) - h k v, "
            "where d, k are the damping and stiffness of the effects", "h q v",
            [self.inputs["a"]], compute, acted=True)

    def _mass(self) -> Function:
        def compute(x: Recording) -> Results:
            M = composite.mass_matrix(x.motion(False, False, False), x.rigids, x.inertias)
            return [[entry for row in M for entry in row]]

        nv = self.tree.nv
        return self._function("mass_matrix", "M(q), row by row; symmetric, positive definite", "q",
                              [array("M", (nv, nv), "masses in kg, kg m, kg m^2")], compute)

    def _energy(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            acting = Acting(self.scene, motion).act()
            return [[energies.kinetic(x, motion),
                     energies.potential(x, motion) + acting.potential()]]

        return self._function(
            "energy", "e = (kinetic, potential) energy; gravity's is zero for centres of mass at "
            "the world's origin", "q v", [array("e", (2,), "energies in J")], compute,
            acted=True)

    def _power(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            return [[Acting(self.scene, motion).act().power()]]

        return self._function(
            "power", "P, the power of the effects without potential energy; negative if they "
            "dissipate", "q v", [array("P", (), "power in W")], compute, acted=True)

    def _momentum(self) -> Function:
        def compute(x: Recording) -> Results:
            return [energies.momentum(x, x.motion(accelerating=False))]

        return self._function(
            "momentum", "c = (p; L): linear momentum, angular momentum about the world's origin, "
            "in the world's frame", "q v", [array("c", (6,), "in kg m/s, kg m^2/s")], compute)

    def _poses(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(falling=False)
            return [[entry for body in self.bodies for entry in frames.pose(x, motion, body)]]

        return self._function(
            "body_poses", "D[i] = [R | t] of each body in the world, row by row", "q",
            [array("D", (len(self.bodies), 3, 4), "displacements, t in m")], compute,
            dynamic=False)

    def _twists(self) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False, falling=False)
            found: list[Number] = []
            for body, name in self.bodies.items():
                with x.recorder.part(name, "v", body):
                    found += frames.twist(x, motion, body)
            return [found]

        return self._function(
            "body_twists", f"s[i] = (v; w) of each body {_BODY_FRAME}", "q v",
            [array("s", (len(self.bodies), 6), "screws in m/s, rad/s")], compute, dynamic=False)

    def _jacobian(self, name: str, body: str) -> Function:
        def compute(x: Recording) -> Results:
            with x.recorder.part(self.bodies[body], "J", body):
                columns = frames.jacobian(x, x.motion(False, False, False), body)
            return [[columns[j][i] for i in range(6) for j in range(self.tree.nv)]]

        return self._function(
            name, f"J with J v = (v; w) of {body} {_BODY_FRAME}", "q",
            [array("J", (6, self.tree.nv), "screws of the velocities")], compute, dynamic=False)

    def _reaction(self, name: str, joint: str) -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion()
            acting = Acting(self.scene, motion).act()
            wrenches = inverse.transmitted(
                motion, inverse.net_wrenches(motion, x.rigids, acting))
            return [wrenches[self.tree.links.index(self.tree.link_of(joint))]]

        return self._function(
            name, f"f = (force; moment) that {joint} exerts on its child, "
            f"{_BODY_FRAME}, while it accelerates with a", "q v a",
            [array("f", (6,), "coscrew in N, N m")], compute, acted=True)

    def _integrated(self) -> Function:
        def compute(x: Recording) -> Results:
            q, phi = x.recorder.argument("q"), x.recorder.argument("phi")
            return [coordinates.integrated(x.recorder, self.tree, self.names, q, phi)]

        return self._function(
            "integrated", "qo = q ⊕ phi: by exponentials for quaternions, else q + phi",
            "q phi", [array("qo", (self.tree.nq,), "coordinates")], compute,
            dynamic=False)

    def _chart(self) -> Function | None:
        if not any(c.kind in ("spherical", "free") for c in self.tree.coordinates):
            return None

        def compute(x: Recording) -> Results:
            return [coordinates.chart_rate(x.recorder, self.tree, self.names)]

        return self._function(
            "chart_rate", "u = phi' while q = integrated(q0, phi) moves with v: v + [phi, v]/2 + "
            "[phi, [phi, v]]/12, accurate to fourth order", "v phi",
            [array("u", (self.tree.nv,), "in m/s, rad/s")], compute, dynamic=False)

