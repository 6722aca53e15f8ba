"""Gradients of a whole run: the adjoints of its steps, from the last to the first.

States are stored at every s-th step, s = ⌈√n⌉ of n steps, and the states between are computed again
from the one stored before them: 2 √n states of NQ + NV numbers are in memory at a time, and every
step is taken twice and differentiated once, which costs three steps more."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import isqrt
from operator import index
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coscrew_codegen.runtime.caller_warnings import at_callers_line
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.function_selection import CONTACTS, FREE
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.plan import known
from coscrew_codegen.simulation.system import State, System, scene_of, system

Reals = NDArray[np.floating]
Weights = Callable[[int, Reals, Reals], tuple[ArrayLike, ArrayLike] | None]
"""(k, q, v) -> derivatives of a cost by the state after step k: by q along velocities, with those
by effects' states behind them, and by v; None where the cost does not depend on it."""


@dataclass(frozen=True)
class RunGradient:
    """The end of a run, and the derivatives of a cost: by the start, along velocities of q, with
    those by effects' states behind them; by the torques of each step, (n, NV), if they were given;
    by run-time parameters."""

    q: Reals
    v: Reals
    g_q: Reals
    g_v: Reals
    g_tau: Reals | None
    g_p: Reals


def run_adjoint(scene: Kernels | Scene | Path | str, n: int, weights: Weights, *,
                step: float | None = None, q0: ArrayLike | None = None,
                v0: ArrayLike | None = None, tau: ArrayLike | None = None,
                p: ArrayLike | None = None, t: float = 0.0, integrator: str | None = None,
                precision: str = "double") -> RunGradient:
    """The derivatives of a cost of the states that n steps go through, by everything that the run
    starts with.

    `weights` is called for k = n, n - 1, … 1, and once for k = 0, with the state after k steps.
    tau, (n, NV), are torques of joints that each step holds, besides the effects.  Arguments that
    are None have the scene's values.  A step that is split at limits is differentiated part by
    part, their number taken as constant: the derivative is that on one side of a contact.

    Raises SimulateError for impossible settings, and the errors of reading a scene."""
    with at_callers_line():
        its, name = _system(scene, integrator, tau is not None, precision)
    if p is not None:
        its = its.at(np.asarray(p, its.dtype))
    count, h = index(n), its.scene.run.step if step is None else float(step)
    if count < 1 or not h > 0:
        raise SimulateError(f"{count} steps of {h} s: wanted one or more, of positive length")
    torques = None if tau is None else np.asarray(tau, its.dtype)
    if torques is not None and torques.shape != (count, its.functions.nv):
        raise SimulateError(f"tau: got shape {torques.shape}; wanted {(count, its.functions.nv)}, "
                            "the torques of each step")
    q, v = (y if x is None else np.array(x, its.dtype)
            for x, y in zip((q0, v0), its.start(), strict=True))
    return _Adjoint(its, name, t, h, torques).gradient(count, weights, (q, v))


