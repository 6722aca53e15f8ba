"""Recording of one function of a scene."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.algorithms import rnea
from coscrew_codegen.dynamics.algorithms.bodies import Rigid, rigids
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.added_inertia import added_inertias
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias, gravity, joint_inertias
from coscrew_codegen.scene.effect_quantities import places_of
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Scene


@dataclass
class FunctionRecording:
    """Recording of one function, with the quantities that most functions need."""

    scene: Scene
    tree: Tree
    names: tuple[str, ...]
    recorder: Recorder

    def motion(self, moving: bool = True, accelerating: bool = True, falling: bool = True,
               at: tuple[Sequence[Number], Sequence[Number]] | None = None,
               a: Sequence[Number] | None = None, carried: bool = False) -> Motion:
        """The motion for the function's inputs, or for `at` = (q, v), or with the accelerations
        `a`; `falling`: with the scene's gravity; `carried` as in Motion."""
        down = gravity(self.scene, self.recorder) if falling else None
        return Motion(self.recorder, self.tree, self.names, down, moving, accelerating, at, a,
                      places_of(self.scene), carried)

    @property
    def tau(self) -> Sequence[Number]:
        """The torques of joints, zeros if the function does not take them."""
        return self.recorder.argument("tau") if self.recorder.has("tau") else \
            self.recorder.numbers([0] * self.tree.nv)

    @cached_property
    def rigids(self) -> list[Rigid]:
        """The inertia of each link, with those that effects add beside it."""
        own = rigids(self.recorder, self.names, self.tree)
        adding = [x for x in self.scene.effects if x.effect.body_inertia]
        for link, inertia in added_inertias(adding, self.recorder, self.tree) if adding else ():
            own[link] = replace(own[link], added=inertia.entries)
        return own

    @cached_property
    def inertias(self) -> OwnInertias:
        """The joints' own inertias, and those of sums of coordinates."""
        return joint_inertias(self.scene, self.recorder, self.tree)

    def torques(self, motion: Motion, acting: AppliedEffects | None) -> list[Number]:
        """The torques of inverse dynamics."""
        wrenches = rnea.transmitted(motion, rnea.net_wrenches(motion, self.rigids, acting))
        return rnea.joint_torques(motion, wrenches, acting, self.inertias)
