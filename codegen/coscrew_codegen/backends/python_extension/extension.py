"""The sources of extension modules: for each tier in Python, loops over its C kernels."""

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from itertools import pairwise

from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.backends.c import c_amalgamated, c_headers, c_many_lanes, c_operations
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_operations import c_name
from coscrew_codegen.backends.c.c_statements import listed
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.numpy import numpy_twins
from coscrew_codegen.backends.python_extension import gufunc
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.requirements import defects_of, requirements
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.values.quantity import QUANTITIES, TOLERANCE, Quantity


@dataclass(frozen=True)
class _Best:
    """The second copy of the loops, for processors with AVX2: its name, its compiler targets, and
    the C condition for a processor that has it.

    Plain loops must not have FMA: gcc's vectoriser fuses products into sums in spite of its flag
    where sums and differences alternate, which does not occur in compensated loops."""

    best: str
    fma: bool
    gcc_target: str
    clang_target: str
    supported: str


_AVX2 = _Best("AVX2", False, "avx2,no-fma,no-avx512f", "avx2", '__builtin_cpu_supports("avx2")')
_FMA = _Best("AVX2 with FMA", True, "avx2,fma,no-avx512f", "avx2,fma",
             '__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")')


def files(library: Library) -> Files:
    """gufunc/module.c, gufunc/accurate/module.c and so on."""
    return {"/".join(filter(None, ("gufunc", tier.mark, file))): text for tier in TIERS
            if has_extension(library, tier) for file, text in _sources(library, tier).items()}


def has_extension(library: Library, tier: Tier) -> bool:
    """Whether the tier has one: both languages are selected, it has kernels."""
    return bool(library.having(tier)) and set(TARGET.languages) <= set(library.languages)


def provenance(library: Library, tier: Tier) -> str:
    """A hash of the sources, by which Python recognizes its extension; empty without one."""
    if not has_extension(library, tier):
        return ""
    on_vectors = c_many_lanes.headers(library).values() if _on_vectors(library, tier) else ()
    texts = "\0".join((c_amalgamated.text(library, tier), *_loops(library, tier).values(),
                       *on_vectors))
    return hashlib.sha256(texts.encode()).hexdigest()[:16]


def _sources(library: Library, tier: Tier) -> Files:
    return {**_loops(library, tier), "module.c": _module(library, tier)}


@cache  # also used for the provenance in the Python package
def _loops(library: Library, tier: Tier) -> Files:
    """The sources except the one that holds their provenance."""
    families, on_vectors = _families(library, tier), _on_vectors(library, tier)
    required = library.made(requirements)
    docstrings = numpy_twins.docstrings(library, tier, library.precisions[0])
    best = _best(library, tier)
    headers = f"{'../../' if tier.mark else '../'}c/include/ksl"
    sources = {"_gufunc.h": render("gufunc/_gufunc.h", banner=library.banner,
                                   accesses=_accesses(library, QUANTITIES),
                                   families=families, lanes=bool(on_vectors), **asdict(best),
                                   arguments=tuple(pairwise(range(
                                       _most_arguments(library, tier) + 1))),
                                   precisions=library.precisions,
                                   types=f"{headers}/ksl_types.h")}
    if on_vectors:
        sources["_lanes.h"] = _lanes(library, tier)
    dtypes = [f"PyArray_{precision.c_type.title()}DType" for precision in library.precisions]
    sources["promoter.c"] = render("gufunc/promoter.c", banner=library.banner, dtypes=dtypes,
                                   package=tier.package, precisions=library.precisions,
                                   header=f"{headers}/{tier.umbrella}.h",
                                   types=_types(library), **_checks(library, tier))
    for family in families:
        gufuncs = [gufunc.gufunc(op, library.precisions, docstrings[op.name], tier.mark,
                                 on_vectors.get(family), required[family].get(op.name, ""))
                   for op in library.having(tier) if op.family == family]
        sources[f"{family}.c"] = render(
            "gufunc/family.c", banner=library.banner, family=family, gufuncs=gufuncs,
            quiet=tier.bounds, kernels=f"{headers}/{'_'.join(filter(None, (family, tier.mark)))}.h",
            states=f"{headers}/{c_many_lanes.named(family)}.h" * (family in on_vectors))
        sources[f"{family}_avx2.c"] = render("gufunc/family_avx2.c", banner=library.banner,
                                             family=family, best=best.best)
    return sources


def _lanes(library: Library, tier: Tier) -> str:
    """Returns the text that reads and writes quantities of the kernels on vectors."""
    named = {name for held in _on_vectors(library, tier).values() for name, _ in held}
    used = {a.quantity.name for op in library.having(tier) if op.name in named
            for a in (*op.inputs, *op.outputs)}
    return render("gufunc/_lanes.h", banner=library.banner, accesses=_accesses(
        library, [quantity for quantity in QUANTITIES if quantity.name in used]))


def _accesses(library: Library, quantities: Iterable[Quantity]) -> list[gufunc.Access]:
    return [gufunc.access(quantity, precision)
            for quantity in quantities for precision in library.precisions]


def _on_vectors(library: Library, tier: Tier
                ) -> Mapping[str, Mapping[tuple[str, str], CFunction]]:
    """The kernels on vectors, by family, then by operation and precision."""
    if tier.marked:
        return {}
    made = library.made(c_many_lanes.kernels)
    return {family: made[family] for family in _families(library, tier) if made[family]}


def _families(library: Library, tier: Tier) -> tuple[str, ...]:
    held = {op.family for op in library.having(tier)}
    return tuple(family for family in library.families if family in held)


def _best(library: Library, tier: Tier) -> _Best:
    return _FMA if "ksl_exact" in c_headers.headers(library, tier) else _AVX2


def _module(library: Library, tier: Tier) -> str:
    families, best = _families(library, tier), _best(library, tier)
    return render("gufunc/module.c", banner=library.banner, families=families,
                  package=tier.package, supported=best.supported, best=best.best,
                  most_arguments=_most_arguments(library, tier), count=len(library.having(tier)),
                  provenance=provenance(library, tier),
                  baseline=_table(families, "baseline", "gufuncs"),
                  avx2=_table(families, "avx2", "gufuncs_avx2"),
                  types=_types(library))


def _most_arguments(library: Library, tier: Tier) -> int:
    return max(len(op.inputs) + len(op.outputs) for op in library.having(tier))


def _types(library: Library) -> list[str]:
    return [f"NPY_{precision.c_type.upper()}" for precision in library.precisions]


def _checks(library: Library, tier: Tier) -> dict[str, object]:
    """Returns what refuses arguments: the defects of what functions require, by precision, and the
    plain kernels that compute them, those that the tier's header does not have."""
    required = [letters for found in library.made(requirements).values()
                for letters in found.values()]
    defects = [(p, letter, op, c_name(op.name, p)) for letter, op in defects_of(required).items()
               for p in library.precisions]
    header = c_amalgamated.text(library, tier)
    return {"kernels": [c_operations.function(op, library_program(op.name), p) for p, _, op,
                        name in defects
                        if f"{p.c_type} {name}(" not in header],
            "defects": [{"letter": letter.value, "precision": p.name, "function": name,
                         "quantity": op.inputs[0].quantity.name,
                         "tolerance": f"{float(TOLERANCE)}{p.suffix}"}
                        for p, letter, op, name in defects]}


def _table(families: tuple[str, ...], name: str, suffix: str) -> str:
    entries = [f"coscrew_{family}_{suffix}" for family in families]
    return listed(f"static const coscrew_gufunc *const {name}[] = {{", entries, "};")


TARGET = Target("extension modules", ("c", "python"), library=files)
