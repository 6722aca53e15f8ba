"""The tables [effects.*] of a scene file as Applied effects.

An effect on joints or bodies is given for several at once, with `joints = "all"` or a list of them,
or by tables of its parameters ({ elbow = 0.1 }); or in a table for each, [effects.stribeck.elbow];
or on a weighted sum of joints' coordinates, under a label, with joints = { one = 1, other = -0.5 }.
A table under the name of a joint or body belongs to it, even if a parameter has the same name.
"""

from collections.abc import Iterator, Mapping

from coscrew_codegen.scene.effect import Effect, Place
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.names import MANY as MANY_NAMES
from coscrew_codegen.scene.names import did_you_mean, nearest
from coscrew_codegen.scene.patterns import PatternError, expanded
from coscrew_codegen.scene.readers.part_tables import completed, on_parts
from coscrew_codegen.scene.readers.toml.effect_table import ALL, MANY, MODEL, EffectTable, Use
from coscrew_codegen.scene.readers.toml.pair_tables import on_pairs
from coscrew_codegen.scene.readers.toml.sum_terms import read_terms
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described
from coscrew_codegen.scene.readers.toml.trajectories.trajectory_table import is_trajectory
from coscrew_codegen.scene.recorded_quantities import expected, recorded
from coscrew_codegen.scene.scene import Applied, Scene


def read_effects(effects: TomlTable, model: Model, catalogue: tuple[Effect, ...], use: Use
                 ) -> tuple[Applied, ...]:
    """The effects in the catalogue's order, each on joints or bodies in the model's order.

    Raises SceneError for anything unknown, missing, given twice or out of range."""
    effects.only(*(effect.name for effect in catalogue))
    readers = {Place.SCENE: _on_scene, Place.JOINT: _on_several, Place.BODY: _on_several,
               Place.PAIR: on_pairs}
    applied: list[Applied] = []
    for effect in catalogue:
        if effect.name in effects:
            reading = EffectTable(effect, effects.table(effect.name), model, use)
            applied += on_parts(reading) if effect.parts else readers[effect.place](reading)
    if any(x.effect.completed for x in applied):
        applied = completed(effects, model, applied)
    _refuse_on_followers(effects, model, applied)
    return tuple(applied)


def _refuse_on_followers(effects: TomlTable, model: Model, effects_read: list[Applied]) -> None:
    """Refuse gears and compensation of gravity at joints that follow others; the latter also where
    there is no gravity."""
    falls, follows = (any(getattr(x.effect, name) for x in effects_read)
                      for name in ("gravity", "mimic"))
    leaders = {j.name: j.mimic.joint for j in model.joints if j.mimic and follows}
    for applied in effects_read:
        flag, table = applied.effect.compensates, effects.table(applied.effect.name)
        if applied.effect.elastic and applied.on in leaders:
            table.refuse(applied.on, f"joint {applied.on!r} follows {leaders[applied.on]!r}, whose "
                                     f"rotor drives both; wanted {applied.effect.name} there")
        if not flag or applied.values[flag] is None:
            continue
        if applied.terms:
            table.refuse(flag, f"{applied.name} acts on a sum of coordinates, which no torque "
                               f"holds; wanted no {flag} there")
        if not falls:
            table.refuse(flag, f"the scene of {applied.name} has no gravity; wanted "
                               f"[effects.gravity], or no {flag}")
        if applied.on in leaders:
            table.refuse(flag, f"joint {applied.on!r} follows {leaders[applied.on]!r}, which holds "
                               f"its weight; wanted {flag} there")


def _on_scene(reading: EffectTable) -> list[Applied]:
    """[effects.gravity] g = …"""
    table = reading.table
    table.only(*reading.parameters)
    applied = Applied(reading.effect, "", reading.values(table, table.values, ""))
    if reading.effect.mimic:
        _refuse_wrong_mimics(reading)
        following = {(j.name, "mimic") for j in reading.model.joints if j.mimic}
        if not following:
            table.refuse("", "no joint of the model follows another; wanted mimic = { joint, … } "
                             f"of a joint, or no {reading.effect.name}")
        reading.use.of_model |= following
    return [applied]


def _refuse_wrong_mimics(reading: EffectTable) -> None:
    """Refuse followers that cannot follow, the first ones by name."""
    wrong = [(joint.name, fault) for joint in reading.model.joints
             if (fault := joint.fault("mimic"))]
    listed = ", ".join(f"joint {name!r} cannot follow ({fault})"
                       for name, fault in wrong[:MANY])
    if wrong:
        reading.table.refuse("", f"{listed}{', …' * (len(wrong) > MANY)}; mend the file, or leave "
                                 f"out {reading.effect.name}")


