"""Scene files: reads a TOML file, or a model's file alone, as a Scene."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from coscrew_codegen.program.values.formats import BY_NAME, CHOICES, DOUBLE
from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.function_selection import (
    FunctionsError,
    TiersError,
    resolved,
    selected_tiers,
    tiers_in_ranges,
    tiers_on_request,
)
from coscrew_codegen.scene.identifiers import refused, scene_identifier
from coscrew_codegen.scene.integrators import NAMES
from coscrew_codegen.scene.mechanism.assembly import followers
from coscrew_codegen.scene.mechanism.inertia_checks import ERROR, WARN
from coscrew_codegen.scene.mechanism.model import Joint, Model
from coscrew_codegen.scene.mechanism.notices import ACCEPT, Notice
from coscrew_codegen.scene.mechanism.rotations import unit
from coscrew_codegen.scene.readers.declared_effects import of_file_alone
from coscrew_codegen.scene.readers.described_robots import SCHEME, robot_source
from coscrew_codegen.scene.readers.model_formats import SCENE_SUFFIX, reader_of, stem, unknown
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.omissions import besides, falling, idle, unused
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.toml.effect_table import Use
from coscrew_codegen.scene.readers.toml.keys import EXPECT, OUTPUTS, RUN, SCENE, START
from coscrew_codegen.scene.readers.toml.named_model import model_of
from coscrew_codegen.scene.readers.toml.plain_tables import scene_text
from coscrew_codegen.scene.readers.toml.runtime import with_parameters
from coscrew_codegen.scene.readers.toml.tables.accuracy_table import (
    limits_used,
    read_accuracy,
    refuse_faults,
)
from coscrew_codegen.scene.readers.toml.tables.loops_table import read_loops
from coscrew_codegen.scene.readers.toml.tables.ranges_table import limits_in_ranges, read_ranges
from coscrew_codegen.scene.readers.toml.toml_effects import read_effects, with_reactions
from coscrew_codegen.scene.readers.toml.toml_model import refuse_not_unit
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals, TomlTable, described, read_toml
from coscrew_codegen.scene.recorded_quantities import STATES, QuantityError, expected, quantities_of
from coscrew_codegen.scene.scene import Applied, Expectation, Run, Scene


@dataclass(frozen=True)
class SceneOverrides:
    """Settings that override those in a scene's file; None: the file's."""

    precision: str | None = None  # double, single, both
    implausible: str | None = None  # error, warn
    functions: tuple[str, ...] | None = None  # names, "default", "all"
    tiers: tuple[str, ...] | None = None  # names
    arguments: tuple[tuple[str, str], ...] = ()  # name and value, beside the file's own
    packages: tuple[tuple[str, str], ...] = ()  # name and folder, likewise
    leave_out: tuple[str, ...] = ()  # groups of elements, likewise

    def __post_init__(self) -> None:
        for key, choices in (("precision", CHOICES), ("implausible", (ERROR, WARN))):
            if (word := getattr(self, key)) not in (None, *choices):
                raise ValueError(f"{key} = {word!r}; wanted one of {', '.join(choices)}")

    @property
    def folders(self) -> dict[str, Path]:
        """The packages' folders by name."""
        return {name: Path(folder) for name, folder in self.packages}


def read_scene(path: Path | str, catalogue: tuple[Effect, ...] | None = None,
               overrides: SceneOverrides = SceneOverrides()) -> Scene:
    """The scene in a TOML file; for a model's file alone, one with the effects that act without a
    scene file, and those that the file declares.

    `catalogue` holds the known effects (None: all).  Raises SceneError, naming file and key, for
    anything unknown, missing, of the wrong type, out of range, or not used."""
    path = Path(path)
    effects = _all_effects() if catalogue is None else catalogue
    if path.suffix.lower() == SCENE_SUFFIX:
        return _scene(read_toml(path), effects, overrides)
    tables, model = _alone(path, effects, overrides)
    return _scene(tables, effects, overrides, model)


