"""CUDA kernels of a scene in fixed point, called as a shared library: compiled as C++, translated
instruction by instruction, or on a device."""

import ctypes
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.backends.cuda.cuda_kernels import CudaKernel
from coscrew_codegen.backends.fixed import scene_cuda_fixed
from coscrew_codegen.program.fixed.fixed_program import Products
from tests.support.compiled import nvcc
from tests.support.compiled.c_harness import COMPILERS, CXX_COMPILERS, STRICT, run
from tests.support.compiled.ptx import to_c
from tests.support.scenes import fixed_point as fx
from tests.support.scenes.cuda_program import GRID, TRANSLATED
from tests.support.scenes.cuda_runs import CXX11, FLAGS, WITHOUT, ptx_of

GAP = 2  # integers between rows
_STATES = 70
_LAUNCHED = """
#include <cuda_runtime.h>
#include <string.h>
static int32_t *managed(const int32_t *from, size_t count) {
  void *made = 0;
  if (cudaMallocManaged(&made, count * sizeof *from + 4)) return 0;
  memcpy(made, from, count * sizeof *from);
  return (int32_t *)made;
}
"""


def written(made: FixedScene, folder: Path) -> None:
    """Writes the header and coscrew_fixed.h."""
    for path, text in scene_cuda_fixed.files(made, "for a test").items():
        (folder / path).write_text(text)


def on_host(made: FixedScene, folder: Path, compiler: str, *flags: str) -> ctypes.CDLL:
    """The kernels as C++."""
    written(made, folder)
    program = folder / "cuda.cpp"
    program.write_text("\n".join((
        GRID, "#define KSL_KERNEL static", f'#include "{made.stem}.cuh"',
        *map(_on_grid, scene_cuda_fixed.kernels(made)), "")))
    return _opened(folder, compiler, *flags, *STRICT, program)


def translated(made: FixedScene, folder: Path, compiler: str) -> tuple[ctypes.CDLL, str]:
    """The kernels in PTX, executed on the host; and their text, which no flag changes."""
    written(made, folder)
    kernels, device = scene_cuda_fixed.kernels(made), folder / "device.cu"
    device.write_text(f'{TRANSLATED}#include "{made.stem}.cuh"\n')
    ptx = ptx_of(device, compiler, *FLAGS[compiler])
    assert ptx == ptx_of(device, compiler, *WITHOUT[compiler])
    (folder / "device.c").write_text(to_c(ptx))
    run((COMPILERS[0], "-std=c11", "-O0", "-fPIC", "-c", folder / "device.c", "-o",
         folder / "device.o"))
    program = folder / "cuda.cpp"
    program.write_text("\n".join((
        "#include <stdint.h>", GRID,
        *(f"{x.kernel};".replace("KSL_KERNEL", 'extern "C"') for x in kernels),
        *map(_on_grid, kernels), "")))
    return _opened(folder, CXX_COMPILERS[0], program, folder / "device.o"), ptx


def device_program(made: FixedScene, folder: Path) -> Path:
    """The program that launches the kernels on a device."""
    written(made, folder)
    program = folder / "cuda.cu"
    program.write_text("\n".join((
        f'#include "{made.stem}.cuh"', _LAUNCHED, *map(_launched, scene_cuda_fixed.kernels(made)),
        "")))
    return program


def on_device(made: FixedScene, folder: Path) -> ctypes.CDLL:
    """The kernels, launched on a device."""
    nvcc.run(device_program(made, folder), folder / "cuda.so", "-arch=native", "-shared",
             "-Xcompiler", "-fPIC")
    return ctypes.CDLL(str(folder / "cuda.so"))


def _opened(folder: Path, compiler: str, *given: str | Path) -> ctypes.CDLL:
    run((compiler, *CXX11, "-shared", "-fPIC", *given, "-o", folder / "cuda.so", "-lm"))
    return ctypes.CDLL(str(folder / "cuda.so"))


def _head(x: CudaKernel) -> str:
    """int call_NAME(n, each argument and its stride)"""
    return f"{x.kernel}".replace("KSL_KERNEL void ", 'extern "C" int call_')


def _on_grid(x: CudaKernel) -> str:
    """The threads of a grid one after another."""
    name = x.kernel.partition("(")[0].removeprefix("KSL_KERNEL void ")
    passed = ", ".join(f"{a.name}, {a.name}_stride" for a in x.taken)
    head = _head(x)
    return f"{head};\n{head} {{ on_grid({name})(n, {passed}); return 0; }}"


def _launched(x: CudaKernel) -> str:
    """Copies arguments to memory of both, launches, and copies results back."""
    name = x.kernel.partition("(")[0].removeprefix("KSL_KERNEL void ").replace("kernel", "launch")
    rows = [f"const size_t {a.name}_count = (size_t)(n * {a.name}_stride);\n"
            f"  int32_t *{a.name}_there = managed({a.name}, {a.name}_count);" for a in x.taken]
    passed = ", ".join(f"{a.name}_there, {a.name}_stride" for a in x.taken)
    back = [f"memcpy({a.name}, {a.name}_there, {a.name}_count * sizeof *{a.name});"
            for a in x.taken if not a.const]
    freed = [f"cudaFree({a.name}_there);" for a in x.taken]
    body = "\n  ".join((*rows, f"const int wrong = {name}(n, {passed}) || cudaDeviceSynchronize();",
                        *back, *freed, "return wrong;"))
    return f"{_head(x)} {{\n  {body}\n}}"


def compared(opened: ctypes.CDLL, made: FixedScene, count: int = _STATES) -> int:
    """Compares the results of all functions with NumPy's integers; returns how many are equal,
    which are all."""
    number, kernels = 0, iter(scene_cuda_fixed.kernels(made))
    for products in fx.MARKS:
        for function in made.functions:
            number += _compared(opened, next(kernels), function, products, count)
    return number


def _compared(opened: ctypes.CDLL, kernel: CudaKernel, function: FixedFunction,
              products: Products, count: int) -> int:
    states = fx.states(function, count)
    given = [_rows(parts) for parts in states]
    sizes = [a.quantity.size for a in function.plain.program.outputs]
    results = [np.full((count, size + GAP), 7, np.int32) for size in sizes]
    passed = [x for a in (*given, *results) for x in (
        a.ctypes.data_as(ctypes.c_void_p), ctypes.c_ssize_t(a.shape[1]))]
    name = kernel.kernel.partition("(")[0].removeprefix("KSL_KERNEL void ")
    assert getattr(opened, f"call_{name}")(ctypes.c_ssize_t(count), *passed) == 0, name
    made = np.hstack([x[:, :size] for x, size in zip(results, sizes, strict=True)]).T
    assert (made == fx.results(function.programs[products], states)).all(), name
    assert all((x[:, size:] == 7).all() for x, size in zip(results, sizes, strict=True))
    return made.size


def _rows(parts: Sequence[np.ndarray]) -> np.ndarray:
    """Arguments, with gaps between rows."""
    return np.hstack([np.stack(parts, -1), np.full((len(parts[0]), GAP), -1)]).astype(np.int32)
