"""Compiles kernels of scenes for CUDA with nvcc, plain and in tiers, and compares them with C.

`python -m tests.cuda_attack [--function NAME ...] [SCENE ...]`, or `make cuda`: the instructions,
executed on the host, have the bits of C, and no flag changes them; kernels and launches assemble
without a warning; where there is a device, kernels are launched and have the bits of C.  Fixed
point has those of NumPy's integers: `--fixed` runs these alone.
"""

import argparse
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from coscrew_codegen.accuracy.fixed_scene import in_fixed
from coscrew_codegen.accuracy.scene_tiers import in_tier, tiers_of
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.compiled import nvcc
from tests.support.compiled.c_harness import C11, COMPILERS, run
from tests.support.scenes import fixed_cuda, fixed_robots
from tests.support.scenes.cuda_program import Scene, of_scene, of_tier
from tests.support.scenes.cuda_runs import FLAGS, executed
from tests.support.scenes.generated_scenes import pendulum, slider, spinner

EXAMPLES = Path(__file__).parents[1] / "examples" / "scenes"
TIERS = ("accurate", "certified", "pairs")
ARCHITECTURES = ("sm_80", "sm_90", "sm_100")


def by_hand() -> Iterator[Scene]:
    """Scenes that call every elementary function, have time and parameters, quaternions; tiers."""
    yield from (of_scene(make()) for make in (pendulum, slider, spinner))
    yield from (of_tier(in_tier(pendulum(), tier_named(tier))) for tier in TIERS)


def of_example(name: str, functions: tuple[str, ...]) -> Iterator[Scene]:
    """The scene's functions; forward dynamics in tiers."""
    path = EXAMPLES / f"{name}.toml"
    yield of_scene(derive(read_scene(path, overrides=SceneOverrides(functions=functions))))
    yield from map(of_tier, tiers_of(derive(read_scene(path, overrides=SceneOverrides(
        functions=("forward_dynamics",), tiers=TIERS)))))


def assembled(program: Path, folder: Path) -> Iterator[str]:
    """Assembles for each architecture: the most registers of a kernel, and whether registers are
    spilled."""
    for architecture in ARCHITECTURES:
        text = nvcc.run(program, folder / "cuda.o", "-c", f"-arch={architecture}", "-Xptxas", "-v",
                        "-Werror", "all-warnings")
        registers = max(map(int, re.findall(r"Used (\d+) registers", text)))
        spilled = max(map(int, re.findall(r"(\d+) bytes spill stores", text)))
        yield f"{architecture}: {registers} registers, {spilled} bytes spilled"


def launched(scene: Scene, folder: Path) -> str:
    """Compares numbers on a device, which are the same; returns how many."""
    program, *references = scene.on_device(folder)
    for path in references:
        run((COMPILERS[0], *C11, "-c", path, "-o", path.with_suffix(".o")))
    nvcc.run(program, folder / "cuda", "-arch=native", *FLAGS["nvcc"],
             *(str(x.with_suffix(".o")) for x in references))
    return run([folder / "cuda"]).strip()


def in_fixed_point(device: bool) -> None:
    """Compares fixed point: the gimbal's functions, and a Panda's inverse dynamics."""
    gimbal = derive(read_scene(EXAMPLES.parent / "fixed_point" / "gimbal.toml"))
    for made in (in_fixed(gimbal, tier_named("fixed")),
                 fixed_robots.fixed("Panda", ("inverse_dynamics",))):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            library, _ = fixed_cuda.translated(made, folder, "nvcc")
            print(f"{made.stem}: {fixed_cuda.compared(library, made)} integers", flush=True)
            for line in assembled(fixed_cuda.device_program(made, folder), folder):
                print(f"  {line}", flush=True)
            if device:
                library = fixed_cuda.on_device(made, folder)
                compared = fixed_cuda.compared(library, made, 100_000)
                print(f"  on the device: {compared} integers", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fixed", action="store_true", help="fixed point alone")
    parser.add_argument("--function", metavar="NAME", action="append",
                        help="of the scenes' functions, instead of the default ones")
    parser.add_argument("scenes", metavar="SCENE", nargs="*")
    options = parser.parse_args()
    names = options.scenes
    if not nvcc.NVCC:
        print('no nvcc: run `pip install "coscrew[cuda]"`', file=sys.stderr)
        return 2
    device = nvcc.has_device()
    print("a device runs the kernels" if device else "no device: kernels are executed on the host")
    if options.fixed or not names:
        in_fixed_point(device)
    if options.fixed:
        return 0
    functions = tuple(options.function or ("default",))
    for scenes in (of_example(x, functions) for x in names) if names else (by_hand(),):
        for scene in scenes:
            with tempfile.TemporaryDirectory() as folder:
                compared, _ = executed(scene, Path(folder), "nvcc")
                print(f"{scene.stem}: {compared} numbers", flush=True)
                program, *_ = scene.on_device(Path(folder))
                for line in assembled(program, Path(folder)):
                    print(f"  {line}", flush=True)
                if device:
                    print(f"  on the device: {launched(scene, Path(folder))} numbers", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
