"""Builds steps of integrators: their schemes as calls of a scene's functions.

All arithmetic of a step is in a few functions.  Those of one velocity or acceleration are shared by
the integrators, those of a weighted mean belong to one:

    drift(h, u) = h u                  half_drift(h, u) = h/2 u             phi of q ⊕ phi
    kick(h, v, a) = v + h a            half_kick(h, v, a) = v + h/2 a       kick_2_3: 2 h/3
    time_after_step(t, h) = t + h      time_after_half_step(t, h) = t + h/2
    rk4_displacement(h, u1, u2, u3, u4) = h/6 (u1 + 2 u2 + 2 u3 + u4)
    rk4_velocity(h, v, a1, a2, a3, a4) = v + h/6 (a1 + 2 a2 + 2 a3 + a4)
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from math import lcm

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array, headings
from coscrew_codegen.program.scene_functions import (
    Call,
    FunctionProgram,
    IntegratorStep,
    SceneFunctions,
    Split,
)
from coscrew_codegen.scene.function_selection import (
    CARRIED,
    CLOSED,
    CONTACTS,
    FREE,
    MOVED,
    MOVED_STATES,
    STATE_RATES,
)
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.integrator import Composition, Drift, Integrator, Kick, Tableau
from coscrew_codegen.scene.integrators import EMITTED

ACCELERATION = "forward_dynamics"
RATE = "chart_rate"
(MOMENTUM, CORRECTED), (CLOSING, PARTS) = FREE, CONTACTS
CHART_ORDER = 4
"""The order of accuracy of `chart_rate`."""


def needs(integrator: Integrator, takes_tau: bool = False) -> tuple[str, ...]:
    """Names of the functions that a step calls, if the scene has them."""
    match integrator.scheme:
        case Tableau():
            return ACCELERATION, MOVED, RATE, CLOSED, STATE_RATES
        case Composition() as scheme:
            return (*(_accelerating(x.by, takes_tau) for x in scheme.stages
                      if isinstance(x, Kick)), MOVED, CLOSED,
                    *(CONTACTS if scheme.splits else ()),
                    CARRIED if scheme.moves_states else MOVED_STATES,
                    *(FREE if scheme.keeps_momentum and not takes_tau else ()))
    return ()


def _accelerating(by: str, takes_tau: bool) -> str:
    """Name of the acceleration function `by`, or of its variant that also takes joint torques."""
    return f"{by}_tau" if takes_tau and by != ACCELERATION else by


def stepped(scene: SceneFunctions, integrators: Iterable[Integrator] = EMITTED,
            with_tau: Iterable[Integrator] = ()) -> SceneFunctions:
    """Adds to the scene a step for each of these integrators, steps that take joint torques for
    those in `with_tau`, and the internal functions that steps need.

    Raises ValueError if an integrator calls a function that the scene does not have, or has a
    higher order than the chart for quaternions."""
    means = _Means(scene)
    steps = (*(_StepWriter(scene, means, x).step() for x in integrators),
             *(_StepWriter(scene, means, x, takes_tau=True).step() for x in with_tau))
    return replace(scene, functions=(*scene.functions, *means.functions.values()), steps=steps)


class _Means:
    """The functions of weighted means, each recorded once."""

    def __init__(self, scene: SceneFunctions):
        self.scene, self.functions = scene, dict[str, FunctionProgram]()
        self.joints = identifiers([x.joint for x in scene.coordinates])

    def time(self, c: Fraction) -> str:
        """The name of t + c h."""
        name, result = f"time_after_{_part_of('step', c)}", array("t", (), "time in s")
        if name not in self.functions:
            recorder = Recorder((result, array("h", (), "step in s")))
            (t,), (h,) = recorder.argument("t"), recorder.argument("h")
            with recorder.part("later"):
                program = recorder.program(name, [(result, [t + h / c.denominator * c.numerator])])
            self.functions[name] = FunctionProgram(name, f"t + {c} h", program, internal=True)
        return name

    def drift(self, weights: Sequence[Fraction], owner: str = "{}") -> str:
        """The name of h times the weighted mean of velocities u; of several, it is the `owner`'s
        displacement."""
        name = owner.format("displacement") if len(weights) > 1 else _part_of("drift", weights[0])
        return self._mean(name, "drift", "u", "phi", weights)

    def kick(self, weights: Sequence[Fraction], owner: str = "{}") -> str:
        """The name of v + h times the weighted mean of accelerations a; of several, it is the
        `owner`'s velocity."""
        name = owner.format("velocity") if len(weights) > 1 else _part_of("kick", weights[0])
        return self._mean(name, "kick", "a", "v", weights)

    def states(self, weights: Sequence[Fraction], owner: str) -> str:
        """The name of q whose states of effects are those of q0 and h times the weighted mean of
        rates dx."""
        name = owner.format("states") if len(weights) > 1 else _part_of("states", weights[0])
        if name not in self.functions:
            nq, names = self.scene.nq, numbered("dx", len(weights))
            first = nq - len(self.scene.states)
            q, size = array("q", (nq,), "coordinates"), (len(self.scene.states),)
            recorder = Recorder((array("h", (), "step in s"), q, array("q0", (nq,), "at first"),
                                 *(array(x, size, "rates") for x in names)))
            given, above, below = [recorder.argument(x) for x in names], *_scaled(weights)
            with recorder.part("part"):
                part = recorder.argument("h")[0] / below
            with recorder.part("x", heading="states of effects"):
                moved = [y + part * _sum([x[k] * n for x, n in zip(given, above, strict=True)])
                         for k, y in enumerate(recorder.argument("q0")[first:])]
            program = recorder.program(name, [(q, [*recorder.argument("q")[:first], *moved])])
            words = f"q with the states x0 + {_in_words(weights, names)}"
            self.functions[name] = FunctionProgram(name, words, program, headings(program),
                                                   internal=True)
        return name

    def _mean(self, name: str, kind: str, of: str, result: str, weights: Sequence[Fraction]) -> str:
        names = numbered(of, len(weights))
        if name in self.functions:
            return name
        size, added = (self.scene.nv,), ("v",) if kind == "kick" else ()
        recorder = Recorder((array("h", (), "step in s"), *(
            array(x, size, "along the speeds") for x in (*added, *names))))
        given, above, below = [recorder.argument(x) for x in names], *_scaled(weights)
        with recorder.part("part"):
            part = recorder.argument("h")[0] / below
        results: list[Number] = []
        for joint, places in zip(self.joints, self.scene.coordinates, strict=True):
            with recorder.part(joint, kind, f"joint {places.joint!r}"):
                for k in places.v:
                    mean = part * _sum([x[k] * n for x, n in zip(given, above, strict=True)])
                    results.append(recorder.argument("v")[k] + mean if added else mean)
        program = recorder.program(name, [(array(result, size, "along the speeds"), results)])
        words = f"{result} = {'v + ' if added else ''}{_in_words(weights, names)}"
        self.functions[name] = FunctionProgram(name, words, program, headings(program),
                                               internal=True)
        return name


