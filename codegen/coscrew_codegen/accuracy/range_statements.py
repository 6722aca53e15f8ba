"""Statements of bounds that are proved over stated ranges, for comments and docstrings."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isfinite

from coscrew_codegen.accuracy.range_proofs import ResultBound, ResultBounds
from coscrew_codegen.accuracy.rounding_rules import followed
from coscrew_codegen.program.scene_functions import ArgumentRanges, FunctionProgram
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument

_LISTED = 36
"""The most components, or rows of a matrix, whose bounds are listed one by one."""
_ENDS = 3
"""The most intervals of an argument that are written out."""


def statement(function: FunctionProgram, bounds: Mapping[Precision, ResultBounds]) -> str:
    """The bounds of the function's results in these precisions, over its stated ranges."""
    parts, silent, start = [], [], 0
    for a in function.program.outputs:
        stop = start + a.quantity.size
        of = {p: each[start:stop] for p, each in bounds.items()}
        start = stop
        known = [k for k in range(a.quantity.size)
                 if all(isfinite(each[k].error + each[k].size) for each in of.values())]
        if any(each[k].error for each in of.values() for k in known):
            parts.append(_of_output(a, of, known))
        if len(known) < a.quantity.size:
            silent.append(f"other components of {a.name}" if known else a.name)
    none = f"Nothing is proved of {_listed(silent)}: {reason(function)}." if silent else ""
    proved = f"Proved for every {domain(function)}: {'; '.join(parts)}." if parts else ""
    return "  ".join(filter(None, (proved, none)))


def reason(function: FunctionProgram) -> str:
    """The reason why results have no proved bound."""
    assert function.ranges
    if not followed(function.program):
        return "it calls functions beyond sines and cosines, or chooses"
    used = {x.argument for x in function.program.used_inputs()}
    unstated = [a.name for n, (a, each) in enumerate(zip(
        function.program.inputs, function.ranges.intervals, strict=True))
        if n in used and not all(isfinite(end) for x in each for end in x)]
    return f"[ranges] states no range of {_listed(unstated)}" if unstated else \
        "no bound of its quotients is known"


def _of_output(a: Argument, of: Mapping[Precision, ResultBounds], known: Sequence[int]) -> str:
    """The bounds of the components of an output that have one."""
    moves = " and ".join(f"{two_digits_up(max(each[k].error for k in known))} in {p.name}"
                         for p, each in of.items())
    whole = len(known) == a.quantity.size
    name = a.name if whole else f"{len(known)} of the {a.quantity.size} components of {a.name}"
    words = (f"rounding moves {name} by at most {moves} precision, and |{a.name}| <= "
             f"{_size(x for each in of.values() for x in (each[k] for k in known))}")
    rows = list(_rows(a, next(iter(of.values()))))
    if not whole or not 1 < len(rows) <= _LISTED:
        return words
    lists = [f"{', '.join(_error(x) for x in _rows(a, each))} in {p.name}"
             for p, each in of.items()]
    sizes = ", ".join(_size(x) for x in _rows(a, [*of.values()][-1]))
    return (f"{words}; by {'component' if len(rows) == a.quantity.size else 'row'} "
            f"{'; '.join(lists)}; sizes {sizes}")


def _error(row: Iterable[ResultBound]) -> str:
    return two_digits_up(max(x.error for x in row))


def _size(row: Iterable[ResultBound]) -> str:
    """The largest size of computed results."""
    return f"{float(two_digits_up(max(x.size + x.error for x in row))):g}"


def _rows(a: Argument, each: Sequence[ResultBound]) -> Iterator[Sequence[ResultBound]]:
    """The components one by one or, if there are many, by row."""
    wide = a.quantity.size // a.quantity.shape[0] if a.quantity.shape else 1
    wide = wide if a.quantity.size > _LISTED or len(a.quantity.shape) > 1 else 1
    for start in range(0, len(each), wide):
        yield each[start:start + wide]


def domain(function: FunctionProgram) -> str:
    """The ranges of the function's arguments, in words."""
    assert function.ranges
    return _listed([_of_argument(n, a, function.ranges)
                    for n, a in enumerate(function.program.inputs)]) or "call"


def _of_argument(number: int, a: Argument, ranges: ArgumentRanges) -> str:
    turning = {x.index for each in ranges.quaternions for x in each if x.argument == number}
    intervals = [x for k, x in enumerate(ranges.intervals[number]) if k not in turning]
    words = _of_numbers(a.name, intervals)
    return f"{words} (quaternions with 0.999 <= |q|^2 <= 1.001)" if turning else words


def _of_numbers(name: str, intervals: Sequence[tuple[float, float]]) -> str:
    if not any(isfinite(end) for x in intervals for end in x):
        return name
    different = dict.fromkeys(intervals)
    if len(different) == 1:
        (low, high), = different
        return f"|{name}| <= {high:.5g}" if low == -high else f"{name} in [{low:.5g}, {high:.5g}]"
    if len(intervals) > _ENDS:
        return f"{name} in the scene's ranges"
    return f"{name} in " + " × ".join(f"[{low:.5g}, {high:.5g}]" for low, high in intervals)


def _listed(words: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), *words[-1:])))
