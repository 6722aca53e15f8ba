"""Verdicts on motions depend neither on where, how fast and which way a whole scene moves, nor on
bodies that move beside it; resting scenes do not stop, and no start passes that steps do not
resolve."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen import load_scene
from coscrew_codegen.program.values.formats import SINGLE
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.check.error_limits import ALLOWED
from coscrew_codegen.simulation.check.motion_error import Extent, StateParts
from coscrew_codegen.simulation.check.step_advice import remedy
from coscrew_codegen.simulation.plan import plan
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import System, system

BASE = """
runtime = ["actuator.j1.kp"]
[bodies]
b0 = { mass = 10, inertia = [0.5, 0.5, 0.5] }
b1 = { mass = 0.2, com = [0, 0, -0.1], inertia = [0.001, 0.001, 0.001] }
heavy = { mass = 1000, inertia = [9, 9, 9] }
[joints]
j0 = { type = "free", child = "b0" }
beside = { type = "prismatic", child = "heavy", axis = [1, 0, 0] }
[joints.j1]
type = "continuous"
parent = "b0"
child = "b1"
axis = [0, 1, 0]
origin.xyz = [0.3, 0, 0]
[effects.actuator.j1]
kind = "pd"
target = 0
kp = 1
kd = 0.12
[start.q]
j1 = 0.01
[run]
duration = 0.2
"""
SERVO = """
runtime = ["actuator.hinge.kp", "actuator.hinge.kd", "actuator.hinge.target"]
[bodies]
link = { mass = 2, com = [0, 0, -0.25], inertia = [0.04, 0.04, 0.002] }
[joints]
hinge = { type = "revolute", child = "link", axis = [0, 1, 0] }
[effects.gravity]
[effects.actuator.hinge]
kind = "pd"
kp = 1
kd = 1
target = 0.5
[start.q]
hinge = 0.5
[run]
duration = 2
"""
INERTIA = 0.04 + 2 * 0.25**2
TURN = np.array([0.36, 0.48, 0.64, 0.48])  # a unit quaternion


@pytest.fixture(scope="module")
def loaded(tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("alarm")

    def load(text: str) -> Kernels:
        path: Path = folder / f"scene{hash(text) % 10**9}.toml"
        path.write_text(text)
        return load_scene(path)

    kernels = {text: load(text) for text in (BASE, SERVO)}
    return lambda text, precision="double", **values: system(
        kernels[text], precision, {name.replace("_", "."): x for name, x in values.items()})


def watched(its: System, q: np.ndarray | None = None, v: np.ndarray | None = None,
            **planned: float) -> tuple[str, float]:
    """Reason why the run stopped, and its largest error relative to the allowed one."""
    alarms: list[Alarm] = []

    def alarm(*given: object) -> Alarm:
        alarms.append(Alarm(*given))
        return alarms[-1]

    q0, v0 = its.start()
    start = q0 if q is None else q.astype(its.dtype), v0 if v is None else v.astype(its.dtype)
    run = integrate(its, plan(its, **planned), alarm=alarm, start=start)
    errors = alarms[0]._errors.worst / (ALLOWED * alarms[0].extent.sizes)
    return run.stopped, float(errors.max())


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("kp, right", ((12000, False), (12, True)))
def test_the_verdict_is_that_of_a_scene_at_rest(loaded, precision, kp, right):
    """At 100 and 300 m/s, a hundred metres away, turned, beside a ton at 10 m/s: h ω is 2 and 0.06.
    """
    its = loaded(BASE, precision, actuator_j1_kp=kp)
    q, v = its.start()
    verdicts, errors = [], []
    for speed, place, turn, beside in ((0, 0, None, 0), (100, 0, None, 0), (300, 0, None, 0),
                                       (0, 100, None, 0), (0, 0, TURN, 0), (0, 0, None, 10)):
        q1, v1 = q.astype(float), v.astype(float)
        q1[0], v1[1], v1[-1] = place, speed, beside
        if turn is not None:
            q1[3:7] = coscrew.double.quaternion_product_qq(turn, q1[3:7])
        stopped, error = watched(its, q1, v1)
        verdicts.append(stopped == "")
        errors.append(error)
    assert verdicts == [right] * len(verdicts), (verdicts, errors)
    if precision == "double":  # steps are of velocities in the base's frame, which turns
        assert max(errors) < 2 * min(errors)


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("h_omega", (0.1, 1, 1.4, 2.5, 10, 50))
def test_a_robot_at_rest_never_stops(loaded, precision, h_omega):
    """A stiff servo holds a link against gravity, critically damped, from its first step on."""
    omega = h_omega / 1e-3
    its = loaded(SERVO, precision, actuator_hinge_kp=INERTIA * omega**2,
                 actuator_hinge_kd=2 * INERTIA * omega)
    assert watched(its)[0] == ""


@pytest.mark.parametrize("h_omega, right", ((0.02, True), (2.5, False), (10, False)))
def test_a_start_that_steps_do_not_resolve_stops(loaded, h_omega, right):
    """The servo starts a twentieth of a radian from its target: all is over within 50 steps."""
    omega = h_omega / 1e-3
    its = loaded(SERVO, actuator_hinge_kp=INERTIA * omega**2,
                 actuator_hinge_kd=0.4 * INERTIA * omega, actuator_hinge_target=0.55)
    stopped, _ = watched(its)
    assert (stopped == "") == right
    assert right or "at t = 0 s: joint hinge is off by" in stopped


def test_what_floats_keeps_its_centre_of_mass_on_a_parabola_to_rounding(loaded):
    """Momentum and angular momentum about the world's origin are kept, too, over 2e4 steps."""
    for precision, u in (("double", 2.0**-53), ("single", 2.0**-24)):
        its = loaded(BASE, precision, actuator_j1_kp=5.0)
        q, v = its.start()
        v[:6] = 1, 2, -1, 3, 1, 2
        run = integrate(its, plan(its, until=20.0), start=(q, v))
        x = StateParts(its).places(run.q)[1]
        speed = StateParts(its).velocities(run.q, run.v)[1]
        path = x[0] + speed[0] * run.t[:, None]
        assert np.max(np.abs(x - path)) <= 64 * u * np.max(np.abs(path))
        assert np.max(np.abs(speed - speed[0])) <= 64 * u * np.max(np.abs(speed))
        L = np.asarray(loaded(BASE).call("momentum", q=run.q, v=run.v), float)[:, 3:]
        moment = 10.2 * np.linalg.norm(speed[0]) * np.max(np.abs(x))
        assert np.max(np.abs(L - L[0])) <= 64 * u * moment


