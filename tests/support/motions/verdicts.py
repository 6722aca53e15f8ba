"""Motions computed by coscrew, with the verdicts of `simulate` and `check`."""

import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.function_selection import together
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import required_functions
from coscrew_codegen.simulation.check import check_report
from coscrew_codegen.simulation.check.check import check
from coscrew_codegen.simulation.plan import Plan, plan
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from coscrew_codegen.simulation.system import System, system
from tests.support.motions.dynamics import Dynamics
from tests.support.motions.mechanism import Motion

FIXED = ("leapfrog", "linear-implicit-euler", "semi-implicit-euler", "rk4")


@dataclass(frozen=True)
class Setting:
    """Settings of a run."""

    step: float
    integrator: str
    precision: str
    tolerances: tuple[float, float] | None = None  # rtol and atol; None: the defaults

    @property
    def words(self) -> str:
        tolerances = "rtol = {:g}, atol = {:g} ".format(*self.tolerances) if self.tolerances else ""
        return (f"{tolerances}--step {self.step:g} --integrator {self.integrator} "
                f"--precision {self.precision}")


@dataclass(frozen=True)
class Said:
    """Output of the commands: the run's stop, or ""; whether the check passes; its text."""

    stopped: str
    passed: bool
    strictly: bool
    text: str

    @property
    def goes_on(self) -> bool:
        """True if neither command refuses the motion."""
        return self.passed and not self.stopped

    @property
    def reasons(self) -> str:
        """The sentences on faults."""
        false = [x for x in self.text.splitlines() if x.startswith(("FALSE", "double:", "single:"))]
        return " ".join(dict.fromkeys((*false, self.stopped))).strip()

    @property
    def column(self) -> str:
        """The check's verdict in a word."""
        return "passed" if self.strictly else "strict fails" if self.passed else "failed"


@lru_cache(maxsize=64)
def _shared(text: str, integrators: tuple[str, ...]) -> Kernels:
    """The kernels of all scenes that differ in numbers given at run time alone."""
    scene = _read(text)
    return kernels_for(scene,
                       together(*(required_functions.of_check(scene, x) for x in integrators)))


@lru_cache(maxsize=8)
def _read(text: str) -> Scene:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "motion.toml")
        path.write_text(text)
        return read_scene(path)


@dataclass(frozen=True)
class Runs:
    """The runs of a motion, by kernels that it shares with others."""

    motion: Motion
    kernels: Kernels

    def _settings(self) -> tuple[tuple[str, float], ...]:
        return tuple(self.motion.mechanism.settings.items())

    def _kernels(self, how: Setting) -> Kernels:
        scene = _read(self.motion.text(how.step, how.integrator, how.precision, how.tolerances))
        wanted = replace(self.kernels.request, scene=replace(scene, precision=how.precision))
        return replace(self.kernels, request=wanted)

    def _planned(self, how: Setting) -> tuple[System, Plan]:
        its = system(self._kernels(how), how.precision, dict(self._settings()))
        return its, plan(its)

    def times(self, how: Setting) -> np.ndarray:
        """The times of samples."""
        return self._planned(how)[1].samples

    def states(self, how: Setting, its: Dynamics) -> tuple[np.ndarray, np.ndarray]:
        """q and v of a run that nothing stops, in the order of the judge; NaN after its end."""
        made, planned = self._planned(how)
        run = integrate(made, planned)
        n = len(planned.samples)
        q, v = (np.full((n, size), np.nan) for size in (its.model.nq, its.model.nv))
        at = {p.joint.name: p for p in its.places}
        for c in made.functions.coordinates:
            place, count = at[c.joint], len(run.t)
            q[:count, place.q], v[:count, place.v] = run.q[:, c.q], run.v[:, c.v]
        its.followed(q, v)
        return q, v

    def verdicts(self, how: Setting) -> Said:
        """The verdicts of `simulate` and `check`, without the rounding of functions."""
        kernels = self._kernels(how)
        given = RunOverrides(None, None, None, how.precision, self._settings())
        stopped = simulated(kernels, given, with_provenance=False)[0].trajectory.stopped
        findings = check(kernels, given)
        return Said(stopped, findings.passed, findings.strictly_passed,
                    check_report.table(findings, strict=True))


def runs(motion: Motion) -> Runs:
    """The runs of a motion."""
    alike = motion.mechanism.text(alike=True)
    return Runs(motion, _shared(alike, FIXED))


_ADVICE = re.compile(r"(?:^|; )take (.+)$", re.MULTILINE)
_UNNAMED = "a smaller step"
_FORMS: tuple[tuple[str, Callable[..., Setting]], ...] = (
    (r"a step of (\S+) s", lambda how, step: replace(how, step=float(step))),
    (r"integrator (\S+)", lambda how, name: replace(how, integrator=name, tolerances=None)),
    (r"rtol = (\S+) and atol = (\S+)",
     lambda how, *tolerances: replace(how, tolerances=tuple(map(float, tolerances)))),
    (r"--precision (\S+)", lambda how, name: replace(how, precision=name)))


def advised(text: str, how: Setting) -> tuple[Setting, ...]:
    """The settings that sentences advise, each of which should do.  Raises ValueError if one is of
    no known form."""
    each = [x for result in _ADVICE.findall(text) for x in result.split(", or ")]
    return tuple(_read_advice(x, how) for x in each if x != _UNNAMED)


def _read_advice(words: str, how: Setting) -> Setting:
    parts = re.fullmatch(r"(--precision \S+) and (.+)", words)
    for part in parts.groups() if parts else (words,):
        result = next(((setting, x) for form, setting in _FORMS if (x := re.fullmatch(form, part))),
                      None)
        if result is None:
            raise ValueError(f"advice of no known form: take {words}")
        how = result[0](how, *result[1].groups())
    return how
