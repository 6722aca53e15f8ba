"""The sources that a result depends on: derived from imports, compared by syntax trees, and never
fewer than the files that making the result enters."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from coscrew_codegen.runtime import sources, syntax
from coscrew_codegen.runtime.sources import Sources
from tests.support.work import calls_of

ROOT = Path(__file__).parents[2]
MODULE = '''"""A docstring."""
from a import b

FACTOR = 2.5
"""The factor."""


class Kind:
    """A docstring."""

    def half(self, x):
        """Another."""
        # A comment.
        return x / 2
'''


def meaning(text: str) -> syntax.SourceMeaning:
    return syntax.of_module(text.encode(), "a")


@pytest.mark.parametrize("old, new", [
    ("# A comment.", "# Another comment."), ("Another.", "Another docstring."),
    ('"""A docstring."""\nfrom', "from"), ("The factor", "A factor"), ("2.5", "2.50"),
    ("    # A comment.\n", "\n\n"), ("x / 2", "(x\n                / 2)")])
def test_comments_docstrings_and_positions_have_no_meaning(old, new):
    assert old in MODULE
    assert meaning(MODULE.replace(old, new, 1)).digest == meaning(MODULE).digest


@pytest.mark.parametrize("old, new", [
    ("2.5", "2.75"), ("x / 2", "2 / x"), ("half", "third"), ("import b", "import c"),
    ("2.5", "'2.5'"), ("class Kind", "@b\nclass Kind"), ("2.5\n", "2.5\nFACTOR\n")])
def test_all_else_has(old, new):
    assert old in MODULE
    assert meaning(MODULE.replace(old, new, 1)).digest != meaning(MODULE).digest


def test_a_docstring_that_code_reads_has_a_meaning():
    """A module's own by __doc__; those of others by getdoc and the like."""
    reading = MODULE + "\nNAME = __doc__\n"
    changed = meaning(reading.replace("A docstring", "Another", 1))
    assert changed.digest != meaning(reading).digest and not changed.reads_docstrings
    assert meaning(reading.replace("Another.", "One.")).digest == meaning(reading).digest
    for line in ("b.__doc__", "import inspect; inspect.getdoc(b)", "from inspect import getsource"):
        assert meaning(f"{MODULE}\n{line}\n").reads_docstrings, line
    assert not meaning(f"{MODULE}\nb.__doc__ = 'words'\n").reads_docstrings


GRAPH = {
    "p": b"", "p.read": b"from p import a\n", "p.a": b"def f():\n    from .b import x\n",
    "p.b": b"from . import c\nfrom p import unknown\nimport sympy\n", "p.c": b"import p.inner.d\n",
    "p.inner": b"from p.found import found\nALL = found(__name__, __path__)\n",
    "p.inner.d": b"from .. import e\nrender('c/d.h', x=1)\n", "p.inner.other": b"", "p.e": b"",
    "p.all": b"from p.inner import ALL\nimport p.typed\n", "p.found": b"", "p.named": b"",
    "p.typed": b"if TYPE_CHECKING:\n    from p.e import E\nTABLE = {'name': 'p.named'}\n",
    "p.patterns": b"def f(x):\n    return render(f'c/{x}.h')\n",
    "p.computed": b"def f(x):\n    return render(x)\n",
    "p.copied": b"def f():\n    return runtime('runtime/r/*.h'), copied('runtime/d.c')\n",
    "c/d.h.jinja": b"{% include 'c/inner.jinja' %}", "c/inner.jinja": b"", "q/e.jinja": b"",
    "runtime/r/a.h": b"", "runtime/r/b.h": b"", "runtime/s/c.h": b"", "runtime/d.c": b""}


@pytest.mark.parametrize("maker, wanted", [
    ("p.read", "p.read p.a p.b p.c p p.inner.d p.e c/d.h.jinja c/inner.jinja"),
    ("p.inner", "p.inner p.found p.inner.d p.inner.other p p.e c/d.h.jinja c/inner.jinja"),
    ("p.all", "p.all p.inner p.found p.inner.d p.inner.other p p.e p.typed p.named c/d.h.jinja "
              "c/inner.jinja"),
    ("p.patterns", "p.patterns c/d.h.jinja c/inner.jinja"),
    ("p.computed", "p.computed c/d.h.jinja c/inner.jinja q/e.jinja"), ("p.e", "p.e"),
    ("p.copied", "p.copied runtime/r/a.h runtime/r/b.h runtime/d.c")])
def test_what_a_module_imports_is_found(maker, wanted):
    """Imports inside functions, relative ones, for types, by a name in a table, and by looking into
    a folder are found; so are templates that are named, also by a pattern, or all if the name is
    computed, and C that is copied, by its name or a pattern."""
    assert Sources.of(GRAPH).reached([maker]) - {"p"} == {*wanted.split()} - {"p"}


def test_of_a_package_that_imports_all_its_modules_the_chosen_count():
    its = Sources.of(GRAPH)
    assert its.reached(["p.inner"], {"p.inner": ()}) == {"p.inner", "p.found"}
    assert "p.inner.d" in its.reached(["p.inner"], {"p.inner": {"p.inner.d"}})


def test_a_load_costs_little_more_than_a_look_at_each_source():
    """Every one asks for the sources that its kernels depend on, which differ with its effects."""
    its = Sources.of(sources.read())
    maker, effects = "coscrew_codegen.runtime.load", "coscrew_codegen.scene.effects"
    its.digest([maker], {effects: ()})
    other = {effects: {f"{effects}.gravity"}}
    assert calls_of(lambda: its.digest([maker], other)) < 50 * len(its.meanings)


