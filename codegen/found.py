"""What is found, not listed: a file put into a folder belongs to it, one taken away is gone.

Effects, tiers, targets: each is a module that holds it under one name.  Modules of the folder that
have no such name help the others."""

from collections.abc import Iterable
from importlib import import_module
from pkgutil import iter_modules
from typing import Protocol, TypeVar


class Named(Protocol):
    """What is found describes itself, by a name that nothing else in its folder has."""

    @property
    def name(self) -> str: ...


Found = TypeVar("Found", bound=Named)


def found(package: str, path: Iterable[str], attribute: str, kind: type[Found]
          ) -> tuple[Found, ...]:
    """What the modules of a package call `attribute`, by the modules' names.

    Raises TypeError for what is of another kind, ValueError for two of one name."""
    owners: dict[str, str] = {}
    things: list[Found] = []
    for module in sorted(x.name for x in iter_modules(path)):
        thing = getattr(import_module(f"{package}.{module}"), attribute, None)
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
