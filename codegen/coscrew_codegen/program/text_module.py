"""Generated Python, imported from its text."""

from collections.abc import Mapping
from importlib import util
from importlib.abc import InspectLoader
from types import ModuleType


class _TextLoader(InspectLoader):
    """Imports a text."""

    def __init__(self, text: str):
        self._text = text

    def get_source(self, fullname: str) -> str:
        return self._text


def imported(name: str, text: str, known: Mapping[str, object] | None = None) -> ModuleType:
    """The module of this text, in which these names are known."""
    loader = _TextLoader(text)
    spec = util.spec_from_loader(name, loader)
    assert spec
    module = util.module_from_spec(spec)
    vars(module).update(known or {})
    loader.exec_module(module)
    return module
