"""Driven: the steps of a run during which a controller sets parameters.

A controller in C is called by compiled steps, without Python between; else by Python.
"""

import ctypes
from typing import cast

import numpy as np

from coscrew_codegen.runtime.compiled_calls import InC
from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.check.sign_changes import Turns
from coscrew_codegen.simulation.control import EFFORT, Controller, Law, refuse_precision, set_by
from coscrew_codegen.simulation.plan import Plan, Stop
from coscrew_codegen.simulation.system import State, System

_IN_C = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.c_void_p] * 4)


class Driven:
    """The parameters of a run that a controller sets, and its steps."""

    def __init__(self, controller: Controller, system: System, plan: Plan, q: np.ndarray,
                 steps: int = 0):
        self._controller, self._system, self.steps = controller, system, steps
        refuse_precision(controller, np.dtype(system.dtype))
        self._places = np.array(set_by(controller, system.scene), np.intp)
        p = np.asarray(system.p, system.dtype)
        self.p = np.broadcast_to(p, (*q.shape[:-1], p.shape[-1])).copy()
        name = INTEGRATOR_NAMED[plan.integrator].step_name
        self._step = system.stepper_at(name)
        self._in_c = system.driver(name) if controller.address else None
        self._turns = Turns()
        self._called = -1  # step before which `update` last called it
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
        p[..., self._places] = self._values(k, t, q, v)
        self.p = p
        values = p[..., self._places]
        self._turns.add(values)
        if not np.isfinite(values).all():
            for *i, n in np.argwhere(~np.isfinite(values)).tolist():
                self._refuse(tuple(i), n, t, values[(*i, n)])

    def advance(self, n: int, k: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        """q and v after n steps of h from t, the first of them the k-th of the run."""
        every = self._controller.steps
        if self._in_c:
            due = k % every == 0 and k != self._called
            wait = 0 if due else every - k % every
            by = InC(self._controller.address, self._controller.context, every, self._places, wait)
            self.p, q, v, refused = self._in_c(by, n, t, h, self.p, q, v)
            for x in refused:
                member = (x.member,) if q.ndim > 1 else ()
                self._refuse(member, x.number, x.t, self._system.dtype.type(x.value))
            return q, v
        done = 0
        while done < n:
            self.update(k + done, t + done * h, q, v)
            more = min(n - done, every - (k + done) % every)
            q, v = self._step(self.p, more, t + done * h, h, q, v)
            done += more
        return q, v

    @property
    def turned(self) -> bool:
        """True if its values changed direction from call to call; unknown, and so false, for calls
        by compiled steps."""
        return self._turns.many or self._in_c is not None and not self._controller.in_python

    def demanded(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Returns the values that the controller would set at this state, without setting them."""
        return self._values(self.steps, t, q, v)

    def refused(self, alive: np.ndarray) -> tuple[Stop, ...]:
        """The members that stop because a value is not finite."""
        return tuple(stop for i, stop in self._refused.items() if alive[i])

    def _values(self, k: int, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Returns the controller's values for each state."""
        if self._controller.address:
            return self._from_c(t, q, v)
        law = cast("Law", self._controller.function)
        try:
            result = law(float(t), q.copy(), v.copy())
        except Exception as error:
            error.add_note(f"the controller was called at t = {t:.9g} s, before step {k}")
            raise
        return self._checked(result, q.shape[:-1])

    def _checked(self, result: object, lead: tuple[int, ...]) -> np.ndarray:
        """The numbers that a function in Python returned.  Raises SimulateError."""
        count = len(self._places)
        try:
            values = np.asarray(result)
        except ValueError:  # rows of different lengths
            values = np.array(None)
        shapes = {(count,), (*lead, count), *([()] if count == 1 else [])}
        if values.dtype.kind not in "iuf" or values.shape not in shapes:
            several = f", or a row of them for each of {lead[0]} members" if lead else ""
            raise SimulateError(f"controller: wanted {count} numbers, of "
                                f"{', '.join(self.names)}{several}; got {result!r}")
        return np.broadcast_to(values.astype(self._system.dtype), (*lead, count))

    def _from_c(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The values from a function in C, for one state after the other."""
        law, u = _IN_C(self._controller.address), np.ascontiguousarray(self.p[..., self._places])
        q, v = q.copy(), v.copy()
        for i in np.ndindex(q.shape[:-1]):
            law(t, q[i].ctypes.data, v[i].ctypes.data, u[i].ctypes.data, self._controller.context)
        return u

    def _refuse(self, member: tuple[int, ...], n: int, t: float, value: np.floating) -> None:
        """Note the first value of a member that is not finite."""
        if member in self._refused:
            return
        name = self.names[n]
        joint = name.removeprefix("actuator.").removesuffix(EFFORT)
        self._refused = self._refused | {member: Stop(
            member[0] if member else 0, t, joint if joint != name else "",
            f"the controller returned {value} for {name} at t = {t:.9g} s")}
