"""Specification of a sweep: everything that determines the values and results of its members."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from fractions import Fraction
from functools import cached_property
from hashlib import sha256
from math import prod

from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.candidates import (
    Candidate,
    candidates,
    limits_of,
    matching,
    one,
    turned,
)
from coscrew_codegen.simulation.sweep.sweep_options import GridOption, SobolOption


@dataclass(frozen=True)
class Grid:
    """Values that an input takes, one after the other."""

    of: Candidate
    values: tuple[float, ...]


@dataclass(frozen=True)
class Range:
    """A coordinate of the Sobol sequence, from `low` to `high`; if `log`, in logarithms."""

    of: Candidate
    low: float
    high: float
    log: bool


@dataclass(frozen=True)
class Varied:
    """Inputs that vary: all points of the grids, each with all samples of the ranges."""

    grids: tuple[Grid, ...]
    ranges: tuple[Range, ...]
    samples: int
    seed: int

    @property
    def columns(self) -> tuple[Candidate, ...]:
        """Inputs that vary, in the order of a member's values."""
        return tuple(x.of for x in self.each)

    @property
    def each(self) -> tuple[Grid | Range, ...]:
        """The grids, then the ranges."""
        results: tuple[Grid | Range, ...] = self.grids
        return results + self.ranges

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the grids."""
        return tuple(len(x.values) for x in self.grids)

    @property
    def members(self) -> int:
        """The number of runs."""
        return self.samples * prod(self.shape)

    @property
    def ends(self) -> Mapping[str, tuple[float, float]]:
        """Smallest and largest values of the varied quantities, by name."""
        return ({x.of.name: (min(x.values), max(x.values)) for x in self.grids}
                | {x.of.name: (x.low, x.high) for x in self.ranges})


@dataclass(frozen=True)
class Conditions:
    """Settings of each member's run, and the quantities that are kept of it."""

    settings: tuple[tuple[str, float], ...]  # of parameters that do not vary
    until: float
    step: float
    integrator: str
    every: float
    precision: str
    record: tuple[str, ...]
    series: bool


@dataclass(frozen=True)
class Specification:
    """A sweep of a scene with this content, in chunks of so many members."""

    scene: str
    scene_sha256: str
    coscrew: str  # version
    varied: Varied
    conditions: Conditions
    chunk: int

    @property
    def chunks(self) -> int:
        """The number of chunks; the last may be shorter."""
        return -(-self.varied.members // self.chunk)

    def members(self, number: int) -> range:
        """The members of a chunk."""
        first = number * self.chunk
        return range(first, min(first + self.chunk, self.varied.members))

    @property
    def data(self) -> Mapping[str, Json]:
        """Returns the specification as JSON."""
        results: Mapping[str, Json] = json.loads(json.dumps(asdict(self)))
        return results

    @cached_property
    def sha256(self) -> str:
        """The hash that identifies the sweep of a folder."""
        return sha256(json.dumps(self.data, sort_keys=True).encode()).hexdigest()


def varied(scene: Scene, settings: Mapping[str, float], grids: Sequence[GridOption],
           sobols: Sequence[SobolOption], samples: int | None, seed: int | None) -> Varied:
    """Reads the inputs to vary from the options.  Raises SweepError."""
    if not (grids or sobols):
        raise SweepError("nothing varies; wanted --grid NAME=FROM:TO:COUNT or --sobol "
                         "PATTERN=LOW:HIGH with --samples N")
    if bool(sobols) != (samples is not None) or seed is not None and not sobols:
        raise SweepError("--sobol wants --samples N" if sobols else
                         "--samples and --seed want --sobol PATTERN=LOW:HIGH")
    known = candidates(scene, settings)
    made = Varied(tuple(_grid(x, one("--grid", x.name, scene, known)) for x in grids),
                  tuple(r for x in sobols for r in _ranges(x, scene, known)),
                  samples or 1, seed or 0)
    names = [x.name for x in made.columns]
    for name in names:
        if names.count(name) > 1:
            raise SweepError(f"{name}: varies by two options; wanted one")
        if name in settings:
            raise SweepError(f"--set {name}: it varies; wanted one of the two")
    return made


def _grid(option: GridOption, of: Candidate) -> Grid:
    first, last = option.ends
    steps = max(option.count - 1, 1)
    if not option.log:
        return Grid(of, tuple(float(first + Fraction(i, steps) * (last - first))
                              for i in range(option.count)))
    from mpmath import mp

    with mp.workdps(50):
        a, b = (mp.mpf(x.numerator) / x.denominator for x in option.ends)
        inner = [float(a * (b / a)**(mp.mpf(i) / steps)) for i in range(1, steps)]
    return Grid(of, (float(first), *inner, float(last))[:option.count])


def _ranges(option: SobolOption, scene: Scene, known: Mapping[str, Candidate]) -> Iterator[Range]:
    if option.uniform:
        yield from (Range(x, 0.0, 1.0, False) for x in turned("--sobol", option.pattern, scene))
    else:
        yield from (_range(option, x) for x in matching("--sobol", option.pattern, scene, known))


def _range(given: SobolOption, of: Candidate) -> Range:
    low, high = map(float, given.ends) if given.ends else limits_of(f"--sobol {given.pattern}", of)
    return Range(of, low, high, given.log)
