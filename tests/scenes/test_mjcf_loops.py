"""Closed loops of MJCF files: connect and weld, by bodies and by sites, close where MuJoCo closes
them, and `import` writes them."""

from pathlib import Path

import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.system import system
from tests.support.scenes.evaluation import DOUBLE, Evaluated

ROBOT = """<mujoco><compiler angle="radian"/><worldbody>
<body name="a" pos="0.1 0 0.5" quat="0.9 0.1 0.3 0.2"><joint name="one" axis="0 1 0"/>
<geom type="box" size="0.1 0.02 0.03" pos="0.1 0 0"/>
<body name="b" pos="0.25 0 0"><joint name="two" type="ball"/>
<geom type="box" size="0.1 0.03 0.02" pos="0.1 0 0"/>
<site name="u" pos="0.2 0 0.1" euler="0.3 0 1"/>
</body></body>
<body name="c" pos="-0.2 0.1 0.4" euler="0.4 0.2 0.1"><freejoint name="three"/>
<geom type="box" size="0.1 0.02 0.05"/><site name="w" pos="0.1 0.05 0" euler="0 0.5 0.2"/></body>
</worldbody><equality>LOOP</equality></mujoco>"""
LOOPS = {"connect of bodies": '<connect body1="b" body2="c" anchor="0.2 0.05 0"/>',
         "connect to the world": '<connect name="pin" body1="b" anchor="0.2 0.05 0"/>',
         "weld of bodies": '<weld body1="c" body2="b" relpose="0.1 0.2 0.3 0.9 0.1 0.2 0.3" '
                           'anchor="0.05 0.1 0.1"/>',
         "connect of sites": '<connect site1="u" site2="w"/>',
         "weld of sites": '<weld site1="w" site2="u"/>'}


def gaps(folder: Path, loop: str) -> tuple[np.ndarray, np.ndarray]:
    """MuJoCo's residuals of the equality at random states, and ours in the world's axes: angles as
    signed sizes only."""
    path = folder / "robot.xml"
    path.write_text(ROBOT.replace("LOOP", loop))
    model = mujoco.MjModel.from_xml_path(str(path))
    data, f = mujoco.MjData(model), Evaluated(read_scene(path), DOUBLE)
    rng, theirs, ours = np.random.default_rng(2), [], []
    for _ in range(5):
        q = rng.normal(size=model.nq)
        for k in (1, 8):
            q[k:k + 4] /= np.linalg.norm(q[k:k + 4])
        data.qpos[:] = q
        mujoco.mj_forward(model, data)
        rows = data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
        theirs.append(data.efc_pos[rows].copy())
        own = [*q[:1], *q[2:5], q[1], *q[5:8], *q[9:12], q[8]]
        kind = f.scene.model.loops[0].kind
        ours.append(np.array(f.components("closure", q=own), float)[:kind.count])
    return np.array(theirs), np.array(ours)


@pytest.mark.parametrize("loop", LOOPS.values(), ids=LOOPS)
def test_loops_are_open_as_far_as_in_mujoco(tmp_path: Path, loop: str) -> None:
    """Distances are the same; ours of angles are 2 tan(θ/2), MuJoCo's sin(θ/2)."""
    theirs, ours = gaps(tmp_path, loop)
    assert np.allclose(*(np.linalg.norm(x[:, :3], axis=1) for x in (theirs, ours)), rtol=1e-12)
    if "weld" in loop:
        angle = 2 * np.arctan(np.linalg.norm(ours[:, 3:], axis=1) / 2)
        theirs_angle = np.linalg.norm(theirs[:, 3:], axis=1)
        assert np.allclose(np.sin(angle / 2), theirs_angle, rtol=1e-9) or np.allclose(
            2 * np.sin(angle / 2), theirs_angle, rtol=1e-9)


def test_import_writes_loops(tmp_path: Path) -> None:
    path, scene = tmp_path / "robot.xml", tmp_path / "robot.toml"
    path.write_text(ROBOT.replace("LOOP", "".join(LOOPS.values())))
    assert main(["import", str(path), "-o", str(scene)]) == 0
    both = [Evaluated(read_scene(x), DOUBLE) for x in (path, scene)]
    q = np.array([0.3, 0.2, 0.4, 0.4, 0.8, 0.1, 0.2, 0.3, 0.4, 0.2, 0.4, 0.8])
    first, second = (np.array(f.components("closure", q=q), float) for f in both)
    assert np.allclose(np.linalg.norm(first[:3]), np.linalg.norm(second[:3]), rtol=1e-12)
    assert [x.name for x in both[1].scene.model.loops] == [
        "equality0", "pin", "equality2", "equality3", "equality4"]


def test_loops_may_be_left_out(tmp_path: Path) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(ROBOT.replace("LOOP", LOOPS["connect to the world"]))
    scene = tmp_path / "scene.toml"
    scene.write_text('model = "robot.xml"\nleave_out = ["loops"]\n')
    left = read_scene(scene)
    assert not left.model.loops
    assert any("left out (loops)" in x for x in left.unused)


def test_a_linkage_of_mujoco_runs(tmp_path: Path) -> None:
    path = tmp_path / "bars.xml"
    path.write_text("""<mujoco><worldbody>
<body name="crank"><joint name="drive" axis="0 1 0"/><geom type="capsule" size="0.02"
 fromto="0 0 0 0 0 0.3"/><body name="coupler" pos="0 0 0.3"><joint name="elbow" axis="0 1 0"/>
<geom type="capsule" size="0.02" fromto="0 0 0 0.8 0 0"/></body></body>
<body name="rocker" pos="0.8 0 0"><joint name="pivot" axis="0 1 0"/><geom type="capsule"
 size="0.02" fromto="0 0 0 0 0 0.3"/></body></worldbody>
<equality><connect body1="coupler" body2="rocker" anchor="0.8 0 0"/></equality></mujoco>""")
    its = system(load_scene(path), "double")
    q, v = its.start()
    q, v = its.stepper("step_leapfrog")(1000, 0.0, 1e-3, q, np.array([1.0, -1.0, 1.0]))
    assert abs(its.outputs("closure", q=q)[0]).max() < 1e-13
    assert q[0] == pytest.approx(q[2], abs=1e-12)  # a parallelogram
    assert abs(q[0]) > 0.1
