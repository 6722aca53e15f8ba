"""Times of a Panda's state on arrays of JAX and of NumPy on one core, against frax.

arrays_on_a_core.py measures, in a process with one core and with the settings that frax recommends.
Without frax (the extra `peers`) the ratio is to what its authors state, of another machine."""

import json
import os
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, version

import numpy as np
from tabulate import tabulate

from coscrew_codegen.reports.timing.loop_timing import Timing
from tests.benchmarks.bars import Bar, show
from tests.benchmarks.words import span

PUBLISHED = {"inverse_dynamics": 3914, "forward_dynamics": 8507}
"""frax's ns a state of 4,096: what its authors state."""
WANTED = {"arrays": 30, "numpy": 100}
"""frax's time / ours."""
SETTINGS = {"JAX_ENABLE_X64": "1", "JAX_PLATFORMS": "cpu", "OPENBLAS_NUM_THREADS": "1",
            "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false "
                         "--xla_cpu_scheduler_type=CPU_SCHEDULER_TYPE_MEMORY_OPTIMIZED"}
WAYS = ("arrays", "gradient", "numpy", "frax")


def measured() -> dict[str, dict[str, Timing]]:
    """Times by function and way."""
    command = [sys.executable, "-m", "tests.benchmarks.arrays_on_a_core"]
    done = subprocess.run(command, env={**os.environ, **SETTINGS}, stdout=subprocess.PIPE,
                          text=True, check=True, preexec_fn=_on_a_core)
    return {name: {way: Timing(np.array(x)) for way, x in ways.items()}
            for name, ways in json.loads(done.stdout).items()}


def _on_a_core() -> None:
    """Keep this process to one of its cores, where the system can."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def main() -> list[Bar]:
    """Print the table."""
    result, bars = measured(), []
    try:
        rival = f"frax {version('frax')}"
    except PackageNotFoundError:
        rival = ""
    for name, ways in result.items():
        for way, wanted in WANTED.items():
            bars.append(Bar(f"frax / {'arrays(jax.numpy)' if way == 'arrays' else 'NumPy'}, "
                            f"{name} of 4096 states", wanted,
                            ways["frax"].ratio(ways[way]) if rival else None,
                            note=rival or "no frax: pip install frax"))
    rows = [(name, *(span(ways[way].time) if way in ways else "" for way in WAYS),
             *(span(ways["frax"].ratio(ways[way])) if rival else
               f"{PUBLISHED[name] / ways[way].time.median:.0f} (published)"
               if name in PUBLISHED else "" for way in WANTED)) for name, ways in result.items()]
    print(f"\n4096 states of a Panda on one core, ns a state; {rival or 'no frax'}; median (95 % "
          "interval) of rounds in which all take turns")
    print(tabulate(rows, ("function", "arrays of JAX", "gradient", "arrays of NumPy", "frax",
                          "frax / JAX", "frax / NumPy"), disable_numparse=True))
    return bars


if __name__ == "__main__":
    show(main())
