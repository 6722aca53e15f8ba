"""Selects the functions that a run needs; no others are derived and compiled."""

from collections.abc import Iterable

from coscrew_codegen.scene.function_selection import (
    ALL_CONTACTS,
    BRISTLES,
    CONTACTS,
    FREE,
    LOOPS,
    OF_STATES,
    together,
)
from coscrew_codegen.scene.functions.whole_scene.mass_matrix import MANY, speeds
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.scene.recorded_quantities import expected, recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.plan import known

VIEWED = ("body_poses", ALL_CONTACTS)
"""Functions of playbacks; contacts only of scenes in which something touches."""
JUDGED = (ALL_CONTACTS, BRISTLES)
"""Functions by which runs and checks judge contacts and friction, of scenes that have them."""


def of_run(scene: Scene, integrator: str | None, view: bool = False, held: bool = False
           ) -> tuple[str, ...]:
    """Names of the functions that `simulate` needs: for integration, the Alarm, recorded
    quantities, and the playback if `view`; with torques that a controller `held`, also for the
    warning that it changes too fast."""
    return together(_of_motion(scene, integrator, held),
                    *(recorded(text, scene).functions for text in scene.record),
                    VIEWED if view else ())


def of_check(scene: Scene, integrator: str | None) -> tuple[str, ...]:
    """Names of the functions that `check` needs."""
    return together(of_run(scene, integrator),
                    ("inverse_dynamics", "forward_dynamics", "mass_matrix", "power",
                     INTEGRATOR_NAMED[DEFAULT].step_name, *JUDGED, *CONTACTS, *FREE),
                    *(expected(x.quantity, scene).functions for x in scene.expectations))


def _of_motion(scene: Scene, integrator: str | None, held: bool) -> Iterable[str]:
    """Names of the functions for integration; for the Alarm, which also uses the default
    integrator, and the mass matrix if a base floats; and for the accelerations by torques that are
    `held`."""
    own = INTEGRATOR_NAMED[known(scene.run.integrator if integrator is None else integrator)]
    if not own.emitted:
        return "energy", "forward_dynamics", *LOOPS, *OF_STATES
    floats = any(joint.kind.floats for joint in scene.model.joints)
    mass = ("mass_matrix",) if floats and speeds(scene) <= MANY else ()
    pushed = ("forward_dynamics",) if held else ()
    return ("energy", "power", *mass, *pushed, own.step_name,
            INTEGRATOR_NAMED[DEFAULT].step_name, *JUDGED, *CONTACTS, *FREE, *LOOPS)
