"""Which files are generated, and what each holds: Selection → {path: text}."""

import hashlib
from collections.abc import Iterator
from functools import partial

from coscrew_codegen.kernel import kernel_of
from coscrew_codegen.operations import Operation, family_title
from coscrew_codegen.passes import simplified
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import QUANTITIES
from coscrew_codegen.render import render
from coscrew_codegen.selection import Selection
from coscrew_codegen.targets import c, c_storage, gufunc, numpy
from coscrew_codegen.targets.precision import Precision
from coscrew_codegen.tiers.plain import plain
from coscrew_codegen.tiers.table import ACCURATE, TIERS, Tier, has_tiers

Files = dict[str, str]  # by path in the output folder, with forward slashes
Programs = dict[str, Program]

# What a family's header includes, so that any header may come first.
_INCLUDES = {
    "vec3": (), "trig": (), "mat6x6": (), "mat3x3": ("vec3",), "SE3": ("mat3x3",),
    "matrix": ("SE3", "trig"), "screw": ("matrix", "mat6x6"), "coscrew": ("screw",),
}

# Short names of constructors, in Python.
_ALIASES = (("SE3", "SE3_fromRt"), ("screw", "screw_from_lin_ang"),
            ("coscrew", "coscrew_from_lin_ang"))


_UMBRELLAS = ("ksl", *(f"ksl_{tier.name}" for tier in TIERS))

# NumPy's C names for the precisions: type number, DType.
_NUMPY_C_NAMES = {"double": ("NPY_DOUBLE", "PyArray_DoubleDType"),
                  "single": ("NPY_FLOAT", "PyArray_FloatDType")}


def program_of(operation: Operation) -> Program:
    """The operation's program: kernel, passes, plain tier."""
    return plain(simplified(kernel_of(operation)))


def generated_files(selection: Selection, programs: Programs) -> Files:
    """Every file of the selection, by its path in the output folder."""
    files: Files = {}
    headers = _headers(selection, programs)
    amalgamation = _amalgamation(selection, headers, "All headers of plain kernels")
    extension = selection.languages == ("c", "python")
    if "c" in selection.languages:
        files |= {f"c/include/ksl/{name}.h": text for name, text in headers.items()}
        files["c/coscrew.h"] = amalgamation
        for tier in TIERS:
            made = _tier_headers(selection, programs, tier)
            files |= {f"c/include/ksl/{name}.h": text for name, text in made.items()}
            files[f"c/coscrew_{tier.name}.h"] = _amalgamation(
                selection, {"ksl_types": headers["ksl_types"], **made},
                f"All headers of {tier.name} kernels")
    sources = _extension(selection, programs) if extension else {}
    provenance = _digest(amalgamation, *sources.values())
    if extension:
        files["c/__init__.py"] = render("c/__init__.py", banner=selection.banner)
        files |= {f"gufunc/{name}": text for name, text in sources.items()}
        files["gufunc/module.c"] = _extension_module(selection, provenance)
    if "python" in selection.languages:
        package = _package(selection, programs, extension, provenance)
        files |= {f"python/{name}": text for name, text in package.items()}
    return files


def _digest(*texts: str) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]


# C headers


def _headers(selection: Selection, programs: Programs) -> dict[str, str]:
    """The headers by name, each after those it includes."""
    families = selection.families
    headers = {"ksl_types": _types_header(selection)}
    for family in families:
        functions = [function for precision in selection.precisions
                     for function in (*c_storage.storage_functions(family, precision),
                                      *_c_functions(selection, programs, family, precision))]
        allocations = [c_storage.allocation(family, precision)
                       for precision in selection.precisions]
        headers[family] = render(
            "c/family.h", banner=selection.banner, title=family_title(family),
            guard=f"KSL_{family.upper()}_H", functions=functions,
            includes=("ksl_types", *_included(family, families)),
            allocations=[function for function in allocations if function])
    headers["ksl_selfcheck"] = render(
        "c/ksl_selfcheck.h", banner=selection.banner,
        precisions=list(map(c_storage.selfcheck_numbers, selection.precisions)))
    headers["ksl"] = render(
        "c/ksl.h", banner=selection.banner, includes=(*families, "ksl_selfcheck"), guard="KSL_H",
        title="Everything: vectors, rotations, displacements, screws and coscrews.")
    return headers


