"""The sources of extension modules: for each tier in Python, loops over its C kernels."""

import hashlib
from collections.abc import Iterable, Mapping
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
from coscrew_codegen.backends.render import render, runtime
from coscrew_codegen.backends.requirements import defects_of, requirements
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.values.formats import PRECISIONS, SINGLE
from coscrew_codegen.program.values.quantity import QUANTITIES, TOLERANCE, Quantity


def files(library: Library) -> Files:
    """gufunc/module.c, gufunc/accurate/module.c and so on, and what they share."""
    made = {"/".join(filter(None, ("gufunc", tier.mark, file))): text for tier in TIERS
            if has_extension(library, tier) for file, text in _sources(library, tier).items()}
    return made | (_runtime(library.banner) if made else {})


def _runtime(banner: str) -> Files:
    """The C that depends on no Program."""
    headers = runtime("runtime/gufunc/*.h", banner)
    return {path.replace("gufunc/", "gufunc/runtime/"): text for path, text in headers.items()}


def has_extension(library: Library, tier: Tier) -> bool:
    """Returns whether the tier has one: both languages are selected, it has kernels."""
    return bool(library.having(tier)) and set(TARGET.languages) <= set(library.languages)


def provenance(library: Library, tier: Tier) -> str:
    """A hash of the sources, by which Python recognizes its extension; empty without one."""
    if not has_extension(library, tier):
        return ""
    on_vectors = c_many_lanes.headers(library).values() if _on_vectors(library, tier) else ()
    texts = "\0".join((c_amalgamated.text(library, tier), *_loops(library, tier).values(),
                       *_runtime(library.banner).values(), *on_vectors))
    return hashlib.sha256(texts.encode()).hexdigest()[:16]


def _sources(library: Library, tier: Tier) -> Files:
    return {**_loops(library, tier), "module.c": _module(library, tier)}


@cache  # also used for the provenance in the Python package
def _loops(library: Library, tier: Tier) -> Files:
    """The sources except the one that holds their provenance."""
    families, on_vectors = _families(library, tier), _on_vectors(library, tier)
    required, copies = library.made(requirements), library.made(gufunc.worth)
    docstrings = numpy_twins.docstrings(library, tier, library.precisions[0])
    headers = f"{'../' * bool(tier.mark)}../c/include/ksl"
    shared = {"banner": library.banner, "runtime": _runtime_folder(tier),
              "precisions": library.precisions}
    sources = {"_gufunc.h": render(
        "gufunc/_gufunc.h", **shared, accesses=_accesses(library, QUANTITIES), families=families,
        fma=int(_has_fma(library, tier)), on_vectors=int(bool(on_vectors)), package=tier.package,
        only=_only(library), arguments=tuple(pairwise(range(_most_arguments(library, tier) + 1))),
        types=f"{headers}/ksl_types.h")}
    if on_vectors:
        sources["_lanes.h"] = _lanes(library, tier)
    sources["promoter.c"] = render(
        "gufunc/promoter.c", **shared, header=f"{headers}/{tier.umbrella}.h",
        single={p.name: int(p is SINGLE) for p in PRECISIONS}, **_checks(library, tier))
    for family in families:
        gufuncs = [gufunc.gufunc(op, library.precisions, docstrings[op.name], tier, copies[family],
                                 on_vectors.get(family), required[family].get(op.name, ""))
                   for op in library.having(tier) if op.family == family]
        sources[f"{family}.c"] = render(
            "gufunc/family.c", banner=library.banner, family=family, gufuncs=gufuncs,
            quiet=tier.bounds, kernels=f"{headers}/{'_'.join(filter(None, (family, tier.mark)))}.h",
            states=f"{headers}/{c_many_lanes.named(family)}.h" * (family in on_vectors))
        sources[f"{family}_avx2.c"] = render("gufunc/family_avx2.c", banner=library.banner,
                                             family=family, best=_best(library, tier))
    return sources


def _runtime_folder(tier: Tier) -> str:
    """The folder of the C that depends on no Program, from a tier's folder."""
    return f"{'../' * bool(tier.mark)}runtime"


def _only(library: Library) -> str:
    """DOUBLE or SINGLE if the library has no other precision."""
    return library.precisions[0].name.upper() if len(library.precisions) == 1 else ""


def _lanes(library: Library, tier: Tier) -> str:
    """Returns the text that reads and writes quantities of the kernels on vectors."""
    named = {name for held in _on_vectors(library, tier).values() for name, _ in held}
    used = {a.quantity.name for op in library.having(tier) if op.name in named
            for a in (*op.inputs, *op.outputs)}
    return render("gufunc/_lanes.h", banner=library.banner, runtime=_runtime_folder(tier),
                  accesses=_accesses(library, [x for x in QUANTITIES if x.name in used]))


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


def _has_fma(library: Library, tier: Tier) -> bool:
    """Returns whether loops for AVX2 may have FMA, too: where every product is rounded on its own.
    """
    return "ksl_exact" in c_headers.headers(library, tier)


def _best(library: Library, tier: Tier) -> str:
    """The name of the second copy of the loops."""
    return "AVX2 with FMA" if _has_fma(library, tier) else "AVX2"


def _module(library: Library, tier: Tier) -> str:
    families = _families(library, tier)
    return render("gufunc/module.c", banner=library.banner, runtime=_runtime_folder(tier),
                  package=tier.package, best=_best(library, tier),
                  most_arguments=_most_arguments(library, tier), count=len(library.having(tier)),
                  provenance=provenance(library, tier),
                  baseline=_table(families, "baseline", "gufuncs"),
                  avx2=_table(families, "avx2", "gufuncs_avx2"))


def _most_arguments(library: Library, tier: Tier) -> int:
    return max(len(op.inputs) + len(op.outputs) for op in library.having(tier))


def _checks(library: Library, tier: Tier) -> dict[str, object]:
    """Returns what refuses arguments: the defects of what functions require, by precision, and the
    plain kernels that compute them, those that the tier's header does not have."""
    required = [letters for letters_of in library.made(requirements).values()
                for letters in letters_of.values()]
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
