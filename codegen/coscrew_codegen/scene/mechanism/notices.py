"""Notices on content of a model's file that a scene does not use, and one line that sums them up.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

FALLING = "weight"
ACCEPT = "accept"
"""The value of a scene's `falling` without which the notice is given."""
IDLE = "torque or force"
COLLISION = "collision shape"
SUBJECTS = (
    FALLING, IDLE, COLLISION, "gravity", "actuator", "wrench", "other tools' joints", "spring",
    "armature",
    "mimic", "wrong mimic", "friction", "wrong friction", "damping", "wrong damping",
    "other tools' numbers", "limits", "wrong limits", "effort", "wrong effort", "velocity",
    "wrong velocity", "acceleration", "deceleration", "jerk", "safety controller",
    "repeated element", "xacro")
"""Subjects of notices; those that change the motion most come first."""


@dataclass(frozen=True)
class Notice:
    """A line on a number or element of a model that the scene does not use."""

    subject: str  # one of SUBJECTS
    of: str  # "joint elbow"
    text: str  # the whole line
    remedy: str = ""  # 'add [effects.viscous] with joints = "all" and d = "model"', if that is one
    used_by: tuple[str, str] = ("", "")  # the effect that uses it, and its joint, body or label, or
    # "" for any

    def __post_init__(self) -> None:
        if self.subject not in SUBJECTS:
            raise ValueError(f"a notice of {self.subject!r}; wanted one of {', '.join(SUBJECTS)}")


def by_importance(notices: Iterable[Notice]) -> tuple[Notice, ...]:
    """The notices in the order of their subjects, otherwise as given."""
    return tuple(sorted(notices, key=lambda x: SUBJECTS.index(x.subject)))


def lines(notices: Sequence[Notice], verbose: bool) -> list[str]:
    """All notices, or what falls and one line that sums up the others."""
    if verbose:
        return [x.text for x in by_importance(notices)]
    others = [x for x in notices if x.subject != FALLING]
    fall = [x.text for x in notices if x.subject == FALLING]
    return [x for x in (*fall, summary(others)) if x]


def summary(notices: Sequence[Notice], option: str = "--verbose") -> str:
    """One line that sums the notices up, or is the only one; "" for none.

    "not used: mimic of 3 joints, friction and damping of 7, limits of 7 (add [effects.mimic],
    [effects.viscous]; --verbose lists them with what to write)"."""
    if len(notices) < 2:
        return "".join(x.text for x in notices)
    ordered = by_importance(notices)
    remedies = dict.fromkeys(x.remedy.removeprefix("add ") for x in ordered if x.remedy)
    effects = dict.fromkeys(f"{'.'.join(x.partition(']')[0].split('.')[:2])}]" for x in remedies)
    hints = [f"add {', '.join(effects if len(remedies) > 1 else remedies)}"] if remedies else []
    more = " with what to write" if len(remedies) > 1 else ""
    return f"not used: {_listed(ordered)} ({'; '.join([*hints, f'{option} lists them{more}'])})"


def _listed(ordered: Sequence[Notice]) -> str:
    """"mimic of 3 joints, friction and damping of 7": subjects of the same joints together."""
    owners: dict[str, dict[str, None]] = {}
    for notice in ordered:
        owners.setdefault(notice.subject, {})[notice.of] = None
    groups: list[tuple[list[str], list[str]]] = []
    for subject, of in owners.items():
        if groups and groups[-1][1] == list(of):
            groups[-1][0].append(subject)
        else:
            groups.append(([subject], list(of)))
    listed, last = [], ""
    for subjects, names in groups:
        what, count = _plural(names), names[0]
        if len(names) > 1:
            count = f"{len(names)}" if what == last else f"{len(names)} {what}"
            last = what
        listed.append(f"{_joined(subjects)} of {count}")
    return ", ".join(listed)


def _plural(owners: Sequence[str]) -> str:
    words = {owner.partition(" ")[0] for owner in owners}
    plural = {"joint": "joints", "body": "bodies", "effect": "effects"}
    return plural.get(words.pop(), "elements") if len(words) == 1 else "elements"


def _joined(words: Sequence[str]) -> str:
    """a; a and b; a, b and c."""
    return " and ".join((", ".join(words[:-1]), words[-1])) if len(words) > 1 else words[0]