def imported(path: Path, overrides: SceneOverrides) -> str:
    """The text of a scene of plain tables: what a model's file alone is, and in comments what it
    says besides.  Raises SceneError as `read_scene`, and for a scene."""
    if path.suffix.lower() == SCENE_SUFFIX:
        raise SceneError(path, "", "is a scene; wanted a model's file")
    effects = _all_effects()
    file, model = _alone(path, effects, overrides)
    _refuse_still(path, model)
    tables = file.table("effects")
    acting = read_effects(tables, model, effects, Use())
    wrong = (f"joint {joint.name}: {fault}" for joint in model.joints for fault in joint.faults)
    comments = (f"Made of {path.name} by `coscrew import`.", *dict.fromkeys(wrong),
                *(x.text for x in besides(model, acting)), *_unwritten(path, model))
    return scene_text(file.text("name"), model, file.texts("runtime", ()), tables.values,
                      file.table("start").table("q").values, comments)


def _unwritten(path: Path, model: Model) -> Iterator[str]:
    """The comment on shapes, which have no tables."""
    seen = sum(len(x.visuals) for x in model.bodies)
    counts = {"visual": seen, "collision": len(model.collisions)}
    if words := [f"{count} {kind}" for kind, count in counts.items() if count]:
        one = sum(counts.values()) == 1
        yield (f"{' and '.join(words)} shape{' is' if one else 's are'} not written: a scene with "
               f'model = "{path.name}" has {"it" if one else "them"}')


def _alone(path: Path, catalogue: tuple[Effect, ...], overrides: SceneOverrides
           ) -> tuple[TomlTable, Model]:
    """The tables that a model's file alone stands for, and the model.  Raises SceneError."""
    source = ModelSource(path, None, overrides.implausible or ERROR, overrides.folders,
                         dict(overrides.arguments), overrides.leave_out)
    if str(path).startswith(SCHEME):
        try:
            source = robot_source(str(path), source)
        except ValueError as error:
            raise SceneError(path, "", str(error)) from None
    path = source.path
    reader = reader_of(path)
    if reader is None:
        raise SceneError(path, "", unknown(path, scenes=True))
    parts = reader.parts_of(source)
    model = parts.model(source)
    start = {name: [Decimals(repr(x)) for x in q] for name, q in parts.start.items()}
    tables = {"name": scene_identifier(stem(path)), "start": {"q": start},
              "effects": of_file_alone(model, parts.effects, catalogue)}
    if parts.inputs:
        tables["runtime"] = list(parts.inputs)
    return TomlTable(path, "", tables), model


def _all_effects() -> tuple[Effect, ...]:
    from coscrew_codegen.scene.effects import EFFECTS
    return EFFECTS


def _emitted(precision: str | None) -> tuple[str, ...]:
    """The precisions in which a scene is generated: only double if that is selected, since single
    may not hold the scene's numbers; else both."""
    return (DOUBLE.name,) if precision == DOUBLE.name else tuple(BY_NAME)


def _overridden(by: str | None, file: TomlTable, key: str, choices: tuple[str, ...]) -> str | None:
    """The overriding word, or else the file's."""
    written = file.choice(key, choices) if key in file else None
    return by or written


