"""Controllers: functions that set run-time parameters during a run.

A controller is called at the start and after every `steps` steps.  What it returns holds until the
next call: all stages and parts of a step have the same values.
"""

import ctypes
from _ctypes import CFuncPtr
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.integrators import named
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.plan import Plan, Stop
from coscrew_codegen.simulate.settings import constant
from coscrew_codegen.simulate.system import State, System

Law = Callable[[float, np.ndarray, np.ndarray], ArrayLike]
"""(t, q, v) -> the values that it sets; q and v, and so the values, may have a leading axis."""
_IN_C = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.c_void_p] * 4)
EFFORT = ".torque"


@dataclass(frozen=True)
class Controller:
    """A function that sets run-time parameters, called at the start and after every `steps` steps.

    In Python: (t, q, v) -> the values, in the order of `sets`.  In C: a pointer of ctypes or an
    address, of a function (t, q, v, u, context) that overwrites the values u:

        void law(double t, const double *q, const double *v, double *u, void *context);

    with float for double, except for t, in single precision.
    `sets` names elements of p; by default
    they are the torques of actuators, `actuator.JOINT.torque`.  A controller has no memory that a
    recording could hold: the report of where a run diverged calls it again."""

    function: Law | int | CFuncPtr
    steps: int = 1
    sets: Sequence[str] = ()
    context: int | None = None  # an address

    def __post_init__(self) -> None:
        pointer = isinstance(self.function, int | CFuncPtr)
        if isinstance(self.function, bool) or (pointer and not self.address) or not (
                pointer or callable(self.function)):
            raise SimulateError("controller: wanted a function of (t, q, v), or a pointer to one "
                                f"in C; got {_shown(self.function)}")
        if not isinstance(self.steps, int) or self.steps < 1:
            raise SimulateError(f"controller: wanted a whole number of steps; got {self.steps!r}")

    @property
    def address(self) -> int:
        """The address of a function in C; 0 of a function in Python."""
        if isinstance(self.function, int):
            return self.function
        if isinstance(self.function, CFuncPtr):
            return ctypes.cast(self.function, ctypes.c_void_p).value or 0
        return 0

    @property
    def told(self) -> str:
        """What provenance says of it."""
        if self.address:
            what = "a function in C"
        else:
            what = f"function {getattr(self.function, '__qualname__', type(self.function))}"
        return f"{what}, every {self.steps} steps" if self.steps > 1 else f"{what}, every step"


def _shown(function: object) -> str:
    """What was given instead of a function: a number itself, of anything else its type."""
    if isinstance(function, int):
        return repr(function)
    null = "a null pointer, " if isinstance(function, CFuncPtr) else ""
    return null + type(function).__name__


def set_by(controller: Controller, scene: Scene) -> tuple[int, ...]:
    """The indices in p of the parameters that a controller sets.  Raises SimulateError."""
    names = tuple(x.name for x in scene.parameters)
    torques = tuple(x for x in names if x.startswith("actuator.") and x.endswith(EFFORT))
    wanted = tuple(controller.sets) or torques
    if not wanted:
        raise SimulateError(
            "controller: the scene has no torque at run time; wanted [effects.actuator.JOINT] with "
            'kind = "torque" and torque = 0, and runtime = ["actuator.JOINT.torque"]')
    fixed = constant(scene)
    for name in wanted:
        if name not in names:
            raise SimulateError(f"controller: sets {name!r}; wanted what the scene lists in "
                                f"`runtime`; {did_you_mean(name, names)}")
        if name in fixed:
            raise SimulateError(f"controller: sets {name!r}, which is constant in a run; wanted "
                                "torques, forces, voltages and targets of effects")
    return tuple(map(names.index, wanted))


class Driven:
    """The parameters of a run that a controller sets, and its steps."""

    def __init__(self, controller: Controller, system: System, plan: Plan, q: np.ndarray,
                 steps: int = 0, held: np.ndarray | None = None):
        self._controller, self._system, self.steps = controller, system, steps
        self._places = np.array(set_by(controller, system.scene), np.intp)
        p = np.asarray(system.p, system.dtype)
        self.p = np.broadcast_to(p, (*q.shape[:-1], p.shape[-1])).copy()
        if held is not None:
            self.p[..., self._places] = held[..., self._places]
        self._step = system.stepper_at(named(plan.integrator).step_name)
        self._called = -1  # step before which it was last called
        self._refused: dict[tuple[int, ...], Stop] = {}

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that it sets."""
        return tuple(self._system.scene.parameters[i].name for i in self._places)

    def update(self, k: int, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Call it before step k, if it is due."""
        if k % self._controller.steps or k == self._called:
            return
        self._called, p = k, self.p.copy()
        p[..., self._places] = self._values(t, q, v)
        self.p = p
        self._refuse(t)

    def advance(self, n: int, k: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        """q and v after n steps of h from t, the first of them the k-th of the run."""
        done = 0
        while done < n:
            self.update(k + done, t + done * h, q, v)
            every = self._controller.steps
            more = min(n - done, every - (k + done) % every)
            q, v = self._step(self.p, more, t + done * h, h, q, v)
            done += more
        return q, v

    def refused(self, alive: np.ndarray) -> tuple[Stop, ...]:
        """The members that stop since a value is not finite."""
        return tuple(stop for i, stop in self._refused.items() if alive[i])

    def _values(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        given = self._controller.function
        law = self._in_c if isinstance(given, int | CFuncPtr) else given
        found = law(float(t), q.copy(), v.copy())
        try:
            return np.broadcast_to(np.asarray(found, self._system.dtype),
                                   (*q.shape[:-1], len(self._places)))
        except (ValueError, TypeError):
            raise SimulateError(f"controller: wanted {len(self._places)} numbers, of "
                                f"{', '.join(self.names)}; got {found!r}") from None

    def _in_c(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The values from a function in C, for one state after the other."""
        law, u = _IN_C(self._controller.address), np.ascontiguousarray(self.p[..., self._places])
        for i in np.ndindex(q.shape[:-1]):
            law(t, q[i].ctypes.data, v[i].ctypes.data, u[i].ctypes.data, self._controller.context)
        return u

    def _refuse(self, t: float) -> None:
        values = self.p[..., self._places]
        if np.isfinite(values).all():
            return
        self._refused = dict(self._refused)
        for *i, n in np.argwhere(~np.isfinite(values)).tolist():
            name = self.names[n]
            joint = name.removeprefix("actuator.").removesuffix(EFFORT)
            self._refused.setdefault(tuple(i), Stop(
                i[0] if i else 0, t, joint if joint != name else "",
                f"the controller returned {values[(*i, n)]} for {name} at t = {t:.9g} s"))