@pytest.mark.parametrize("name, maker, counts", [
    ("p.b", "p.read", True), ("p.inner.other", "p.read", False), ("p.inner", "p.read", True),
    ("c/inner.jinja", "p.read", True), ("q/e.jinja", "p.read", False), ("p", "p.e", True),
    ("p.read", "p.b", False), ("p.named", "p.all", True), ("runtime/r/b.h", "p.copied", True),
    ("runtime/s/c.h", "p.copied", False)])
def test_a_change_counts_where_it_is_reached(name, maker, counts):
    """A package's own file counts for all modules in it, as importing these runs it."""
    changed = Sources.of(GRAPH | {name: GRAPH[name] + b"\nX = 1\n"})
    assert (changed.digest([maker], {}) != Sources.of(GRAPH).digest([maker], {})) == counts


def test_docstrings_count_where_a_module_reads_them():
    for reader, counts in ((b"", False), (b"from p import b\nprint(b.f.__doc__)\n", True)):
        before, after = (Sources.of(GRAPH | {"p.b": b"def f():\n    '''%s'''\n" % text,
                                             "p.a": b"from p import b\n" + reader})
                         for text in (b"one", b"two"))
        assert (before.digest(["p.a"], {}) != after.digest(["p.a"], {})) == counts


def test_a_maker_without_a_source_is_an_error():
    with pytest.raises(KeyError):
        Sources.of(GRAPH).digest(["p.moved"], {})


def test_meanings_are_kept_and_damaged_ones_are_read_again(tmp_path, monkeypatch):
    place, read = tmp_path / "inner" / "kept.json", []
    monkeypatch.setattr(sources, "_places", lambda: iter([Path("/dev/null/kept.json"), place]))
    of_module = syntax.of_module
    monkeypatch.setattr(syntax, "of_module", lambda content, package: (
        read.append(content), of_module(content, package))[1])
    wanted = Sources.of(GRAPH)
    modules = [x for x in GRAPH if "/" not in x]
    assert len(read) == len(modules)
    assert Sources.of(GRAPH) == wanted and len(read) == len(modules)
    changed = GRAPH | {"p.e": b"X = 1\n"}
    assert Sources.of(changed) != wanted and read[len(modules):] == [b"X = 1\n"]
    for damage in ("", "{}", "[]", place.read_text()[:-9], json.dumps(
            json.loads(place.read_text()) | {"maker": "another"})):
        place.write_text(damage)
        assert Sources.of(GRAPH) == wanted, damage
    monkeypatch.setattr(sources, "_places", lambda: iter(()))
    assert Sources.of(GRAPH) == wanted


TRACED = """
import sys
from importlib import import_module
from coscrew_codegen.backends import render
from coscrew_codegen.runtime import sources

FILES, entered = {}, set()
for name in sources.read():
    if "/" not in name and name != "coscrew_codegen.__main__":
        try:
            FILES[import_module(name).__file__] = name
        except ImportError:
            pass  # of an optional package

def enter(frame, event, argument):
    if event == "call" and frame.f_code.co_filename in FILES:
        entered.add(FILES[frame.f_code.co_filename])

source = render._source
render._source = lambda name: (entered.add(name), source(name))[1]
"""
FAMILIES = TRACED + """
from coscrew_codegen.runtime.family_cache import makers, modules
from coscrew_codegen.backends.output_files import generated_files
from coscrew_codegen.reports.reference import reference_files
from coscrew_codegen.algebra.operations import __name__ as operations
from coscrew_codegen.backends.selection import Selection

its, makes = sources.Sources.of(sources.read()), set()

def keep(kernels, make):
    if kernels.family not in sys.argv[1:]:
        return make(kernels)
    makes.add(make)
    entered.clear()
    sys.setprofile(enter)
    made = make(kernels)
    sys.setprofile(None)
    print(kernels.family, make.__qualname__,
          *sorted(entered - its.reached(makers(make), {operations: modules(kernels.family)})))
    return made

library = Selection(families=tuple(sys.argv[1:])).library(keep)
generated_files(library)
from coscrew_codegen.reports.reference import operation_pages as pages
library.made(pages._derived)
print(len(makes))
"""


def test_deriving_a_family_enters_only_what_counts():
    """Rendering its parts enters only those modules and templates, too, whatever imports them."""
    done = subprocess.run([sys.executable, "-c", FAMILIES, "trig", "mat3x3"], cwd=ROOT, text=True,
                          capture_output=True, check=True)
    *lines, makes = done.stdout.splitlines()
    assert [x for x in lines if len(x.split()) != 2] == []
    assert len(lines) == 2 * int(makes) >= 10


SCENES = TRACED + """
from pathlib import Path
from coscrew_codegen import load_scene
from coscrew_codegen.program.plugins import holder
from coscrew_codegen.runtime import scene_library
from coscrew_codegen.scene import effects

def traced(*given):
    sys.setprofile(enter)
    made = make(*given)
    sys.setprofile(None)
    return made

make, scene_library._made = scene_library._made, traced
kernels = load_scene(Path(sys.argv[1]), tiers=["accurate"])
kernels.accurate, kernels._lanes._library
used = {holder(effects.__name__, "EFFECT", x.effect) for x in kernels.scene.effects}
its = sources.Sources.of(sources.read())
reached = its.reached([scene_library.__name__], {effects.__name__: used})
print(len(entered), *sorted(entered - reached))
"""


def test_making_a_scene_s_kernels_enters_only_what_counts(tmp_path, monkeypatch):
    """This holds in C, in a tier, and for many states; only the scene's effects are entered."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    done = subprocess.run([sys.executable, "-c", SCENES, "examples/scenes/pendulum.toml"], cwd=ROOT,
                          text=True, capture_output=True, check=True)
    count, *others = done.stdout.split()
    assert others == [] and int(count) > 100
