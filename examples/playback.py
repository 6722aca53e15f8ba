"""A scene's motion as an animated GIF:

    python examples/playback.py examples/scenes/arm6.toml examples/arm6.gif

Bodies are boxes of their mass and inertia, drawn from far to near."""

import sys
from collections.abc import Iterator
from itertools import product

import numpy as np
from PIL import Image, ImageDraw

import coscrew
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import required_functions
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from coscrew_codegen.simulation.view.body_shapes import drawn

WIDTH, HEIGHT, FINER = 640, 440, 3  # pixels; each drawn with 3 × 3
FRAMES_A_SECOND = 20
AZIMUTH, ELEVATION = -1.1, 0.35
LIGHT = np.array([0.35, -0.5, 0.8]) / np.linalg.norm([0.35, -0.5, 0.8])
COLOURS = ((86, 110, 150), (196, 116, 66), (92, 148, 112), (150, 104, 150), (190, 160, 80),
           (104, 148, 170), (176, 84, 84))
FACES = ((0, 2, 6, 4), (1, 3, 7, 5), (0, 1, 5, 4), (2, 3, 7, 6), (0, 1, 3, 2), (4, 5, 7, 6))
CORNERS = np.array([(x, y, z) for z, y, x in product((-1, 1), repeat=3)])


def boxes(path: str) -> tuple[np.ndarray, np.ndarray]:
    """Corners of all boxes at all frames, (frames, boxes, 8, 3), in m; and their bodies."""
    scene = read_scene(path)
    kernels = kernels_for(scene, required_functions.of_run(scene, None, view=True))
    run = simulated(kernels, RunOverrides(precision="double"))[0]
    t = run.trajectory.t
    chosen = np.searchsorted(t, np.arange(0, t[-1] - 1e-9, 1 / FRAMES_A_SECOND))
    poses = np.asarray(run.system.call("body_poses", t=t[chosen], q=run.trajectory.q[chosen]))
    poses = poses.reshape(len(chosen), -1, 3, 4)
    corners, bodies = [], []
    for part in (x for x in drawn(run.system).parts if x.shape == "box"):
        half, place = np.array(part.size) / 2, np.array(part.place)
        R = coscrew.mat3x3_from_quaternion(place[3:])
        own = (CORNERS * half) @ R.T + place[:3]
        D = poses[:, part.body]
        corners.append(np.einsum("fij,cj->fci", D[..., :3], own) + D[:, None, :, 3])
        bodies.append(part.body)
    return np.stack(corners, 1), np.array(bodies)


def camera(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The camera's axes (rows: right, up, towards it) and the middle of the scene."""
    ca, sa, ce, se = (f(x) for x in (AZIMUTH, ELEVATION) for f in (np.cos, np.sin))
    back, right = np.array([ce * ca, ce * sa, se]), np.array([-sa, ca, 0])
    low, high = points.reshape(-1, 3).min(0), points.reshape(-1, 3).max(0)
    return np.stack([right, np.cross(back, right), back]), (low + high) / 2


def frames(corners: np.ndarray, bodies: np.ndarray) -> Iterator[Image.Image]:
    axes, middle = camera(corners)
    seen = (corners - middle) @ axes.T
    scale = 0.46 * FINER * min(WIDTH / abs(seen[..., 0]).max(), HEIGHT / abs(seen[..., 1]).max())
    size = np.array([WIDTH, HEIGHT]) * FINER
    for shown, world in zip(seen, corners, strict=True):
        image = Image.new("RGB", tuple(size), (255, 255, 255))
        draw = ImageDraw.Draw(image)
        for _, pixels, colour in sorted(_faces(shown, world, bodies, scale, size),
                                        key=lambda face: face[0]):
            draw.polygon(pixels, fill=colour, outline=tuple(int(0.7 * c) for c in colour),
                         width=FINER)
        yield image.resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)


def _faces(shown: np.ndarray, world: np.ndarray, bodies: np.ndarray, scale: float,
           size: np.ndarray) -> Iterator[tuple[float, list[tuple[float, float]], tuple]]:
    """Distance of each face, its corners in pixels, its colour by its side to the light."""
    for box, places, body in zip(shown, world, bodies, strict=True):
        for face in map(list, FACES):
            out = places[face].mean(0) - places.mean(0)
            bright = 0.85 + 0.3 * out @ LIGHT / max(np.linalg.norm(out), 1e-12)
            pixels = [(size[0] / 2 + scale * x, size[1] / 2 - scale * y) for x, y, _ in box[face]]
            colour = tuple(min(255, int(bright * c)) for c in COLOURS[body % len(COLOURS)])
            yield box[face][:, 2].mean(), pixels, colour


def main(scene: str, output: str) -> None:
    """Simulate the scene and write the GIF."""
    images = list(frames(*boxes(scene)))
    palette = images[len(images) // 2].quantize(64)
    shown = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    shown[0].save(output, save_all=True, append_images=shown[1:], loop=0, optimize=True,
                  duration=1000 // FRAMES_A_SECOND)


if __name__ == "__main__":
    main(*sys.argv[1:])
