"""Mass matrices that are singular for every q although each joint moves an inertia: joints that can
move together such that nothing with a mass moves."""

import math
import re
import time
import warnings

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.mechanism import unresisted
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

HEAVY = ('<inertial><origin xyz="0.1 0.2 0.3"/><mass value="1"/><inertia ixx="0.1" iyy="0.2" '
         'izz="0.15" ixy="0.01" ixz="0" iyz="0"/></inertial>')
POINT = '<inertial><origin xyz="{}"/><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ' \
        'ixz="0" iyz="0"/></inertial>'


def chain(*joints, masses=None, last=HEAVY):
    """A chain of (type, axis, attributes of the origin); only the last link has a mass, and those
    in `masses`."""
    links = {**dict.fromkeys(masses or (), HEAVY), len(joints): last}
    return '<robot name="r"><link name="l0"/>' + "".join(
        f'<link name="l{n}">{links.get(n, "")}</link><joint name="j{n}" type="{kind}">'
        f'<parent link="l{n - 1}"/><child link="l{n}"/><origin {at}/><axis xyz="{axis}"/></joint>'
        for n, (kind, axis, at) in enumerate(joints, 1)) + "</robot>"


UP, HERE = 'xyz="0 0 1"', 'xyz="0 0 0"'
SINGULAR = {
    "coaxial": (chain(("revolute", "0 0 1", UP), ("revolute", "0 0 1", UP)), [1, 2], [1]),
    "coaxial, oblique": (chain(("revolute", "1 2 7", UP), ("revolute", "1 2 7", 'xyz="2 4 14"')),
                         [1, 2], [1]),
    "coaxial in a turned frame": (chain(
        ("revolute", "0 0 1", UP),
        ("revolute", f"0 {math.sin(0.37):.10f} {math.cos(0.37):.10f}", f'{UP} rpy="0.37 0 0"')),
        [1, 2], [1]),
    "one rail twice": (chain(("prismatic", "1 0 0", UP), ("prismatic", "1 0 0", UP)), [1, 2], [1]),
    "three rails in a plane": (chain(("prismatic", "1 0 0", UP), ("prismatic", "0 1 0", UP),
                                     ("prismatic", "1 2 0", UP)), [1, 2, 3], [1]),
    "four rails": (chain(*(("prismatic", axis, UP) for axis in (
        "1 0 0", "0 1 0", "0 0 1", "1 1 1"))), [1, 2, 3, 4], [1]),
    "two of four rails are one": (chain(*(("prismatic", axis, UP) for axis in (
        "1 0 0", "0 1 0", "0 0 1", "0 1 0"))), [2, 4], [2]),
    "four parallel axes": (chain(*(("revolute", "0 0 1", 'xyz="1 0 0"') for _ in range(4))),
                           [1, 2, 3, 4], [1]),
    "seven axes": (chain(*(("revolute", f"{n} {n * n % 5} 1", f'xyz="1 0.1 0.3" rpy="0.3 0.1 {n}"')
                           for n in range(7))), [1, 2, 3, 4, 5, 6, 7], [1]),
    "ball and axis": (chain(("spherical", "1 0 0", UP), ("revolute", "0 0 1", HERE)), [1, 2], [2]),
    "free body and axis": (chain(("floating", "1 0 0", UP), ("revolute", "0 0 1", UP)), [1, 2],
                           [2])}
REGULAR = {
    "parallel axes": chain(("revolute", "0 0 1", UP), ("revolute", "0 0 1", 'xyz="1 0 0"')),
    "planar": chain(("prismatic", "1 0 0", UP), ("prismatic", "0 1 0", UP),
                    ("revolute", "0 0 1", UP)),
    "three rails": chain(*(("prismatic", axis, UP) for axis in ("1 0 0", "1 1 0", "1 1 1"))),
    "six axes": chain(*(("revolute", f"{n} {n * n % 5} 1", f'xyz="1 0.1 0.3" rpy="0.3 0.1 {n}"')
                        for n in range(6))),
    "coaxial with a mass between": chain(("revolute", "0 0 1", UP), ("revolute", "0 0 1", UP),
                                         masses=[1]),
    "a tilt of 1e-8 rad": chain(("revolute", "0 0 1", UP), ("revolute", "0 1e-8 1", UP)),
    "a point turned to the axis at q = 0 only": chain(
        ("revolute", "1 0 0", UP), ("revolute", "0 0 1", HERE), last=POINT.format("0.1 0 0")),
    "a point beside its axis": chain(("revolute", "0 0 1", UP), last=POINT.format("1e-17 0 1"))}


