"""Playback: runs of a scene, its drawing and its signals, for every file that shows them.

    results ──▶ runs: poses, signals ─┐
    scene ──▶ drawing: parts, meshes ─┴▶ playback ──▶ page, recording of Rerun or of Foxglove"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from coscrew_codegen.runtime.extras import pip
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.function_selection import names
from coscrew_codegen.simulation import required_functions
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.system import System, system
from coscrew_codegen.simulation.view import page_signals
from coscrew_codegen.simulation.view.body_shapes import RobotDrawing, drawn
from coscrew_codegen.simulation.view.collision_shapes import add_collisions
from coscrew_codegen.simulation.view.page_runs import PageRun, run_of, target_of
from coscrew_codegen.simulation.view.page_signals import SignalGroup
from coscrew_codegen.simulation.view.part_places import numbers_of


@dataclass(frozen=True, eq=False)
class Playback:
    """Runs to be shown: the first is the result's, the others are its ghosts."""

    result: Result
    runs: tuple[PageRun, ...]
    drawing: RobotDrawing
    groups: tuple[SignalGroup, ...]

    @property
    def lacks(self) -> str:
        """Says that meshes are boxes since no package reads them; "" if none is."""
        if not self.drawing.unread:
            return ""
        several = self.drawing.unread > 1
        return (f"{self.drawing.unread} mesh{'es are' if several else ' is'} not shown, boxes of "
                f"inertia are in {'their' if several else 'its'} place; run `{pip('view')}`")


def playback(results: Sequence[Result], besides: Sequence[PageRun] = ()) -> Playback:
    """The playback of the first result, with the others, runs `besides` and targets as ghosts."""
    first = results[0]
    runs = [run_of(x, label) for x, label in zip(results, _labels(results), strict=True)]
    runs += besides
    if target := target_of(first.system, runs[0]):
        runs.append(target)
    groups = page_signals.grouped(first.system, first.recording.columns,
                                  [x.columns for x in runs])
    drawing = drawn(first.system)
    add_collisions(drawing, first.system.scene.model)
    return Playback(first, tuple(runs), drawing, tuple(groups))


def with_poses(result: Result) -> Result:
    """The result with a system that has the poses of all bodies, and all contacts."""
    its = result.system
    if all(map(its.has, {*required_functions.VIEWED}.intersection(names(its.scene)))):
        return result
    kernels = kernels_for(its.scene, required_functions.of_run(
        its.scene, result.plan.integrator, view=True), (its.precision.name,))
    return replace(result, system=replace(system(kernels, its.precision.name), p=its.p))


def _labels(results: Sequence[Result]) -> list[str]:
    """The results' precisions, or numbers where these are the same."""
    names = [x.system.precision.name for x in results]
    return names if len({*names}) == len(names) else [f"run {n + 1}" for n, _ in enumerate(names)]


def unique_labels(shown: Playback) -> list[str]:
    """The labels of the runs, with a number where another run before has the same."""
    labels = [x.label for x in shown.runs]
    return [f"{x} ({labels[:n].count(x) + 1})" if x in labels[:n] else x
            for n, x in enumerate(labels)]


def up_of(system: System) -> list[float]:
    """The direction opposite to gravity, or z without gravity."""
    for applied in system.scene.effects:
        if applied.effect.name == "gravity":
            g = numbers_of(system, applied.vector("g"))
            if np.any(g):
                return [float(x) for x in -g / np.linalg.norm(g)]
    return [0.0, 0.0, 1.0]