@dataclass(frozen=True)
class _Adjoint:
    """Steps of one integrator, and their adjoints."""

    its: System
    name: str
    t: float
    h: float
    tau: Reals | None

    def gradient(self, n: int, weights: Weights, start: State) -> RunGradient:
        """Forward to the stored states, then back from the last to the first."""
        stride = isqrt(n - 1) + 1
        stored = [start]
        for first in range(0, n - stride, stride):
            stored.append(self._onward(first, stride, stored[-1])[-1])
        g_q, g_v = self._still()
        g_p = self._zeros()
        g_tau, end = None if self.tau is None else np.zeros_like(self.tau), start
        for first in reversed(range(0, n, stride)):
            states = self._onward(first, min(stride, n - first), stored.pop())
            end = states[-1] if first + stride >= n else end
            for k in reversed(range(first, first + len(states) - 1)):
                g_q, g_v = _plus(g_q, g_v, weights(k + 1, *states[k + 1 - first]))
                g_q, g_v, by_p, by_tau = self._back(k, states[k - first], g_q, g_v)
                g_p = g_p + by_p
                if g_tau is not None:
                    g_tau[k] = by_tau
        return RunGradient(*end, *_plus(g_q, g_v, weights(0, *start)), g_tau, g_p)

    def _still(self) -> tuple[Reals, Reals]:
        """Zeros along velocities and effects' states, and along velocities."""
        nv = self.its.functions.nv
        g_q, g_v = (np.zeros(n, self.its.dtype) for n in (
            nv + len(self.its.functions.states), nv))
        return g_q, g_v

    def _zeros(self) -> Reals:
        """Zero for each run-time parameter."""
        return np.zeros(len(self.its.functions.parameters), self.its.dtype)

    def _given(self, k: int) -> dict[str, object]:
        """The inputs of step k besides its state."""
        tau = {} if self.tau is None else {"tau": self.tau[k]}
        return {"t": self.t + k * self.h, "h": self.h, **tau}

    def _onward(self, first: int, count: int, state: State) -> list[State]:
        """The state before step `first`, and those after each of the following steps."""
        states = [state]
        for k in range(first, first + count):
            q, v = self.its.outputs(self.name, q=states[-1][0], v=states[-1][1], **self._given(k))
            states.append((q, v))
        return states

    def _back(self, k: int, state: State, w_q: Reals, w_v: Reals) -> tuple[Reals, ...]:
        """The derivatives of a weighted sum of q and v after step k: by q, v, p and tau."""
        g_p, g_tau = self._zeros(), np.zeros_like(w_v)
        for given in reversed(list(self._parts(k, state))):
            result = self._adjoint(given, w_q, w_v)
            w_q, w_v = result["g_q"], result["g_v"]
            g_p, g_tau = g_p + result.get("g_p", 0), g_tau + result.get("g_tau", 0)
        return w_q, w_v, g_p, g_tau

    def _adjoint(self, given: dict[str, object], w_q: Reals, w_v: Reals) -> dict[str, Reals]:
        name = f"{self.name}_adjoint"
        outputs = self.its.outputs(name, **given, w_qo=w_q, w_vo=w_v)
        names = [x for x, _ in self.its.described(name).outputs]
        return dict(zip(names, outputs, strict=True))

    def _parts(self, k: int, state: State) -> Iterator[dict[str, object]]:
        """The inputs of each part in which step k is taken."""
        given = {**self._given(k), "q": state[0], "v": state[1]}
        closing, parts = CONTACTS
        if not self.its.has(closing) or not self.its.call(closing, **given):
            yield given
            return
        count, part = self.its.outputs(parts, **given)
        for j in range(int(count)):
            given |= {"h": part, "t": self.t + k * self.h + j * float(part)}
            yield dict(given)
            after = self._adjoint(given, *self._still())
            given |= {"q": after["qo"], "v": after["vo"]}


def _plus(g_q: Reals, g_v: Reals, more: tuple[ArrayLike, ArrayLike] | None
          ) -> tuple[Reals, Reals]:
    """The derivatives with those of the cost by this state added."""
    if more is None:
        return g_q, g_v
    w_q, w_v = more
    return g_q + np.asarray(w_q, g_q.dtype), g_v + np.asarray(w_v, g_v.dtype)


def _system(scene: Kernels | Scene | Path | str, integrator: str | None, driven: bool,
            precision: str) -> tuple[System, str]:
    """The compiled functions, and the name of the step."""
    if isinstance(scene, (Path, str)):
        from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

        scene = read_scene(Path(scene))
    its = _integrator(scene_of(scene) if isinstance(scene, Kernels) else scene, integrator)
    name = its.step_with_tau if driven else its.step_name
    names = (name, f"{name}_adjoint", *(CONTACTS if its.splits else ()), *FREE)
    kernels = scene._with(*names) if isinstance(scene, Kernels) else kernels_for(
        scene, names, (precision,))
    if precision not in kernels.precisions:
        raise SimulateError(f"precision: {precision!r}; wanted one of "
                            f"{', '.join(kernels.precisions)}")
    return system(kernels, precision), name


def _integrator(scene: Scene, name: str | None) -> Integrator:
    """The integrator of this name, or the scene's, or the default one where that is SciPy's."""
    its = INTEGRATOR_NAMED[known(scene.run.integrator if name is None else name)]
    if its.emitted:
        return its
    if name is not None:
        raise SimulateError(f"{name}: SciPy takes its steps; wanted an integrator whose steps are "
                            "functions of the scene")
    return INTEGRATOR_NAMED[DEFAULT]