@pytest.fixture
def written(tmp_path):
    def written(urdf, tail=""):
        (tmp_path / "r.urdf").write_text(urdf)
        path = tmp_path / "r.toml"
        path.write_text(f'model = "r.urdf"\n[effects.gravity]\n{tail}')
        return path
    return written


@pytest.mark.parametrize("urdf, joints, cure", SINGULAR.values(), ids=SINGULAR)
def test_joints_that_move_together_are_named_with_a_remedy_that_works(written, capsys, urdf, joints,
                                                                      cure, tmp_path):
    path = written(urdf)
    names = ", ".join(f"'j{n}'" for n in joints)
    remedy = f'[effects.armature] with joints = ["j{cure[0]}"] and inertia = 1e-3'
    why = (f"joints {names} can move together without inertia against that motion, so that the "
           f"mass matrix is singular; wanted {remedy}")
    assert why_singular(read_scene(path)) == why
    assert main(["generate", str(path), "-o", str(tmp_path / "out")]) == 0
    assert (f"r.toml: forward_dynamics and steps are left out: {why}"
            in capsys.readouterr().err.splitlines())
    assert main(["simulate", str(path)]) == 2
    assert capsys.readouterr().err.endswith(f"divides by the mass matrix, but {why}\n")
    cured = written(urdf, remedy.replace(" with ", "\n").replace(" and ", "\n")
                    + "\n[run]\nduration = 2e-3\n")
    assert not why_singular(read_scene(cured))
    assert main(["simulate", str(cured)]) == 0


@pytest.mark.parametrize("urdf", REGULAR.values(), ids=REGULAR)
def test_regular_mass_matrices_are_not_called_singular(written, urdf):
    assert not why_singular(read_scene(written(urdf)))


@pytest.mark.parametrize("axis, at", [("1 2 7", "0.1 0.2 0.7"), ("0.3 0.4 0.5", "0.6 0.8 1.0"),
                                      ("1 1 1", "-3 -3 -3"), ("0 0 1", "0 0 5")])
def test_a_point_on_an_oblique_axis_has_no_inertia_against_it(written, axis, at):
    path = written(chain(("revolute", axis, UP), last=POINT.format(at)))
    assert why_singular(read_scene(path)).startswith(
        "what joint 'j1' moves has no inertia against that motion")


def random_robot(random):
    """A tree with rough axes, places and masses, many of them missing."""
    count = int(random.integers(2, 8))
    heavy = random.uniform(size=count + 1) < 0.5
    parts = [f'<robot name="r"><link name="l0">{HEAVY}</link>']
    for n in range(1, count + 1):
        kind = random.choice(["revolute", "prismatic"])
        axis = random.integers(-1, 2, 3)
        axis = axis if axis.any() else [0, 0, 1]
        at, turn = random.integers(0, 2, 3), random.integers(0, 3, 3) * 0.3
        parent = n - 1 if random.uniform() < 0.8 else int(random.integers(n))
        parts.append(
            f'<link name="l{n}">{HEAVY if heavy[n] else ""}</link><joint name="j{n}" type="{kind}">'
            f'<parent link="l{parent}"/><child link="l{n}"/><limit effort="1" velocity="1" '
            'lower="-9" upper="9"/>'
            f'<origin xyz="{" ".join(map(str, at))}" rpy="{" ".join(map(str, turn))}"/>'
            f'<axis xyz="{" ".join(map(str, axis))}"/></joint>')
    return "".join(parts) + "</robot>"


def test_random_trees_are_singular_where_pinocchio_s_mass_matrix_is(written):
    pinocchio = pytest.importorskip("pinocchio")
    random, seen = np.random.default_rng(5), {True: 0, False: 0}
    for _ in range(60):
        urdf = random_robot(random)
        model = pinocchio.buildModelFromXML(urdf)
        ranks = [np.linalg.matrix_rank(pinocchio.crba(
            model, model.createData(), random.uniform(-1.5, 1.5, model.nq)), tol=1e-9,
            hermitian=True) for _ in range(5)]
        why = why_singular(read_scene(written(urdf)))
        assert bool(why) == (max(ranks) < model.nv), urdf
        seen[bool(why)] += 1
        if why:
            joints = re.search(r"\[effects.armature\] with joints = (\[.*?\])", why)[1]
            cured = read_scene(written(
                urdf, f"[effects.armature]\njoints = {joints}\ninertia = 1e-3\n"))
            assert not why_singular(cured)
            assert joints.count("j") == model.nv - max(ranks)
    assert min(seen.values()) > 10


