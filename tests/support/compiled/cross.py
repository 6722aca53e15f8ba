"""Compilers for other processors, whose programs run under qemu-user."""

import shutil

import pytest

# architecture → compiler; Debian's packages are named below.
COMPILERS = {"aarch64": "aarch64-linux-gnu-gcc", "riscv64": "riscv64-linux-gnu-gcc",
             "arm": "arm-linux-gnueabihf-gcc", "s390x": "s390x-linux-gnu-gcc"}
PACKAGES = (
    "gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-riscv64-linux-gnu libc6-dev-riscv64-cross "
    "gcc-arm-linux-gnueabihf libc6-dev-armhf-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross "
    "qemu-user gcc-arm-none-eabi libnewlib-arm-none-eabi")


def needed(*commands: str) -> None:
    """If one of the commands is missing, the test fails and says what to install."""
    if missing := [name for name in commands if shutil.which(name) is None]:
        pytest.fail(f"{', '.join(missing)} not installed; on Debian: apt-get install {PACKAGES}",
                    pytrace=False)
