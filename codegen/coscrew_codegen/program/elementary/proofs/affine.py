"""Affine forms mid + Σ parts_i x_i ± spread, |x_i| <= 1, of integers that stand for multiples of a
small unit."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Form:
    """mid + Σ parts[i] x_i ± spread, where forms share the unknown x_i."""

    mid: int
    parts: dict[int, int]
    spread: int

    @property
    def radius(self) -> int:
        """The largest distance from the middle."""
        return sum(map(abs, self.parts.values())) + self.spread

    @property
    def range(self) -> tuple[int, int]:
        radius = self.radius
        return self.mid - radius, self.mid + radius

    def __add__(self, other: "Form") -> "Form":
        parts = dict(self.parts)
        for symbol, x in other.parts.items():
            total = parts.get(symbol, 0) + x
            if total:
                parts[symbol] = total
            else:
                del parts[symbol]
        return Form(self.mid + other.mid, parts, self.spread + other.spread)

    def __neg__(self) -> "Form":
        return Form(-self.mid, {s: -x for s, x in self.parts.items()}, self.spread)

    def __sub__(self, other: "Form") -> "Form":
        return self + -other

    def times(self, low: int, high: int, scale: int) -> "Form":
        """The form times a number between low and high, in units of 2^-scale: times the middle,
        and the rest as spread."""
        if not self.parts and not self.mid and not self.spread:
            return self
        middle = (low + high) // 2
        rest = max(high - middle, middle - low)
        parts = {s: y for s, x in self.parts.items() if (y := x * middle >> scale)}
        lost = ceil_shift((self.radius + abs(self.mid)) * rest + self.spread * abs(middle), scale)
        return Form(self.mid * middle >> scale, parts, lost + len(self.parts) + 1)


def ceil_shift(x: int, scale: int) -> int:
    """x / 2^scale, rounded up."""
    return -(-x >> scale)
