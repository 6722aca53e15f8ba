"""Which files are generated, and what each holds: Selection → {path: text}."""

from collections.abc import Iterator
from dataclasses import replace

from coscrew_codegen.extension import extension_sources
from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.operations import Operation, family_title
from coscrew_codegen.program import Program
from coscrew_codegen.render import LICENSE, render
from coscrew_codegen.selection import Selection
from coscrew_codegen.targets import c, c_ksl, c_storage, numpy
from coscrew_codegen.tiers.table import TIERS, Tier
from coscrew_codegen.version import VERSION, numbers

Files = dict[str, str]  # by path in the output folder, with forward slashes
Programs = dict[str, Program]

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

# Short names of constructors, in Python.
_ALIASES = (("SE3", "SE3_fromRt"), ("screw", "screw_from_lin_ang"),
            ("coscrew", "coscrew_from_lin_ang"))


_UMBRELLAS = ("ksl", *(f"ksl_{tier.name}" for tier in TIERS))


def generated_files(selection: Selection, programs: Programs) -> Files:
    """Every file of the selection, by its path in the output folder."""
    files: Files = {}
    headers = _headers(selection, programs)
    if "c" in selection.languages:
        files |= {f"c/include/ksl/{name}.h": text for name, text in headers.items()}
        files |= {f"c/include/ksl/{name}.h": render("c/refused.h", banner=selection.banner,
                                                    what=what, sentence=sentence)
                  for name, (what, sentence) in c_ksl.REFUSED.items()
                  if "vec3" in selection.families}
    for tier in (None, *TIERS):
        made = headers
        if tier and "c" in selection.languages:
            made = _tier_headers(selection, programs, tier)
            files |= {f"c/include/ksl/{name}.h": text for name, text in made.items()}
            made = {name: headers[name] for name in ("ksl_rounding", "ksl_types")} | made
        files |= _tier_files(selection, programs, tier, _amalgamation(
            selection, made, f"All headers of {tier.name if tier else 'plain'} kernels"))
    if selection.languages == ("c", "python"):
        files["c/__init__.py"] = render("c/__init__.py", banner=selection.banner)
    return files


def _tier_files(selection: Selection, programs: Programs, tier: Tier | None,
                amalgamation: str) -> Files:
    """The files of a tier, or of plain kernels: C in one file, the extension, the package."""
    name, folder = (tier.name, f"{tier.name}/") if tier else ("", "")
    files: Files = {}
    if "c" in selection.languages:
        files[f"c/coscrew_{name}.h" if tier else "c/coscrew.h"] = amalgamation
    if tier and not tier.in_python:
        return files
    provenance = ""
    if kernels := _documented(selection, programs, tier):
        if selection.languages == ("c", "python"):
            sources, provenance = extension_sources(selection, kernels, tier, amalgamation)
            files |= {f"gufunc/{folder}{file}": text for file, text in sources.items()}
        if "python" in selection.languages:
            package = _package(selection, programs, tier, provenance)
            files |= {f"python/{folder}{file}": text for file, text in package.items()}
    return files


def _documented(selection: Selection, programs: Programs,
                tier: Tier | None) -> dict[Operation, Program]:
    """The operations of a tier with the programs that documentation describes: the first
    precision's, which is double's where there are both."""
    if tier is None:
        return {op: programs[op.name] for op in selection.operations}
    first = selection.precisions[0].name
    return {tier.operation(op): tier.program(programs[op.name], first)
            for op in selection.operations if tier.has(programs[op.name])}


# C headers


