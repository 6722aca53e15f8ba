"""A scene's functions in every number format on cores for which fixed point is made, and on this
machine: proved bounds over the stated ranges, and instructions or times of a call."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene, fixed_of
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError, SceneTier, in_tier
from coscrew_codegen.accuracy.tiers import OF_SCENES, PLAIN, tier_named
from coscrew_codegen.backends.fixed import scene_c_fixed
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.html.pages import Table, with_interval
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.backends.scene.scene_text import banner_of, c_name
from coscrew_codegen.backends.target import Files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.fixed.fixed_program import FixedProgram, Products
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.reports.cost.function_errors import FunctionErrors
from coscrew_codegen.reports.cost.measured import TierChoice
from coscrew_codegen.reports.cost.needs import core_estimates, cortex_m4
from coscrew_codegen.reports.cost.needs.core_estimates import Operations
from coscrew_codegen.reports.cost.needs.fixed_times import FORMATS, fixed_times
from coscrew_codegen.reports.cost.needs.proved import over_ranges
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.runtime.compilation import Compiler
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.result_units import in_unit

CORES = {**cortex_m4.WITHOUT_FLOATS, "Cortex-M4F": cortex_m4.COMPILER}
_STATE = 0.4  # of the largest arguments
_ABOVE = ("Proved: no error exceeds it while arguments are in the stated ranges, where fixed point "
          "cannot overflow.  Found: the worst error of a search there; a bound far above it is "
          "loose, as those of long chains are.  Instructions of a call with its sines, at one "
          "state; double is software on all three cores, single on the first two.")


@dataclass(frozen=True)
class CoreCost:
    """A function in one number format: by unit the proved bound over the ranges, the worst error
    that a search found there, and the largest bound that it returned; instructions by core, and its
    time on this machine."""

    function: str
    format: str  # double, single accurate, fixed, fixed (high)
    tier: str
    precision: str
    bounds: dict[str, float]  # {} without a proof
    instructions: dict[str, int]  # without those too few to be estimated
    time: Interval | None = None
    counted: bool = False  # else estimated
    worst: Mapping[str, float] = field(default_factory=dict)  # {} without a search
    returned: Mapping[str, float] = field(default_factory=dict)  # {} if it returns no bounds


@dataclass(frozen=True)
class FormatC:
    """A function's C in a number format."""

    words: str
    tier: str
    precision: Precision
    stem: str  # of the file
    header: str
    name: str  # of the C function
    function: FunctionProgram
    bounds: Sequence[float] | None
    made: FixedProgram | None = None
    products: Products | None = None


Search = Callable[[FixedFunction, Products], Mapping[str, float]]
"""Returns the worst errors of a function in fixed point, by unit."""


def on_cores(scene: Scene, names: Sequence[str], compiler: Compiler,
             measured: Mapping[tuple[str, str], FunctionErrors],
             search: Search | None = None) -> tuple[CoreCost, ...]:
    """The costs of these functions, if the scene selects fixed point; () if it does not.  Errors
    and times of other formats are known, by function and format.  Raises CountError."""
    if not any(tier.fixed for tier in map(tier_named, scene.tiers)) or not names:
        return ()
    plain = derive(scene, tuple(names))
    try:
        (made,) = fixed_of(plain)
    except NoFunctionsError:
        return ()
    files, tiers, plain = _files(made, plain)
    times = {key: x.time for key, x in measured.items()} | fixed_times(made, files, compiler)
    costs = []
    with TemporaryDirectory() as folder:
        _write(files, Path(folder))
        for f in made.functions:
            for x in _variants(made, plain, tiers, f):
                key = f.plain.name, x.words
                cost = _cost(x, f, Path(folder), times.get(key))
                if x.products and search:
                    cost = replace(cost, worst=search(f, x.products))
                elif key in measured:
                    errors = measured[key].errors
                    cost = replace(cost, worst={e.unit: e.worst for e in errors}, returned={
                        e.unit: e.bounds.worst for e in errors if e.bounds})
                costs.append(cost)
    return tuple(costs)


def counted(made: FixedScene, plain: SceneFunctions, folder: Path
            ) -> Iterator[tuple[FixedFunction, FormatC, dict[str, int]]]:
    """The instructions of a call by core, of each function in each number format.  Raises
    CountError."""
    files, tiers, plain = _files(made, plain)
    _write(files, folder)
    for f in made.functions:
        for x in _variants(made, plain, tiers, f):
            yield f, x, _counted(x, f, folder)


def _files(made: FixedScene, plain: SceneFunctions
           ) -> tuple[Files, tuple[SceneTier, ...], SceneFunctions]:
    """The C in all formats, and the functions that fixed point has, in tiers and plain."""
    known = {f.plain.name for f in made.functions}
    plain = replace(plain, steps=(), functions=tuple(
        f for f in plain.functions if f.internal or f.name in known))
    tiers, banner = tuple(_tiers(plain)), banner_of(plain.name)
    files = scene_c.files(plain, banner) | scene_c_fixed.files(made, banner)
    for tier in tiers:
        files |= scene_c_tier.files(tier, banner)
    return files, tiers, plain