def _scene(file: TomlTable, catalogue: tuple[Effect, ...], overrides: SceneOverrides,
           alone: Model | None = None) -> Scene:
    """The scene of these tables, or of the model that is read alone."""
    file.only(*SCENE.names)
    name = _name(file)
    implausible = _overridden(overrides.implausible, file, "implausible", (ERROR, WARN)) or ERROR
    precision = _overridden(overrides.precision, file, "precision", CHOICES)
    model = alone or model_of(file, name, implausible, overrides.folders,
                              dict(overrides.arguments), overrides.leave_out)
    if "loops" in file:
        model = replace(model, loops=read_loops(file, model))
    use = Use()
    effects = read_effects(file.table("effects"), model, catalogue, use)
    _refuse_still(file.file, model)
    scene = Scene(name, model, effects, precision=precision or "double",
                  precisions=_emitted(precision), implausible=implausible,
                  run=_run(file.table("run")))
    start, outputs = file.table("start"), file.table("outputs")
    start.only(*START.names)
    outputs.only(*OUTPUTS.names)
    scene = replace(scene, start_q=_start_q(start.table("q"), scene),
                    start_v=_start_v(start.table("v"), scene),
                    start_x=_start_x(start.table("x"), scene), record=_record(outputs, scene),
                    every=float(outputs.positive("every", Fraction(1, 100))),
                    expectations=_expectations(file, scene))
    functions = _functions(file, scene)
    accuracy = read_accuracy(file, scene, resolved(scene, functions)) if "accuracy" in file else ()
    functions = overrides.functions or functions
    if accuracy:
        selected_now = resolved(scene, functions)
        accuracy = tuple(x for x in accuracy if x.function in selected_now)
    tiers = selected_tiers((*_tiers(file), *(tiers_on_request() if accuracy else ())))
    drawn = limits_used(scene, accuracy) if accuracy else set()
    if drawn:
        refuse_faults(file, scene, drawn)
    if "ranges" in file:
        drawn |= limits_in_ranges(file, scene)
    notices = unused(model, use.of_model | drawn, catalogue, effects)
    effects = with_reactions(scene, catalogue)
    parameters: tuple[Parameter, ...] = ()
    if "runtime" in file:
        model, effects, parameters = with_parameters(file, model, effects, catalogue)
    if overrides.tiers:
        tiers = selected_tiers(overrides.tiers)
    _refuse_without_ranges(file, tiers)
    scene = replace(scene, model=model, effects=effects, parameters=parameters, accuracy=accuracy,
                    tiers=tiers,
                    notices=(*_falling(file, model, effects), *idle(effects), *use.notices,
                             *notices))
    if "ranges" in file:
        scene = replace(scene, ranges=read_ranges(file, scene))
    return _selecting(scene, functions)


def _falling(file: TomlTable, model: Model, effects: tuple[Applied, ...]) -> tuple[Notice, ...]:
    """The notice of bodies that fall, unless the file accepts that."""
    meant = file.choice("falling", (WARN, ACCEPT)) if "falling" in file else WARN
    return falling(model, effects) if meant == WARN else ()


def _functions(file: TomlTable, scene: Scene) -> tuple[str, ...]:
    """The functions that the file selects; (): the default functions."""
    names = file.texts("functions", ())
    if "functions" in file and not names:
        file.refuse("functions", 'an empty list; wanted names, as ["inverse_dynamics"], "default" '
                                 'or "all" among them')
    try:
        return _selecting(scene, names).functions
    except FunctionsError as error:
        file.refuse("functions", str(error))


def _tiers(file: TomlTable) -> tuple[str, ...]:
    """The tiers that the file selects besides plain."""
    names = file.texts("tiers", ())
    if "tiers" in file and not names:
        file.refuse("tiers", 'an empty list; wanted names, as ["plain", "accurate"]')
    try:
        return selected_tiers(names)
    except TiersError as error:
        file.refuse("tiers", str(error))


def _refuse_without_ranges(file: TomlTable, tiers: tuple[str, ...]) -> None:
    """Refuse tiers whose formats follow from the ranges of arguments, if the file states none."""
    if tiers and "ranges" not in file:
        for name in tiers_in_ranges():
            if name in tiers:
                file.refuse("tiers", f"the {name} tier needs the ranges of arguments; wanted "
                                     "[ranges] with the largest sizes, as v = 2 and a = 10")


def _selecting(scene: Scene, functions: tuple[str, ...]) -> Scene:
    """The scene with these functions selected.  Raises FunctionsError for unknown functions."""
    if functions:
        resolved(scene, functions)
    return replace(scene, functions=functions)


def _name(file: TomlTable) -> str:
    if "name" not in file:
        return scene_identifier(file.file.stem)
    name = file.text("name")
    if reason := refused(name):
        file.refuse("name", f"{shown(name)} {reason}; wanted a C identifier such as "
                            f"{scene_identifier(name)!r}")
    return name


def _refuse_still(file: Path, model: Model) -> None:
    """Refuse models in which nothing moves."""
    if not any(joint.kind.moves for joint in model.joints):
        raise SceneError(file, "model", 'has no joint that moves; base = "free" frees its root')


def _moving(table: TomlTable, key: str, scene: Scene) -> Joint:
    """The joint that a key of [start] names."""
    joints = {joint.name: joint for joint in scene.model.joints if joint.kind.moves}
    name = table.known(key, key, "joint that moves", joints)
    if leader := followers(scene).get(name):
        table.refuse(key, f"follows joint {leader.joint!r}; wanted the start of that one")
    return joints[name]


