"""Reads the data of a playback page, and makes runs to be played back."""

import base64
import json
import re
import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.required_functions import VIEWED
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from tests.support.scenes.selecting import checked


class PageData:
    """The JSON of a page, and the arrays of its block."""

    def __init__(self, text: str) -> None:
        self.json = json.loads(element(text, "data"))
        self.block = zlib.decompress(base64.b64decode(element(text, "block")))

    def array(self, place: Sequence[Any]) -> np.ndarray:
        """Reads the planes of bytes one after another, as the page does."""
        at, kind, count = place
        size = int(kind[1])
        planes = np.frombuffer(self.block, np.uint8, size * count, at).reshape(size, count)
        return np.ascontiguousarray(planes.T).view(f"<{kind}").ravel()

    def mesh(self, number: int) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and faces: running sums of differences."""
        mesh = self.json["meshes"][number]
        small = self.array(mesh["vertices"]).reshape(3, -1).astype(np.int64)
        whole = np.cumsum(small, 1) % 2**16
        faces = np.cumsum(self.array(mesh["faces"]).astype(np.int64)).reshape(-1, 3)
        return whole.T * mesh["step"] + mesh["low"], faces

    def signal(self, name: str, run: int = 0) -> np.ndarray:
        """The values of a signal of a run."""
        (x,) = (x for group in self.json["groups"] for x in group["signals"]
                if (x["name"], x["run"]) == (name, run))
        return self.array(x["values"]).astype(float) + x["base"]

    def poses(self, run: int = 0) -> np.ndarray:
        """(bodies, 7, times)."""
        return self.array(self.json["runs"][run]["poses"]).reshape(
            len(self.json["bodies"]), 7, -1)


def element(text: str, name: str) -> str:
    """The content of a script of a page."""
    (content,) = re.findall(rf'<script [^>]*id="{name}">(.*?)</script>', text, re.S)
    return content


def run(path: Path, text: str, **overrides: Any) -> Sequence[Result]:
    """The runs of a scene with this text, one in each precision."""
    path.write_text(text)
    kernels = checked(path, None, others=VIEWED, precisions=("double", "single"))
    return simulated(kernels, RunOverrides(**overrides))


ARM = """
model = "arm.urdf"
[effects.gravity]
[effects.actuator.hinge]
kind = "pd"
kp = 40
kd = 4
target = "0.5*t"
[effects.wrench.gust]
body = "arm"
force = [3, 0, 0]
point = [0, 0, -1]
[effects.reaction]
joints = ["hinge"]
[effects.spring_damper.coil]
bodies = ["world", "arm"]
first = [1, 0, 0]
second = [0, 0, -1]
k = 5
length = 1
[outputs]
record = ["q", "position.arm", "reaction.hinge", "wrench.gust.force"]
every = 0.01
[run]
duration = 5
step = 5e-3
"""
URDF = """<robot name="arm"><link name="arm"><inertial><origin xyz="0 0 -1"/><mass value="1"/>
<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>{visuals}</link>
<link name="base"/><joint name="hinge" type="continuous"><parent link="base"/><child link="arm"/>
<axis xyz="0 1 0"/></joint></robot>"""
MESHED = '<visual><geometry><mesh filename="{}"/></geometry></visual>'


def arm(folder: Path, *visuals: str, text: str = ARM, **overrides: Any) -> Sequence[Result]:
    """The runs of an arm whose link has these visuals."""
    (folder / "arm.urdf").write_text(URDF.format(visuals="".join(visuals)))
    return run(folder / "arm.toml", text, **overrides)
