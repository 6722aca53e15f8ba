"""What a scene costs: operations and times of kernels, effect by effect, and accuracy by time."""

from coscrew_codegen.errors import Told


class CostError(Told, ValueError):
    """The costs cannot be measured as asked; the message says what came and what was wanted."""
