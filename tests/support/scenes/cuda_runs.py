"""Compares kernels of CUDA headers with C: compiled as C++, and translated for a device."""

from pathlib import Path

from tests.support.compiled import nvcc
from tests.support.compiled.c_harness import C11, COMPILERS, CXX_COMPILERS, STRICT, run
from tests.support.compiled.ptx import to_c
from tests.support.scenes.cuda_program import Scene

CXX11 = ("-std=c++11",)
FLAGS = {"clang++": ("-O1", "-ffp-contract=fast", "-fgpu-flush-denormals-to-zero"),
         "nvcc": ("-use_fast_math",)}
"""Of each compiler, flags that change what operators of CUDA do: fuse, approximate, flush."""
WITHOUT = {"clang++": ("-O1",), "nvcc": ()}
"""The same without them."""


def compared(scene: Scene, folder: Path, compiler: str, *flags: str) -> int:
    """Compares the numbers of the header as C++, which are equal; returns how many."""
    program, *references = scene.on_host(folder)
    for path in references:
        run((COMPILERS[0], *C11, "-c", path, "-o", path.with_suffix(".o")))
    run((compiler, *CXX11, *flags, *STRICT, program,
         *(x.with_suffix(".o") for x in references), "-o", folder / "cuda", "-lm"))
    return int(run([folder / "cuda"]))


def ptx_of(source: Path, compiler: str, *flags: str) -> str:
    """The kernels of a file in PTX."""
    made = source.with_suffix(".ptx")
    if compiler == "nvcc":
        nvcc.run(source, made, "-arch=sm_80", "-ptx", *flags)
    else:
        run((compiler, "-x", "cuda", "--cuda-device-only", "--cuda-gpu-arch=sm_80", "-nocudainc",
             "-nocudalib", "-Wno-unknown-cuda-version", "-std=c++17", *flags, "-S", source, "-o",
             made))
    return made.read_text()


def executed(scene: Scene, folder: Path, compiler: str) -> tuple[int, str]:
    """Compares the numbers of the kernels in PTX, executed on the host; returns how many, and the
    kernels.  The numbers are equal, and no flag changes the kernels."""
    device, program, *references = scene.translated(folder)
    ptx = ptx_of(device, compiler, *FLAGS[compiler])
    assert ptx == ptx_of(device, compiler, *WITHOUT[compiler])
    (folder / "device.c").write_text(to_c(ptx))
    for path in (folder / "device.c", *references):
        run((COMPILERS[0], *C11, "-O0", "-c", path, "-o", path.with_suffix(".o")))
    run((CXX_COMPILERS[0], *CXX11, program, *(x.with_suffix(".o") for x in references),
         folder / "device.o", "-o", folder / "cuda", "-lm"))
    return int(run([folder / "cuda"])), ptx
