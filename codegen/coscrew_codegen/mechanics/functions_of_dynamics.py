"""Functions of the whole scene: torques, accelerations, inertia, energy, momentum."""

from coscrew_codegen.mechanics import composite, energies, forward
from coscrew_codegen.mechanics.acting import Acting
from coscrew_codegen.mechanics.derivation import Derivation, Makers
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.quantity import Argument
from coscrew_codegen.recording.recorder import array
from coscrew_codegen.scene.possible import why_singular
from coscrew_codegen.scene_functions import Function


class DynamicsFunctions(Derivation):
    """Torques, accelerations, inertia, energy, momentum."""

    def _of_dynamics(self) -> Makers:
        return {
            "inverse_dynamics": self._inverse, "forward_dynamics": self._forward,
            "mass_matrix": self._mass, "bias_torques": self._bias,
            "gravity_torques": self._gravity, "energy": self._energy, "power": self._power,
            "momentum": self._momentum}

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

    def _mass(self) -> Function:
        def compute(x: Recording) -> Results:
            M = composite.mass_matrix(x.motion(False, False, False), x.rigids, x.inertias)
            return [[entry for row in M for entry in row]]

        nv, definite = self.tree.nv, "semidefinite" if why_singular(self.scene) else "definite"
        return self._function("mass_matrix", f"M(q), row by row; symmetric, positive {definite}",
                              "q", [array("M", (nv, nv), "masses in kg, kg m, kg m^2")], compute)

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
