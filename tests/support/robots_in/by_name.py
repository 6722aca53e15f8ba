"""Robots by name: files of one name, in any format, hold one robot, and so do copies of a model."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import PurePath

from tests.support.robots_in.outcome import STATUSES, STILL, Outcome

_OF_NO_ROBOT = frozenset("""assets description descriptions main mj mjcf model robot robots scene
sdf urdf xacro xml""".split())
"""Words that name no robot."""


def name_of(file: str) -> str:
    """The words of the file's name, or of the first folder above it that has such."""
    path = PurePath(file.lower())
    for part in (path.name.partition(".")[0], *reversed(path.parts[:-1])):
        if words := [x for x in re.split("[^a-z0-9]+", part) if x and x not in _OF_NO_ROBOT]:
            return "_".join(words)
    return file


def robots(outcomes: Iterable[Outcome]) -> list[list[Outcome]]:
    """The files of each robot that moves, or that may move."""
    by_key: dict[str, list[Outcome]] = {}
    for x in outcomes:
        if x.status != STILL:
            own = [x]
            for key in (name_of(x.file), *([f"{x.format} {x.model}"] if x.model else [])):
                if key in by_key and by_key[key] is not own:
                    own += by_key[key]
                by_key[key] = own
            for y in own:  # both groups are one robot now
                for key in (name_of(y.file), f"{y.format} {y.model}"):
                    if key in by_key:
                        by_key[key] = own
    return list({id(x): x for x in by_key.values()}.values())


def alone(outcomes: Iterable[Outcome], formats: Iterable[str]) -> Mapping[str, Counter[str]]:
    """By format, the number of robots that no other format holds, by the best status of a file."""
    counts = {x: Counter[str]() for x in formats}
    for files in robots(outcomes):
        if len(held := {x.format for x in files}) == 1:
            counts[held.pop()][min((x.status for x in files), key=STATUSES.index)] += 1
    return counts
