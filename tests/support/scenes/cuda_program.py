"""A C++ program that compares the kernels of a scene's CUDA header with its C functions, bit for
bit: on the host, the threads of a grid one after another, or on a device.

On the host they execute the header, compiled as C++, or the instructions that a compiler makes of
it for a device.  Six threads take up to 70 states, so that a thread takes several.
"""

from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.backends.cuda import cuda_kernels, scene_cuda
from coscrew_codegen.backends.cuda.cuda_kernels import c_name_of
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.backends.target import Files
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature
from coscrew_codegen.program.values.formats import Precision, named
from tests.support.scenes import lanes_program
from tests.support.scenes.generated_scenes import BANNER

GRID = """
#include <stddef.h>
struct Place { unsigned x; };
extern "C" {
Place blockIdx, threadIdx;
extern const Place gridDim, blockDim;
const Place gridDim = {2}, blockDim = {3};
}
template <class... T> struct OnGrid {
  void (*kernel)(T...);
  void operator()(T... x) const {
    for (blockIdx.x = 0; blockIdx.x < gridDim.x; ++blockIdx.x)
      for (threadIdx.x = 0; threadIdx.x < blockDim.x; ++threadIdx.x) kernel(x...);
  }
};
template <class... T> static OnGrid<T...> on_grid(void (*kernel)(T...)) { return {kernel}; }
"""

_ON_DEVICE = """
#include <cuda_runtime.h>
static void *managed(size_t bytes) {
  void *found = 0;
  return cudaMallocManaged(&found, bytes) ? 0 : found;
}
#define malloc managed
#define free cudaFree
template <class... T> struct OnDevice {
  cudaError_t (*launch)(T...);
  template <class... Given> void operator()(Given... given) const {
    if (launch(given..., 0) || cudaDeviceSynchronize()) ++wrong;
  }
};
template <class... T> static OnDevice<T...> on_device(cudaError_t (*launch)(T...)) {
  return {launch};
}
"""

TRANSLATED = """\
#ifdef __NVCC__
#define KSL_KERNEL extern "C" __global__
#else
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __launch_bounds__(...) __attribute__((launch_bounds(__VA_ARGS__)))
#define __CUDACC_RTC__
#define KSL_KERNEL extern "C" __global__
#include <__clang_cuda_builtin_vars.h>
static __device__ float __int_as_float(int x) { return __builtin_bit_cast(float, x); }
#endif
"""
"""What clang's own headers declare where CUDA is installed."""


@dataclass(frozen=True)
class Scene:
    """A scene or a tier of it: the C with which its kernels are compared, and their header."""

    scene: SceneFunctions
    stem: str
    files: Files

    def on_host(self, folder: Path) -> tuple[Path, ...]:
        """The program, whose kernels are the header's as C++, and the C; beside the headers."""
        return self._written(folder, "cuda.cpp", self._grid(
            f'#define KSL_KERNEL static\n#include "{self.stem}.cuh"\n'))

    def translated(self, folder: Path) -> tuple[Path, ...]:
        """The file from which kernels of C linkage are made, and the program to be linked with
        them."""
        kernels = [x for p in named(self.scene.precisions)
                   for x in cuda_kernels.kernels(self.scene, self.scene, p)]
        declared = (f"{x.kernel};\n".replace("KSL_KERNEL", 'extern "C"') for x in kernels)
        (folder / "device.cu").write_text(f'{TRANSLATED}#include "{self.stem}.cuh"\n')
        written = self._written(folder, "cuda.cpp", self._grid("".join(declared)))
        return folder / "device.cu", *written

    def on_device(self, folder: Path) -> tuple[Path, ...]:
        """The program that launches the kernels on a device."""
        return self._written(folder, "cuda.cu", lanes_program.Compared(
            f'#include "{self.stem}.h"\n#include "{self.stem}.cuh"',
            partial(_called, self.scene, "launch"), _ON_DEVICE))

    def _grid(self, kernels: str) -> lanes_program.Compared:
        return lanes_program.Compared(f'#include "{self.stem}.h"\n{GRID}{kernels}',
                                      partial(_called, self.scene, "kernel"))

    def _written(self, folder: Path, name: str, compared: lanes_program.Compared
                 ) -> tuple[Path, ...]:
        for path, content in {**self.files, name: lanes_program.text(self.scene, compared)}.items():
            (folder / path).write_text(content)
        return folder / name, *(folder / x for x in self.files if x.endswith(".c"))


def of_scene(scene: SceneFunctions) -> Scene:
    """The functions of a scene."""
    return Scene(scene, scene.name, scene_c.files(scene, BANNER) | scene_cuda.files(scene, BANNER))


def of_tier(made: SceneTier) -> Scene:
    """The functions of a tier."""
    scene = replace(made.first, precisions=tuple(p.name for p, _ in made.in_precisions))
    return Scene(scene, made.stem,
                 scene_c_tier.files(made, BANNER) | scene_cuda.tier_files(made, BANNER))


def _called(scene: SceneFunctions, what: str, function: Signature, precision: Precision) -> str:
    where = {"kernel": "on_grid", "launch": "on_device"}[what]
    return f"{where}({c_name_of(scene, function.name, precision, what)})"