def _start_q(table: TomlTable, scene: Scene) -> Mapping[str, tuple[float, ...]]:
    """Coordinates by joint; quaternions normalised."""
    start = {}
    for key in table.values:
        joint = _moving(table, key, scene)
        numbers = _start(table, key, joint.kind.nq)
        for places in joint.kind.quaternions:
            refuse_not_unit(table, key, numbers[places])
            numbers = (*numbers[:places.start], *unit(numbers[places]), *numbers[places.stop:])
        start[key] = tuple(float(x) for x in numbers)
    return start


def _start_v(table: TomlTable, scene: Scene) -> Mapping[str, tuple[float, ...]]:
    return {key: tuple(float(x) for x in _start(table, key, _moving(table, key, scene).kind.nv))
            for key in table.values}


def _start_x(table: TomlTable, scene: Scene) -> Mapping[str, float]:
    """States of effects, by the names of their columns."""
    states = {x.name: x for x in states_of(scene)}
    by_effect = {key: states[table.known(key, key, "effect with states", states)]
                 for key in table.values}
    return {column: float(x) for key, own in by_effect.items() for column, x in zip(
        own.columns, _start(table, key, len(own.units)), strict=True)}


def _start(table: TomlTable, key: str, count: int) -> tuple[Fraction, ...]:
    value = table.values[key]
    if count == 1 and not isinstance(value, list):
        return (table.as_number(key, value),)
    return table.as_numbers(key, value, (count,))


def _record(outputs: TomlTable, scene: Scene) -> tuple[str, ...]:
    texts = outputs.texts("record", ("q", "v", STATES) if states_of(scene) else ("q", "v"))
    if not texts:
        outputs.refuse("record", 'an empty list; wanted quantities, as ["q", "v"]')
    try:
        return quantities_of(texts, scene)
    except QuantityError as error:
        outputs.refuse("record", str(error))


def _run(table: TomlTable) -> Run:
    table.only(*RUN.names)
    run = Run()
    duration, step, rtol, atol = (
        float(table.positive(key, Fraction(getattr(run, key))))
        for key in ("duration", "step", "rtol", "atol"))
    if step > duration:
        table.refuse("step", f"{step:g} s is longer than the duration, {duration:g} s")
    return Run(duration, table.choice("integrator", NAMES, run.integrator), step, rtol, atol)


def _expectations(file: TomlTable, scene: Scene) -> tuple[Expectation, ...]:
    """[expect]: a table for each quantity, or a list of tables."""
    expectations = []
    outer = file.table("expect")
    for quantity, value in outer.values.items():
        try:
            names = quantities_of((quantity,), scene)
            for name in names:
                expected(name, scene)
        except QuantityError as error:
            outer.refuse(quantity, f"{error}{_quotes(quantity, value)}")
        for given in value if isinstance(value, list) else [value]:
            if not isinstance(given, dict):
                outer.refuse(quantity, f"{described(given)}; wanted a table: at, value, rtol")
            table = TomlTable(file.file, outer.key(quantity), given)
            expectations += [_expectation(table, name, scene.run.duration) for name in names]
    return tuple(expectations)


def _quotes(quantity: str, value: object) -> str:
    """A hint for q.elbow = { … }, which TOML reads as a table q."""
    inside = [key for key, x in value.items() if isinstance(x, dict)] \
        if isinstance(value, dict) else []
    return f'; keys with a dot take quotes: "{quantity}.{inside[0]}" = …' if inside else ""


def _expectation(table: TomlTable, quantity: str, duration: float) -> Expectation:
    table.only(*EXPECT.names)
    at = float(table.nonnegative("at", Fraction(0)) if "at" in table else table.number("at"))
    if at > duration:
        table.refuse("at", f"{at:g} s is after the end of the run, {duration:g} s")
    rtol, atol = (table.nonnegative(key, Fraction(0)) for key in ("rtol", "atol"))
    if not rtol and not atol:
        table.missing("rtol", "a tolerance: rtol, atol or both")
    return Expectation(quantity, at, float(table.number("value")), float(rtol), float(atol))
