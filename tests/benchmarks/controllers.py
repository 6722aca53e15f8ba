"""Cost of a controller in C that is called before every step of a 6-joint arm: by compiled steps,
and by Python; beside the steps without a controller.  Rounds of all take turns."""

import ctypes
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

import numpy as np
from tabulate import tabulate

from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.timing.loop_timing import timed_calls
from coscrew_codegen.runtime import lanes
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.integrators import named
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import required_functions
from coscrew_codegen.simulation.control import Controller
from coscrew_codegen.simulation.controlled_run import Driven
from coscrew_codegen.simulation.plan import plan
from coscrew_codegen.simulation.system import system
from tests.benchmarks.python_calls import least
from tests.benchmarks.words import span
from tests.support.compiled.c_harness import run

ARM = Path(__file__).parents[2] / "examples" / "scenes" / "arm6.toml"
JOINTS = ("pan", "lift", "elbow", "bend", "swing", "roll")
LAW = """void law{f}(double t, const {real} *q, const {real} *v, {real} *u, void *context) {{
  static const {real} at[6] = {{0, -1.1{f}, 1.6{f}, -0.5{f}, 0, 0}};
  (void)t, (void)context;
  for (int i = 0; i < 6; i++) u[i] = 600 * (at[i] - q[i]) - 20 * v[i];
}}
"""
SECONDS = 2.0  # of each comparison
STEP = 5e-4


def scene_text() -> str:
    """The arm of the example with torques that a controller sets."""
    head, _, rest = ARM.read_text(encoding="utf-8").partition("[effects.actuator]")
    torques = "".join(f'[effects.actuator.{x}]\nkind = "torque"\ntorque = 0\n' for x in JOINTS)
    start = rest[rest.index("[start.q]"):rest.index("# With Pinocchio")]
    names = ", ".join(f'"actuator.{x}.torque"' for x in JOINTS)
    return head.replace('["payload.mass"]', f"[{names}]") + torques + start


def laws(folder: Path) -> ctypes.CDLL:
    """A controller in both precisions."""
    (folder / "law.c").write_text("".join(LAW.format(f=p.suffix, real=p.c_type)
                                          for p in PRECISIONS))
    run(("gcc", "-O2", "-shared", "-fPIC", folder / "law.c", "-o", folder / "law.so"))
    return ctypes.CDLL(str(folder / "law.so"))


def rows(kernels: Kernels, library: ctypes.CDLL, integrator: str, p: Precision
         ) -> Iterator[list[str]]:
    """A line for each number of members."""
    its, law = system(kernels, p.name), getattr(library, f"law{p.suffix}")
    free = its.stepper(named(integrator).step_name)
    for members, steps in ((1, 500), (8, 200), (1024, 10)):
        q, v = its.start()
        if members > 1:
            q, v = (np.broadcast_to(x, (members, x.size)).copy() for x in (q, v))
        its_plan = plan(its, integrator=integrator)
        compiled = Driven(Controller(law), its, its_plan, q)
        with patch.object(type(its), "driver", return_value=None):  # as where nothing is compiled
            python = Driven(Controller(law), its, its_plan, q)
        timings = timed_calls([
            lambda: free(steps, 0.0, STEP, q, v),
            *(lambda by=by: by.advance(steps, 0, 0.0, STEP, q, v) for by in (compiled, python))],
            1e9 * SECONDS)
        ns = [f"{x.minimum / steps / members:.3g}" for x in timings]
        yield [integrator, p.name, str(members), *ns, least(timings[2], timings[1]),
               span(timings[2].ratio(timings[1]))]


def main() -> None:
    """Print the table."""
    print("\nns a step and member of arm6 with a controller in C before every step")
    table = []
    with TemporaryDirectory() as folder:
        path = Path(folder) / "arm6.toml"
        path.write_text(scene_text())
        scene, library = read_scene(path), laws(Path(folder))
        for integrator in ("leapfrog", "rk4"):
            kernels = kernels_for(scene, required_functions.of_run(scene, integrator))
            kernels._lanes._met = lanes.PAYS
            for p in PRECISIONS:
                table += rows(kernels, library, integrator, p)
    print(tabulate(table, ("integrator", "precision", "members", "no controller", "compiled",
                           "Python", "Python / compiled", ""), disable_numparse=True))


if __name__ == "__main__":
    main()