class _StepWriter:
    """Writes the step of one integrator."""

    def __init__(self, scene: SceneFunctions, means: _Means, integrator: Integrator,
                 takes_tau: bool = False):
        self.scene, self.means, self.integrator = scene, means, integrator
        self.takes_tau = takes_tau
        self.calls: list[Call] = []
        self.zeros: tuple[str, ...] = ()
        self.h = "h"

    def step(self) -> IntegratorStep:
        """The step as calls."""
        body: Sequence[Call | Split]
        match self.integrator.scheme:
            case Tableau() as scheme:
                body = self._runge_kutta(scheme)
            case Composition() as scheme:
                body = self._composed(scheme)
            case _:
                raise ValueError(f"{self.integrator.name} is SciPy's: it has no step to emit")
        its = self.integrator
        if not self.takes_tau:
            return IntegratorStep(its.name, its.step_name, its.equation, tuple(body), self.zeros)
        return IntegratorStep(its.name, its.step_with_tau,
                              f"{its.step_name} with tau, torques and forces of joints that hold "
                              "during the step, besides the effects; it does not correct the "
                              "momentum of floating bases", tuple(body), takes_tau=True)

    def _call(self, name: str, *results: str, **given: str) -> None:
        self.calls.append(self._made(name, *results, **given))

    def _made(self, name: str, *results: str, **given: str) -> Call:
        """The call, with h the length of a part if the step is split."""
        function = self.means.functions.get(name) or self._of_scene(name)
        given = {"h": self.h, **given}
        return Call(name, results, tuple((x, y) for x, y in given.items()
                                         if x != y and function.takes(x)))

    def _of_scene(self, name: str) -> FunctionProgram:
        if not self.scene.has(name):
            raise ValueError(f"scene {self.scene.name!r} has no function {name!r}, which "
                             f"{self.integrator.name} needs")
        return self.scene.named(name)

    def _accelerate(self, by: str, a: str, c: Fraction, t: str, q: str, v: str) -> None:
        """Append a = by(t + c h, q, v), at tau = 0 unless the step takes it; `t` is the variable of
        that time."""
        by = _accelerating(by, self.takes_tau)
        function, t = self._of_scene(by), self._time(by, c, t)
        if function.takes("tau") and not self.takes_tau:
            self.zeros = ("tau",)
        moved = [q] if len(function.program.outputs) > 1 else []  # with the states of effects
        self._call(by, a, *moved, t=t, q=q, v=v)

    def _time(self, of: str, c: Fraction, t: str) -> str:
        """The variable of the time t + c h at which a function is called, if it takes the time."""
        if not (c and self.scene.has(of) and self._of_scene(of).takes("t")):
            return "t"
        if not any(x.results == (t,) for x in self.calls):
            self._call(self.means.time(c), t)
        return t

    # explicit Runge–Kutta methods

    def _runge_kutta(self, scheme: Tableau) -> list[Call]:
        """The rates of φ and v, stage by stage; without quaternions φ' = v."""
        charted = self.scene.has(RATE)
        if charted and self.integrator.order > CHART_ORDER:
            raise ValueError(f"{self.integrator.name} is of order {self.integrator.order}; the "
                             f"chart that moves quaternions is true to order {CHART_ORDER}")
        speeds, accelerations, rates = ["v"], ["a1"], ["dx1"]
        self._rate_states("dx1", "q", "q", "v", "t")
        self._accelerate(ACCELERATION, "a1", Fraction(0), "t", "q", "v")
        for n, (row, c) in enumerate(zip(scheme.a, scheme.c[1:], strict=True), 2):
            t, q, v, u, a = (f"{x}{n}" for x in "tqvua")
            self._weighted(self.means.drift, "u", row, speeds, "phi", f"_of_stage_{n}")
            self._weighted(self.means.kick, "a", row, accelerations, v, f"_of_stage_{n}")
            self._call(MOVED, q)
            if charted:
                self._call(RATE, u, v=v)
            self._move_states(row, rates, q, f"_of_stage_{n}")
            self._rate_states(f"dx{n}", q, q, v, self._time(STATE_RATES, c, t))
            self._accelerate(ACCELERATION, a, c, t, q, v)
            speeds.append(u if charted else v)
            accelerations.append(a)
            rates.append(f"dx{n}")
        self._weighted(self.means.drift, "u", scheme.b, speeds, "phi")
        self._weighted(self.means.kick, "a", scheme.b, accelerations, "v")
        self._call(MOVED, "q")
        self._move_states(scheme.b, rates, "q")
        self._close()
        self._rate_states("dx1", "q", "q", "v", self._time(STATE_RATES, Fraction(1), "t_end"))
        return self.calls

    def _move_states(self, row: Sequence[Fraction], rates: Sequence[str], q: str,
                     stage: str = "") -> None:
        """Appends the motion of effects' states by a weighted mean of their rates."""
        if self.scene.has(STATE_RATES):
            self._weighted(self.means.states, "dx", row, rates, q, stage, q=q, q0="q")

    def _rate_states(self, rates: str, kept: str, q: str, v: str, t: str) -> None:
        """Appends the rates of effects' states, and q with them within their bounds."""
        if self.scene.has(STATE_RATES):
            self._call(STATE_RATES, rates, kept, t=t, q=q, v=v)

    def _weighted(self, mean: Callable[[Sequence[Fraction], str], str], of: str,
                  row: Sequence[Fraction], values: Sequence[str], result: str,
                  stage: str = "", **given: str) -> None:
        """Appends a weighted mean, without values of weight zero."""
        kept = [(weight, x) for weight, x in zip(row, values, strict=True) if weight]
        names = numbered(of, len(kept))
        owner = f"{self.integrator.step_name.removeprefix('step_')}_{{}}{stage}"
        self._call(mean([weight for weight, _ in kept], owner), result, **given,
                   **{name: x for name, (_, x) in zip(names, kept, strict=True)})

    # drifts and kicks

    def _composed(self, scheme: Composition) -> list[Call | Split]:
        before: list[Call] = []
        after: list[Call] = []
        if scheme.keeps_momentum and self.scene.has(MOMENTUM) and not self.takes_tau:
            before.append(self._made(MOMENTUM, "c"))
            after.append(self._made(CORRECTED, "q", "v", t="h"))
        if not (scheme.splits and self.scene.has(CLOSING)):
            self._stages(scheme)
            return [*before, *self.calls, *after]
        test, parts = self._test(), self._made(PARTS, "count", "part")
        self.h, timed = "part", self.scene.timed
        self._stages(scheme)
        if timed:
            self._call(self.means.time(Fraction(1)), "t")
        moved = (*(("t",) if timed else ()), "q", "v")
        return [*before, Split(test, parts, tuple(self.calls), moved), *after]

    def _test(self) -> Call | None:
        """The call that tells whether a step is split, unless the number of parts takes about as
        long: of bodies' contacts the poses take most of both."""
        test, parts = (len(self._of_scene(x).program.instructions) for x in CONTACTS)
        return self._made(CLOSING, "closing") if parts > 2 * test else None

    def _stages(self, scheme: Composition) -> None:
        passed = Fraction(0)
        for stage in scheme.stages:
            if isinstance(stage, Drift):
                if scheme.moves_states and self.scene.has(CARRIED):
                    self._call(CARRIED, "q", "v")
                else:
                    self._call(self.means.drift((stage.part,)), "phi", u="v")
                    self._call(MOVED, "q")
                passed += stage.part
            else:
                self._accelerate(stage.by, "a", passed, "t_kick", "q", "v")
                self._call(self.means.kick((stage.part,)), "v")
                if not scheme.moves_states and self.scene.has(MOVED_STATES):
                    self._call(MOVED_STATES, "q")
        self._close()

    def _close(self) -> None:
        """Appends the correction of states that have left the closures of loops."""
        if self.scene.has(CLOSED):
            self._call(CLOSED, "q", "v")


