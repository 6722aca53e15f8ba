"""Stores many results while a function runs, each soon after it is computed.

Results that wait for the end occupy registers, or go to the stack and back: derivatives of seven
joints are 147 numbers.  Elements of arguments that are read behind the first store are copied
before it, so that outputs may overlap inputs."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from coscrew_codegen.backends.c.c_stores import Stores, in_lines
from coscrew_codegen.backends.c.c_together import Together
from coscrew_codegen.backends.nesting import Assignment
from coscrew_codegen.program import Program, Ref

FEWEST = 17
"""Least number of computed results: fewer fit into registers."""
Item = Assignment | Together | str
Declared = Callable[[Sequence[Item]], Iterator[str]]
_ELEMENT = re.compile(r"\b([A-Za-z]\w*)\[(\d+)\]")


def pays(stores: Stores) -> bool:
    """Returns whether the function has many results, none of them computed of arguments by a loop.
    """
    return has_many_results(stores.program) and not any(x.reads for x in stores.alike)


def has_many_results(program: Program) -> bool:
    """Returns whether many results are computed."""
    return len({x.name for x in program.results if isinstance(x, Ref)}) >= FEWEST


def statements(stores: Stores, saved: Mapping[str, str], declared: Declared, width: int
               ) -> Iterator[str]:
    """Declarations and stores, a line of stores at a time; `saved` has the variables of inputs that
    are results."""
    items, of_value, done = stores.declared(), _by_value(stores), set[str]()
    start = _first_result(items, of_value)
    copied = {**_late(stores, items[start:], saved), **saved}
    yield from declared(items[:start])
    yield from stores.copies(copied, width)
    piece, waiting = list[Item](), list[tuple[str, str]]()
    for item in (*(_of_copies(x, copied) for x in items[start:]), ""):
        if not item or sum(len(x) + len(y) + 5 for x, y in waiting) > width:
            yield from declared(piece)
            yield from in_lines(waiting, width)
            done.update(target for target, _ in waiting)
            piece, waiting = [], []
        piece.append(item)
        waiting += _stores_of(item, of_value)
    single = dict(stores.single())
    rest = [x for x in stores.targets if x not in done]
    yield from stores.of_targets([x for x in rest if x not in single], saved, width)
    yield from in_lines([(x, saved.get(single[x], single[x])) for x in rest
                         if single.get(x, x) != x], width)


def _by_value(stores: Stores) -> dict[str, list[tuple[str, str]]]:
    """The stores of each computed value outside of loops: targets and texts."""
    single = dict(stores.single())
    result: dict[str, list[tuple[str, str]]] = {}
    for target, x in zip(stores.targets, stores.program.results, strict=True):
        if isinstance(x, Ref) and target in single:
            result.setdefault(x.name, []).append((target, single[target]))
    return result


def _stores_of(item: Item, of_value: Mapping[str, list[tuple[str, str]]]
               ) -> list[tuple[str, str]]:
    names = () if isinstance(item, str) else item.names
    return [store for name in names for store in of_value.get(name, ())]


def _first_result(items: Sequence[Item], of_value: Mapping[str, list[tuple[str, str]]]) -> int:
    """The place of the first item that is a result; angles, of arguments, are before it."""
    last_angles = max((n for n, x in enumerate(items) if isinstance(x, Together)), default=-1)
    return next((n for n, item in enumerate(items)
                 if n > last_angles and _stores_of(item, of_value)), len(items))


def _late(stores: Stores, items: Sequence[Item], saved: Mapping[str, str]) -> dict[str, str]:
    """The variables of elements of arguments that these items read."""
    arguments = {a.name for a in stores.program.inputs}
    taken = {*(step.name for step in stores.program.instructions), *saved.values()}
    late: dict[str, str] = {}
    for item in items:
        for match in _ELEMENT.finditer(item.expression if isinstance(item, Assignment) else ""):
            if match[1] in arguments and match[0] not in saved:
                name = f"{match[1]}_{match[2]}"
                while name in taken:
                    name += "_"
                late[match[0]] = name
    return late


def _of_copies(item: Item, copied: Mapping[str, str]) -> Item:
    """The item with these variables in place of elements."""
    if not isinstance(item, Assignment):
        return item
    return replace(item, expression=_ELEMENT.sub(lambda x: copied.get(x[0], x[0]), item.expression))
