"""Selected functions are derived, printed and compiled, and no others."""

import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.dynamics import derive, integrator_steps
from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.runtime import load
from coscrew_codegen.scene.function_selection import (
    ALL_CONTACTS,
    BRISTLES,
    CONTACTS,
    FREE,
    LOOPS,
    MOST,
    OF_STATES,
    STATE_RATES,
    SWITCHES,
    FunctionsError,
    names,
    refuse_many,
    resolved,
    selected_functions,
)
from coscrew_codegen.scene.functions import FUNCTIONS, functions_of
from coscrew_codegen.scene.functions.whole_scene.mass_matrix import MANY
from coscrew_codegen.scene.integrators import EMITTED, INTEGRATORS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Run, Scene
from coscrew_codegen.scene.scene_function import ALWAYS
from coscrew_codegen.simulation import plan, required_functions, run, system
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.recordings import record
from tests.support.compiled.c_harness import COMPILERS, EXACT, STRICT
from tests.support.compiled.c_harness import run as compiled
from tests.support.scenes import mechanisms as m
from tests.support.scenes.kinds import Kind

ALL = ("all",)
OF_ALL = [x.name for x in FUNCTIONS if x.default is ALWAYS or x.name == "mass_matrix"]
"""The functions that every scene has by default."""


def arm(*selected: str, **others: object) -> Scene:
    """Two joints with a limit at the second; b2 is fixed to b1."""
    model = m.chain((Kind.REVOLUTE, m.Y, m.HERE, m.inertia(1, (0, 0, 1), (1, 1, 1, 0, 0, 0))),
                    (Kind.PRISMATIC, m.X, m.at(0, 0, 1), m.inertia(2)),
                    (Kind.FIXED, m.Z, m.at(0, 1, 0), m.inertia(1)), name="arm")
    limit = m.applied("limit", "j1", lower=m.Fraction(-1), upper=m.Fraction(1),
                      k=m.Fraction(1000))
    return replace(m.scene(model, m.gravity(), limit, **others), functions=selected)


def flyer(*selected: str) -> Scene:
    return replace(m.scene(m.free_body(), m.gravity()), functions=selected)


def public(scene: Scene) -> list[str]:
    """The functions that C declares, steps among them."""
    result = derive(scene)
    header = scene_c.files(result, "banner")[f"{scene.name}.h"]
    in_double, _, _ = header.partition("The same in single")
    return re.findall(rf"^void {scene.name}_(\w+?)\(", in_double, re.M)


def test_without_a_word_jacobians_reactions_and_other_integrators_are_left_out():
    assert public(arm()) == [*OF_ALL, *CONTACTS, "step_leapfrog"]
    assert public(flyer()) == [*OF_ALL, *FREE, "step_leapfrog"]
    selected = m.applied("reaction", "j1")
    assert "reaction_j1" in public(replace(arm(), effects=(*arm().effects, selected)))


@pytest.mark.parametrize("integrator", INTEGRATORS, ids=lambda x: x.name)
def test_the_step_is_that_of_the_run(integrator):
    """Steps of SciPy's integrators are not emitted; a scene that runs with one has the default's.
    """
    results = [x for x in public(arm(run=Run(integrator=integrator.name))) if x.startswith("step_")]
    assert results == [integrator.step_name or "step_leapfrog"]


@pytest.mark.parametrize("name", names(arm()))
def test_each_function_can_stand_alone(name: str, tmp_path: Path):
    """Nothing else is declared; its text is the same as among all others; it compiles without a
    warning, of unused functions either."""
    for absent, why in ((FREE, "no base is floating"), ((*LOOPS, "closings"), "no loop is closed"),
                        ((ALL_CONTACTS,), "nothing touches anything"),
                        ((STATE_RATES,), "no effect has states"),
                        ((SWITCHES, BRISTLES), "no effect has switches")):
        if name in absent:
            with pytest.raises(FunctionsError, match=f"arm: there is no {name}: {why}"):
                derive(arm(name))
            return
    assert public(arm(name)) == [name]
    files = scene_c.files(derive(arm(name)), "banner")
    whole = whole_arm()
    text = files["arm.c"]
    for file, content in files.items():
        (tmp_path / file).write_text(content)
    compiled([COMPILERS[0], "-std=c11", *STRICT, EXACT, "-c", tmp_path / "arm.c",
              "-o", tmp_path / "arm.o"])
    for head in re.findall(r"^(?:static )?void (arm_\w+)\(", text, re.M):
        assert body(text, head) == body(whole, head), head


