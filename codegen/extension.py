"""The extension modules' sources: one for plain kernels, one for each tier that Python has."""

import hashlib
from dataclasses import asdict, dataclass

from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import QUANTITIES
from coscrew_codegen.render import render
from coscrew_codegen.selection import Selection
from coscrew_codegen.targets import gufunc, numpy
from coscrew_codegen.targets.c_statements import listed
from coscrew_codegen.tiers.table import Tier

# NumPy's C names for the precisions: type number, DType.
_NUMPY_C_NAMES = {"double": ("NPY_DOUBLE", "PyArray_DoubleDType"),
                  "single": ("NPY_FLOAT", "PyArray_FloatDType")}


@dataclass(frozen=True)
class _Best:
    """The loops for processors with AVX2: what they are called, what they are compiled for, and how
    C asks whether this processor has it.

    gcc's vectoriser fuses products and sums in spite of its flag: plain loops must not have FMA.
    It does so where sums and differences alternate, which compensated loops do not."""

    best: str
    fma: bool
    gcc_target: str
    clang_target: str
    supported: str


_AVX2 = _Best("AVX2", False, "avx2,no-fma,no-avx512f", "avx2", '__builtin_cpu_supports("avx2")')
_FMA = _Best("AVX2 with FMA", True, "avx2,fma,no-avx512f", "avx2,fma",
             '__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")')


def extension_sources(selection: Selection, kernels: dict[Operation, Program], tier: Tier | None,
                      amalgamation: str) -> tuple[dict[str, str], str]:
    """The C sources of one extension module by file name, and what names their content.

    `kernels` are its operations, with the programs that their docstrings describe; `amalgamation`
    is the text of the headers they come from."""
    families = tuple(f for f in selection.families if any(op.family == f for op in kernels))
    accesses = [gufunc.access(quantity, precision)
                for quantity in QUANTITIES for precision in selection.precisions]
    name, best = (tier.name, _FMA if tier.exact else _AVX2) if tier else ("", _AVX2)
    header = f"../../c/coscrew_{name}.h" if tier else "../c/coscrew.h"
    sources = {"_gufunc.h": render("gufunc/_gufunc.h", banner=selection.banner, accesses=accesses,
                                   families=families, amalgamation=header, **asdict(best))}
    dtypes = [_NUMPY_C_NAMES[precision.name][1] for precision in selection.precisions]
    package = f"coscrew.{name}" if name else "coscrew"
    sources["promoter.c"] = render("gufunc/promoter.c", banner=selection.banner, dtypes=dtypes,
                                   package=package)
    for family in families:
        gufuncs = [gufunc.gufunc(op, selection.precisions, numpy.docstring_of(op, program), name)
                   for op, program in kernels.items() if op.family == family]
        sources[f"{family}.c"] = render("gufunc/family.c", banner=selection.banner,
                                        family=family, gufuncs=gufuncs)
        sources[f"{family}_avx2.c"] = render("gufunc/family_avx2.c", banner=selection.banner,
                                             family=family, best=best.best)
    texts = "\0".join((amalgamation, *sources.values()))
    provenance = hashlib.sha256(texts.encode()).hexdigest()[:16]
    sources["module.c"] = _module(selection, tuple(kernels), families, name, best, provenance)
    return sources, provenance


def _module(selection: Selection, operations: tuple[Operation, ...], families: tuple[str, ...],
            tier: str, best: _Best, provenance: str) -> str:
    most = max(len(op.inputs) + len(op.outputs) for op in operations)
    return render("gufunc/module.c", banner=selection.banner, families=families,
                  package=f"coscrew.{tier}" if tier else "coscrew", supported=best.supported,
                  best=best.best,
                  most_arguments=most, provenance=provenance,
                  baseline=_table(families, "baseline", "gufuncs"),
                  avx2=_table(families, "avx2", "gufuncs_avx2"),
                  types=[_NUMPY_C_NAMES[precision.name][0] for precision in selection.precisions])


def _table(families: tuple[str, ...], name: str, suffix: str) -> str:
    entries = [f"coscrew_{family}_{suffix}" for family in families]
    return listed(f"static const coscrew_gufunc *const {name}[] = {{", entries, "};")