def _c_functions(selection: Selection, programs: Programs, family: str,
                 precision: Precision) -> Iterator[c.CFunction]:
    for operation in selection.operations:
        if operation.family == family:
            yield c.function(operation, programs[operation.name], precision)


def _types_header(selection: Selection) -> str:
    types = [{"name": c.type_name(quantity.name, precision),
              "meaning": f"{c_storage.meaning(quantity)}; {precision.name} precision.",
              "views": c_storage.views(quantity, precision)}
             for quantity in c_storage.TYPES for precision in selection.precisions]
    return render("c/ksl_types.h", banner=selection.banner, types=types,
                  precisions=[precision.name for precision in selection.precisions])


def _included(family: str, families: tuple[str, ...]) -> tuple[str, ...]:
    """The selected families a header includes directly; through those left out, theirs."""
    found: list[str] = []
    for other in _INCLUDES[family]:
        found += [other] if other in families else _included(other, families)
    return tuple(dict.fromkeys(found))


def _tier_headers(selection: Selection, programs: Programs, tier: Tier) -> dict[str, str]:
    """The headers of a tier behind plain: exact errors, one per family, one that includes all."""
    exact = {"ksl_exact": render("c/ksl_exact.h", banner=selection.banner)}
    headers = exact if tier.header == "ksl_exact" else {}
    for family in selection.families:
        functions = [
            c.function(tier.operation(op), tier.program(programs[op.name], precision.name),
                       precision, tier.name)
            for precision in selection.precisions for op in selection.operations
            if op.family == family and has_tiers(programs[op.name])]
        if functions:
            headers[f"{family}_{tier.name}"] = render(
                "c/family.h", banner=selection.banner,
                title=f"{family_title(family)}\n   {tier.title}",
                guard=f"KSL_{family.upper()}_{tier.name.upper()}_H", functions=functions,
                includes=(tier.header,), allocations=[])
    umbrella = tuple(name for name in headers if name != "ksl_exact")
    headers[f"ksl_{tier.name}"] = render(
        "c/ksl.h", banner=selection.banner, includes=umbrella,
        title=f"All kernels of the {tier.name} tier.", guard=f"KSL_{tier.name.upper()}_H")
    return headers


def _amalgamation(selection: Selection, headers: dict[str, str], title: str) -> str:
    sections = ["\n".join(line for line in text.splitlines()[1:]
                          if not line.startswith('#include "')) + "\n"
                for name, text in headers.items() if name not in _UMBRELLAS]
    return render("c/coscrew.h", banner=selection.banner, sections=sections, title=title)


# the extension module


def _extension(selection: Selection, programs: Programs) -> dict[str, str]:
    """The C sources of the gufuncs, by file name."""
    accesses = [gufunc.access(quantity, precision)
                for quantity in QUANTITIES for precision in selection.precisions]
    sources = {"_gufunc.h": render("gufunc/_gufunc.h", banner=selection.banner, accesses=accesses,
                                   families=selection.families,
                                   amalgamation="../c/coscrew.h")}
    dtypes = [_NUMPY_C_NAMES[precision.name][1] for precision in selection.precisions]
    sources["promoter.c"] = render("gufunc/promoter.c", banner=selection.banner, dtypes=dtypes)
    for family in selection.families:
        gufuncs = [gufunc.gufunc(op, selection.precisions,
                                 numpy.docstring_of(op, programs[op.name]))
                   for op in selection.operations if op.family == family]
        sources[f"{family}.c"] = render("gufunc/family.c", banner=selection.banner,
                                        family=family, gufuncs=gufuncs)
        sources[f"{family}_avx2.c"] = render("gufunc/family_avx2.c", banner=selection.banner,
                                             family=family)
    return sources


def _table(selection: Selection, name: str, suffix: str) -> str:
    entries = [f"coscrew_{family}_{suffix}" for family in selection.families]
    return c.listed(f"static const coscrew_gufunc *const {name}[] = {{", entries, "};")


