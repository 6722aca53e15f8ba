"""System: a scene's compiled functions at fixed parameters, in one precision, called by name.

The inputs of a function depend on the scene (time, parameters); a System calls all in the same way.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from coscrew_codegen.program import Program
from coscrew_codegen.program.scene_functions import SceneInterface, Signature
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime.compiled_calls import Driven, InC, Take
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.function_selection import CLOSURE
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.loops.loop_closing import closed
from coscrew_codegen.simulation.parameter_checks import refuse_settings

if TYPE_CHECKING:
    from coscrew_codegen.runtime.callables import Functions
    from coscrew_codegen.runtime.load import Kernels

State = tuple[np.ndarray, np.ndarray]
Watch = Callable[[float, np.ndarray, np.ndarray], None]
"""Callback that receives the current t, q, v of a run."""
Stepper = Callable[[np.ndarray, int, float, float, np.ndarray, np.ndarray], State]
Sampler = Callable[[Sequence[Take], np.ndarray, np.ndarray], State]
Driver = Callable[[InC, int, float, float, np.ndarray, np.ndarray, np.ndarray], Driven]


@dataclass(frozen=True)
class System:
    """A scene's functions: `kernels` has a callable for each, in `precision`; p are parameters,
    (np), or those of each state of a batch, (…, np)."""

    scene: Scene
    functions: SceneInterface
    kernels: "Functions[np.floating]"
    precision: Precision
    p: tuple[float, ...] | np.ndarray = ()
    origin: "Kernels | None" = None  # the kernels of all precisions

    @cached_property
    def dtype(self) -> np.dtype:
        """The type of its numbers."""
        return np.dtype(self.precision.numpy_type)

    @cached_property
    def inputs(self) -> Mapping[str, tuple[str, ...]]:
        """The names of each function's inputs, in order."""
        return {x.name: tuple(name for name, _ in x.inputs) for x in self.functions.signatures}

    def described(self, name: str) -> Signature:
        """The inputs and outputs of the function of this name."""
        return next(x for x in self.functions.signatures if x.name == name)

    @property
    def programs(self) -> Mapping[str, Program]:
        """The Program of each function."""
        result = self.origin.functions.functions if self.origin else ()
        return {f.name: f.program for f in result if not f.internal}

    def zero(self, name: str) -> bool:
        """Returns whether the scene lacks the function, or its outputs are zero whatever the
        inputs."""
        return all(x.zero for x in self.functions.signatures if x.name == name)

    def has(self, name: str) -> bool:
        """Returns whether the scene has this function."""
        return name in self.inputs

    def call(self, name: str, **values: object) -> np.ndarray:
        """The function's output for these inputs (t, h, q, v, a, tau, phi), which broadcast over
        leading axes; inputs that it does not take are ignored."""
        given = {"p": self._p, **values}
        arguments = [np.asarray(given[x], self.dtype) for x in self.inputs[name]]
        result: np.ndarray = getattr(self.kernels, name)(*arguments)
        return result

    def outputs(self, name: str, **values: object) -> tuple[np.ndarray, ...]:
        """Returns the outputs of a function with several ones; inputs as of `call`."""
        return tuple(self.call(name, **values))

    def stepper(self, name: str, watch: Watch | None = None
                ) -> Callable[[int, float, float, np.ndarray, np.ndarray], State]:
        """The integrator as (n, t, h, q, v) -> q and v after n steps of h: in one call of C, or in
        pure NumPy, where `watch` is called after every step.  q and v may have leading axes."""
        return partial(self.stepper_at(name, watch), self._p)

    def stepper_at(self, name: str, watch: Watch | None = None) -> Stepper:
        """Returns the integrator as a function that also takes parameters: (p, n, t, h, q, v)."""
        function = getattr(self.kernels, name)
        several = getattr(function, "repeated", None)
        real = self.dtype.type
        timed, takes_p = self.functions.timed, bool(self.functions.parameters)

        def steps(p: np.ndarray, n: int, t: float, h: float, q: np.ndarray, v: np.ndarray
                  ) -> State:
            if several and (n > 1 or q.ndim > 1):
                result: State = several(n, t, h, p, q, v)
                return result
            for k in range(n):
                if watch and k:
                    watch(t + k * h, q, v)
                now = [real(t + k * h)] if timed else []
                q, v = function(*now, real(h), *([p] if takes_p else []), q, v)
            return q, v

        return steps

    def sampler(self, name: str, finer: int = 1) -> "Sampler | None":
        """The integrator of one state, if it is compiled: (steps, q, v) -> q and v after each of
        consecutive (n, t, h), n steps of h from t on, each split as one longer by the factor
        `finer` would be."""
        several = getattr(getattr(self.kernels, name), "finer" if finer > 1 else "sampled", None)
        if not several or self._p.ndim > 1:
            return None
        factor = (finer,) if finer > 1 else ()
        return lambda takes, q, v: several(takes, self._p, q, v, *factor)

    def driver(self, name: str) -> "Driver | None":
        """The integrator under a controller in C, if it is compiled: (by, n, t, h, p, q, v) -> p, q
        and v after n steps, and the first value of the controller that is not finite."""
        driven: Driver | None = getattr(getattr(self.kernels, name), "driven", None)
        return driven

    def momentum(self, q: np.ndarray, v: np.ndarray) -> np.ndarray | None:
        """(p; L; x) of floating bases, if nothing but gravity changes it: momentum, angular
        momentum about the centre of mass, and the centre of mass."""
        return self.call("free_momentum", q=q, v=v) if self.has("free_momentum") else None

    def kept(self, c: np.ndarray | None, t: float, q: np.ndarray, v: np.ndarray) -> State:
        """q and v corrected to the centre of mass and the momentum that floating bases must have at
        t if they started with `c` at t = 0: removes the accumulated errors of many steps."""
        if c is None:
            return q, v
        q, v = self.outputs("with_free_momentum", t=t, q=q, v=v, c=c)
        return q, v

    def at(self, p: np.ndarray) -> "System":
        """The system with these parameters.  (…, np)."""
        return replace(self, p=p)

    @property
    def p_of_samples(self) -> np.ndarray:
        """The parameters, to broadcast with samples of each member: (np), or (…, 1, np)."""
        return self._p if self._p.ndim < 2 else self._p[..., None, :]

    def member(self, index: int | tuple[int, ...] | np.ndarray) -> "System":
        """The system with the parameters of one state of a batch, or some."""
        return self.at(self._p[index]) if self._p.ndim > 1 else self

    def energies(self, t: object, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Kinetic and potential energy in J.  (…), (…, nq), (…, nv)->(…), (…), in double."""
        both = np.asarray(self.call("energy", t=t, q=q, v=v), float)
        return both[..., 0], both[..., 1]

    def start(self) -> State:
        """q and v at t = 0: the scene's, with loops closed.  Raises SimulateError for loops that
        are open."""
        return self.closed(*self.written_start())

    def closed(self, q: np.ndarray, v: np.ndarray) -> State:
        """q and v on the closures of the scene's loops; as they are without loops."""
        return closed(self, q, v) if self.has(CLOSURE) else (q, v)

    def written_start(self) -> State:
        """The scene's q and v as written, by default the neutral configuration at rest."""
        q, v = np.array(self.functions.neutral), np.zeros(self.functions.nv)
        for c in self.functions.coordinates:
            q[c.q] = self.scene.start_q.get(c.joint, q[c.q])
            v[c.v] = self.scene.start_v.get(c.joint, v[c.v])
        first = len(q) - len(self.functions.states)
        for place, (column, _) in enumerate(self.functions.states, first):
            q[place] = self.scene.start_x.get(column, q[place])
        q = self.with_rotors(q, v)
        with np.errstate(over="ignore"):  # in single precision; `integrate` refuses infinities
            return self.normalized(q).astype(self.dtype), v.astype(self.dtype)

    def with_rotors(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """q, whose states of effects that start with their joint, as a rotor's angle and speed, are
        those of q and v, unless the scene starts them.  (…, nq), (…, nv)->(…, nq)."""
        q, first = np.array(q), q.shape[-1] - len(self.functions.states)
        joints = {c.joint: c for c in self.functions.coordinates}
        for own in states_of(self.scene) if self.functions.states else ():
            for place, state, column in zip(own.places, own.applied.states, own.columns,
                                            strict=True):
                if state.starts and column not in self.scene.start_x:
                    at = joints[own.applied.on]
                    q[..., first + place] = q[..., at.q.start] if state.starts == "q" \
                        else v[..., at.v.start]
        return q

    def normalized(self, q: np.ndarray) -> np.ndarray:
        """q with quaternions of norm 1.  (…, nq)->(…, nq)."""
        q = np.array(q)
        for places in self.quaternions:
            q[..., places] /= np.linalg.norm(q[..., places], axis=-1, keepdims=True)
        return q

    @cached_property
    def quaternions(self) -> tuple[slice, ...]:
        """The slices of q that hold quaternions."""
        return tuple(slice(c.q[x].start, c.q[x].stop) for c in self.functions.coordinates
                     for x in KIND_NAMED[c.kind].quaternions)

    def lacking(self, q: np.ndarray, v: np.ndarray) -> str:
        """'joint elbow: v is inf': the first number of a state that is not finite; else ""."""
        for c in self.functions.coordinates:
            for name, numbers in (("q", q[c.q]), ("v", v[c.v])):
                if not np.isfinite(numbers).all():
                    bad = numbers[~np.isfinite(numbers)][0]
                    return f"joint {c.joint}: {name} is {bad}"
        for (column, _), number in zip(self.functions.states,
                                       q[len(q) - len(self.functions.states):], strict=True):
            if not np.isfinite(number):
                return f"{column} is {number}"
        return ""

    @cached_property
    def _p(self) -> np.ndarray:
        return np.array(self.p, self.dtype)


def scene_of(kernels: "Kernels") -> Scene:
    """The scene of the kernels.  Raises SimulateError for functions that were derived without a
    scene."""
    if kernels.scene is None:
        raise SimulateError("these kernels belong to no scene")
    return kernels.scene


def system(kernels: "Kernels", precision: str, settings: Mapping[str, float] | None = None
           ) -> System:
    """The system of `kernels` (as load_scene returns them) in the precision of this name.

    `settings` are values of run-time parameters.  Raises SimulateError for unknown ones, and for
    values that a scene's file must not have."""
    functions, scene = kernels.interface, scene_of(kernels)
    result = next(x for x in PRECISIONS if x.name == precision)
    refuse_settings(scene, settings or {}, result)
    values = tuple((settings or {}).get(name, value) for name, value in functions.parameters)
    return System(scene, functions, getattr(kernels, precision), result, values, kernels)
