"""Numbers that XLA computes once.

It computes a number again where that saves memory, and may round it differently there, since it
contracts a b + c.  A choice between options would be made one way for some results, another way for
others."""

from typing import Any

import jax
from jax.experimental.xla_metadata import set_xla_metadata


def once(x: Any) -> Any:
    """Returns the number so that each use reads it from memory."""
    return jax.lax.platform_dependent(x, cpu=_by_call, default=jax.lax.optimization_barrier)


def _by_call(x: Any) -> Any:
    """Through a call that stays one: on a CPU, XLA drops barriers before it fuses."""
    with set_xla_metadata(inlineable="false"):
        return _same(x)


@jax.jit
def _same(x: Any) -> Any:
    return x
