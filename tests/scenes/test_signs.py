"""Run-time parameters that must be positive, or must not be negative: headers say so, and Python's
functions refuse others."""

import itertools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.runtime.callables import Functions
from coscrew_codegen.runtime.load import Kernels, kernels_of
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.generated_scenes import files

HINGE = """
runtime = ["tool.mass", "tool.com.z", "coulomb.hinge.tau_c", "coulomb.hinge.eps"]
functions = ["forward_dynamics", "body_poses", "step_leapfrog"]
[bodies]
tool = { mass = 2, com = [0, 0, -0.5], inertia = [1, 1, 1] }
[joints]
hinge = { type = "revolute", child = "tool", axis = [0, 1, 0] }
[effects.coulomb.hinge]
tau_c = 1
eps = 0.125
"""
P = (2.0, -0.5, 1.0, 0.125)
REFUSED = ((0, 0.0, "tool.mass = 0.0; wanted a positive number"),
           (0, -1.0, "tool.mass = -1.0; wanted a positive number"),
           (2, -0.5, "coulomb.hinge.tau_c = -0.5; wanted 0 or more"),
           (3, 0.0, "coulomb.hinge.eps = 0.0; wanted a positive number"),
           (3, -np.inf, "coulomb.hinge.eps = -inf; wanted a positive number"))
ACCEPTED = (P, (2.0, 0.5, 0.0, 0.125), (2.0, -0.5, -0.0, 0.125), (np.nan, -0.5, 1.0, 0.125))


@pytest.fixture(scope="module")
def hinge(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    path = tmp_path_factory.mktemp("hinge") / "hinge.toml"
    path.write_text(HINGE, encoding="utf-8")
    return read_scene(path)


@pytest.fixture(scope="module", params=("compiled", "NumPy"))
def kernels(request: pytest.FixtureRequest, hinge: Scene,
            tmp_path_factory: pytest.TempPathFactory) -> Kernels:
    """The hinge's kernels, compiled and not."""
    functions = derive(hinge)
    if request.param == "compiled":
        made = kernels_of(functions)
        assert made.compiled
        return made
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("numpy")))
        patch.setenv("CC", "/no/such/compiler")
        with pytest.warns(RuntimeWarning, match="hinge runs in pure NumPy"):
            return kernels_of(functions)


def calls(functions: Functions, p: object) -> tuple[Callable[[], object], ...]:
    """A function, a step, and each with results in given arrays; where they are compiled, runs,
    also of arrays that need no conversion."""
    p, q, v, tau = (np.array(x, float) for x in (p, [0.1], [0.2], [0.3]))
    lead, kind = p.shape[:-1], functions.forward_dynamics(P, q, v, tau).dtype
    out = [np.full((*lead, 1), 7, kind) for _ in range(2)]
    run = getattr(functions.step_leapfrog, "repeated", None)
    runs = () if run is None else (lambda: run(3, 0.0, 0.1, p, q, v), lambda: run(
        3, 0.0, 0.1, *(x.astype(kind) for x in (p, q, v))))
    return (*runs, lambda: functions.forward_dynamics(p, q, v, tau),
            lambda: functions.step_leapfrog(0.1, p, q, v),
            lambda: functions.forward_dynamics(p, q, v, tau, out=out[0]),
            lambda: functions.step_leapfrog(0.1, p, q, v, out=tuple(out)))


@pytest.mark.parametrize("index, number, message", REFUSED)
def test_parameters_out_of_their_range_are_refused_by_name(kernels: Kernels, index: int,
                                                           number: float, message: str) -> None:
    """Given for one state, or for one of three."""
    wrong = [*P[:index], number, *P[index + 1:]]
    for functions, p in itertools.product((kernels.double, kernels.single),
                                          (wrong, [P, wrong, P])):
        for call in calls(functions, p):
            with pytest.raises(ValueError) as error:
                call()
            assert str(error.value) == f"p: got {message}"


@pytest.mark.parametrize("p", ACCEPTED)
def test_parameters_in_their_range_are_accepted(kernels: Kernels, p: tuple[float, ...]) -> None:
    """Zero where it is allowed, and NaN, which gives NaN as in any argument."""
    for functions, given in itertools.product((kernels.double, kernels.single), (p, [P, p])):
        for call in calls(functions, given):
            result = call()
            last = np.asarray(result if isinstance(result, np.ndarray) else result[1])[..., -1]
            assert np.isnan(last.flat[-1]) == np.isnan(p).any()


def test_what_single_precision_rounds_to_zero_is_zero_there(kernels: Kernels) -> None:
    p = np.array([1e-60, *P[1:]])
    assert np.isfinite(calls(kernels.double, p)[0]()).all()
    with pytest.raises(ValueError, match=r"^p: got tool.mass = 0.0; wanted a positive number$"):
        calls(kernels.single, p)[0]()


def test_functions_without_parameters_take_none(kernels: Kernels) -> None:
    assert kernels.double.body_poses([0.0]).shape == (1, 3, 4)


def test_headers_and_packages_say_which_sign_a_parameter_has(hinge: Scene) -> None:
    result = files(derive(hinge))
    for name in ("hinge.h", "hinge/__init__.py"):
        assert ("Parameters p: 0 tool.mass = 2.0 (must be positive), 1 tool.com.z = -0.5, 2 "
                "coulomb.hinge.tau_c = 1.0 (must not be negative), 3 coulomb.hinge.eps = 0.125 "
                "(must be positive).") in " ".join(result[name].split())


def test_the_reference_says_which_sign_a_parameter_has() -> None:
    page = Path(__file__).parents[2].joinpath("generated/docs/effects.md").read_text("utf-8")
    sections = {x.partition("\n")[0]: x for x in page.split("\n## ")}
    for effect in EFFECTS:
        for parameter in effect.parameters:
            row = next(line for line in sections[effect.name].splitlines()
                       if line.startswith(f"| `{parameter.name}` |"))
            messages = row.rpartition(" | ")[2].removesuffix(" |").split("; ")
            for words, has in (("a positive number", parameter.positive),
                               ("0 or more", parameter.nonnegative)):
                assert (words in messages) == has, row
