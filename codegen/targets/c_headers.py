"""The C headers: one per family and tier, and those that they share."""

from collections.abc import Mapping
from functools import cache

from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.library import Library
from coscrew_codegen.operations import family_title
from coscrew_codegen.render import render
from coscrew_codegen.targets import c, c_ksl, c_storage
from coscrew_codegen.targets.target import Files, Target
from coscrew_codegen.tiers import MARKED, PLAIN, TIERS, Tier
from coscrew_codegen.version import VERSION, numbers

Headers = Mapping[str, str]  # name → text, each after those it includes

# What a family's header includes, so that any header may come first.
_INCLUDES = {
    "vec3": (), "vec4": (), "trig": (), "mat6x6": (), "axis": ("vec3",),
    "array": (), "mat3x3": ("vec3", "axis"), "SE3": ("mat3x3",),
    "mat4x4": ("SE3", "vec4"),
    "matrix": ("SE3", "trig"), "screw": ("matrix", "mat6x6"), "coscrew": ("screw",),
    "quaternion": ("mat3x3",), "exponential": ("quaternion", "SE3", "screw"),
    "symmetric": ("mat6x6", "screw", "coscrew"), "inertia": ("SE3",),
    "spatial_inertia": ("inertia", "coscrew"),
}


def files(library: Library) -> Files:
    """c/include/ksl/coscrew.h and so on, of all tiers."""
    return {f"c/include/ksl/{name}.h": text for tier in TIERS
            for name, text in headers(library, tier).items()}


@cache  # also used by other targets
def headers(library: Library, tier: Tier) -> Headers:
    """The headers of a tier; those of the plain tier with the shared ones."""
    return _plain_headers(library) if tier is PLAIN else _marked_headers(library, tier)


def _plain_headers(library: Library) -> Headers:
    made = {"ksl_rounding": render("c/ksl_rounding.h", banner=library.banner,
                                   products=library.precisions),
            "ksl_types": _types(library)}
    titles = _titles(library.families)
    for name, title in titles.items():
        functions = [function for precision in library.precisions
                     for function in (*c_storage.storage_functions(name, precision),
                                      *(c.function(op, program, precision) for op, program in
                                        library.by_family(PLAIN, precision).get(name, {}).items()))]
        allocations = [c_storage.allocation(name, precision) for precision in library.precisions]
        made[name] = render(
            "c/family.h", banner=library.banner, title=title,
            guard=f"KSL_{name.upper()}_H", functions=functions,
            includes=("ksl_types", *_included(name, titles)), system=c_ksl.SYSTEM.get(name, ()),
            by_hand=c_ksl.text(name, tuple(titles), library.precisions),
            allocations=[function for function in allocations if function])
    made["ksl_selfcheck"] = render(
        "c/ksl_selfcheck.h", banner=library.banner,
        precisions=list(map(c_storage.selfcheck_numbers, library.precisions)))
    made[PLAIN.umbrella] = render(
        "c/ksl.h", banner=library.banner, guard="KSL_H", includes=(*titles, "ksl_selfcheck"),
        title="Everything: vectors, rotations, displacements, screws and coscrews.")
    return made


def _titles(families: tuple[str, ...]) -> dict[str, str]:
    """Name → title of the headers with KSL's names, each after those it includes."""
    titles: dict[str, str] = {}
    for family in families:
        titles[family] = family_title(family)
        titles |= {name: title for name, (after, title) in c_ksl.HEADERS.items() if after == family}
    return titles


def _types(library: Library) -> str:
    types = [{"name": c.type_name(quantity.name, precision),
              "meaning": f"{c_storage.meaning(quantity)}; {precision.name} precision.",
              "views": c_storage.views(quantity, precision)}
             for quantity in c_storage.TYPES
             for precision in (*library.precisions,
                               *[c_storage.INTEGER] * (quantity in c_storage.INTEGRAL))]
    return render("c/ksl_types.h", banner=library.banner, types=types, version=VERSION,
                  parts=zip(("MAJOR", "MINOR", "PATCH"), numbers(), strict=True),
                  precisions=[precision.name for precision in library.precisions],
                  sequences=[name for name, _ in c_ksl.SEQUENCES])


def _included(family: str, titles: Mapping[str, str]) -> tuple[str, ...]:
    """The headers in `titles` that a header includes, directly or through headers not in it."""
    found: list[str] = []
    for other in _INCLUDES[family]:
        found += [other] if other in titles else _included(other, titles)
    return tuple(dict.fromkeys(found))


def _marked_headers(library: Library, tier: Tier) -> Headers:
    """ksl_exact if the tier needs it, one header per family, and one that includes all."""
    families = {}
    for family in library.families:
        functions = [
            c.function(op, program, precision, tier.mark) for precision in library.precisions
            for op, program in library.by_family(tier, precision).get(family, {}).items()]
        if functions:
            families[f"{family}_{tier.mark}"] = render(
                "c/family.h", banner=library.banner,
                title=f"{family_title(family)}\n   {tier.title}",
                guard=f"KSL_{family.upper()}_{tier.mark.upper()}_H", functions=functions,
                includes=(tier.header,), system=(), by_hand="", allocations=[])
    umbrella = render(
        "c/ksl.h", banner=library.banner, includes=tuple(families),
        title=f"All kernels of the {tier.name} tier.", guard=f"{tier.umbrella.upper()}_H")
    return (_exact(library) if tier.exact else {}) | families | {tier.umbrella: umbrella}


def _exact(library: Library) -> dict[str, str]:
    return {"ksl_exact": render("c/ksl_exact.h", banner=library.banner, products=[
        DOUBLE] if DOUBLE not in library.precisions else [])}


def umbrellas() -> tuple[str, ...]:
    """The headers that only include others."""
    return tuple(tier.umbrella for tier in (PLAIN, *MARKED))


TARGET = Target("C headers", ("c",), library=files)
