"""`coscrew effects` prints every effect with its equation, parameters and units."""

from dataclasses import replace

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.effect import Effect, ParameterOf, Place
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.effect_syntax import described

NAMES = tuple(effect.name for effect in EFFECTS)


def test_effects_are_in_order_and_each_fills_a_slot():
    assert tuple(sorted(NAMES)) == NAMES
    for effect in EFFECTS:
        slots = (effect.gravity, effect.wind, effect.ground, effect.joint_torque,
                 effect.joint_inertia, effect.body_force, effect.body_inertia, effect.pair_force,
                 effect.bodies_force, effect.reaction, effect.mimic)
        assert sum(map(bool, slots)) == 1, effect.name
        assert effect.place is not Place.PAIR or effect.pair_force or effect.bodies_force


@pytest.mark.parametrize("effect", EFFECTS, ids=lambda effect: effect.name)
def test_an_effect_is_printed_with_all_that_a_scene_needs(effect, capsys):
    assert main(["effects", effect.name]) == 0
    printed = capsys.readouterr().out
    assert all(len(line) <= 100 for line in printed.splitlines())
    flat = " ".join(printed.split())
    assert effect.words in flat and " ".join(effect.equation.split()) in flat
    for parameter in effect.parameters:
        unit = f" [{parameter.unit}]" if parameter.unit else ""
        assert f"{parameter.name}{unit}: {parameter.words}" in flat
        for choice in parameter.choices:
            assert choice in flat


def test_all_are_printed_in_order(capsys):
    assert main(["effects"]) == 0
    heads = [line.split(":")[0] for line in capsys.readouterr().out.splitlines()
             if line and not line.startswith(" ")]
    assert tuple(heads) == NAMES


def test_a_wrong_name_is_told_the_nearest(capsys):
    assert main(["effects", "dragg"]) == 2
    assert "did you mean 'drag'" in capsys.readouterr().err


def test_alternatives_are_told():
    effect = Effect("stop", "ends", "…", Place.JOINT,
                    (ParameterOf("lower", "rad", "lower end", required=False),
                     ParameterOf("upper", "rad", "upper end", required=False)),
                    any_of=("lower", "upper"))
    assert list(described(effect))[-1].strip() == "at least one of lower and upper"
    of_model = replace(effect, parameters=tuple(replace(x, model=x.name)
                                                for x in effect.parameters))
    assert list(described(of_model))[-1].strip() == \
        "at least one of lower and upper, here or in the model"
