"""A small invented report: no figure was measured, and strings and numbers are awkward."""

from math import inf, isnan, nan

from coscrew_codegen.accuracy.tiers import TIERS as ALL_TIERS
from coscrew_codegen.reports.kernels.report_json import (
    SCHEMA,
    Change,
    Comparison,
    CompilerRecord,
    DriftErrors,
    ErrorFigures,
    Provenance,
    ProvenBound,
    Report,
    ReportEntry,
    Time,
)

AWKWARD = "</script><script>alert(1)</script> <b> & \"ω~\" 'τ' | `x` *y* \u2028 <!--"
LAYOUTS = (("C", "gcc", "array of structs"), ("C", "gcc", "structure of arrays"),
           ("C", "gcc", "latency"), ("Python", None, "N = 1000"))
TIERS = tuple(tier.name for tier in ALL_TIERS)


def _errors(worst: float) -> ErrorFigures:
    return ErrorFigures(1000, worst, worst / 2, 0.25, ("0x1.8p+0", "-0x1.23456789abcdep-1022"),
                        "ang.y")


def _time(language: str, compiler: str | None, layout: str, ns: float, width: float,
          ratio: float | None, dominated: bool) -> Time:
    low, high = (None, None) if ratio is None else (ratio - width / 4, ratio + width / 2)
    return Time(language, compiler, layout, ns, ns - width / 2, ns + width, ns - width, 25, ratio,
                low, high, dominated)


def _entry(number: int, operation: str, family: str, precision: str, tier: str) -> ReportEntry:
    place = TIERS.index(tier)
    top = {"double": 3.25e15, "single": 7.125e7}[precision]
    times = tuple(_time(language, compiler, layout, (1.5 + number) * (place + 1) + 0.0625 * k,
                        0.03125 * (k + 1), 1.0 if place == 0 else place + 1.0, tier == "certified")
                  for k, (language, compiler, layout) in enumerate(LAYOUTS))
    worst = (top, 1.0625, 0.5)[place]
    return ReportEntry(
        operation, family, f"co = {operation} {AWKWARD}", precision, tier, "ulp",
        _errors(2.5 - place / 2), _errors(worst),
        ProvenBound(f"{5 - place} u S", 5.0 - place, 3.0 * place, True,
                    0.125 * (number + place + 1)),
        ((1.0, 0.5), (1e3, 2.0 + place), (1e8, worst)), 30 + 10 * place, "18 mul, 12 add", times)


def sample_report() -> Report:
    """Two operations in all tiers, and three whose figures are missing, infinite or no numbers."""
    names = (("product_CoAdc", "coscrew"), ("cross_sc", "coscrew"))
    entries = [_entry(number, name, family, precision, tier)
               for number, (name, family) in enumerate(names)
               for precision in ("double", "single") for tier in TIERS]
    rounded = (_time("C", "gcc", "structure of arrays", 10.5, 0.0, None, False),)
    entries += [
        ReportEntry("vec3_copy", "vec3", "vo = vi", "double", "plain", "ulp", _errors(0.0),
                    _errors(0.0),
                    ProvenBound("0", 0.0, 0.0, False, 0.0), ((1.0, 0.0),), 0, "no arithmetic",
                    rounded),
        ReportEntry("vec3_l2norm", "vec3", "|v|", "double", "plain", "u", _errors(1.5),
                    _errors(inf),
                    None, ((inf, inf), (nan, nan)), 6, "3 mul, 2 add, 1 sqrt", rounded),
        ReportEntry("dc", "trig", "sin θ, cos θ", "single", "plain", "ulp", None, _errors(nan),
                    None, (),
                    2, "2 trig", ()),
    ]
    provenance = Provenance(
        f"coscrew report {AWKWARD}", 7, "0.0", f"made-up machine {AWKWARD}", 2, "system", "3.11",
        "2.0", (CompilerRecord("gcc", f"gcc {AWKWARD}",
                               f"-O3 -march=native {'-ffp-contract=off ' * 12}"),
                CompilerRecord("clang", "clang 0", "-O3")), 12.5)
    drift = (DriftErrors("double", False, 1000, 12.5, 101.25, 20.5, 20.25, 21.0),
             DriftErrors("single", True, 1000000, 1.5, inf, 30.25, 30.0, 30.5))
    changes = (Change("product_CoAdc", "double", "plain", f"ns {AWKWARD}", 2.0, 3.0, 1.5),
               Change("cross_sc", "single", "accurate", "worst error, hard, ulp", 4.0, 4.0, 1.0),
               Change("cross_sc", "single", "plain", "worst error, hard, ulp", 4.0, 1.0, 0.25))
    return Report(SCHEMA, provenance, tuple(entries), drift,
                  Comparison(f"before {AWKWARD}", changes))


def variant(entry: ReportEntry) -> str:
    """The name of an entry."""
    return f"{entry.operation} {entry.precision} {entry.tier}"


def layout_name(time: Time) -> str:
    """The name of the timed layout."""
    return ", ".join(filter(None, (time.language, time.compiler, time.layout)))


def same(value: float, wanted: float) -> bool:
    """Returns whether both are equal, or both NaN."""
    return value == wanted or isnan(value) and isnan(wanted)


SHOWN_FIRST = ", ".join(filter(None, LAYOUTS[1]))
