"""Fixtures of several files of this folder."""

from tests.support.scenes.reading import read

__all__ = ["read"]