def _headers(selection: Selection, programs: Programs) -> dict[str, str]:
    """The headers by name, each after those it includes."""
    families = selection.families
    headers = {"ksl_rounding": render("c/ksl_rounding.h", banner=selection.banner,
                                      products=selection.precisions),
               "ksl_types": _types_header(selection)}
    for name, title in _header_titles(families).items():
        functions = [function for precision in selection.precisions
                     for function in (*c_storage.storage_functions(name, precision),
                                      *_c_functions(selection, programs, name, precision))]
        allocations = [c_storage.allocation(name, precision)
                       for precision in selection.precisions]
        headers[name] = render(
            "c/family.h", banner=selection.banner, title=title,
            guard=f"KSL_{name.upper()}_H", functions=functions,
            includes=("ksl_types", *_included(name, families)),
            system=c_ksl.SYSTEM.get(name, ()),
            by_hand=c_ksl.text(name, tuple(_header_titles(families)), selection.precisions),
            allocations=[function for function in allocations if function])
    headers["ksl_selfcheck"] = render(
        "c/ksl_selfcheck.h", banner=selection.banner,
        precisions=list(map(c_storage.selfcheck_numbers, selection.precisions)))
    headers["ksl"] = render(
        "c/ksl.h", banner=selection.banner, guard="KSL_H",
        includes=(*_header_titles(families), "ksl_selfcheck"),
        title="Everything: vectors, rotations, displacements, screws and coscrews.")
    return headers


def _header_titles(families: tuple[str, ...]) -> dict[str, str]:
    """The headers of KSL's names, each after those it includes, with their first lines."""
    titles: dict[str, str] = {}
    for family in families:
        titles[family] = family_title(family)
        titles |= {name: title for name, (after, title) in c_ksl.HEADERS.items() if after == family}
    return titles


def _c_functions(selection: Selection, programs: Programs, family: str,
                 precision: Precision) -> Iterator[c.CFunction]:
    for operation in selection.operations:
        if operation.family == family:
            yield c.function(operation, programs[operation.name], precision)


def _types_header(selection: Selection) -> str:
    types = [{"name": c.type_name(quantity.name, precision),
              "meaning": f"{c_storage.meaning(quantity)}; {precision.name} precision.",
              "views": c_storage.views(quantity, precision)}
             for quantity in c_storage.TYPES
             for precision in (*selection.precisions,
                               *[c_storage.INTEGER] * (quantity in c_storage.INTEGRAL))]
    return render("c/ksl_types.h", banner=selection.banner, types=types, version=VERSION,
                  parts=zip(("MAJOR", "MINOR", "PATCH"), numbers()),
                  precisions=[precision.name for precision in selection.precisions],
                  sequences=[name for name, _ in c_ksl.SEQUENCES])


def _included(family: str, families: tuple[str, ...]) -> tuple[str, ...]:
    """The selected families a header includes directly; through those left out, theirs."""
    found: list[str] = []
    for other in _INCLUDES[family]:
        found += [other] if other in _header_titles(families) else _included(other, families)
    return tuple(dict.fromkeys(found))


def _tier_headers(selection: Selection, programs: Programs, tier: Tier) -> dict[str, str]:
    """The headers of a tier behind plain: exact errors, one per family, one that includes all."""
    exact = {"ksl_exact": render("c/ksl_exact.h", banner=selection.banner, products=[
        DOUBLE] if DOUBLE not in selection.precisions else [])}
    headers = exact if tier.header == "ksl_exact" else {}
    for family in selection.families:
        functions = [
            c.function(tier.operation(op), tier.program(programs[op.name], precision.name),
                       precision, tier.name)
            for precision in selection.precisions for op in selection.operations
            if op.family == family and tier.has(programs[op.name])]
        if functions:
            headers[f"{family}_{tier.name}"] = render(
                "c/family.h", banner=selection.banner,
                title=f"{family_title(family)}\n   {tier.title}",
                guard=f"KSL_{family.upper()}_{tier.name.upper()}_H", functions=functions,
                includes=(tier.header,), system=(), by_hand="", allocations=[])
    umbrella = tuple(name for name in headers if name != "ksl_exact")
    headers[f"ksl_{tier.name}"] = render(
        "c/ksl.h", banner=selection.banner, includes=umbrella,
        title=f"All kernels of the {tier.name} tier.", guard=f"KSL_{tier.name.upper()}_H")
    return headers