def _write(files: Files, folder: Path) -> None:
    for path, text in files.items():
        (folder / path).write_text(text, encoding="utf-8")


def _tiers(plain: SceneFunctions) -> Iterator[SceneTier]:
    """The functions in all tiers of floating point besides plain."""
    for tier in OF_SCENES:
        if tier != PLAIN and not tier.fixed:
            try:
                yield in_tier(plain, tier)
            except NoFunctionsError:  # mixed, where no function has a requested accuracy
                continue


def _variants(made: FixedScene, plain: SceneFunctions, tiers: Sequence[SceneTier],
              f: FixedFunction) -> Iterator[FormatC]:
    name = f.plain.name
    scenes = [(PLAIN.name, p, plain, plain.name) for p in named(plain.precisions)]
    scenes += [(x.tier.name, p, scene, x.stem) for x in tiers for p, scene in x.in_precisions
               if scene.has(name)]
    for tier, p, scene, stem in scenes:
        function = scene.named(name)
        words = p.name if tier == PLAIN.name else f"{p.name} {tier}"
        yield FormatC(words, tier, p, stem, stem, c_name(scene, name, p), function,
                      over_ranges(plain.named(name), TierChoice(tier, p)))
    for products, fixed in f.programs.items():
        mark = scene_c_fixed.MARK[products]
        yield FormatC(FORMATS[products], made.tier.name,
                      INTEGERS, f"{made.stem}{mark}", made.stem,
                      scene_c_fixed.c_name(made, f, products), f.plain,
                      [float(x.error) for x in fixed.results], fixed, products)


def given_at(x: FormatC, f: FixedFunction) -> list[np.ndarray]:
    """The arguments at the state at which instructions are counted."""
    integers = [np.array([int(_STATE * y.largest) for y in values], np.int32)
                for values in f.inputs]
    return integers if x.precision is INTEGERS else [
        np.array([y / 2.0**value.bits for y, value in zip(parts, values, strict=True)], np.float32)
        for parts, values in zip(integers, f.inputs, strict=True)]


def operations(x: FormatC, f: FixedFunction) -> Operations:
    """The operations of a call there, by kind."""
    if x.made and x.products:
        return core_estimates.of_fixed(x.made.program, x.products)
    return core_estimates.of_function(x.function, x.precision, given_at(x, f))


def _counted(x: FormatC, f: FixedFunction, folder: Path) -> dict[str, int]:
    """The instructions of a call at one state, by core."""
    return {core: cortex_m4.counted(
        cortex_m4.built(folder, x.stem, x.precision, compiler), x.header, x.function, x.name,
        given_at(x, f), x.precision, compiler)[0] for core, compiler in CORES.items()}


def _cost(x: FormatC, f: FixedFunction, folder: Path, time: Interval | None) -> CoreCost:
    exact = not cortex_m4.missing()
    if exact:
        instructions = _counted(x, f, folder)
    else:
        instructions = {core: number for core in CORES if (number := operations(x, f).on(core))}
    return CoreCost(f.plain.name, x.words, x.tier, x.precision.name,
                    _by_unit(f.plain, x.bounds) if x.bounds else {}, instructions,
                    time, exact)


def _by_unit(f: FunctionProgram, errors: Sequence[float]) -> dict[str, float]:
    """The largest error of each unit."""
    pairs = list(zip(f.units, errors, strict=False))  # certified functions have bounds, too
    return {unit: max(float(x) for other, x in pairs if other == unit)
            for unit in dict.fromkeys(f.units)}


def _in_units(errors: Mapping[str, float]) -> str:
    return " and ".join(in_unit(x, unit) for unit, x in errors.items() if x < inf)


def _instructions(x: CoreCost, core: str) -> str:
    known = x.instructions.get(core)
    return f"{'' if x.counted else 'about '}{known:,}" if known else ""


def table(costs: Sequence[CoreCost]) -> Table:
    """A line for each function and format."""
    rows = tuple(
        (x.function if n == 0 or costs[n - 1].function != x.function else "", x.format,
         _in_units(x.bounds), _in_units(x.worst),
         with_interval(x.time.median, x.time.low, x.time.high) if x.time else "",
         *(_instructions(x, core) for core in CORES))
        for n, x in enumerate(costs))
    missing = cortex_m4.missing()
    why = (
        f"Estimated from operations, without {' and '.join(missing)}, within about 10 % of counts; "
        f"none below {core_estimates.LEAST} instructions, where the compiler's choice of registers "
        "decides.",) if missing else ()
    return Table(("in the stated ranges", "format", "proved", "found", "ns here", *CORES), rows,
                 (_ABOVE, *why), title="Fixed point", texts=3)
