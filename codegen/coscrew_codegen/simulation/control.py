"""Controllers: functions that set run-time parameters during a run.

A controller is called at the start and after every `steps` steps.  Its values hold until the next
call: all stages and parts of a step have the same values."""

from __future__ import annotations

import ctypes
import inspect
from _ctypes import CFuncPtr
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from hashlib import sha256

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.scene.names import did_you_mean, listed
from coscrew_codegen.scene.patterns import PatternError, expanded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.parameter_checks import constant
from coscrew_codegen.simulation.plan import MOST_STEPS

Law = Callable[[float, np.ndarray, np.ndarray], ArrayLike]
"""(t, q, v) -> the values that it sets; q and v, and so the values, may have a leading axis."""
EFFORT = ".torque"
_LAST = 2**(8 * ctypes.sizeof(ctypes.c_void_p)) - 1  # address


@dataclass(frozen=True)
class Controller:
    """A function that sets run-time parameters, called at the start and after every `steps` steps.

    In Python: (t, q, v) -> the values, in the order of `sets`.  In C: a pointer of ctypes or an
    address, of a function (t, q, v, u, context) that overwrites the values u:

        void law(double t, const double *q, const double *v, double *u, void *context);

    with float for double, except for t, in single precision.  q and v are copies.  `sets` names
    elements of p; by default they are the torques of actuators, `actuator.JOINT.torque`. Its values
    are held until the next call.  A controller should have no memory: recordings do not hold it.
    The report of the place where a run diverged calls the controller again; so does the test
    whether it is called too seldom, after a run in which its values changed direction from call to
    call."""

    function: Law | int | ctypes.c_void_p | CFuncPtr
    steps: int = 1
    sets: Sequence[str] = ()
    context: int | ctypes.c_void_p | None = None  # an address

    def __post_init__(self) -> None:
        if not (self.address or callable(self.function)) or (
                isinstance(self.function, CFuncPtr) and not self.address):
            raise SimulateError("controller: wanted a function of (t, q, v), or a pointer to one "
                                f"in C; got {_shown(self.function)}")
        if not (isinstance(self.steps, int | np.integer) and self.steps is not True
                and 0 < self.steps <= MOST_STEPS):
            raise SimulateError("controller: steps: wanted a whole number of steps, from 1 to "
                                f"{MOST_STEPS:.0e}; got {self.steps!r}")
        object.__setattr__(self, "steps", int(self.steps))
        object.__setattr__(self, "sets", listed("controller: sets", self.sets,
                                                "actuator.JOINT.torque", SimulateError))
        if self.context is not None and _address(self.context) is None:
            raise SimulateError("controller: context: wanted an address, as ctypes.addressof(x); "
                                f"got {_shown(self.context)}")

    @property
    def address(self) -> int:
        """The address of a function in C; 0 of a function in Python."""
        return _address(self.function) or 0

    @property
    def in_python(self) -> bool:
        """True if Python runs when it is called, also through a pointer that ctypes made."""
        kept = (getattr(self.function, "_objects", None) or {}).values()
        return not self.address or any("Thunk" in type(x).__name__ for x in kept)

    def described(self, scene: Scene) -> str:
        """Describes it for provenance: name, interval of calls, parameters that it sets, and a hash
        of its source, if that can be read."""
        when = f"every {self.steps} steps" if self.steps > 1 else "every step"
        sets = ", ".join(scene.parameters[i].name for i in set_by(self, scene))
        return f"{self._named}, {when}, sets {sets}{self._hashed}"

    @property
    def _named(self) -> str:
        if self.address:
            name = getattr(self.function, "__name__", "")  # of a function of a library
            return f"function {name} in C" if name else "a function in C"
        return f"function {getattr(self.function, '__qualname__', type(self.function).__name__)}"

    @property
    def _hashed(self) -> str:
        its = self.function
        try:
            source = inspect.getsource(its if inspect.isroutine(its) else type(its))
        except (OSError, TypeError):
            return ""
        return f", source sha256 {sha256(source.encode()).hexdigest()}"


def _address(pointer: object) -> int | None:
    """The address that a number or a pointer of ctypes stands for; None for anything else."""
    if isinstance(pointer, CFuncPtr | ctypes.c_void_p):
        return ctypes.cast(pointer, ctypes.c_void_p).value or 0
    if isinstance(pointer, int) and not isinstance(pointer, bool) and 0 <= pointer <= _LAST:
        return pointer
    return None


def _shown(given: object) -> str:
    """Shows an argument given instead of a pointer: a number itself, the type of anything else."""
    if isinstance(given, int):
        return repr(given)
    null = "a null pointer, " if isinstance(given, CFuncPtr | ctypes.c_void_p) else ""
    return null + type(given).__name__


def refuse_precision(controller: Controller, dtype: np.dtype) -> None:
    """Raise SimulateError if a pointer of ctypes declares arrays of the other precision: the
    function would write or read beyond their ends."""
    wanted = np.ctypeslib.as_ctypes_type(dtype)
    declared = getattr(controller.function, "argtypes", None) if controller.address else None
    for x in (declared or ())[1:4]:
        if getattr(x, "_type_", None) in {ctypes.c_float, ctypes.c_double} - {wanted}:
            raise SimulateError(f"controller: a function in C of {x._type_.__name__}; wanted "
                                f"{wanted.__name__}, of a run in this precision")


def set_by(controller: Controller, scene: Scene) -> tuple[int, ...]:
    """The indices in p of the parameters that a controller sets.  Raises SimulateError."""
    names = tuple(x.name for x in scene.parameters)
    torques = tuple(x for x in names if x.startswith("actuator.") and x.endswith(EFFORT))
    try:
        wanted = expanded(controller.sets, names) or torques
    except PatternError as error:
        raise SimulateError(f"controller: sets {error}") from None
    if not wanted:
        raise SimulateError(
            "controller: the scene has no torque at run time; wanted [effects.actuator.JOINT] with "
            'kind = "torque" and torque = 0, and runtime = ["actuator.JOINT.torque"]')
    fixed = constant(scene)
    if twice := [name for name in wanted if wanted.count(name) > 1]:
        raise SimulateError(f"controller: sets {twice[0]!r} twice")
    for name in wanted:
        if name not in names:
            raise SimulateError(f"controller: sets {name!r}; wanted a parameter that the scene "
                                f"lists in `runtime`; {did_you_mean(name, names)}")
        if name in fixed:
            raise SimulateError(f"controller: sets {name!r}, which is constant in a run; wanted "
                                "torques, forces, voltages and targets of effects")
    return tuple(map(names.index, wanted))