def _amalgamation(selection: Selection, headers: dict[str, str], title: str) -> str:
    head = 1 + len(LICENSE)
    sections = ["\n".join(line for line in text.splitlines()[head:]
                          if not line.startswith('#include "')) + "\n"
                for name, text in headers.items() if name not in _UMBRELLAS]
    return render("c/coscrew.h", banner=selection.banner, sections=sections, title=title)


# the Python package


def _package(selection: Selection, programs: Programs, tier: Tier | None,
             provenance: str) -> dict[str, str]:
    """The files of the package `coscrew`, or of a tier's within it, by path in it."""
    kernels = _documented(selection, programs, tier)
    names = [op.name for op in kernels]
    shared = {"banner": selection.banner, "names": names, "provenance": provenance,
              "aliases": [] if tier else [(a, name) for a, name in _ALIASES if name in names],
              "package": f"coscrew.{tier.name}" if tier else "coscrew", "version": VERSION,
              "about": tier.in_words if tier else "",
              "precisions": [precision.name for precision in selection.precisions],
              "extension": bool(provenance),
              "selfcheck": not tier and "coscrew" in selection.families}
    shapes = ["__init__.py", "_dispatch.py", "_arrays.py", "_kernel.py", "_exact.py",
              "_provenance.py", *(["_selfcheck.py"] if shared["selfcheck"] else [])]
    package = {"_dispatch.py": render("python/_dispatch.py", **shared),
               "__init__.py": render("python/tier.py", **shared)} if tier else {
        name: render(f"python/{name}", **shared) for name in shapes}
    package["__init__.pyi"] = _stubs(kernels, shared, "np.floating", top=True)
    if not tier:
        package["py.typed"] = ""
    for precision in selection.precisions:
        package[f"{precision.name}/__init__.pyi"] = _stubs(
            _kernels(selection, programs, tier, precision), shared, f"np.{precision.numpy_type}")
    return package | _twin_modules(selection, programs, tier)


def _kernels(selection: Selection, programs: Programs, tier: Tier | None,
             precision: Precision) -> dict[Operation, Program]:
    """The operations of a tier with their programs in this precision."""
    return _documented(replace(selection, precisions=(precision,)), programs, tier)


def _stubs(kernels: dict[Operation, Program], shared: dict[str, object], scalar: str,
           top: bool = False) -> str:
    stubs = [numpy.stub(op, program, scalar) for op, program in kernels.items()]
    return render("python/operations.pyi", stubs=stubs, top=top, **shared)


def _twin_modules(selection: Selection, programs: Programs, tier: Tier | None) -> dict[str, str]:
    """The modules of both precisions, one per family, and what gathers them."""
    modules: dict[str, str] = {}
    for precision in selection.precisions:
        kernels = _kernels(selection, programs, tier, precision)
        names = [op.name for op in kernels]
        families = {f: {op: p for op, p in kernels.items() if op.family == f}
                    for f in selection.families}
        families = {family: members for family, members in families.items() if members}
        modules[f"{precision.name}/__init__.py"] = render(
            "python/precision.py", banner=selection.banner, precision=precision,
            package=f"coscrew.{tier.name}" if tier else "coscrew",
            families=[{"name": family, "operations": [op.name for op in members]}
                      for family, members in families.items()],
            aliases=[(alias, name) for alias, name in _ALIASES if name in names])
        for family, members in families.items():
            modules[f"{precision.name}/{family}.py"] = _twins(
                selection, family, members, precision, tier.name if tier else "plain")
    return modules


def _twins(selection: Selection, family: str, kernels: dict[Operation, Program],
           precision: Precision, tier: str) -> str:
    programs = tuple(kernels.values())
    return render("python/family.py", banner=selection.banner, title=family_title(family),
                  precision=precision, imports=numpy.imports(programs, precision), tier=tier,
                  functions=[numpy.function(op, program, precision)
                             for op, program in kernels.items()],
                  kernel="wide_kernel" if programs[0].wide else f"{precision.name}_kernel")
