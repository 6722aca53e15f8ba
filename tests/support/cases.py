"""Cases of one test: cheaper than parameters where cases are short, with equally clear failures."""

import functools
import inspect
from collections.abc import Callable, Iterable
from itertools import product

import pytest

Test = Callable[..., None]


def for_all(**values: Iterable[object]) -> Callable[[Test], Test]:
    """Run the test for every combination of these values, the last of them varying fastest; it
    fails with the errors of all cases that do, and their names.  A partial is called anew for each
    case."""
    cases = tuple(product(*(tuple(x) for x in values.values())))
    assert cases

    def decorated(test: Test) -> Test:
        @functools.wraps(test)
        def run(**fixtures: object) -> None:
            errors: list[BaseException] = []
            names: list[str] = []
            for case in cases:
                made = (x() if isinstance(x, functools.partial) else x for x in case)
                try:
                    test(**fixtures, **dict(zip(values, made, strict=True)))
                except (Exception, pytest.fail.Exception) as error:
                    names.append("-".join(map(name_of, case)))
                    error.add_note(f"in case {names[-1]}")
                    errors.append(error)
            if errors:
                raise BaseExceptionGroup(f"of {len(cases)} cases failed {', '.join(names)}", errors)

        signature = inspect.signature(test)
        setattr(run, "__signature__", signature.replace(parameters=[  # noqa: B010  unknown to mypy
            x for name, x in signature.parameters.items() if name not in values]))
        return run

    return decorated


def name_of(value: object) -> str:
    """Text of this value in a case's name: its own name if it has one."""
    if isinstance(value, functools.partial):
        return "-".join(map(name_of, value.args))
    named = (getattr(value, "name", None), getattr(value, "__name__", None))
    return next((x for x in named if isinstance(x, str)), str(value))
