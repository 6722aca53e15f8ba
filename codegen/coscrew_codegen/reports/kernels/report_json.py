"""report.json as frozen dataclasses: the results of `coscrew report`, written and read back.

Field names are JSON keys.  A number may be `Infinity`, as Python's json writes it: the error of an
infinite or NaN result whose exact value is finite.
"""

import json
import types
import typing
from dataclasses import asdict, dataclass, fields, is_dataclass
from typing import Any

SCHEMA = 2


@dataclass(frozen=True)
class CompilerRecord:
    """A C compiler: its command, the first line it prints about itself, the flags used."""

    name: str
    version: str
    flags: str


@dataclass(frozen=True)
class Provenance:
    """Origin of the figures: command, seed, version, machine, compilers, duration."""

    command: str
    seed: int
    version: str
    cpu: str
    cores: int
    system: str
    python: str
    numpy: str
    compilers: tuple[CompilerRecord, ...]
    seconds: float


@dataclass(frozen=True)
class ErrorFigures:
    """Errors of `outputs` output components; `witness` is the input of the worst error, in hex,
    component by component, and `component` names its output."""

    outputs: int
    worst: float
    p999: float
    median: float
    witness: tuple[str, ...]
    component: str


@dataclass(frozen=True)
class ProvenBound:
    """|x̂ - x| <= u |x̂| [if rounded] + (c1 u + c2 u²) S, with the largest constants of all
    components; `worst_ratio` is the largest measured error over its bound."""

    text: str
    c1: float
    c2: float
    rounded: bool
    worst_ratio: float


@dataclass(frozen=True)
class Time:
    """A time in ns per element: the median over `rounds`, its interval from low to high, the
    minimum.

    `ratio` is the median ratio to plain in the same round, language, compiler and layout, with its
    own interval.  `dominated`: another tier's interval lies below, and it is at least as accurate.
    """

    language: str
    compiler: str | None
    layout: str
    ns: float
    low: float
    high: float
    minimum: float
    rounds: int
    ratio: float | None
    ratio_low: float | None
    ratio_high: float | None
    dominated: bool

    @property
    def interval(self) -> tuple[float, float, float]:
        """The median with its interval."""
        return self.ns, self.low, self.high

    @property
    def kind(self) -> str:
        """Its language, compiler and layout."""
        return ", ".join(filter(None, (self.language, self.compiler, self.layout)))


@dataclass(frozen=True)
class ReportEntry:
    """One operation in one precision and tier.  Errors are in `measure`: ulp of the component, or u
    relative to the largest component of its part; `condition` pairs S / |x| with an error."""

    operation: str
    family: str
    statement: str
    precision: str
    tier: str
    measure: str
    benign: ErrorFigures | None
    hard: ErrorFigures | None
    bound: ProvenBound | None
    condition: tuple[tuple[float, float], ...]
    flops: int
    counts: str
    times: tuple[Time, ...]

    @property
    def name(self) -> str:
        """Its name in sentences and plots."""
        return f"{self.operation} {self.precision} {self.tier}"

    def time(self, kind: str) -> Time | None:
        """The time of this kind."""
        return next((x for x in self.times if x.kind == kind), None)


@dataclass(frozen=True)
class DriftErrors:
    """A displacement after `steps` compositions: its rotation's orthonormality defect and its
    error, in u; the time per step, as a median of runs with its interval."""

    precision: str
    orthonormalised: bool
    steps: int
    defect_u: float
    error_u: float
    ns_per_step: float
    ns_low: float
    ns_high: float


@dataclass(frozen=True)
class Change:
    """A figure of the earlier report and the same figure of this one."""

    operation: str
    precision: str
    tier: str
    what: str
    before: float
    after: float
    ratio: float


@dataclass(frozen=True)
class Comparison:
    """Changes since the report in `file`."""

    file: str
    rows: tuple[Change, ...]


@dataclass(frozen=True)
class Report:
    """Everything `coscrew report` measured."""

    schema: int
    provenance: Provenance
    entries: tuple[ReportEntry, ...]
    drift: tuple[DriftErrors, ...]
    compare: Comparison | None

    @property
    def kinds(self) -> tuple[str, ...]:
        """All kinds of times, those in C over a structure of arrays first; one without a name, if
        nothing was timed."""
        times = [time for entry in self.entries for time in entry.times]
        times.sort(key=lambda x: (x.language, x.layout) != ("C", "structure of arrays"))
        return tuple(dict.fromkeys(x.kind for x in times)) or ("",)

    def to_json(self) -> str:
        """The report as the text of report.json."""
        return json.dumps(asdict(self), ensure_ascii=False, indent=1) + "\n"

    @classmethod
    def from_json(cls, text: str) -> "Report":
        """Read what `to_json` wrote.  Raises ValueError, naming the place, for anything else."""
        result = json.loads(text)
        if not isinstance(result, dict) or result.get("schema") != SCHEMA:
            raise ValueError(f"not a report of schema {SCHEMA}")
        report: Report = _read(cls, result, "report")
        return report


def _read(kind: Any, value: object, where: str) -> Any:
    """`value` as `kind`: a dataclass, a tuple, an alternative with None, or a plain type."""
    if isinstance(kind, types.UnionType):
        kinds = [k for k in typing.get_args(kind) if k is not type(None)]
        return None if value is None else _read(kinds[0], value, where)
    if is_dataclass(kind) and isinstance(kind, type):
        names = [field.name for field in fields(kind)]
        if not isinstance(value, dict) or not set(value) >= set(names):
            raise ValueError(f"{where}: wanted an object with {', '.join(names)}")
        hints = typing.get_type_hints(kind)
        return kind(**{name: _read(hints[name], value[name], f"{where}.{name}")
                       for name in names})
    if typing.get_origin(kind) is tuple:
        first, *others = typing.get_args(kind)
        if not isinstance(value, list) or others != [...] and len(value) != 1 + len(others):
            raise ValueError(f"{where}: wanted a list; got {value!r}")
        each = [first] * len(value) if others == [...] else [first, *others]
        return tuple(_read(k, x, f"{where}[{i}]")
                     for i, (k, x) in enumerate(zip(each, value, strict=True)))
    wanted = (int, float) if kind is float else kind
    if not isinstance(value, wanted) or isinstance(value, bool) and kind is not bool:
        raise ValueError(f"{where}: wanted {kind.__name__}; got {value!r}")
    return kind(value)