def _on_several(reading: EffectTable) -> list[Applied]:
    """[effects.viscous] joints = …, d = …, and [effects.viscous.elbow] d = …"""
    table = reading.table
    plain = {key: value for key, value in table.values.items()
             if key in (*reading.parameters, reading.several) and not _is_place(reading, key)}
    for key, value in table.values.items():
        if key not in plain and not isinstance(value, dict):
            _refuse_unknown(reading, key)
    if not table.values:
        _refuse_nowhere(reading)
    effects_read = [_in_own_table(reading, key) for key in table.values if key not in plain]
    effects_read += _on_named(reading, plain, {x.on for x in effects_read if not x.label})
    order = {name: i for i, name in enumerate(reading.targets)}
    effects_read.sort(key=lambda applied: (order.get(applied.on, len(order)), applied.label))
    for one, next_one in zip(effects_read, effects_read[1:], strict=False):
        if (one.on, one.label) == (next_one.on, next_one.label):
            table.refuse(one.on, f"{reading.effect.name} is given twice for {reading.what} "
                                 f"{one.on!r}; wanted it once")
    return effects_read


def _is_place(reading: EffectTable, key: str) -> bool:
    """Returns whether a key that is a parameter's name stands for a joint or body: if its value is
    a table.

    Raises SceneError if that table could also hold the parameter for each joint or body."""
    given = reading.table.values[key]
    if not isinstance(given, dict):
        return False
    if key in reading.targets:
        if given and key in reading.parameters and all(name in reading.targets for name in given):
            place = f"[{reading.table.where}.{reading.what.upper()}]"
            reading.table.refuse(key, f"{key!r} is a {reading.what} and a parameter, and this "
                                      f'table could be of either; wanted {reading.several} = '
                                      f'["{key}"] with numbers, or tables {place} of the others')
        return True
    label = "body" if reading.what == "body" else reading.several
    if label in given and label not in reading.targets and (
            reading.what == "body" or isinstance(given[label], dict)):
        reading.table.refuse(key, f"{key!r} is a parameter; wanted another label")
    return False


def _refuse_unknown(reading: EffectTable, key: str) -> None:
    known = (*reading.parameters, reading.several)
    every = (*known, *reading.targets)
    listed = nearest(key, every) or len(every) <= MANY_NAMES
    wanted = did_you_mean(key, every if listed else known)
    reading.table.refuse(key, f"unknown key; {wanted}")


def _in_own_table(reading: EffectTable, key: str) -> Applied:
    """[effects.viscous.elbow], or under a label [effects.wrench.push] body = "tool"."""
    table = reading.table
    own = table.table(key)
    if reading.what == "body" and "body" in own:
        if key in reading.targets:  # in `runtime`, its name would mean two effects
            own.refuse("body", f"{key!r} is itself a body; wanted another label")
        own.only("body", *reading.parameters)
        on = reading.target(own, "body", own.text("body"))
        return Applied(reading.effect, on, reading.values(own, own.values, on), key)
    if reading.what == "joint" and isinstance(own.values.get("joints"), dict):
        if not reading.sums:
            own.refuse("joints", f"{reading.effect.name} acts on joints, not on a sum of their "
                       "coordinates; wanted a table for each joint")
        return _on_sum(reading, own, key)
    label = "; or body = … under a label" if reading.what == "body" else (
        "; or joints = { … } under a label" if reading.sums else "")
    if key not in {x.name for x in reading.elements}:
        if reading.several in own.values or key == "all":
            table.refuse(key, f"no {reading.what} {key!r}; wanted {reading.several} = \"all\" or a "
                              f"list of names in [{table.where}] itself, or a table for each "
                              f"{reading.what}{label}")
        known = (*reading.targets, *reading.parameters, reading.several)
        table.refuse(key, f"no {reading.what} {key!r}{label}; {did_you_mean(key, known)}")
    on = reading.target(table, key, key)
    own.only(*reading.parameters)
    return Applied(reading.effect, on, reading.values(own, own.values, on))


def _on_sum(reading: EffectTable, own: TomlTable, label: str) -> Applied:
    """[effects.spring.tendon] joints = { one = 1, other = -0.5 }"""
    if label in {x.name for x in reading.elements}:
        own.refuse("joints", f"{label!r} is itself a joint; wanted another label for a sum")
    own.only("joints", *reading.parameters)
    terms = read_terms(own.table("joints"), reading.model)
    given = {key: value for key, value in own.values.items() if key != "joints"}
    return Applied(reading.effect, label, reading.values(own, given, label), label, terms)


