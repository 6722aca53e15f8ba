"""Arguments of functions of arrays, given in order or by name, as a mapping; errors of their number
name the missing one."""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.scene.names import or_mean

Shape = tuple[int, ...]
Given = TypeVar("Given")


def bound(function: str, inputs: Sequence[tuple[str, Shape]], given: Sequence[Given],
          named: Mapping[str, Given]) -> dict[str, Given]:
    """The arguments by name, in the order of `inputs`, which holds names and shapes of last axes.

    Raises TypeError for missing, repeated and unknown ones.  If arguments are given in order, the
    missing one is the one whose omission makes the others' shapes fit."""
    names = [name for name, _ in inputs]
    if len(given) == len(names) and not named:
        return dict(zip(names, given, strict=True))
    head = f"{function}({', '.join(names)})"
    wanted = "; wanted " + (", ".join(f"{name} {shape}" for name, shape in inputs) or "none")
    if unknown := [name for name in named if name not in names]:
        raise TypeError(f"{head}: no argument {unknown[0]!r}{or_mean(unknown[0], names)}{wanted}")
    if len(given) > len(names):
        raise TypeError(f"{head}: got {len(given)} arguments{wanted}")
    if missing := len(names) - len(given) - len(named):
        raise TypeError(f"{head}: {_missing(inputs, given, named, missing)}{wanted}")
    arguments = dict(zip(names, given, strict=False))
    if twice := [name for name in named if name in arguments]:
        raise TypeError(f"{head}: {twice[0]} is given twice, in order and by name{wanted}")
    arguments.update(named)
    return {name: arguments[name] for name in names}


def _missing(inputs: Sequence[tuple[str, Shape]], given: Sequence[object],
             named: Mapping[str, object], count: int) -> str:
    """"p is missing", if shapes show it; else the number of arguments."""
    others = [x for x in inputs if x[0] not in named]
    fitting = [kept for kept in combinations(others, len(given))
               if all(_fits(x, shape) for x, (_, shape) in zip(given, kept, strict=True))]
    got = f"got {len(given) + len(named) or 'no'} argument{'s' * (len(given) + len(named) != 1)}"
    if len(fitting) == 1:
        lost = [name for name, _ in others if name not in {kept for kept, _ in fitting[0]}]
        return f"{' and '.join(lost)} {'is' if count == 1 else 'are'} missing; {got}"
    return f"{count} of {', '.join(name for name, _ in others)} {'is' if count == 1 else 'are'} " \
           f"missing; {got}"


def _fits(x: object, shape: Shape) -> bool:
    """Returns whether the last axes have these lengths; a number has no axes."""
    try:
        actual: Shape = tuple(np.shape(cast("ArrayLike", x)))
    except ValueError:  # nested lists of several lengths
        return False
    return actual[len(actual) - len(shape):] == shape if shape else not actual
