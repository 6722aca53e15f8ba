"""Advice and tables of coscrew cost: advice that follows from them, tables, and marks whose numbers
can be read."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import pytest
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from coscrew_codegen.backends.html.plots import place_labels, styled
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.figures.cost_figure import panel
from coscrew_codegen.reports.cost.figures.cost_page import about, accuracies
from coscrew_codegen.reports.cost.function_errors import Bounds, ErrorStatistics, FunctionErrors
from coscrew_codegen.reports.cost.recommendations import recommended, sentences
from coscrew_codegen.reports.timing.intervals import Interval


def made(tier: str, precision: str, worst: float, ns: float, bound: float = 0) -> FunctionErrors:
    bounds = Bounds(bound, 1, 2, 3) if bound else None
    return FunctionErrors("inverse_dynamics", tier, precision, 64,
                          Interval(ns, 0.99 * ns, 1.01 * ns),
                          (ErrorStatistics("N m", worst / 3, worst, 8, 7, 100, "run", bounds),), {})


def choices(single_accurate_ns: float = 110) -> Sequence[FunctionErrors]:
    return (made("plain", "double", 1e-14, 100), made("plain", "single", 1e-5, 90),
            made("accurate", "double", 1e-15, 500),
            made("accurate", "single", 1e-6, single_accurate_ns),
            made("certified", "double", 1e-14, 520, 2e-14),
            made("certified", "single", 1e-5, 480, math.inf))


def measured(rows: Sequence[FunctionErrors]) -> Costs:
    return Costs("spring", "gcc", (), None, (), (tuple(rows),))


def test_the_advice_follows_from_the_figures():
    assert recommended(choices()).name == "double plain"
    assert sentences(choices()) == (
        "inverse_dynamics: double plain is within 1e-14 N m everywhere we looked (64 states), at "
        "1.11× single plain (100 ns).",
        "Double accurate is within 1e-15 N m: 10 times less error than double plain, at 5× double "
        "plain.",
        "In single precision accurate is within 1 µN m, at 1.22× plain.",
        "Double certified returns the plain results and bounds of their errors, here at most 2e-14 "
        "N m, at 5.2× double plain.")


def test_what_is_slow_is_not_recommended():
    """Double precision computed by software is such a case."""
    slow = [replace(x, time=Interval(9000, 8990, 9010)) if x.precision == "double" else x
            for x in choices()]
    assert recommended(slow).name == "single accurate"
    assert sentences(slow)[0] == (
        "inverse_dynamics: single accurate is within 1 µN m everywhere we looked (64 states), at "
        "1.22× single plain (110 ns).")
    assert sentences(slow)[-1] == (
        "Single certified returns the plain results, but no bounds of their errors at some of "
        "these states, at 5.33× single plain.")
    alone = [x for x in choices(400) if x.precision == "single"]
    assert recommended(alone).name == "single plain"
    assert sentences(alone)[0].endswith("(64 states), the fastest choice (90 ns).")


def test_what_the_scene_is_not_generated_in_is_not_recommended():
    single = [replace(x, emitted=x.precision == "single") for x in choices()]
    assert recommended(single).name == "single accurate"
    assert not any("ouble" in x for x in sentences(single))
    assert not any("comparison" in x for x in about(measured(choices())))
    *_, last = about(measured(single))
    assert last == ("The scene is generated in single precision alone: double is measured for "
                    "comparison, not recommended.")


def test_the_table_says_what_is_recommended_and_what_is_better():
    """Plain is not called better than certified, which says more."""
    (table,) = accuracies(choices())
    marks = {row[0]: row[-1] for row in table.rows}
    assert marks == {"double plain": "recommended", "single plain": "", "double accurate": "",
                     "single accurate": "double plain is better", "double certified": "",
                     "single certified": ""}


def with_units(*worst: tuple[str, float]) -> list[FunctionErrors]:
    """Choices with these errors in these units."""
    return [replace(x, errors=tuple(replace(x.errors[0], unit=unit, worst=error)
                                    for unit, error in worst)) for x in choices()]


def test_units_without_errors_have_no_table():
    tables = [*accuracies(with_units(("N m", 1e-6), ("kg", 0), ("N", 2e-6), ("kg m^2", 0)))]
    assert [x.headers[0] for x in tables] == ["inverse_dynamics, N m", "inverse_dynamics, N"]
    assert [x.notes for x in tables] == [(), ("Exact in all choices: kg, kg m².",)]
    assert "within 1 µN m and 2 µN everywhere" in sentences(
        with_units(("N m", 1e-6), ("kg", 0), ("N", 2e-6)))[0]
    (alone,) = accuracies(with_units(("kg", 0), ("kg m^2", 0)))
    assert alone.headers[0] == "inverse_dynamics, kg" and len(alone.rows) == 6
    assert "is exact everywhere" in sentences(with_units(("kg", 0), ("kg m^2", 0)))[0]


def test_ratios_have_three_digits():
    one = made("certified", "double", 1e-14, 500, 2e-14)
    errors = replace(one.errors[0], bounds=Bounds(2e-14, 1, 9.996, 150))
    (table,) = accuracies([replace(one, errors=(errors,)), *choices()])
    assert table.rows[0][6] == "1.00, 10, 150"


def texts_beside(rows: Sequence[FunctionErrors]) -> list[Bbox]:
    """The extents of the texts beside a panel's marks."""
    drawn = Figure(figsize=(12.6, 4.6), layout="constrained")
    panel(drawn.subplots(1, 3)[0], rows)
    place_labels(drawn)
    drawn.draw_without_rendering()
    return [x.get_window_extent() for x in drawn.axes[0].texts]


@pytest.mark.parametrize("single_certified, accurate", ((193, 434), (72, 434), (64, 900), (66, 69)))
def test_numbers_beside_marks_do_not_meet(single_certified, accurate):
    """A Panda's mass matrix has such marks: certified and plain single have the same error."""
    rows = [made("plain", "double", 1.6e-15, 68.9), made("plain", "single", 9.2e-7, 62.9),
            made("accurate", "double", 2.2e-16, accurate), made("accurate", "single", 1.2e-7, 68.5),
            made("certified", "double", 1.6e-15, accurate + 8, 1.6e-15),
            made("certified", "single", 9.2e-7, single_certified, 9.2e-7)]
    boxes = styled(texts_beside)(rows)
    assert len(boxes) == 6
    for a, b in combinations(boxes, 2):
        assert not a.overlaps(b), (a, b)
