"""Functions that steps of integrators call."""

from functools import cached_property, partial

from coscrew_codegen.mechanics import coordinates, floating, forward, leapfrog
from coscrew_codegen.mechanics.acting import Acting
from coscrew_codegen.mechanics.derivation import Derivation, Makers
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.quantity import Argument
from coscrew_codegen.recording.numbers import Number
from coscrew_codegen.recording.recorder import array
from coscrew_codegen.scene_functions import Function


class StepFunctions(Derivation):
    """Motion of coordinates, implicit accelerations, floating trees, contacts."""

    def _of_steps(self) -> Makers:
        return {
            "integrated": self._integrated, "implicit_acceleration": self._implicit,
            "midpoint_acceleration": self._kick,
            "implicit_acceleration_tau": partial(self._implicit, "tau"),
            "midpoint_acceleration_tau": partial(self._kick, "tau"), "chart_rate": self._chart,
            "free_momentum": self._free_momentum, "with_free_momentum": self._with_free_momentum,
            "closing_contacts": self._closing, "parts": self._parts}

    def _integrated(self) -> Function:
        def compute(x: Recording) -> Results:
            q, phi = x.recorder.argument("q"), x.recorder.argument("phi")
            return [coordinates.integrated(x.recorder, self.tree, self.names, q, phi)]

        return self._function(
            "integrated", "qo = q ⊕ phi: by exponentials for quaternions, which come out of "
            "length 1, else q + phi",
            "q phi", [array("qo", (self.tree.nq,), "coordinates")], compute,
            dynamic=False)

    def _implicit(self, tau: str = "") -> Function:
        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            acting = Acting(self.scene, motion).act()
            h, = x.recorder.argument("h")

            def weights(d: Number, k: Number, _: Number) -> tuple[Number, Number]:
                return (d + k * h) * h, k * h

            return [forward.implicit(motion, acting, x.rigids, x.inertias, weights, x.tau).a]

        return self._function(
            _with("implicit_acceleration", tau), f"a with (M + h d + h^2 k) a = {_plus(tau)}"
            "-bias_torques(q, v) - h k v, where d, k are the damping and stiffness of the effects",
            f"h q v {tau}", [self.inputs["a"]], compute, acted=True)

    def _kick(self, tau: str = "") -> Function:
        return self._function(
            _with("midpoint_acceleration", tau), f"a with M(q) a = {_plus(tau)}"
            "-bias_torques(q, v + h/2 a) as the default integrator solves it, in two passes, "
            "implicit in damping and stiffness of the effects",
            f"h q v {tau}", [self.inputs["a"]], lambda x: [leapfrog.kick(x)], acted=True)

    def _chart(self) -> Function | None:
        if not any(c.kind in ("spherical", "free") for c in self.tree.coordinates):
            return None

        def compute(x: Recording) -> Results:
            return [coordinates.chart_rate(x.recorder, self.tree, self.names)]

        return self._function(
            "chart_rate", "u = phi' while q = integrated(q0, phi) moves with v: v + [phi, v]/2 + "
            "[phi, [phi, v]]/12, accurate to fourth order", "v phi",
            [array("u", (self.tree.nv,), "in m/s, rad/s")], compute, dynamic=False)

    @cached_property
    def _floating(self) -> tuple[int, ...]:
        return floating.floating(self.scene, self.tree)

    @cached_property
    def _momenta(self) -> Argument:
        return array("c", (len(self._floating), 9), "in kg m/s, kg m^2/s, m")

    def _free_momentum(self) -> Function | None:
        if not self._floating:
            return None
        free = ", ".join(self.tree.links[n].name for n in self._floating)
        return self._function(
            "free_momentum", f"c = (p; L; x) of each floating tree ({free}, and all bodies on it): "
            "linear momentum, angular momentum about its centre of mass, and the centre of mass, "
            "in the world's axes",
            "q v", [self._momenta], lambda x: [floating.momentum(x, self._floating)])

    def _with_free_momentum(self) -> Function | None:
        if not self._floating:
            return None
        self.inputs["c"] = self._momenta
        return self._function(
            "with_free_momentum", "q and v, with the position and the velocity of each floating "
            "base corrected so that its tree's centre of mass is x + p t/m + g t^2/2 and its "
            "momentum (p + m g t; L), c = (p; L; x) after t seconds of gravity: after each step it "
            "removes the errors of integration and rounding", "t q v c",
            [self.inputs["q"], self.inputs["v"]],
            lambda x: list(floating.corrected(x, self._floating)))

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


def _with(name: str, tau: str) -> str:
    return f"{name}_{tau}" if tau else name


def _plus(tau: str) -> str:
    """Returns the term before "-bias_torques"."""
    return f"{tau} " if tau else ""
