"""The robots of example-robot-data, which comes with Pinocchio."""

import sysconfig
from pathlib import Path


def robots() -> tuple[Path, ...]:
    """All URDF files, in order; none without the package."""
    folder = Path(sysconfig.get_path("purelib"), "cmeel.prefix/share/example-robot-data/robots")
    return tuple(sorted(folder.rglob("*.urdf")))