def numbered(name: str, count: int) -> list[str]:
    """[x], or [x1, x2, …] if there are several."""
    return [name] if count == 1 else [f"{name}{n}" for n in range(1, count + 1)]


def _scaled(weights: Sequence[Fraction]) -> tuple[list[int], int]:
    """The weights as integers over their common denominator."""
    below = lcm(*(x.denominator for x in weights))
    return [int(x * below) for x in weights], below


def _sum(terms: Sequence[Number]) -> Number:
    first, *rest = terms
    for x in rest:
        first = first + x
    return first


def _part_of(what: str, part: Fraction) -> str:
    """kick, half_kick, kick_2_3, kick_minus_1_3, kick_2_1."""
    if part in (1, Fraction(1, 2)):
        return what if part == 1 else f"half_{what}"
    return f"{what}{'_minus' * (part < 0)}_{abs(part.numerator)}_{part.denominator}"


def _in_words(weights: Sequence[Fraction], names: Sequence[str]) -> str:
    """h a; h/2 a; h/6 (a1 + 2 a2)."""
    above, below = _scaled(weights)
    terms = " + ".join(f"{n} {x}" if n != 1 else x for n, x in zip(above, names, strict=True))
    over = f"/{below}" if below != 1 else ""
    return f"h{over} ({terms})" if len(names) > 1 else f"h{over} {terms}"