def test_followers_bind_what_could_move(written):
    """A joint that follows its coaxial neighbour moves the mass with it, unless backwards."""
    def urdf(multiplier):
        return chain(("revolute", "0 0 1", UP), ("revolute", "0 0 1", UP)).replace(
            "</joint></robot>", f'<mimic joint="j1" multiplier="{multiplier}"/></joint></robot>')
    for multiplier, singular in ((1, False), (0, False), (-0.5, False), (-1, True)):
        path = written(urdf(multiplier), "[effects.mimic]\n")
        assert bool(why_singular(read_scene(path))) == singular
    assert why_singular(read_scene(written(urdf(1))))


@pytest.mark.parametrize("given", [
    'joints = ["j1"]\ninertia = 1e-3\n', "inertia = { j1 = 1e-3 }\n", "[effects.armature.j1]\n"
    "inertia = 1e-3\n"])
def test_the_remedy_works_beside_armatures_that_are_there(written, given):
    urdf = chain(("revolute", "0 1 0", UP), ("prismatic", "1 0 0", UP), last="")
    head = f"[effects.armature]\n{given}"
    why = why_singular(read_scene(written(urdf, head)))
    table = re.search(r"wanted (\[.*?\]) with (inertia = 1e-3), beside the armatures", why)
    assert table[1] == "[effects.armature.j2]"
    path = written(urdf, f"{head}{table[1]}\n{table[2]}\n[run]\nduration = 2e-3\n")
    assert not why_singular(read_scene(path)) and main(["simulate", str(path)]) == 0


def test_armatures_of_zero_are_none(written, capsys):
    urdf = chain(("revolute", "0 1 0", UP), ("prismatic", "1 0 0", UP), last="")
    path = written(urdf, "[effects.armature]\ninertia = { j1 = 1, j2 = 0 }\n")
    assert why_singular(read_scene(path)) == (
        "joint 'j2' moves nothing that has a mass, so that the mass matrix is singular; wanted a "
        "positive inertia of 'j2' in [effects.armature]")
    assert main(["simulate", str(path)]) == 2
    assert "a positive inertia of 'j2'" in capsys.readouterr().err
    path = written(urdf, "[effects.armature]\njoints = 'all'\nrotor = 1\ninertia = 0\n")
    assert not why_singular(read_scene(path))


def test_what_can_be_had_of_such_a_model_is_right(written):
    """M from the inverse dynamics; its null space turns both joints against each other."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        f = load_scene(written(SINGULAR["coaxial"][0])).double
    M = f.mass_matrix(np.array([0.3, -0.8]))
    assert not hasattr(f, "forward_dynamics")
    np.testing.assert_allclose(M, np.full((2, 2), 0.15 + 0.1**2 + 0.2**2), rtol=1e-15)


@pytest.mark.parametrize("at", [HERE, UP])
def test_long_chains_are_judged_at_once(written, at):
    """35 joints, every other link without a mass; the last two on one rail."""
    joints = [("revolute", f"{n % 3} {n % 2} 1", f'xyz="0.3 0 0.1" rpy="0.3 {n} 0"')
              for n in range(33)]
    urdf = chain(*joints, *[("prismatic", "1 0 0", at)] * 2, masses=range(0, 34, 2))
    scene = read_scene(written(urdf))
    unresisted.alone.cache_clear()
    unresisted.common.cache_clear()
    start = time.process_time()
    assert why_singular(scene).startswith("joints 'j34', 'j35' can move together")
    assert time.process_time() - start < 1


def test_impossible_bodies_that_are_accepted_have_regular_matrices(written):
    """Negative moments: a wrong mass matrix, but no singular one."""
    heavy = HEAVY.replace('izz="0.15"', 'izz="-3"')
    for kind in ("revolute", "spherical"):
        path = written(chain(("revolute", "0 1 0", UP), (kind, "0 0 1", UP), last=heavy))
        scene = read_scene(path, overrides=SceneOverrides(implausible="warn"))
        assert scene.model.implausible and not why_singular(scene)
