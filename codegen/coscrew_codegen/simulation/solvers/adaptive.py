"""Integration by SciPy, which chooses its steps by tolerances.

The state is y = (q; v), with q' = v for angles and lengths and r' = r (ω; 0) / 2 for quaternions.
The solver keeps |r| within its tolerance only, so r is normalized before the dynamics use it, and
in samples.  Where loops are closed, the state after each step, and each sample, is moved onto the
closures.  States of effects are put within their bounds after each step; where an effect begins to
follow another part of its law, a step ends, and the solver begins anew."""

from collections.abc import Callable, Iterator

import numpy as np
import scipy.integrate
from scipy.integrate import OdeSolver

from coscrew_codegen.scene.effect import required
from coscrew_codegen.scene.function_selection import CLOSED, STATE_RATES, SWITCHES
from coscrew_codegen.scene.integrators import ADAPTIVE
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.simulation import coordinate_rates
from coscrew_codegen.simulation.plan import Plan
from coscrew_codegen.simulation.solvers.events import Events
from coscrew_codegen.simulation.system import State, System, Watch

_OF_STATES = 1e-3  # a usual size of states of effects, in their units
_SPACINGS = 16  # of times, within which events are found
_PROJECTIONS = 2  # onto closures: steps of SciPy are long, and velocities follow coordinates
Rates = Callable[[float, np.ndarray], np.ndarray]


def adaptive(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
             watch: Watch | None = None) -> Iterator[tuple[np.ndarray, np.ndarray, int, str]]:
    """Yields (q, v, steps so far, "") at each sample after the first; instead of "" the place and
    reason if the run stopped early."""
    steps, sample, begun = 0, 1, _beginning(system, plan, float(times[-1]))
    events = Events(system, plan.rtol, plan.atol) if system.has(SWITCHES) else None
    with np.errstate(all="ignore"):
        solver = begun(0.0, np.concatenate((q, v)).astype(float))
        while sample < len(times):
            if failed := _step(solver):
                yield q, v, steps, f"{failed} at t = {solver.t:.9g} s: {_trouble(system, solver)}"
                return
            steps += 1
            before = required(solver.t_old)
            needed = events or times[sample] < solver.t
            interpolant = solver.dense_output() if needed else None
            event = events.first(interpolant, before, solver.t, _least(solver)) \
                if events and interpolant else None
            if event is not None and interpolant:
                solver = begun(event, interpolant(event))
            _close(system, solver)
            if watch and solver.t < times[sample]:
                watch(solver.t, *_state(system, solver.t, solver.y))
            while sample < len(times) and times[sample] <= solver.t:
                y = interpolant(times[sample]) if interpolant and times[sample] < solver.t \
                    else solver.y
                q, v = _state(system, times[sample], y)
                yield q, v, steps, ""
                sample += 1


def _beginning(system: System, plan: Plan, end: float) -> Callable[[float, np.ndarray], OdeSolver]:
    """(t, y) -> the plan's solver, at this state."""
    rates, scheme = rates_of(system), ADAPTIVE[plan.integrator]
    options = {"jac": jacobian_of(system, rates)} if scheme.implicit else {}
    solver = getattr(scipy.integrate, scheme.solver)
    return lambda t, y: solver(rates, t, y, end, rtol=plan.rtol, atol=plan.atol, **options)


def _least(solver: OdeSolver) -> float:
    """Width of the interval to which the time of an event is narrowed."""
    return _SPACINGS * float(np.spacing(max(abs(solver.t), abs(solver.step_size or 0.0))))


def _state(system: System, t: float, y: np.ndarray) -> State:
    """q and v of y, in the system's precision."""
    nq = system.functions.nq
    q, v = system.normalized(y[:nq]).astype(system.dtype), y[nq:].astype(system.dtype)
    for _ in range(_PROJECTIONS if system.has(CLOSED) else 0):
        q, v = system.outputs(CLOSED, q=q, v=v)
    if system.has(STATE_RATES):
        q = system.outputs(STATE_RATES, t=t, q=q, v=v)[1]
    return q, v


def rates_of(system: System) -> Rates:
    """(t, y) -> y'.  (…), (…, nq + nv)->(…, nq + nv)."""
    nq, nv = system.functions.nq, system.functions.nv
    tau, rates_of_coordinates = np.zeros(nv), _coordinate_rates(system)

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        q, v = system.normalized(y[..., :nq]), y[..., nq:]
        moved = rates_of_coordinates(y[..., :nq], q, v)
        if system.has(STATE_RATES):
            x_rates, q = system.outputs(STATE_RATES, t=t, q=q, v=v)
            moved[..., nq - x_rates.shape[-1]:] = x_rates
        a = system.call("forward_dynamics", t=t, q=q, v=v, tau=tau)
        return np.concatenate((moved, a), -1)

    return rates


def _coordinate_rates(system: System) -> Callable[..., np.ndarray]:
    """(r, q, v) -> the rates of the coordinates r; q is r with normalized quaternions.

    Rates that are velocities, the most of a robot, are taken at once."""
    turning = [c for c in system.functions.coordinates if KIND_NAMED[c.kind].manifold]
    others = [c for c in system.functions.coordinates if not KIND_NAMED[c.kind].manifold]
    places, speeds = [k for c in others for k in c.q], [k for c in others for k in c.v]

    def coordinates(r: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        result = np.empty(q.shape)
        result[..., places] = v[..., speeds]
        for c in turning:
            result[..., c.q] = coordinate_rates.rates(c.kind, r[..., c.q], q[..., c.q], v[..., c.v])
        return result

    return coordinates


def jacobian_of(system: System, rates: Rates) -> Rates:
    """(t, y) -> ∂y'/∂y by central differences, all in one call.

    Their steps suit the precision of the dynamics: SciPy's steps, made for double, would give only
    noise in single.  Bristles yield by less than a millimetre."""
    step, nq = float(np.cbrt(np.finfo(system.dtype).eps)), system.functions.nq
    scale = np.ones(nq + system.functions.nv)
    scale[nq - len(system.functions.states):nq] = _OF_STATES

    def jacobian(t: float, y: np.ndarray) -> np.ndarray:
        moved = np.diag(step * np.maximum(scale, np.abs(y)))
        above, below = y + moved, y - moved
        size = np.diag(above - below)
        return ((rates(t, above) - rates(t, below)) / size[:, None]).T

    return jacobian


def _step(solver: OdeSolver) -> str:
    """Take a step; returns the reason if it failed, else ""."""
    try:
        solver.step()
    except (ValueError, np.linalg.LinAlgError):  # from Radau's linear algebra
        return "the solver met a state that is not finite"
    return "the solver's steps became too small" if solver.status == "failed" else ""


def _close(system: System, solver: OdeSolver) -> None:
    """Moves the state that a step has reached onto the closures of loops, and states of effects
    within their bounds."""
    if (system.has(CLOSED) or system.has(STATE_RATES)) and np.isfinite(solver.y).all():
        solver.y = np.concatenate(_state(system, solver.t, solver.y)).astype(float)
        solver.f = solver.fun(solver.t, solver.y)


def _trouble(system: System, solver: OdeSolver) -> str:
    """A sentence on the joint whose acceleration is not finite, or else the largest."""
    a = solver.fun(solver.t, solver.y)[system.functions.nq:]
    finite = np.where(np.isfinite(a), np.abs(a), np.inf)
    worst = int(np.argmax(finite))
    joint = next(c.joint for c in system.functions.coordinates if worst in c.v)
    return f"joint {joint}: acceleration {a[worst]:.3g}"
