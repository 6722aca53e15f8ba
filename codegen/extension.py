"""The extension modules' sources: one for plain kernels, one for each tier that Python has."""

import hashlib

from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import QUANTITIES
from coscrew_codegen.render import render
from coscrew_codegen.selection import Selection
from coscrew_codegen.targets import gufunc, numpy
from coscrew_codegen.targets.c_statements import listed

# NumPy's C names for the precisions: type number, DType.
_NUMPY_C_NAMES = {"double": ("NPY_DOUBLE", "PyArray_DoubleDType"),
                  "single": ("NPY_FLOAT", "PyArray_FloatDType")}


def extension_sources(selection: Selection, kernels: dict[Operation, Program], tier: str,
                      amalgamation: str) -> tuple[dict[str, str], str]:
    """The C sources of one extension module by file name, and what names their content.

    `kernels` are its operations, with the programs that their docstrings describe; `amalgamation`
    is the text of the headers they come from."""
    families = tuple(f for f in selection.families if any(op.family == f for op in kernels))
    accesses = [gufunc.access(quantity, precision)
                for quantity in QUANTITIES for precision in selection.precisions]
    header = f"../../c/coscrew_{tier}.h" if tier else "../c/coscrew.h"
    sources = {"_gufunc.h": render("gufunc/_gufunc.h", banner=selection.banner, accesses=accesses,
                                   families=families, amalgamation=header)}
    dtypes = [_NUMPY_C_NAMES[precision.name][1] for precision in selection.precisions]
    package = f"coscrew.{tier}" if tier else "coscrew"
    sources["promoter.c"] = render("gufunc/promoter.c", banner=selection.banner, dtypes=dtypes,
                                   package=package)
    for family in families:
        gufuncs = [gufunc.gufunc(op, selection.precisions, numpy.docstring_of(op, program), tier)
                   for op, program in kernels.items() if op.family == family]
        sources[f"{family}.c"] = render("gufunc/family.c", banner=selection.banner,
                                        family=family, gufuncs=gufuncs)
        sources[f"{family}_avx2.c"] = render("gufunc/family_avx2.c", banner=selection.banner,
                                             family=family)
    texts = "\0".join((amalgamation, *sources.values()))
    provenance = hashlib.sha256(texts.encode()).hexdigest()[:16]
    sources["module.c"] = _module(selection, tuple(kernels), families, tier, provenance)
    return sources, provenance


def _module(selection: Selection, operations: tuple[Operation, ...], families: tuple[str, ...],
            tier: str, provenance: str) -> str:
    most = max(len(op.inputs) + len(op.outputs) for op in operations)
    return render("gufunc/module.c", banner=selection.banner, families=families,
                  package=f"coscrew.{tier}" if tier else "coscrew",
                  most_arguments=most, provenance=provenance,
                  baseline=_table(families, "baseline", "gufuncs"),
                  avx2=_table(families, "avx2", "gufuncs_avx2"),
                  types=[_NUMPY_C_NAMES[precision.name][0] for precision in selection.precisions])


def _table(families: tuple[str, ...], name: str, suffix: str) -> str:
    entries = [f"coscrew_{family}_{suffix}" for family in families]
    return listed(f"static const coscrew_gufunc *const {name}[] = {{", entries, "};")
