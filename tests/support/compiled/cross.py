"""Compilers for other processors, whose programs run under qemu-user."""

import shutil

import pytest

# architecture → compiler
COMPILERS = {"aarch64": "aarch64-linux-gnu-gcc", "riscv64": "riscv64-linux-gnu-gcc",
             "arm": "arm-linux-gnueabihf-gcc", "s390x": "s390x-linux-gnu-gcc"}


def needed(*commands: str) -> None:
    """Fails the test if one of the commands is missing, and names the package to install."""
    if missing := [name for name in commands if shutil.which(name) is None]:
        pytest.fail(f"{', '.join(missing)} not installed; sh tests/install_tools.sh installs it",
                    pytrace=False)