PAIR = """
[bodies]
a = { mass = 1, inertia = [0.1, 0.1, 0.1] }
b = { mass = 1, inertia = [0.1, 0.1, 0.1] }
[joints]
ja = { type = "KIND", child = "a" }
jb = { type = "KIND", child = "b" }
[effects.spring_damper.tie]
bodies = ["a", "b"]
k = K
length = 1
[run]
duration = 0.1
"""
"""Two bodies that vibrate by a centimetre; they float, or slide along one rail."""


@pytest.mark.parametrize("kind", ("free", "prismatic"))
@pytest.mark.parametrize("h_omega, right", ((3, False), (0.05, True)))
def test_a_pair_that_travels_is_judged_as_one_at_rest(kind, h_omega, right, tmp_path):
    axis = ', axis = [1, 0, 0] }' if kind == "prismatic" else " }"
    path = tmp_path / "pair.toml"
    path.write_text(PAIR.replace("KIND", kind).replace('" }', f'"{axis}').replace(
        "K\n", f"{h_omega**2 / 2 * 1e6}\n"))
    its = system(load_scene(path), "double")
    each = its.functions.coordinates
    advised = set()
    for speed in (0, 1, 300):
        q, v = its.start()
        q[each[1].q.start] = 1.01
        for c in each:
            v[c.v.start] = speed
        stopped, _ = watched(its, q, v)
        assert (stopped == "") == right, (speed, stopped)
        if stopped:
            advised.add(remedy(its, plan(its), (q, v)))
    assert len(advised) <= 1


def test_the_verdict_on_a_member_is_that_on_any_number_of_them(loaded):
    """h ω is 1000 and the damping twice critical; with 9000 members the first steps are resolved of
    some of them alone."""
    its = loaded(SERVO)
    stiff = replace(its, p=np.broadcast_to(
        [INERTIA * 1e12, 4 * INERTIA * 1e6, 0.5], (9000, 3)).copy())
    q, v = (np.broadcast_to(x, (9000, *x.shape)).copy() for x in its.start())
    for members in (1, 600, 9000):
        some = stiff.member(np.arange(members))
        run = integrate(some, plan(some, until=0.1), alarm=Alarm, start=(q[:members], v[:members]))
        assert not run.failed, members
    moved = replace(its, p=np.broadcast_to(
        [INERTIA * 6.25e6, 0.4 * INERTIA * 2500, 0.55], (9000, 3)).copy())
    run = integrate(moved, plan(moved, until=0.1), alarm=Alarm, start=(q, v))
    assert len(run.failed) == 9000  # a step that does not resolve the start stops all of them


