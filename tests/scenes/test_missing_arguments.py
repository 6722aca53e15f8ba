"""Errors of the number of arguments name the missing one; signatures that `help` shows are short.
"""

import inspect
import pydoc

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen import load_scene
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation import sweep
from tests.support.scenes.simulated import scene_file

TEXT = """
runtime = ["tip.mass", "tip.com"]
[bodies.base]
mass = 1
inertia = [1, 1, 1]
[bodies.tip]
mass = 1
com = [1, 0, 0]
inertia = [1, 1, 1]
[joints.shoulder]
type = "continuous"
child = "base"
axis = [0, 1, 0]
[joints.elbow]
type = "continuous"
parent = "base"
child = "tip"
axis = [0, 1, 0]
[effects.gravity]
"""
P, Q = np.array([1.0, 1, 0, 0]), np.array([0.1, 0.2])


@pytest.fixture(scope="module", params=("C", "Python"))
def kernels(request, tmp_path_factory) -> Kernels:
    """Compiled, and without a compiler."""
    path = scene_file(tmp_path_factory.mktemp("scene"), TEXT, "arm")
    with pytest.MonkeyPatch.context() as patch:
        if request.param == "Python":
            patch.setenv("CC", "no-such-compiler")
            with pytest.warns(RuntimeWarning):
                return load_scene(path)
        return load_scene(path)


@pytest.mark.parametrize(("name", "given", "named", "message"), (
    ("gravity_torques", (Q,), {}, "gravity_torques(p, q): p is missing; got 1 argument; wanted "
     "p (4,), q (2,)"),
    ("gravity_torques", (P,), {}, "gravity_torques(p, q): q is missing"),
    ("gravity_torques", ([[1.0, 1, 0, 0]] * 3,), {}, "gravity_torques(p, q): q is missing"),
    ("gravity_torques", (), {"q": Q}, "gravity_torques(p, q): p is missing"),
    ("gravity_torques", (), {}, "gravity_torques(p, q): p and q are missing; got no arguments"),
    ("inverse_dynamics", (Q, Q, Q), {}, "inverse_dynamics(p, q, v, a): p is missing"),
    ("inverse_dynamics", (P, Q, Q), {}, "1 of p, q, v, a is missing"),
    ("inverse_dynamics", (Q, Q), {"a": Q}, "inverse_dynamics(p, q, v, a): p is missing"),
    ("step_leapfrog", (P, Q, Q), {}, "step_leapfrog(h, p, q, v): h is missing"),
    ("step_leapfrog", (0.1, Q, Q), {}, "step_leapfrog(h, p, q, v): p is missing"),
    ("gravity_torques", (P, Q, Q), {}, "gravity_torques(p, q): got 3 arguments; wanted p (4,), "),
    ("gravity_torques", (P,), {"p": P}, "gravity_torques(p, q): p is given twice, in order"),
    ("gravity_torques", (P, Q), {"thread": 2}, "gravity_torques(p, q): no argument 'thread'"),
    ("gravity_torques", (P,), {"Q": Q}, "gravity_torques(p, q): no argument 'Q'; did you mean 'q'?")
))
def test_the_missing_argument_is_named(kernels, name, given, named, message):
    with pytest.raises(TypeError) as error:
        getattr(kernels.double, name)(*given, **named)
    assert message in str(error.value)


def test_arguments_may_be_given_in_any_way(kernels):
    wanted = kernels.double.gravity_torques(P, Q)
    assert np.array_equal(kernels.double.gravity_torques(q=Q, p=P), wanted)
    assert np.array_equal(kernels.double.gravity_torques(P, q=Q), wanted)
    out = np.empty(2)
    assert kernels.double.gravity_torques(P, q=Q, out=out, threads=1) is out
    assert str(inspect.signature(kernels.double.gravity_torques)) == (
        "(p, q, *, out=None, threads=1)")


@pytest.mark.parametrize("its", (
    coscrew_codegen.run, coscrew_codegen.again, load_scene, coscrew_codegen.Controller,
    sweep.opened), ids=lambda its: its.__name__)
def test_help_is_read_without_scrolling(its):
    """In words that users know: ArrayLike, not its members; eight lines of 80 columns at most."""
    signature = str(inspect.signature(its))
    assert len(signature) < 640
    text = pydoc.render_doc(its, renderer=pydoc.plaintext)
    assert "numpy._typing" not in text and "collections.abc" not in text
    assert max(map(len, text.splitlines())) < 640