@cache
def whole_arm() -> str:
    """The C of the arm with all functions."""
    return scene_c.files(derive(arm(*ALL)), "banner")["arm.c"]


def body(text: str, function: str) -> str:
    """The body of a C function, without its line breaks."""
    result = re.search(rf"^(?:static )?(void {function}\(.*?^}})", text, re.M | re.S)[1]
    return " ".join(result.split())


def test_contacts_are_refused_by_name_where_no_limit_closes():
    for name in CONTACTS:
        with pytest.raises(FunctionsError, match=f"there is no {name}: no limit closes"):
            derive(flyer(name))
    assert not {*CONTACTS} & {*public(flyer(*ALL))}


def test_all_functions_have_names_and_names_have_functions():
    """The two scenes together have everything that a scene without closed loops, contacts and
    states of effects can have."""
    result = {*public(arm(*ALL)), *public(flyer(*ALL)), *LOOPS, *OF_STATES, "bristles",
              "contacts", "closings"}
    assert result == {*names(arm()), *names(flyer())}
    assert {"jacobian_b2", "jacobian_b1", "reaction_j0"} < result and "reaction_j2" not in result


def test_what_is_not_selected_is_not_derived(monkeypatch: pytest.MonkeyPatch):
    made, make = [], Derivation._derived
    monkeypatch.setattr(Derivation, "_derived", lambda self, entry: (
        made.append(entry.name), make(self, entry))[1])
    derive(arm("jacobian_b1"))
    assert made == ["jacobian_b1"]
    made.clear()
    derive(arm("step_semi_implicit_euler"))
    assert sorted(made) == ["forward_dynamics", "integrated"]


def test_words_for_several_stand_beside_names():
    assert selected_functions(arm("jacobian_b1", "default")) == tuple(
        name for name in names(arm()) if name in {*selected_functions(arm()), "jacobian_b1"})
    assert resolved(arm(), ("all", "default")) == {*names(arm())}


FILE = """functions = {}
[bodies]
hand = {{ mass = 1, inertia = [1, 1, 1] }}
[joints.wrist]
type = "revolute"
child = "hand"
axis = [0, 0, 1]
[effects.gravity]
"""


@pytest.mark.parametrize("given, problem", (
    ('["jacobian_hnd"]', "'jacobian_hnd' is no function of the scene; did you mean "
                         "'jacobian_hand'?"),
    ('["defualt"]', "'defualt' is no function of the scene; did you mean 'default'?"),
    ('["reaction_wrst"]', "'reaction_wrst' is no function of the scene; did you mean "
                          "'reaction_wrist'?"),
    ("[]", "an empty list; wanted names"),
    ('"energy"', "the text 'energy'; wanted a list of texts"),
    ('["energy", "energy"]', "'energy' occurs twice")))
def test_names_in_files_are_checked(given: str, problem: str, tmp_path: Path):
    path = tmp_path / "arm.toml"
    path.write_text(FILE.format(given))
    with pytest.raises(SceneError, match=re.escape(f"functions: {problem}")):
        read_scene(path)


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = tmp_path / "arm.toml"
    path.write_text(FILE.format('["jacobian_hand"]'))
    return path


def test_load_scene_takes_what_the_file_says_or_what_it_is_told(file: Path):
    of_file = coscrew_codegen.load_scene(file)
    assert dir(of_file.double) == ["jacobian_hand"]
    assert np.array_equal(of_file.double.jacobian_hand([0.5])[:, 0], [0, 0, 0, 0, 0, 1])
    messages = coscrew_codegen.load_scene(file, functions=["energy"])
    assert dir(messages.double) == ["energy"]
    again = coscrew_codegen.load_scene(messages.scene, functions=["power"])
    assert dir(again.double) == ["power"]
    with pytest.raises(AttributeError, match=r"no function 'power'; it was not selected: "
                                             r"functions=\[\"default\", 'power'\]"):
        messages.double.power
    with pytest.raises(TypeError, match="functions: wanted a list of names"):
        coscrew_codegen.load_scene(file, functions="energy")
    with pytest.raises(FunctionsError, match="did you mean 'energy'"):
        coscrew_codegen.load_scene(file, functions=["enrgy"])


