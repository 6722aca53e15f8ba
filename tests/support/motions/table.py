"""Rows: a motion's run, judged, beside the commands' verdicts; and tables of them."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from tabulate import tabulate

from tests.support.motions.dynamics import Dynamics
from tests.support.motions.errors import Error, errors, judged
from tests.support.motions.mechanism import Motion
from tests.support.motions.reference import Reference, Unjudged, reference
from tests.support.motions.verdicts import FIXED, Runs, Said, Setting, advised, runs

DEFAULT, OTHERS = FIXED[0], FIXED[1:]
ADAPTIVE = ("dop853", "radau")
_MOST_STEPS = 100_000
"""Steps of a run with an advised step, beyond which it is not followed."""
_WORDS = re.compile(r"(rtol = \S+, atol = \S+ )?--step \S+ --integrator \S+ "
                    r"--precision (double|single):? ?")
_ENERGY = 0.01
"""Largest relative change of the energy of a chaotic motion, after which it is wrong."""


@dataclass(frozen=True)
class Row:
    """A run of a motion.  `truth` is right, between, wrong or unjudged; `advice` says what came of
    following the check's advice."""

    motion: Motion
    how: Setting
    truth: str
    worst: Error | None
    verdicts: Said | None
    advice: tuple[str, ...] = ()
    reason: str = ""  # why it is unjudged, or the error that was raised

    @property
    def verdict(self) -> str:
        """The verdict of both commands, in a word."""
        if self.verdicts is None:
            return "error"
        stopped = self.verdicts.stopped and not self.verdicts.passed
        return "stopped" if stopped else self.verdicts.column

    @property
    def false(self) -> tuple[str, ...]:
        """Faults of the commands' verdicts."""
        if self.verdicts is None:
            return ("an error was raised",)
        results = []
        if self.truth == "wrong":
            results += ["wrong, check passes"] if self.verdicts.passed else []
            results += ["wrong, simulate goes on"] if not self.verdicts.stopped else []
        if self.truth == "right":
            results += ["right, check fails"] if not self.verdicts.passed else []
            results += ["right, simulate stops"] if self.verdicts.stopped else []
        return (*results, *(f"advice: {x}" for x in self.advice))

    @property
    def words(self) -> str:
        """A line: the scene, the run, the error, the verdicts."""
        worst = f"{self.worst.part}: q {self.worst.q:.2g}, v {self.worst.v:.2g}" if self.worst \
            else ""
        return (f"{self.motion.name} ({self.motion.about}) {self.how.words}: {self.truth} ({worst})"
                f", {self.verdict}: {'; '.join(self.false)}{self.reason}"
                f"{f' | {self.verdicts.reasons}' if self.verdicts else ''}")


def settings(motion: Motion, every: bool = False) -> Iterator[Setting]:
    """The runs of a motion: `every` one, or the default integrator, and in turn another and one in
    single precision."""
    other, turn = OTHERS[motion.number % 3], motion.number // 3 % 2
    for step in motion.steps:
        yield from (Setting(step, x, "double") for x in FIXED if every or x in (DEFAULT, other))
        yield from (Setting(step, x, "single") for x in FIXED
                    if every or x == (DEFAULT, other)[turn])
        if motion.adaptive:
            yield Setting(step, ADAPTIVE[0], "double")