def _on_named(reading: EffectTable, plain: Mapping[str, object], elsewhere: set[str]
              ) -> Iterator[Applied]:
    """joints = "all", which stands for those without a table `elsewhere`, or a list, or the joints
    that tables of parameters name."""
    if not plain:
        return
    table, several = reading.table, reading.several
    by_target = {key: table.table(key) for key, value in plain.items()
                 if isinstance(value, dict) and key != several and not _is_one(reading, value)}
    for of_each in by_target.values():
        for name in of_each.values:
            reading.target(of_each, name, name)
    if not reading.targets:
        reading.refuse_none()
    chosen, named = _chosen(reading, plain.get(several), by_target, elsewhere)
    for key, of_each in by_target.items():
        for name in of_each.values:
            if name not in chosen:
                of_each.refuse(name, f"is not among the {several} of {table.key(several)}")
        for name in chosen:
            if name not in of_each:
                of_each.missing(name, f"{key} of {reading.what} {name!r}, as for the others")
    applied = False
    for name in chosen:
        given = {key: by_target[key].values[name] if key in by_target else value
                 for key, value in plain.items() if key != several}
        values = reading.values(table, given, name, named)
        if values is not None:
            applied = True
            yield Applied(reading.effect, name, values)
    if not applied:
        lacking = ", ".join(p.model for p in reading.effect.parameters
                            if p.model and plain.get(p.name, p.default) == MODEL)
        table.refuse("", f"no {reading.what} of the model has {lacking}; wanted numbers, or no "
                         f"{reading.effect.name}")


def _is_one(reading: EffectTable, value: object) -> bool:
    """Returns whether a table is one trajectory, not values by joint or body."""
    return is_trajectory(value) and "file" not in reading.targets


def _chosen(reading: EffectTable, several: object, by_target: Mapping[str, TomlTable],
            elsewhere: set[str]) -> tuple[tuple[str, ...], bool]:
    """The targets in the model's order, and whether they were named one by one."""
    table = reading.table
    if several is None:
        names = {name for of_each in by_target.values() for name in of_each.values}
        if not names:
            _refuse_nowhere(reading)
    elif several == ALL:
        if not (every := reading.all_targets(table.values)):
            table.refuse(reading.several, f'"{ALL}" with numbers means joints with one coordinate, '
                         "and there is none; wanted a list of names, as "
                         f'["{next(iter(reading.targets))}"]')
        if not (others := tuple(name for name in every if name not in elsewhere)):
            table.refuse(reading.several, f'"{ALL}" stands for those without a table of their own, '
                                          f"and each {reading.what} has one; wanted no "
                                          f"{reading.several}")
        return others, False
    elif isinstance(several, list):
        names = {reading.target(table, reading.several, name)
                 for name in _listed(reading, table.as_texts(reading.several, several))}
        if not names:
            table.refuse(reading.several, f'an empty list; wanted "{ALL}" or names')
    else:
        table.refuse(reading.several, f'{described(several)}; wanted "{ALL}" or a list of names')
    return tuple(name for name in reading.targets if name in names), True


def _listed(reading: EffectTable, given: tuple[str, ...]) -> tuple[str, ...]:
    """Names of joints or bodies, patterns among them replaced by those on which it can act."""
    try:
        return expanded(given, reading.all_targets({}), tuple(reading.targets))
    except PatternError as error:
        reading.table.refuse(reading.several, str(error))


def _refuse_nowhere(reading: EffectTable) -> None:
    name = reading.table.where
    reading.table.missing(reading.several, f'{reading.several} = "{ALL}", a list of names, or '
                                           f"tables [{name}.{reading.what.upper()}]")


def with_reactions(scene: Scene, catalogue: tuple[Effect, ...]) -> tuple[Applied, ...]:
    """The effects of a scene, with a reaction for each joint whose reaction is recorded or
    expected."""
    effect = next((effect for effect in catalogue if effect.reaction), None)
    wanted = {recorded(text, scene) for text in scene.record}
    wanted |= {expected(x.quantity, scene) for x in scene.expectations}
    there = {applied.on for applied in scene.effects if applied.effect is effect}
    joints = {x.target for x in wanted if x.quantity == "reaction"} - there
    if effect is None or not joints:
        return scene.effects
    effects = [*scene.effects, *(Applied(effect, joint.name, {}) for joint in scene.model.joints
                                 if joint.name in joints)]
    return tuple(sorted(effects, key=lambda applied: catalogue.index(applied.effect)))