def test_runs_have_all_that_they_call_and_tell_what_they_lack(file: Path):
    """A run of a scene that selects only one function."""
    scene = replace(read_scene(file), record=("reaction.wrist", "pose.hand", "a", "momentum"))
    its = system.system(load.kernels_for(scene, required_functions.of_run(scene, "rk4")), "double")
    assert not its.has("jacobian_hand") and not its.has("inverse_dynamics")
    trajectory = run.integrate(its, plan.plan(its, integrator="rk4", until=0.1))
    assert record.record(its, trajectory, ()).values.shape[1] == 6 + 12 + 1 + 6
    with pytest.raises(plan.SimulateError, match="step_linear_implicit_euler is not among the "
                                                 "selected functions"):
        plan.plan(its, integrator="linear-implicit-euler")
    alone = system.system(load.kernels_for(scene, ["forward_dynamics"]), "double")
    with pytest.raises(plan.SimulateError, match="reaction.wrist: reaction_wrist is not among"):
        record.record(alone, trajectory, ())


def test_steps_need_what_the_derivation_has():
    known = {x.name for x in functions_of(arm())}
    assert {name for x in EMITTED for name in integrator_steps.needs(x)} <= known


def chain(joints: int) -> Scene:
    """Joints about x, y and z in turn, of equal bodies."""
    links = [(Kind.REVOLUTE, (m.X, m.Y, m.Z)[n % 3], m.at(0, 0, 1),
              m.inertia(1, (0, 0, "1/2"), (1, 1, 1, 0, 0, 0))) for n in range(joints)]
    return replace(m.scene(m.chain(*links), m.gravity()), functions=())


def test_deriving_takes_in_proportion_to_the_number_of_joints(monkeypatch: pytest.MonkeyPatch):
    """Counted: the operations that are looked at, for all default functions except the mass matrix.
    Three more joints add the same number, wherever they are in the chain."""
    issued = [0]
    issue = Recorder.issue

    def counted(self, *words):
        issued[0] += 1
        return issue(self, *words)

    monkeypatch.setattr(Recorder, "issue", counted)
    counts = []
    for joints in (9, 12, 15):
        issued[0] = 0
        derive(chain(joints), [name for name in selected_functions(chain(3))
                               if name != "mass_matrix"])
        counts.append(issued[0])
    more = [b - a for a, b in pairwise(counts)]
    assert more[0] == more[1] > 0, counts


def test_many_joints_have_no_mass_matrix_unless_asked_and_no_end_of_them_is_refused():
    assert "mass_matrix" in selected_functions(chain(MANY))
    many = chain(MANY + 1)
    assert {*selected_functions(chain(MANY))} - {*selected_functions(many)} == {"mass_matrix"}
    assert "mass_matrix" not in required_functions.of_run(many, None)
    assert "mass_matrix" in selected_functions(replace(many, functions=("default", "mass_matrix")))
    with pytest.raises(FunctionsError,
                       match=f"chain: {MOST + 1} joints move; wanted at most {MOST}"):
        derive(chain(MOST + 1))
    refuse_many(chain(MOST))


def test_alarms_do_without_a_mass_matrix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """With it, an alarm computes the centres of mass of floating trees."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(required_functions, "MANY", 0)
    scene = m.scene(m.slider(1), m.applied("spring", "j0", k=10**6))
    selected = required_functions.of_run(scene, "semi-implicit-euler")
    its = system.system(load.kernels_for(scene, selected), "double")
    assert not its.has("mass_matrix")
    start = replace(its, scene=replace(scene, start_q={"j0": (1.0,)}))
    planned = plan.plan(start, integrator="semi-implicit-euler", step=1.9e-3, until=1.0)
    result = run.integrate(start, planned, alarm=Alarm)
    assert "joint j0 is off by" in result.stopped
