"""A run of a scene walks through its stages once, from the file to numbers, and enters few files.

The stages are packages: `scene` reads the file and selects functions, `dynamics` derives them,
`backends` writes them, `runtime` compiles and binds them, `simulation` runs and records.  The trace
holds each call by which the runtime or the simulation, which lead the walk, enter a function of a
stage; methods and properties of values that a stage has handed on, and `program`, `algebra` and
`accuracy`, in whose words stages speak, are no stages.  A file is entered if any function in it is
called during the run, other than while a module is imported.
"""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
STAGES = ("scene", "dynamics", "backends", "runtime", "simulation")
NO_STAGE = {"backends/version.py": "names the software, in recordings"}
TRACED = """
import os, sys
import coscrew_codegen

LAST = ("library", "gathered", "motion")
root = os.path.dirname(coscrew_codegen.__file__) + os.sep
run, entered, calls = coscrew_codegen.run, set(), []
imports = set()  # frames of modules, while they are imported

def name(frame):
    return frame.f_code.co_filename[len(root):].replace(os.sep, "/")

def enter(frame, event, argument):
    ours = frame.f_code.co_filename.startswith(root)
    if ours and frame.f_code.co_name == "<module>":
        (imports.add if event == "call" else imports.discard)(frame)
    elif ours and event == "call" and not imports:
        entered.add(name(frame))
        caller = frame.f_back
        while caller and not caller.f_code.co_filename.startswith(root):
            caller = caller.f_back
        if caller and "." not in frame.f_code.co_qualname and "<" not in frame.f_code.co_name:
            call = name(caller), name(frame), frame.f_code.co_name
            if call[0].split("/")[0] != call[1].split("/")[0] or call[2] in LAST:
                calls.append(call)

sys.setprofile(enter)
run(sys.argv[1])
sys.setprofile(None)
print(*sorted(entered))
for before, call in zip([(), *calls], calls):
    if call != before:
        print(*call)
"""


@dataclass(frozen=True)
class Trace:
    """A run in a process of its own."""

    entered: tuple[str, ...]
    calls: tuple[tuple[str, str, str], ...]  # files of caller and callee, and the function

    @property
    def packages(self) -> set[str]:
        return {x.partition("/")[0] for x in self.entered}

    @property
    def walk(self) -> list[tuple[str, str]]:
        """Stages in the order in which functions of theirs are first called, and the calls."""
        return [(stage, f"{caller} calls {name} of {callee}") for caller, callee, name in self.calls
                if (stage := _stage(caller, callee, name))]


def _stage(caller: str, callee: str, name: str) -> str:
    """The stage that a call enters; "" if none."""
    leader, stage = (x.partition("/")[0] for x in (caller, callee))
    if leader not in ("runtime", "simulation") or callee in NO_STAGE:
        return ""
    return stage if stage in STAGES[:3] or (callee, name) in LAST else ""


LAST = {("runtime/compilation.py", "library"), ("runtime/callables.py", "gathered"),
        ("simulation/execution.py", "motion")}
"""With these the last two stages begin, whose packages lead the walk."""


def traced(cache: Path) -> Trace:
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", TRACED,
                           "examples/scenes/pendulum.toml"], cwd=ROOT, text=True, check=True,
                          capture_output=True, env={**os.environ, "XDG_CACHE_HOME": str(cache)})
    entered, *calls = done.stdout.splitlines()
    return Trace(tuple(entered.split()), tuple(
        (a, b, c) for a, b, c in (x.split() for x in calls)))


@pytest.fixture(scope="module")
def traces(tmp_path_factory: pytest.TempPathFactory) -> tuple[Trace, Trace]:
    """With an empty cache, and with the one that this has filled."""
    cache = tmp_path_factory.mktemp("cache")
    return traced(cache), traced(cache)


def test_no_stage_is_entered_again_after_it_was_left(traces: tuple[Trace, Trace]):
    for trace in traces:
        reached = 0
        for stage, call in trace.walk:
            assert STAGES.index(stage) >= reached, f"{call}, after {STAGES[reached]} was entered"
            reached = STAGES.index(stage)


def test_a_run_enters_every_stage_and_from_the_cache_none_that_makes(
        traces: tuple[Trace, Trace]):
    cold, warm = traces
    assert [*dict.fromkeys(x for x, _ in cold.walk)] == [*STAGES]
    assert [*dict.fromkeys(x for x, _ in warm.walk)] == ["scene", "runtime", "simulation"]
    assert not {"dynamics", "accuracy"} & warm.packages


def test_few_files_are_entered(traces: tuple[Trace, Trace]):
    """Besides the file that reads the syntax of sources, once after each change of one."""
    cold, warm = ({*x.entered} - {"runtime/syntax.py"} for x in traces)
    assert len(cold) <= 148 and len(warm) <= 61
