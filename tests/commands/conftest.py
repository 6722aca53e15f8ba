"""Fixtures of several files of this folder."""

from tests.support.scenes.simulated import kernels

__all__ = ["kernels"]
