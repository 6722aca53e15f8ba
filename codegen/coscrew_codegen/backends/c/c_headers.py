"""The C headers: one per family and tier, and shared ones."""

import re
from collections.abc import Mapping, Sequence
from functools import cache

from coscrew_codegen.accuracy.tiers import MARKED, PLAIN, TIERS, Tier
from coscrew_codegen.algebra.operations import FAMILIES, family_named
from coscrew_codegen.backends.c import c_double, c_elementary, c_ksl, c_operations, c_storage
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.library import FamilyKernels, Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.backends.version import VERSION, numbers
from coscrew_codegen.program.values.formats import DOUBLE, Precision

_PRODUCT_ERROR = re.compile(r"\bksl_product_(?:error|rest|sum)(f?)\(")
Headers = Mapping[str, str]  # name → text, each after those it includes


def files(library: Library) -> Files:
    """c/include/ksl/coscrew.h and so on, of all tiers."""
    return {f"c/include/ksl/{name}.h": text for tier in TIERS
            for name, text in headers(library, tier).items()}


@cache  # also used by other targets
def headers(library: Library, tier: Tier) -> Headers:
    """The headers of a tier; those of the plain tier with the shared ones."""
    return _plain_headers(library) if tier is PLAIN else _marked_headers(library, tier)


def _functions(kernels: FamilyKernels) -> Mapping[tuple[str, str], tuple[CFunction, ...]]:
    """A family's kernels, by tier and precision."""
    return {(tier.name, precision.name): tuple(
        c_operations.function(op, program, precision, tier.mark)
        for op, program in kernels.of(tier, precision).items())
        for tier in TIERS for precision in kernels.precisions}


def _plain_headers(library: Library) -> Headers:
    made = {"ksl_rounding": render("c/ksl_rounding.h", banner=library.banner,
                                   products=library.precisions,
                                   double=c_double.of_library(library.precisions)),
            "ksl_types": _types(library)}
    titles, kernels = _titles(library.families), library.made(_functions)
    for name, title in titles.items():
        if name == c_elementary.HEADER:
            made[name] = _elementary(library, title)
            continue
        functions = [function for precision in library.precisions for function in (
            *c_storage.storage_functions(name, precision),
            *(kernels[name][PLAIN.name, precision.name] if name in kernels else ()))]
        by_hand = c_ksl.text(name, tuple(titles), library.precisions)
        allocations = [c_storage.allocation(name, precision) for precision in library.precisions]
        made[name] = render(
            "c/family.h", banner=library.banner, title=title,
            guard=f"KSL_{name.upper()}_H", functions=functions,
            includes=("ksl_types", *_elementary_included(functions), *_included(name, titles)),
            system=_system(name, by_hand), by_hand=by_hand,
            allocations=[function for function in allocations if function])
    made["ksl_selfcheck"] = render(
        "c/ksl_selfcheck.h", banner=library.banner,
        precisions=list(map(c_storage.selfcheck_numbers, library.precisions)))
    made[PLAIN.umbrella] = render(
        "c/ksl.h", banner=library.banner, guard="KSL_H", includes=(*titles, "ksl_selfcheck"),
        title="Everything: vectors, rotations, displacements, screws and coscrews.")
    return made


def _system(name: str, by_hand: str) -> tuple[str, ...]:
    """The headers of the C library that a family's header includes."""
    predicates = ("stdbool.h",) if re.search(r"\bbool\b", by_hand) else ()
    return (*predicates, *c_ksl.SYSTEM.get(name, ()))


def _titles(families: tuple[str, ...]) -> dict[str, str]:
    """Name → title of the headers with KSL's names, each after those it includes."""
    first = c_elementary.HEADER
    titles = {first: family_named(first).title}  # always: other families call its functions
    for family in families:
        titles[family] = family_named(family).title
        titles |= {name: title for name, (after, title) in c_ksl.HEADERS.items() if after == family}
    return titles


def _types(library: Library) -> str:
    types = [{"name": c_operations.type_name(quantity.name, precision),
              "meaning": f"{c_storage.meaning(quantity)}; {precision.name} precision.",
              "views": c_storage.views(quantity, precision)}
             for quantity in c_storage.TYPES
             for precision in (*library.precisions,
                               *[c_storage.INTEGER] * (quantity in c_storage.INTEGRAL))]
    return render("c/ksl_types.h", banner=library.banner, types=types, version=VERSION,
                  parts=zip(("MAJOR", "MINOR", "PATCH"), numbers(), strict=True),
                  precisions=[precision.name for precision in library.precisions],
                  sequences=[name for name, _ in c_ksl.SEQUENCES])


