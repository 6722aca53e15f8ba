"""The Python package `coscrew` and its subpackages for tiers: kernels in pure NumPy, stubs, and the
choice between them and the extension."""

from collections.abc import Iterable

from coscrew_codegen.accuracy.tiers import PLAIN, TIERS, Tier
from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.algebra.operations import family_named
from coscrew_codegen.backends.c.c_statements import listed
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.numpy import numpy_elementary, numpy_operations, numpy_twins
from coscrew_codegen.backends.python_extension.extension import provenance
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.requirements import defects_of, requirements
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.backends.version import VERSION
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import TOLERANCE

# Short names of constructors.
_ALIASES = (("SE3", "SE3_fromRt"), ("screw", "screw_from_lin_ang"),
            ("coscrew", "coscrew_from_lin_ang"))

_PLAIN = ("__init__.py", "_dispatch.py", "_arrays.py", "_kernel.py", "_twins.py", "_checked.py",
          "_exact.py", "_provenance.py")
"""The modules of `coscrew` itself, by their templates."""


def files(library: Library) -> Files:
    """python/coscrew/__init__.py, python/coscrew/accurate/__init__.py and so on."""
    return {"/".join(filter(None, ("python/coscrew", tier.mark, file))): text for tier in TIERS
            if library.having(tier) for file, text in _package(library, tier).items()}


def _package(library: Library, tier: Tier) -> Files:
    """The files of a tier's package, by path in it."""
    names, built = [op.name for op in library.having(tier)], provenance(library, tier)
    required = _required(library)
    selfcheck = not tier.mark and "coscrew" in library.families
    shared = {"banner": library.banner, "names": names, "provenance": built,
              "aliases": [] if tier.mark else _aliases(names), "package": tier.package,
              "version": VERSION, "about": tier.in_words, "extension": bool(built),
              "precisions": [precision.name for precision in library.precisions],
              "selfcheck": selfcheck, "tolerance": float(TOLERANCE),
              "predicates": _predicates(library, tier),
              "required": required, "defects": [
                  {"letter": letter.value, "name": op.name, "family": op.family}
                  for letter, op in defects_of(required.values()).items()]}
    package = {"_dispatch.py": render("python/_dispatch.py", **shared),
               "__init__.py": render("python/tier.py", **shared)} if tier.mark else {
        name: render(f"python/{name}", **shared)
        for name in (*_PLAIN, *(["_selfcheck.py"] if selfcheck else []))}
    if not tier.mark:
        package |= {f"_elementary_{p.name}.py": numpy_elementary.module(
            p, [x.name for x in (*ELEMENTARY, *ERRORS)], library.banner)
            for p in dict.fromkeys((*library.precisions, DOUBLE))}  # wide kernels need double
    first, *_ = library.precisions
    package["__init__.pyi"] = _stubs(library, tier, first, shared, "np.floating", top=True)
    if not tier.mark:
        package |= {"py.typed": "", **_modules_of_checks(library)}
    for precision in library.precisions:
        package[f"{precision.name}/__init__.pyi"] = _stubs(
            library, tier, precision, shared, f"np.{precision.numpy_type}")
    return package | _twin_modules(library, tier)


def _required(library: Library) -> dict[str, str]:
    """The letters of operations that refuse arguments, by name."""
    return {name: letters for letters_of in library.made(requirements).values()
            for name, letters in letters_of.items()}


def _aliases(names: Iterable[str]) -> list[tuple[str, str]]:
    return [(alias, name) for alias, name in _ALIASES if name in names]


def _predicates(library: Library, tier: Tier) -> dict[str, str]:
    """Functions that compare the defect of a rotation with the tolerance, and their argument."""
    whole = not tier.mark and {"mat3x3", "quaternion"} <= set(library.families)
    return {"mat3x3_is_rotation": "R", "quaternion_is_unit": "q"} if whole else {}


def _stubs(library: Library, tier: Tier, precision: Precision, shared: dict[str, object],
           scalar: str, top: bool = False) -> str:
    """A module's stub file; the docstrings of twins are in their sources."""
    docstrings = numpy_twins.docstrings(library, tier, precision)
    stubs = [numpy_operations.stub(op, docstrings[op.name]) for op in library.having(tier)]
    return render("python/operations.pyi", stubs=stubs, top=top, scalar=scalar, **shared)


def _twin_modules(library: Library, tier: Tier) -> Files:
    """The modules of kernels, one per family and precision, and one per precision that gathers
    them."""
    modules: Files = {}
    names = [op.name for op in library.having(tier)]
    for precision in library.precisions:
        families = {family: module for family, made in library.made(numpy_twins.twins).items()
                    if (module := made[tier.name, precision.name]).functions}
        modules[f"{precision.name}/__init__.py"] = render(
            "python/precision.py", banner=library.banner, precision=precision,
            package=tier.package, aliases=_aliases(names),
            families=[{"name": family, "operations": [x.name for x in twins.functions]}
                      for family, twins in families.items()])
        for family, twins in families.items():
            modules[f"{precision.name}/{family}.py"] = _family_module(
                library, tier, precision, family, twins)
    return modules


def _family_module(library: Library, tier: Tier, precision: Precision, family: str,
                   twins: numpy_twins.Twins) -> str:
    return render("python/family.py", banner=library.banner, title=family_named(family).title,
                  precision=precision, imports=twins.imports, tier=tier.name,
                  functions=twins.functions, quiet=tier.bounds, package=tier.package,
                  own=not all(x.shared for x in twins.functions), twin=listed(
                      "twin = single_twins(", ["__name__", *(
                          f"{x}={x}" for x in twins.others), *["quiet=True"] * tier.bounds], ")")
                  if any(x.shared for x in twins.functions) else "",
                  kernel="wide_kernel" if twins.wide else f"{precision.name}_kernel")


def _modules_of_checks(library: Library) -> Files:
    """The modules of defects' kernels whose families are not selected: they hold nothing else."""
    needed = defects_of(_required(library).values()).values()
    return {f"{precision.name}/{op.family}.py": _family_module(
        library, PLAIN, precision, op.family,
        numpy_twins.twins_of({op: library_program(op.name)}, precision))
        for op in needed if op.family not in library.families for precision in library.precisions}


TARGET = Target("Python package", ("python",), library=files)
