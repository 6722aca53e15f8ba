"""Tests of work that is not done: what tests/unfinished.txt names may fail, and is reported as such."""

from pathlib import Path

import pytest

UNFINISHED = tuple(line.strip() for line in
                   Path(__file__).with_name("unfinished.txt").read_text("utf-8").splitlines()
                   if line.strip() and not line.startswith("#"))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.nodeid.removeprefix("tests/").startswith(UNFINISHED):
            item.add_marker(pytest.mark.xfail(reason="unfinished: tests/unfinished.txt"))
