"""The tiers of a scene: their selection by `tiers` in its file, by --tier or by load_scene."""

from collections.abc import Sequence

from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.scene.names import did_you_mean


class TiersError(ReportedError, ValueError):
    """A tier that scenes do not have; the message lists the tiers of scenes."""


def known() -> tuple[str, ...]:
    """The tiers that scenes have, the cheapest first."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES  # imported on use: most scenes are plain

    return tuple(tier.name for tier in OF_SCENES)


def on_request() -> tuple[str, ...]:
    """Returns the tiers of functions with a requested accuracy."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES

    return tuple(tier.name for tier in OF_SCENES if tier.on_request)


def need_ranges() -> tuple[str, ...]:
    """Returns the tiers that need the stated ranges of arguments."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES

    return tuple(tier.name for tier in OF_SCENES if tier.fixed)


def selected(words: Sequence[str]) -> tuple[str, ...]:
    """The tiers of these names besides plain, which every scene has; the cheapest first.  Raises
    TiersError."""
    if not words:
        return ()
    from coscrew_codegen.accuracy.tiers import PLAIN, TIERS

    names = known()
    for word in words:
        if word not in names:
            of_library = word in {tier.name for tier in TIERS}
            hint = f"the library alone has it; wanted one of {', '.join(names)}" if of_library \
                else did_you_mean(word, names)
            raise TiersError(f"{word!r} is no tier of scenes; {hint}")
    return tuple(name for name in names if name in words and name != PLAIN.name)