def test_the_alarm_does_not_depend_on_samples(loaded):
    """It looks between them, too: a servo's target comes in the middle of the run's one sample."""
    its = loaded(SERVO, actuator_hinge_kp=INERTIA * 6.25e6,
                 actuator_hinge_kd=0.1 * INERTIA * 2500, actuator_hinge_target=0.55)
    for every in (0.01, 0.5, 2.0):
        assert "too large at t = 0 s" in watched(its, every=every)[0]
    looks: list[float] = []

    class Looking(Alarm):
        def _look(self, since, *its):
            looks.append(round(since, 9))
            super()._look(since, *its)

    run = integrate(loaded(SERVO), plan(its, every=2.0), alarm=Looking)
    assert not run.stopped and looks == [0.0, 0.4, 0.8, 1.2, 1.6, 2.0]


SPIN = """
[bodies]
b = { mass = 1, inertia = [0.1, 0.1, 0.1] }
[joints]
j = { type = "spherical", child = "b" }
[start.q]
j = [0.5, 0.5, 0.5, 0.5]
[start.v]
j = [W, 0, 0]
[run]
duration = 1
step = 1e-4
"""


@pytest.mark.parametrize("w, frozen", ((1e-4, True), (1.0, False)))
@pytest.mark.parametrize("kind, ends", (("spherical", ("", "")), ("free", ("0, 0, 0, ",) * 2)))
def test_rotations_that_freeze_are_told(w, frozen, kind, ends, tmp_path):
    """Single precision moves no number of the quaternion: w h/2 is below half a spacing."""
    path = tmp_path / "spin.toml"
    path.write_text(SPIN.replace("spherical", kind).replace("[0.5", f"[{ends[0]}0.5").replace(
        "[W", f"[{ends[1]}{w}").replace("duration = 1", f"duration = {min(200.0, 0.1 / w)}"))
    its = system(load_scene(path), "single")
    stopped, _ = watched(its)
    assert ("rounding freezes joint j" in stopped) == frozen, stopped
    assert frozen == (float(np.abs(integrate(its, plan(its)).q[-1][-4:] - 0.5).max()) < 1e-6)


@pytest.mark.parametrize("far", (20, 1000))
def test_what_swings_far_away_is_not_frozen(far, tmp_path):
    """In single precision, though after whole periods it is where it was."""
    path = tmp_path / "far.toml"
    path.write_text(f"""
[bodies]
b = {{ mass = 1 }}
[joints]
j = {{ type = "prismatic", child = "b", axis = [1, 0, 0] }}
[effects.spring.j]
k = 1
q0 = {far}
[start.q]
j = {far + 1}
[run]
duration = {4 * np.pi}
""")
    assert watched(system(load_scene(path), "single"))[0] == ""


def test_distances_of_rotations_are_angles(loaded):
    its = loaded(BASE)
    q = np.stack([its.start()[0]] * 2)
    for angle in (1e-9, 0.1, 3.0):
        q[1, 3:7] = 0, np.sin(angle / 2), 0, -np.cos(angle / 2)
        a, b = (StateParts(its).places(x) for x in q)
        assert StateParts(its).distances(a, b)[0] == pytest.approx(angle, rel=1e-6)


def test_sizes_do_not_grow_along_the_line_of_start(loaded):
    its = loaded(BASE)
    q, v = its.start()
    v[0] = 300.0
    extent = Extent.since(StateParts(its), its.precision, 1e-3, q, v)
    moved = q.copy()
    moved[0] += 300.0
    extent.add(1.0, StateParts(its).places(moved))
    assert extent.sizes == pytest.approx([1e-3] * 5, abs=1e-9)  # rest
    assert replace(extent, way=np.ones(5), off=np.ones(5)).sizes == pytest.approx(1.0)
    about_centre = (1.5 + 0.003) / 2 + 10 * 0.2 / 10.2 * (0.3**2 + 0.1**2)  # half the trace
    turned = replace(extent, way=np.array([2.0, 0, 0, 0, 0]), off=np.zeros(5))
    assert turned.sizes[1] == pytest.approx((about_centre / 10.2)**0.5, rel=1e-3)
    single = Extent.since(StateParts(its), SINGLE, 1e-3, q, v)
    single.add(1.0, StateParts(its).places(moved))
    rounded = 1000 * 2**-24 * 300 / ALLOWED  # of a thousand steps
    assert single.sizes == pytest.approx([1e-3, rounded, 1e-3, 1e-3, 1e-3], abs=1e-9)
