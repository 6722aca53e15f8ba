"""Functions of bodies and joints: poses, twists, Jacobians, reactions."""

from functools import partial

from coscrew_codegen.mechanics import frames, inverse
from coscrew_codegen.mechanics.acting import Acting
from coscrew_codegen.mechanics.derivation import Derivation, Makers
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.recording.numbers import Number
from coscrew_codegen.recording.recorder import array
from coscrew_codegen.scene.selected import jacobians, reactions
from coscrew_codegen.scene.tree import heading_of_body
from coscrew_codegen.scene_functions import Function

_BODY_FRAME = "in the frame of the body, at its origin"


class BodyFunctions(Derivation):
    """Poses and twists of all bodies, Jacobians of each, reactions of joints."""

    def _of_bodies(self) -> Makers:
        return {
            "body_poses": self._poses, "body_twists": self._twists,
            **{name: partial(self._jacobian, name, body)
               for name, body in jacobians(self.scene).items()},
            **{name: partial(self._reaction, name, joint)
               for name, joint in reactions(self.scene).items()}}

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
                with x.recorder.part(name, "v", heading_of_body(body)):
                    found += frames.twist(x, motion, body)
            return [found]

        return self._function(
            "body_twists", f"s[i] = (v; w) of each body {_BODY_FRAME}", "q v",
            [array("s", (len(self.bodies), 6), "screws in m/s, rad/s")], compute, dynamic=False)

    def _jacobian(self, name: str, body: str) -> Function:
        def compute(x: Recording) -> Results:
            with x.recorder.part(self.bodies[body], "J", heading_of_body(body)):
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
