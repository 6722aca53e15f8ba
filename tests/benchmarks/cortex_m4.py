"""Cost of accuracy on a Cortex-M4F, whose double precision is software: instructions of a call,
counted under qemu-user, with the largest errors found; and the cost of mixtures that reach a
requested accuracy."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.accuracy.precision_tuning.choice import AccuracyError, chosen
from coscrew_codegen.backends import emit
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.reports.cost.needs.cortex_m4 import built, counted
from coscrew_codegen.runtime.load import Kernels, load_scene
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene, Tolerance
from tests.support.scenes.robots import scene_of
from tests.support.scenes.tiers import results, states

ARM6 = Path(__file__).parents[2] / "examples" / "scenes" / "arm6.toml"
ROBOTS = {"UR5": "ur_description/urdf/ur5_robot.urdf",
          "Panda": "panda_description/urdf/panda.urdf"}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics")
TIERS = ("accurate", "pairs")
VARIANTS = ((SINGLE, ""), (SINGLE, "pairs"), (SINGLE, "accurate"), (DOUBLE, ""))
STATES = 100
ASKED = {"inverse_dynamics": (1e-5, 2e-5, 5e-5), "forward_dynamics": (1e-3,)}  # N m, rad/s²


def measured(kernels: Kernels, function: FunctionProgram,
             folder: Path) -> Iterator[tuple[object, ...]]:
    """A line for each variant: instructions, their ratio to plain's, worst error in units of
    single's last digit, and that below a condition of 1000."""
    least = 0
    given = states(kernels.functions, function, STATES, SINGLE)  # numbers of both precisions
    first = [x[0] for x in given]
    for precision, tier in VARIANTS:
        in_tier = getattr(kernels, tier) if tier else kernels
        stem = "_".join(filter(None, (kernels.interface.name, tier)))
        name = "_".join(filter(None, (kernels.interface.name, function.name, tier)))
        made = folder / f"{stem}_{precision.name}.o"
        if not made.exists():
            built(folder, stem, precision)
        count, there = counted(made, stem, function, f"{name}{precision.suffix}", first, precision)
        result = getattr(getattr(in_tier, precision.name), function.name)(
            *(x.astype(precision.numpy_type) for x in given))
        assert np.array_equal(there, np.ravel(result[0])), "other bits than here"
        judged = [(x.ulps(SINGLE), x.condition) for x in results(function.program, given, result)
                  if x.true]
        least = least or count
        yield (function.name, precision.name, tier or "plain", count, f"{count / least:.1f}",
               f"{max(u for u, _ in judged):.2g}",
               f"{max(u for u, condition in judged if condition < 1000):.2g}")


def rows() -> Iterator[tuple[object, ...]]:
    """The lines of every robot."""
    for name, scene in _scenes():
        kernels = load_scene(scene, functions=FUNCTIONS, tiers=TIERS)
        with TemporaryDirectory() as folder:
            emit.write({x: text for x, text in scene_files(kernels.functions).items()
                        if x.endswith((".c", ".h"))}, Path(folder))
            for function in kernels.functions.functions:
                if not function.internal:
                    for row in measured(kernels, function, Path(folder)):
                        yield name, *row


def mixtures() -> Iterator[tuple[object, ...]]:
    """Mixtures of every robot and accuracy: instructions in the mixed tier and in pairs, and the
    largest error certified at the drawn states."""
    for name, scene in _scenes():
        for function, accuracies in ASKED.items():
            for within in accuracies:
                yield name, function, f"{within:g}", *_mixed(scene, function, within)


def _mixed(scene: Scene, function: str, within: float) -> tuple[object, ...]:
    made = derive(replace(scene, functions=(function,), tiers=("mixed", "pairs"),
                          accuracy=(Tolerance(function, "", within),)))
    f, counts = made.named(function), []
    assert f.accuracy
    try:
        choice = chosen(f.program, f.accuracy)
    except AccuracyError as error:
        return str(error).rpartition("; ")[-1], "", "", "", ""
    given = [x[0] for x in states(made, f, 1, SINGLE)]
    with TemporaryDirectory() as folder:
        emit.write({x: text for x, text in scene_files(made).items()
                    if x.endswith((".c", ".h"))}, Path(folder))
        for tier in ("", "mixed", "pairs"):
            stem, name = ("_".join(filter(None, x)) for x in (
                (made.name, tier), (made.name, function, tier)))
            objects = built(Path(folder), stem, SINGLE)
            counts.append(counted(objects, stem, f, f"{name}f", given, SINGLE)[0])
    share = f"{choice.paired} of {len(f.program.instructions)}"
    return (*counts, share, f"{max(choice.worst):.2g}")


def _scenes() -> Iterator[tuple[str, Scene]]:
    yield "arm6", read_scene(ARM6)
    for name, file in ROBOTS.items():
        yield name, scene_of(file)


def main() -> None:
    """Print the table."""
    print(f"\nCortex-M4F (gcc -O2, qemu-arm): instructions of a call; errors of {STATES} states in "
          "units of single's last digit")
    print(tabulate(rows(), ("robot", "function", "precision", "tier", "instructions", "ratio",
                            "worst", "worst, condition < 1000"), disable_numparse=True))
    print("\nFunctions of an asked accuracy, in N m, rad/s²: instructions of a call")
    print(tabulate(mixtures(), ("robot", "function", "asked", "plain", "mixed", "pairs",
                                "instructions in pairs", "certified"), disable_numparse=True))


if __name__ == "__main__":
    main()
