"""SciPy's DOP853 as these references use it, and a bound of its error."""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.integrate import solve_ivp

TOLERANCE = 1e-13


def solved(rates: Callable[[float, np.ndarray], np.ndarray], start: Sequence[float],
           times: Sequence[float], tolerance: float = TOLERANCE) -> np.ndarray:
    """y at these times.  Each of them ends a step, so that nothing is interpolated."""
    y, t, result = np.array(start, float), 0.0, []
    for end in times:
        run = solve_ivp(rates, (t, end), y, "DOP853", rtol=tolerance, atol=tolerance / 10)
        if not run.success:
            raise ArithmeticError(run.message)
        y, t = run.y[:, -1], end
        result.append(y)
    return np.array(result)
