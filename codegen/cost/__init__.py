"""What a scene costs: operations and times of kernels, effect by effect, and accuracy by time."""


class CostError(ValueError):
    """The costs cannot be measured as asked; the message says what came and what was wanted."""