@dataclass(frozen=True)
class Judge:
    """A motion's reference and runs."""

    motion: Motion
    runs: Runs
    its: Dynamics

    def truth(self, how: Setting) -> tuple[str, Error]:
        """Returns whether a run is right, and its worst part.  Raises Unjudged."""
        q, v = self.runs.states(how, self.its)
        true = reference(self.motion, self.runs.times(how))
        part = true.t <= true.horizon
        result = errors(self.its, self.motion, true.q, true.v, true.q[part], true.v[part], q[part],
                        v[part])
        worst = max(result, key=lambda x: x.of_allowed)
        verdict = judged(result)
        if verdict == "right" and not part.all() and not self._keeps_energy(true, q, v):
            return "wrong", worst
        return verdict, worst

    def _keeps_energy(self, true: Reference, q: np.ndarray, v: np.ndarray) -> bool:
        """Returns whether a chaotic motion keeps its energy to the end."""
        if not (np.isfinite(q).all() and np.isfinite(v).all()):
            return False
        energies, true_ones = (np.array([self.its.energy(*x) for x in zip(*states, strict=True)])
                               for states in ((q, v), (true.q, true.v)))
        least = min(self.its.energy(x, 0 * y) for x, y in zip(true.q, true.v, strict=True))
        return bool(np.abs(energies - true_ones).max() <= _ENERGY * (true_ones[0] - least))

    def row(self, how: Setting, follow: bool) -> Row:
        """The judged run."""
        spoken = None
        try:
            spoken = self.runs.verdicts(how)
            truth, worst = self.truth(how)
        except Unjudged as error:
            return Row(self.motion, how, "unjudged", None, spoken, (), f" {error}")
        except Exception as error:  # whatever a command raises is a finding
            return Row(self.motion, how, "unjudged", None, None, (), f" {_words_of(error)}")
        followed = tuple(self.followed(how, spoken)) if follow else ()
        return Row(self.motion, how, truth, worst, spoken, followed)

    def followed(self, how: Setting, message: Said) -> Iterator[str]:
        """Advice of both commands that proves false when it is followed."""
        seen = set()
        for text in ("" if message.passed else message.text, message.stopped):
            for then in advised(text, how):
                if then in seen or self.motion.duration / then.step > _MOST_STEPS:
                    continue
                seen.add(then)
                yield from self._follow(how, then)

    def _follow(self, how: Setting, then: Setting) -> Iterator[str]:
        twice = replace(then, step=2.1 * then.step)
        try:
            if not self.runs.verdicts(then).goes_on:
                yield f"{then.words} does not pass"
            if then.step < how.step / 2.1 and self.runs.verdicts(twice).goes_on:
                yield f"{then.words}: twice this step passes, too"
            if self.truth(then)[0] == "wrong":
                yield f"{then.words} is wrong"
        except Unjudged:
            return
        except Exception as error:
            yield f"{then.words} raises {_words_of(error)}"


def _words_of(error: Exception) -> str:
    return f"{type(error).__name__}: {str(error)[:200]}"


def judge(motion: Motion) -> Judge:
    """Judges all runs of a motion."""
    return Judge(motion, runs(motion), Dynamics(motion.mechanism))


def converged(motion: Motion) -> Error:
    """The worst error of Runge and Kutta's method at a hundredth of a radian per step, for at most
    4000 of them: a small part of the allowed error for motions by the judge's equations."""
    step = min(motion.steps[0], 0.01 / motion.rate)
    short = replace(motion, duration=min(motion.duration, 4000 * step))
    return judge(short).truth(Setting(step, "rk4", "double"))[1]


COLUMNS = ("passed", "strict fails", "failed", "stopped", "error")
TRUTHS = ("right", "between", "wrong", "unjudged")


def table(rows: Iterable[Row]) -> str:
    """Counts of the commands' verdicts, by family and truth."""
    counts: dict[tuple[str, str], Counter[str]] = {}
    for row in rows:
        for family in (row.motion.family, "all"):
            counts.setdefault((family, row.truth), Counter())[row.verdict] += 1
    order = [x for x in dict.fromkeys(family for family, _ in counts) if x != "all"]
    order += ["all"] if len(order) > 1 else []
    lines = [(family, truth, *(counts[family, truth][x] for x in COLUMNS))
             for family in order for truth in TRUTHS if (family, truth) in counts]
    return str(tabulate(lines, ("family", "motion", *COLUMNS)))


def exceptions(rows: Iterable[Row]) -> str:
    """Numbers of wrong verdicts of the commands, by kind."""
    counts = Counter(_WORDS.sub("", kind) for row in rows for kind in row.false)
    return str(tabulate(sorted(counts.items()), ("exception", "rows")))
