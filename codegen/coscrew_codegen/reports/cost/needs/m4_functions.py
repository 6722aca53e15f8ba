"""A scene's function in every tier and precision as instructions of a Cortex-M4F."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.backends.scene.scene_text import banner_of, c_name
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.reports.cost.measured import TierChoice
from coscrew_codegen.reports.cost.needs import cortex_m4


@dataclass(frozen=True)
class FunctionOnM4:
    """A function of a scene that is measured on this machine, too."""

    built: CompiledLoops
    name: str

    def estimated(self, choice: TierChoice) -> int:
        """Instructions of a call by its operations."""
        tier = self._tier(choice)
        scene = dict(tier.in_precisions)[choice.precision] if tier else self._plain
        return cortex_m4.estimated(scene.named(self.name), choice.precision)

    def counted(self, choice: TierChoice, state: Sequence[Sequence[float]]) -> int:
        """Instructions of a call at this state, counted.  Raises CountError."""
        tier, banner = self._tier(choice), banner_of(self._plain.name)
        scene, stem = (tier.first, tier.stem) if tier else (self._plain, self._plain.name)
        files = scene_c.files(self._plain, banner) | (
            scene_c_tier.files(tier, banner) if tier else {})
        with TemporaryDirectory() as folder:
            for file, text in files.items():
                (Path(folder) / file).write_text(text, encoding="utf-8")
            compiler = cortex_m4.COMPILER
            made = cortex_m4.built(Path(folder), stem, choice.precision, compiler)
            return cortex_m4.counted(
                made, stem, scene.named(self.name), c_name(scene, self.name, choice.precision),
                [np.array(x) for x in state], choice.precision, compiler)[0]

    @cached_property
    def _plain(self) -> SceneFunctions:
        return derive(self.built.part.scene, (self.name,))

    def _tier(self, choice: TierChoice) -> SceneTier | None:
        """The tier with this function alone."""
        tier = next((x for x in self.built.tiers if x.tier.name == choice.tier), None)
        return tier and replace(tier, plain=self._only(tier.plain), in_precisions=tuple(
            (p, self._only(scene)) for p, scene in tier.in_precisions))

    def _only(self, scene: SceneFunctions) -> SceneFunctions:
        return replace(scene, functions=tuple(f for f in scene.functions if f.name == self.name))
