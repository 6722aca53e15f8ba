"""Grids of heights against SciPy's Hermite splines, and bodies that stand on them."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scipy.interpolate import CubicHermiteSpline

from coscrew_codegen import load_scene, run
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.contacts.height_grid import HeightGrid
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

XS, YS = np.linspace(-1, 1, 9), np.linspace(0, 1.5, 7)
K = 1e5


def scene(folder: Path, table: str, rest: str = "") -> Path:
    """A point on heights of a table."""
    (folder / "ground.csv").write_text(table)
    path = folder / "scene.toml"
    path.write_text(f"""
[bodies]
ball = {{ mass = 1, inertia = [0.004, 0.004, 0.004] }}
[joints]
free = {{ type = "free", child = "ball" }}
[effects.gravity]
[effects.ground]
height = {{ file = "ground.csv" }}
[effects.contact.ball]
mu = 0.5
k = {K}
{rest}""")
    return path


def csv(heights: np.ndarray, xs: np.ndarray = XS, ys: np.ndarray = YS) -> str:
    rows = [["y\\x", *xs.tolist()], *([y, *row] for y, row in zip(
        ys, heights.tolist(), strict=True))]
    return "# heights in m\n" + "\n".join(",".join(map(str, row)) for row in rows)


def spline(heights: np.ndarray, x: float, y: float) -> tuple[float, float, float]:
    """The height and its slopes: along x, then along y, with the slopes of numpy.gradient."""
    def along(at: np.ndarray, values: np.ndarray, where: float) -> tuple[float, float]:
        of = CubicHermiteSpline(at, values, np.gradient(values, at))
        return of(where), of(where, 1)

    lines = [along(XS, row, x) for row in heights]
    z, along_y = along(YS, np.array([a for a, _ in lines]), y)
    along_x, _ = along(YS, np.array([b for _, b in lines]), y)
    return float(z), float(along_x), float(along_y)


def depths(heights: np.ndarray, places: np.ndarray, folder: Path) -> tuple[np.ndarray, np.ndarray]:
    """Depths and directions of force at points 5 mm below heights."""
    kernels = load_scene(scene(folder, csv(heights)), functions=["effect_contact_ball"])
    q = np.zeros((len(places), 10))
    q[:, :3], q[:, 6] = places, 1
    force = np.asarray(kernels.double.effect_contact_ball(q, np.zeros((len(q), 6)))[0])
    size = np.linalg.norm(force, axis=1)
    return (size / K)**(2 / 3), force / size[:, None]


def test_heights_and_slopes_are_those_of_another_spline(tmp_path: Path) -> None:
    """The depth is (H - z)/|(-∇H, 1)| along (-∇H, 1): inside, on grid lines and at the edges."""
    rng = np.random.default_rng(3)
    heights = rng.uniform(-0.2, 0.2, (len(YS), len(XS))).round(3)
    places = [*zip(rng.uniform(-1, 1, 60), rng.uniform(0, 1.5, 60), strict=True),
              *((x, y) for x in XS for y in YS[::3]), (-1, 0.3), (1, 1.4), (0.1, 0), (0.2, 1.5)]
    values = np.array([spline(heights, x, y) for x, y in places])
    at = np.array([(x, y, z - 0.005) for (x, y), (z, _, _) in zip(places, values, strict=True)])
    inner = (np.abs(at[:, 0]) < 1) & (at[:, 1] > 0) & (at[:, 1] < 1.5)
    depth, n = depths(heights, at, tmp_path)
    length = np.sqrt(values[:, 1]**2 + values[:, 2]**2 + 1)
    wanted = np.stack([-values[:, 1], -values[:, 2], np.ones(len(at))], 1) / length[:, None]
    assert inner.sum() > 60
    assert np.abs(depth - 0.005 / length)[inner].max() < 1e-14
    assert np.abs(n - wanted)[inner].max() < 1e-12


def test_heights_go_on_level_beyond_the_edges(tmp_path: Path) -> None:
    heights = np.array([[0.1, 0.3], [0.2, 0.7]])
    (tmp_path / "own").mkdir()
    path = scene(tmp_path / "own", csv(heights, np.array([0, 1]), np.array([0, 1])))
    f = load_scene(path, functions=["effect_contact_ball"]).double.effect_contact_ball
    q = np.zeros((2, 10))
    q[:, :3], q[:, 6] = ((5, 7, 0.7 - 0.002), (-3, -4, 0.1 - 0.002)), 1
    force = np.asarray(f(q, np.zeros((2, 6)))[0])
    assert np.abs(force - [0, 0, K * 0.002**1.5]).max() < 1e-9


def test_a_plane_of_points_is_a_plane(tmp_path: Path) -> None:
    """A point slides down it at g (sin α - mu cos α), without a trace of its grid lines."""
    slope = 0.8
    path = scene(tmp_path, csv(-slope * XS + 0 * YS[:, None]), "[start.q]\nfree = [-0.9, 0.7, "
                 f"{0.9 * slope - 1e-3 / 2}, 0, 0, 0, 1]\n[run]\nduration = 0.5\n")
    result = run(path, precision="double")
    t, x = (np.asarray(a)[10:] for a in (result.t, result.q[:, 0]))
    length = np.sqrt(1 + slope**2)
    a = 2 * np.polyfit(t, x, 2)[0] * length
    assert a == pytest.approx(9.81 * (slope - 0.5) / length, rel=2e-3)


@pytest.mark.parametrize("table, words", [
    ("y,0,1\n0,1,2", "wanted two rows and two columns of heights or more"),
    ("y,0,1\n0,1,2\n1,2", "line 3: 2 columns; wanted 3"),
    ("y,0,1\n0,1,2\n1,2,x", "line 3: 'x'"),
    ("y,0,1,3\n0,1,2,3\n1,2,3,4", "x 1 after 0; wanted even steps, here of 1.5"),
    ("y,0,1\n1,1,2\n0,2,3", "y 0 after 1; wanted places that increase"),
    ("y," + ",".join(map(str, range(2**10))) + "".join(
        f"\n{i}" + ",0" * 2**10 for i in range(2**10 + 1)),
     "has 1049600 heights; wanted at most 1048576")])
def test_tables_that_are_no_grid_are_refused(tmp_path: Path, table: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(scene(tmp_path, table))


@pytest.mark.parametrize("bits", [8, 16])
def test_an_image_is_the_table_of_its_greys(tmp_path: Path, bits: int) -> None:
    """The top of the image is at the largest y, black at the lower height."""
    grey = np.random.default_rng(4).integers(0, 2**bits, (3, 5)).astype(f"u{bits // 8}")
    Image.fromarray(grey).save(tmp_path / "ground.png")
    path = scene(tmp_path, "")
    path.write_text(path.read_text().replace('file = "ground.csv"', '''
file = "ground.png", size = [4, 1.5], heights = [-0.5, 2]'''.strip()))
    own = next(x for x in read_scene(path).effects if x.effect.name == "ground").values["height"]
    assert isinstance(own, HeightGrid)
    assert own.start == (-2, Fraction(-3, 4)) and own.spacing == (1, Fraction(3, 4))
    wanted = [[Fraction(5, 2) * int(x) / (2**bits - 1) - Fraction(1, 2) for x in row]
              for row in grey[::-1]]
    assert own.rows == tuple(map(tuple, wanted))


@pytest.mark.parametrize("keys, words", [
    ("size = [4, 1]", "heights: missing"), ("heights = [0, 1]", "size: missing"),
    ("size = [4, 0], heights = [0, 1]", "wanted two positive lengths"),
    ("size = [4, 1], heights = [1, 1]", "wanted the height of black"),
    ("size = [4, 1], heights = [0, 1], scale = 2", "scale: unknown key"),
    ("size = [4, 1], heights = [0, 1]", "wanted grey of 8 or 16 bits")])
def test_images_that_say_no_heights_are_refused(tmp_path: Path, keys: str, words: str) -> None:
    Image.fromarray(np.zeros((3, 5, 3), np.uint8)).save(tmp_path / "ground.png")
    path = scene(tmp_path, "")
    path.write_text(path.read_text().replace('file = "ground.csv"', f'file = "ground.png", {keys}'))
    with pytest.raises(SceneError, match=words):
        read_scene(path)


def test_what_is_no_image_or_too_small_is_refused(tmp_path: Path) -> None:
    path = scene(tmp_path, "")
    path.write_text(path.read_text().replace(
        'file = "ground.csv"', 'file = "ground.png", size = [4, 1], heights = [0, 1]'))
    (tmp_path / "ground.png").write_bytes(b"GIF89a")
    with pytest.raises(SceneError, match="cannot be read as a PNG image"):
        read_scene(path)
    Image.fromarray(np.zeros((1, 5), np.uint8)).save(tmp_path / "ground.png")
    with pytest.raises(SceneError, match="has 5 × 1 points"):
        read_scene(path)


def test_stated_ranges_prove_nothing_of_heights_and_say_so(tmp_path: Path):
    """Bodies' poses do not depend on heights: what does not depend on places is proved."""
    path = scene(tmp_path, csv(np.zeros((7, 9))), "[ranges]\nv = 1\n")
    functions = derive(read_scene(path))
    assert functions.named("energy").rounding.endswith(
        "Nothing is proved of other components of e: it calls functions beyond sines and cosines, "
        "or chooses.")
    assert functions.named("body_poses").rounding.startswith("Proved for every q")