def _included(header: str, titles: Mapping[str, str]) -> tuple[str, ...]:
    """The headers in `titles` that a header includes, directly or through headers not in it."""
    included: list[str] = []
    for other in _includes(header):
        included += [other] if other in titles else _included(other, titles)
    return tuple(dict.fromkeys(included))


def _includes(header: str) -> tuple[str, ...]:
    """Returns the headers that a header includes, so that any may come first: those that its family
    names, and those with functions that its hand-written text calls."""
    includes = family_named(header).includes if header in FAMILIES else ()
    reached = set().union(*map(_reached, includes))
    return (*includes, *(x for x in c_ksl.NEEDED.get(header, ()) if x not in reached))


def _reached(header: str) -> frozenset[str]:
    """The header and all that it includes, through others too."""
    return frozenset({header}).union(*map(_reached, _includes(header)))


def _marked_headers(library: Library, tier: Tier) -> Headers:
    """Returns the headers of a tier: of the exact errors that it needs, one for each family, and
    one that includes all."""
    families, exact = {}, set()
    for family in library.families:
        kernels = library.made(_functions)[family]
        functions = [function for precision in library.precisions
                     for function in kernels[tier.name, precision.name]]
        if functions:
            called = _exact_included(functions)
            exact |= {*called}
            families[f"{family}_{tier.mark}"] = render(
                "c/family.h", banner=library.banner,
                title=f"{family_named(family).title}\n   {tier.title}",
                guard=f"KSL_{family.upper()}_{tier.mark.upper()}_H", functions=functions,
                includes=tuple(dict.fromkeys((tier.header, *called, *_elementary_included(
                    functions if DOUBLE in library.precisions or not tier.exact else ())))),
                system=(), by_hand="", allocations=[])
    umbrella = render(
        "c/ksl.h", banner=library.banner, includes=tuple(families),
        title=f"All kernels of the {tier.name} tier.", guard=f"{tier.umbrella.upper()}_H")
    if any(f'"{c_elementary.ERROR_HEADER}.h"' in text for text in families.values()):
        exact |= {c_elementary.ERROR_HEADER, *(f"ksl_exact{p.suffix}" for p in library.precisions)}
    shared = {name: text for name, text in _exact(library).items() if tier.exact or name in exact}
    return shared | families | {tier.umbrella: umbrella}


def _elementary(library: Library, title: str) -> str:
    return render("c/elementary.h", banner=library.banner, title=title,
                  precisions=library.precisions, elementary=_elementary_of(library.precisions))


def _elementary_of(precisions: Sequence[Precision], header: str = c_elementary.HEADER
                   ) -> list[tuple[Precision, list[c_elementary.ElementaryText]]]:
    """The elementary functions in these precisions, or their error functions."""
    return [(p, c_elementary.written(p, c_elementary.CALLABLE[header])) for p in precisions]


def _elementary_included(functions: Sequence[CFunction]) -> tuple[str, ...]:
    """The headers of the elementary functions that these call."""
    called = c_elementary.called(x.body for x in functions)
    return tuple(header for header, names in c_elementary.CALLABLE.items() if called & {*names})


def _exact_included(functions: Sequence[CFunction]) -> tuple[str, ...]:
    """The headers of the products' errors that these call."""
    called = {f for x in functions for f in _PRODUCT_ERROR.findall(x.body)}
    return tuple(name for name, f in (("ksl_exact", ""), ("ksl_exactf", "f")) if f in called)


def _exact(library: Library) -> dict[str, str]:
    """Returns the headers of exact errors: with the functions that kernels computing in double need
    if only single precision is selected, and error functions of elementary functions."""
    missing = [DOUBLE] if DOUBLE not in library.precisions else []
    return {"ksl_exact": render("c/ksl_exact.h", banner=library.banner, products=missing,
                                precisions=missing, elementary=_elementary_of(missing),
                                double=c_double.EXACT if missing else None),
            "ksl_exactf": render("c/ksl_exactf.h", banner=library.banner),
            c_elementary.ERROR_HEADER: render(
                "c/ksl_elementary_error.h", banner=library.banner,
                exact=[f"ksl_exact{p.suffix}" for p in library.precisions],
                elementary=_elementary_of(library.precisions, c_elementary.ERROR_HEADER))}


def umbrellas() -> tuple[str, ...]:
    """The headers that only include others."""
    return tuple(tier.umbrella for tier in (PLAIN, *MARKED))


TARGET = Target("C headers", ("c",), library=files)