def _extension_module(selection: Selection, provenance: str) -> str:
    most = max(len(op.inputs) + len(op.outputs) for op in selection.operations)
    return render("gufunc/module.c", banner=selection.banner, families=selection.families,
                  most_arguments=most, provenance=provenance,
                  baseline=_table(selection, "baseline", "gufuncs"),
                  avx2=_table(selection, "avx2", "gufuncs_avx2"),
                  types=[_NUMPY_C_NAMES[precision.name][0] for precision in selection.precisions])


# the Python package


def _package(selection: Selection, programs: Programs, extension: bool,
             provenance: str) -> dict[str, str]:
    """The files of the package `coscrew`, by path in it."""
    names = [op.name for op in selection.operations]
    aliases = [(alias, name) for alias, name in _ALIASES if name in names]
    shared = {"banner": selection.banner, "names": names, "aliases": aliases,
              "precisions": [precision.name for precision in selection.precisions],
              "extension": extension, "provenance": provenance,
              "selfcheck": "coscrew" in selection.families}

    package = {name: render(f"python/{name}", **shared)
               for name in ("__init__.py", "_dispatch.py", "_arrays.py", "_kernel.py", "_exact.py")}
    if "coscrew" in selection.families:
        package["_selfcheck.py"] = render("python/_selfcheck.py", **shared)
    stubs = partial(_stubs, selection.operations, programs, shared)
    package["__init__.pyi"] = stubs("np.floating", top=True)
    package["py.typed"] = ""
    for precision in selection.precisions:
        package[f"{precision.name}/__init__.pyi"] = stubs(f"np.{precision.numpy_type}")
    package |= _twin_modules(selection, selection.operations, programs, None)
    return package | _accurate_package(selection, programs, shared)


def _accurate_package(selection: Selection, programs: Programs,
                      shared: dict[str, object]) -> dict[str, str]:
    """The files of coscrew.accurate: twins in both precisions, and the choice between them."""
    operations = tuple(op for op in selection.operations if has_tiers(programs[op.name]))
    shared = {**shared, "names": [op.name for op in operations], "aliases": []}
    package = {"__init__.py": render("python/accurate.py", **shared),
               "__init__.pyi": _stubs(operations, programs, shared, "np.floating")}
    for precision in selection.precisions:
        package[f"{precision.name}/__init__.pyi"] = _stubs(
            operations, programs, shared, f"np.{precision.numpy_type}")
    package |= _twin_modules(selection, operations, programs, ACCURATE)
    return {f"accurate/{name}": text for name, text in package.items()}


def _stubs(operations: tuple[Operation, ...], programs: Programs, shared: dict[str, object],
           scalar: str, top: bool = False) -> str:
    stubs = [numpy.stub(op, programs[op.name], scalar) for op in operations]
    return render("python/operations.pyi", stubs=stubs, top=top, **shared)


def _twin_modules(selection: Selection, operations: tuple[Operation, ...], programs: Programs,
                  tier: Tier | None) -> dict[str, str]:
    """The modules of both precisions, one per family, and what gathers them."""
    modules: dict[str, str] = {}
    families = tuple(f for f in selection.families if any(op.family == f for op in operations))
    names = [op.name for op in operations]
    for precision in selection.precisions:
        folder = precision.name
        by_family = [{"name": family, "operations": [op.name for op in operations
                                                     if op.family == family]}
                     for family in families]
        modules[f"{folder}/__init__.py"] = render(
            "python/precision.py", banner=selection.banner, precision=precision,
            package=f"coscrew.{tier.name}" if tier else "coscrew", families=by_family,
            aliases=[(alias, name) for alias, name in _ALIASES if name in names])
        for family in families:
            modules[f"{folder}/{family}.py"] = _twins(
                selection, [op for op in operations if op.family == family], programs, precision,
                tier)
    return modules


def _twins(selection: Selection, operations: list[Operation], programs: Programs,
           precision: Precision, tier: Tier | None) -> str:
    plain = [programs[op.name] for op in operations]
    chosen = [tier.program(p, precision.name) for p in plain] if tier else plain
    functions = [numpy.function(op, program, precision)
                 for op, program in zip(operations, chosen, strict=True)]
    return render("python/family.py", banner=selection.banner,
                  title=family_title(operations[0].family), precision=precision,
                  functions=functions, imports=numpy.imports(tuple(chosen)),
                  kernel="wide_kernel" if chosen[0].wide else f"{precision.name}_kernel",
                  tier=tier.name if tier else "plain")
