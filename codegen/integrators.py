"""The integrators, the only list of them: names, orders, what each is good for.

Knows no dynamics and no language: `template` names a step's shape in templates/scene, `calls` the
function of the scene that it is built on."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Integrator:
    """One of them; without `template` SciPy's, which chooses its steps by tolerances."""

    name: str  # as scenes and commands call it
    order: int
    good_for: str  # and what not
    equation: str = ""
    template: str = ""
    calls: str = ""
    also: tuple[str, ...] = ()  # other functions that the step calls, of scenes that have them

    @property
    def step(self) -> str:
        """The name of its step's function, behind step_."""
        return self.name.replace("-", "_")

    @property
    def step_name(self) -> str:
        """The step's function; "" of those that are not emitted."""
        return f"step_{self.step}" if self.template else ""

    @property
    def needs(self) -> tuple[str, ...]:
        """All functions that the step may call."""
        return (self.calls, *self.also) if self.template else ()


INTEGRATORS = (
    Integrator(
        "leapfrog", 2, "the default: keeps energy, and the momentum of what floats free; any "
        "dampers, stiff motors, limits that bounce",
        "q_m = q ⊕ h/2 v; v' = v + h a(t + h/2, q_m, (v + v')/2); q' = q_m ⊕ h/2 v': drift, kick, "
        "drift, the kick in two passes, implicit in damping and stiffness of the effects; of "
        "second order.  Steps in which limits close are split, what floats free keeps its "
        "momentum", "leapfrog", "leapfrog",
        ("closing_contacts", "parts", "free_momentum", "with_free_momentum")),
    Integrator(
        "semi-implicit-euler", 1, "the cheapest step; for rough motions without stiff effects; "
        "what floats free gains momentum as it turns",
        "v' = v + h a(t, q, v); q' = q ⊕ h v': one step of the semi-implicit Euler method, of "
        "first order, with a of forward_dynamics at tau = 0", "euler", "forward_dynamics",
        ("integrated",)),
    Integrator(
        "linear-implicit-euler", 1, "never unstable by damping or stiffness, but does not resolve "
        "bounces (what falls on a stiff limit stays there) and vibrations; what floats free gains "
        "momentum as it turns",
        "v' = v + h a(t, q, v); q' = q ⊕ h v': one step of the linearly implicit Euler method, of "
        "first order, with a from dynamics in which damping and stiffness of joints act at the "
        "step's end", "euler", "implicit_acceleration", ("integrated",)),
    Integrator(
        "rk4", 4, "exact figures of smooth motions, fast spin; unstable where effects are stiff",
        "(q, v)' after h: one step of the classical Runge–Kutta method, of fourth order, with a of "
        "forward_dynamics at tau = 0; q moves by q ⊕ φ", "rk4", "forward_dynamics",
        ("integrated", "chart_rate")),
    Integrator("dop853", 8, "SciPy's, by tolerances: reference runs of smooth motions"),
    Integrator("radau", 5, "SciPy's, by tolerances: reference runs of stiff motions"))
"""The default first."""

NAMES = tuple(x.name for x in INTEGRATORS)
DEFAULT = NAMES[0]
ADAPTIVE = tuple(x.name for x in INTEGRATORS if not x.template)
"""SciPy's."""
STEPS = {x.step: x for x in INTEGRATORS if x.template}
"""Those that are emitted, by their steps' names."""


def named(name: str) -> Integrator:
    """The integrator of this name."""
    return next(x for x in INTEGRATORS if x.name == name)


def in_words() -> str:
    """All, with what they are good for, in one paragraph."""
    return "; ".join(f"{x.name}, of order {x.order}: {x.good_for}" for x in INTEGRATORS)
