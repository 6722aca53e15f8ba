"""Random robots keep the promises of the accurate and the certified tier; `make attack` judges
sixty of them."""

from dataclasses import replace

import pytest

from coscrew_codegen.dynamics import derive
from tests.robots_attack import judged, summary
from tests.support.truth.robots import robot

ROBOTS = 60


@pytest.mark.parametrize("number", (23, 41))
def test_tiers_keep_their_promises(number: int):
    results = list(judged(robot(number), 3))
    assert not [x for x in results if x.broken], summary(results)
    assert sum(x.judged for x in results) > len(results) / 2 and any(x.stated for x in results)
    assert [x for x in results if replace(x, bound=float(x.error) / 2).broken]


def test_robots_are_all_different_trees():
    made = [robot(k) for k in range(ROBOTS)]
    assert len({tuple(x.parent for x in r.scene.model.joints) for r in made}) > ROBOTS / 2
    kinds = [{x.kind.name for x in r.scene.model.joints} for r in made]
    assert sum(len(x) == 3 for x in kinds) > ROBOTS / 10
    names = {x.effect.name for r in made for x in r.scene.effects}
    assert names == {"gravity", "spring", "viscous", "coulomb", "armature"}
    assert robot(3) == robot(3)


def test_coordinates_are_in_the_order_of_the_joints():
    for k in range(3):
        scene = robot(k).scene
        assert [c.joint for c in derive(scene).coordinates] == [
            x.name for x in scene.model.joints if x.kind.name != "fixed"]
