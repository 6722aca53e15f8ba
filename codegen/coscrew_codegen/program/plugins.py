"""Finds effects, tiers, targets, readers …: adding or deleting a file adds or removes one.

Each is a module of its package and assigns the object to an agreed name, such as `EFFECT`.  Modules
without that name in their text serve the others, and are not imported to look for it."""

import sys
from collections.abc import Iterable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import walk_packages
from typing import Protocol, TypeVar


class Named(Protocol):
    """An object with a name that is unique in its package."""

    @property
    def name(self) -> str: ...


Found = TypeVar("Found", bound=Named)


def discover(package: str, path: Iterable[str], attribute: str, kind: type[Found]
             ) -> tuple[Found, ...]:
    """The objects called `attribute` in the modules of a package and of the packages in it, in the
    order of module names.

    Raises TypeError for an object of another kind, ValueError for two of the same name."""
    owners: dict[str, str] = {}
    things: list[Found] = []
    for name in sorted(x.name for x in walk_packages(path, f"{package}.") if not x.ispkg):
        thing = getattr(import_module(name), attribute, None) if _has(name, attribute) else None
        module = name.removeprefix(f"{package}.")
        if thing is None:
            continue
        if not isinstance(thing, kind):
            raise TypeError(f"{package}.{module}: {attribute} is {type(thing).__name__}; wanted "
                            f"{kind.__name__}")
        if thing.name in owners:
            raise ValueError(f"{package}: {owners[thing.name]}.py and {module}.py are both called "
                             f"{thing.name!r}")
        owners[thing.name] = module
        things.append(thing)
    return tuple(things)


def _has(module: str, attribute: str) -> bool:
    """Returns whether the text or bytecode of a module contains this word, or cannot be read."""
    spec = find_spec(module)
    return not (spec and spec.origin and spec.has_location) or \
        attribute.encode() in Path(spec.origin).read_bytes()


def holder(package: str, attribute: str, thing: object) -> str:
    """The name of the module in a package that assigns this object to `attribute`; "" if none
    does."""
    return next((name for name, module in [*sys.modules.items()]
                 if name.startswith(f"{package}.")
                 and getattr(module, attribute, None) is thing), "")
