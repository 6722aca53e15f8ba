"""Quaternions are (x, y, z, w) everywhere, as in SciPy and Pinocchio.

In any other order, rotations would differ by far more than the bound of 64 u.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import coscrew
from coscrew_codegen import load_scene
from coscrew_codegen.simulation.system import system
from tests.support.compiled.c_harness import C11, INCLUDE, run
from tests.support.scenes.selecting import STEPPED

pin = pytest.importorskip("pinocchio")

TURNS = Rotation.random(40, random_state=3)
BOUND = 64 * 2.0**-53
SCENE = """
name = "hull"
base = "free"
[bodies.hull]
mass = 1
inertia = [1, 2, 2]
[bodies.head]
mass = 1
inertia = [1, 1, 1]
[joints.ball]
type = "spherical"
parent = "hull"
child = "head"
origin = {{ xyz = [0, 0, 1], quaternion = {placed} }}
[start.q]
base = [1, 2, 3, {base}]
ball = {ball}
"""


def same(result: np.ndarray, wanted: np.ndarray) -> bool:
    return bool(np.max(np.abs(np.asarray(result, float) - wanted)) <= BOUND)


def up_to_sign(result: np.ndarray, wanted: np.ndarray) -> bool:
    sign = np.sign((result * wanted).sum(-1))[..., None]
    return same(sign * result, wanted)


@pytest.mark.parametrize("module", (coscrew, coscrew.double), ids=("gufuncs", "twins"))
def test_rotations_are_scipys(module):
    q, R, v = TURNS.as_quat(), TURNS.as_matrix(), TURNS.as_rotvec()
    assert same(module.mat3x3_from_quaternion(q), R)
    assert up_to_sign(module.quaternion_from_mat3x3(R), q)
    assert up_to_sign(module.quaternion_exp(v), q)
    assert same(module.quaternion_log(q), v)
    product = module.quaternion_product_qq(q[:20], q[20:])
    assert up_to_sign(product, (TURNS[:20] * TURNS[20:]).as_quat())


def test_rotations_are_pinocchios():
    for q in TURNS.as_quat():
        theirs = pin.Quaternion(q)
        assert same(coscrew.mat3x3_from_quaternion(q), theirs.toRotationMatrix())
        assert same(coscrew.quaternion_conjugated(q), theirs.conjugate().coeffs())


def test_scenes_are_scipys(tmp_path):
    """An origin's quaternion, a free base's and a ball joint's, in one chain of rotations."""
    placed, base, ball = TURNS[:3]
    texts = [", ".join(map(repr, x.as_quat().tolist())) for x in (placed, base, ball)]
    path = tmp_path / "hull.toml"
    path.write_text(SCENE.format(placed=f"[{texts[0]}]", base=texts[1], ball=f"[{texts[2]}]"))
    scene = load_scene(path, functions=STEPPED)
    its = system(scene, "double")
    q, v = its.start()
    R = its.call("body_poses", t=0.0, q=q)[..., :3]
    assert same(R[0], base.as_matrix()) and same(R[1], (base * placed * ball).as_matrix())
    assert scene.neutral_q.tolist() == [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1]
    w = np.array([0.3, -0.2, 0.5])
    moved, _ = scene.double.step_rk4(1e-3, q, np.array([0, 0, 0, *w, 0, 0, 0]))
    turned = base * Rotation.from_rotvec(1e-3 * w)
    assert np.max(np.abs(np.abs(moved[3:7] @ turned.as_quat()) - 1)) < 1e-9


def test_members_in_c(tmp_path):
    source = tmp_path / "members.c"
    source.write_text("""#include <ksl/ksl.h>
#include <stdio.h>
int main(void) {
  const ksl_quaternion_t q = ksl_quaternion(1, 2, 3, 4);
  const ksl_quaternionf_t f = ksl_quaternionf(1, 2, 3, 4);
  printf("%g %g %g %g %g %g\\n", q.x, q.y, q.r.z, q.w, q.at[0], q.at[3]);
  printf("%g %g %g %g %g %g\\n", (double)f.x, (double)f.r.y, (double)f.z, (double)f.w,
         (double)f.at[0], (double)f.at[3]);
  return 0;
}
""")
    run(("gcc", *C11, "-I", INCLUDE, source, "-o", tmp_path / "members", "-lm"))
    assert run([tmp_path / "members"]) == 2 * "1 2 3 4 1 4\n"
