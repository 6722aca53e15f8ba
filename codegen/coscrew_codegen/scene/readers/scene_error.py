"""The error in a scene file, or in the model that it names."""

from pathlib import Path

from coscrew_codegen.program.reported_error import ReportedError


class SceneError(ReportedError, ValueError):
    """"FILE: key or element: what came; what was wanted; did you mean …?"."""

    def __init__(self, file: Path | str, where: str, problem: str) -> None:
        place = f"{file}: {where}" if where else f"{file}"
        super().__init__(f"{place}: {problem}")
        self.file, self.where, self.problem = str(file), where, problem


def shown(came: object) -> str:
    """A value as one short line, for messages."""
    text = came if isinstance(came, str) else str(came)
    text = text if len(text) <= 60 else f"{text[:59]}…"
    return repr(text) if isinstance(came, str) else text.replace("\n", " ")
