"""Functions of scenes written by hand, so that files can be tested without a derivation.

`slider` moves two masses along lines: rational arithmetic alone, time, parameters, choices.
`pendulum` has one coordinate and one parameter, and calls every function there is.
`spinner` is a body on a spherical joint: quaternions, and internal functions of the steps.
"""

import importlib.util
import random
import re
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from types import ModuleType

from coscrew_codegen.backends.numpy import scene_python
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.dynamics.integrator_steps import stepped
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.scene_functions import Coordinate, FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.quantity import Argument, Part, Quantity
from coscrew_codegen.scene.integrators import named

LATEST = 120
"""The line of a scene's C by which a reader meets the first public function."""
BANNER = "Made by `coscrew generate scene.toml`; changes are overwritten."


def first_function(text: str) -> int:
    """The line of a scene's C with its first public function."""
    return next(n for n, x in enumerate(text.splitlines(), 1) if re.match(r"void \w+\(", x))


def argument(name: str, *shape: int) -> Argument:
    """An argument of this shape."""
    rows, columns = (*shape, 1, 1)[:2]
    parts = (Part("", range(rows), range(columns)),)
    return Argument(name, Quantity(name, shape, parts, name))


def number(value: str | int | Fraction | Operand) -> Operand:
    """A constant, the same in both precisions."""
    if isinstance(value, (str, int, Fraction)):
        return Constant(Fraction(value), Fraction(value))
    return value


class Writer:
    """Writes a Program line by line: do("x", Op.MUL, a, b)."""

    def __init__(self, *inputs: Argument):
        self.inputs = inputs
        self.steps: list[Instruction] = []
        self.headings: list[tuple[int, str]] = []
        self._places = {a.name: n for n, a in enumerate(inputs)}

    def at(self, name: str, index: int = 0) -> Input:
        """Component `index` of an input."""
        return Input(self._places[name], index)

    def do(self, name: str, op: Op, *operands: str | int | Operand, of: str = "") -> Ref:
        """One instruction, a step towards `of`."""
        self.steps.append(Instruction(name, op, tuple(map(number, operands)), of or name))
        return Ref(name)

    def heading(self, words: str) -> None:
        """Words above the next instruction."""
        self.headings.append((len(self.steps), words))

    def function(self, name: str, words: str, outputs: tuple[Argument, ...],
                 results: Sequence[str | int | Operand], internal: bool = False) -> FunctionProgram:
        """The function that returns these results."""
        program = Program(name, self.inputs, outputs, tuple(self.steps),
                          tuple(map(number, results)))
        return FunctionProgram(name, words, program, tuple(self.headings), internal)


def _stepping(scene: SceneFunctions, *integrators: str) -> SceneFunctions:
    """The scene with the steps of these integrators."""
    return stepped(scene, [named(x) for x in integrators])


def _additive(n: int) -> FunctionProgram:
    w = Writer(argument("q", n), argument("phi", n))
    moved = [w.do(f"moved_{i}", Op.ADD, w.at("q", i), w.at("phi", i)) for i in range(n)]
    return w.function("integrated", "q + φ", (argument("q", n),), moved)


def slider() -> SceneFunctions:
    """Masses p[0] and 2 kg on lines, friction 3/10 v |v|, a force (t - 1) for t >= 1 on the first,
    a spring of 50 N/m on the second."""
    t, p, q, v = argument("t"), argument("p", 2), argument("q", 2), argument("v", 2)

    def forces(w: Writer) -> list[Ref]:
        w.heading("carriage")
        results = []
        for i in range(2):
            speed = w.do(f"speed_{i}", Op.ABS, w.at("v", i), of=f"friction_{i}")
            scaled = w.do(f"friction_{i}a", Op.MUL, "3/10", w.at("v", i), of=f"friction_{i}")
            results.append(w.do(f"friction_{i}", Op.MUL, scaled, speed))
        w.heading("load: its spring, and */ what pushes\nthe carriage")
        late = w.do("late", Op.SUB, w.at("t"), 1, of="push")
        begun = w.do("begun", Op.LESS, 1, w.at("t"), of="push")
        push = w.do("push", Op.SELECT, begun, late, 0)
        spring = w.do("spring", Op.MUL, 50, w.at("q", 1))
        return [w.do("net_0", Op.SUB, push, results[0]),
                w.do("net_1", Op.NEG, w.do("net_1a", Op.ADD, spring, results[1], of="net_1"))]

    w = Writer(t, p, q, v, argument("a", 2))
    net, masses = forces(w), (w.at("p", 0), number(2))
    tau = [w.do(f"tau_{i}", Op.SUB,
                w.do(f"tau_{i}a", Op.MUL, m, w.at("a", i), of=f"tau_{i}"), net[i])
           for i, m in enumerate(masses)]
    inverse = w.function("inverse_dynamics", "τ = M a - f in N", (argument("tau", 2),), tau)
    w = Writer(t, p, q, v, argument("tau", 2))
    net = forces(w)
    a = [w.do(f"a_{i}", Op.DIV, w.do(f"a_{i}a", Op.ADD, w.at("tau", i), net[i], of=f"a_{i}"), m)
         for i, m in enumerate((w.at("p", 0), number(2)))]
    forward = w.function("forward_dynamics", "a = M^-1 (τ + f) in m/s²", (argument("a", 2),), a)
    w = Writer(t, argument("h"), p, q, v)
    net = forces(w)
    a = []
    for i, m in enumerate((w.at("p", 0), number(2))):
        grown = w.do(f"grown_{i}", Op.ADD, m, w.do(f"grown_{i}a", Op.MUL, w.at("h"), "3/10"))
        a.append(w.do(f"a_{i}", Op.DIV, net[i], grown))
    implicit = w.function("implicit_acceleration", "a", (argument("a", 2),), a, internal=True)
    w = Writer(p, q)
    mass = w.function("mass_matrix", "M in kg", (argument("M", 2, 2),), [w.at("p", 0), 0, 0, 2])
    w = Writer(p, q, v)
    square = w.do("square", Op.MUL, w.at("v"), w.at("v"))
    root = w.do("root", Op.SQRT, w.do("twice", Op.MUL, square, w.at("p"), of="root"))
    energy = w.function("energy", "E in J, and its root", (argument("e"), argument("r")),
                        [square, root])
    w = Writer(q)
    poses = w.function("body_poses", "[R | t], t in m", (argument("D", 2, 3, 4),),
                       [1, 0, 0, w.at("q", 0), 0, 1, 0, 0, 0, 0, 1, 0,
                        1, 0, 0, 0, 0, 1, 0, w.at("q", 1), 0, 0, 1, "1/10"])
    w = Writer(q)
    swapped = w.function("swapped", "q_1, q_0", (argument("x", 2),), [w.at("q", 1), w.at("q", 0)])
    coordinates = tuple(Coordinate(name, "prismatic", range(i, i + 1), range(i, i + 1))
                        for i, name in enumerate(("class", "load */ x\\")))
    return _stepping(SceneFunctions(
        "slider", 2, 2, coordinates, ("carriage", 'lambda """'), (("carriage.mass", 1.5),
                                                                  ("unused", 0.1)),
        (0.0, 0.25), (inverse, forward, mass, energy, poses, swapped, _additive(2), implicit),
        timed=True),
        "semi-implicit-euler", "linear-implicit-euler", "rk4")


def pendulum() -> SceneFunctions:
    """θ'' = -g/l sin θ - tanh(ω) e^(-ω²) + τ, l = p[0]; z = l cos θ."""
    p, q, v = argument("p", 1), argument("q", 1), argument("v", 1)
    w = Writer(p, q, v, argument("tau", 1))
    w.heading("rod")
    pull = w.do("pull", Op.MUL, "981/100", w.do("sine", Op.SIN, w.at("q")))
    weight = w.do("weight", Op.DIV, pull, w.at("p"))
    slow = w.do("slow", Op.NEG, w.do("square", Op.MUL, w.at("v"), w.at("v")))
    rub = w.do("rub", Op.MUL, w.do("sign", Op.TANH, w.at("v")), w.do("fade", Op.EXP, slow))
    a = w.do("a_0", Op.SUB, w.do("a_0a", Op.SUB, w.at("tau"), weight), rub)
    forward = w.function("forward_dynamics", "θ'' in rad/s²", (argument("a", 1),), [a])
    w = Writer(p, q)
    z = w.do("up", Op.MUL, w.at("p"), w.do("cosine", Op.COS, w.at("q")))
    back = w.do("back", Op.ATAN2, w.do("sine", Op.SIN, w.at("q")), w.do("far", Op.ABS, z))
    small = w.do("small", Op.LESS, w.do("size", Op.ABS, z), "1/1000")
    level = w.do("flat", Op.SELECT, small, 1, 0)
    height = w.function("height", "z in m, an angle, whether level",
                        (argument("z"), argument("angle"), argument("level")), [z, back, level])
    hinge = Coordinate("hinge", "revolute", range(1), range(1))
    return _stepping(SceneFunctions(
        "pendulum", 1, 1, (hinge,), ("rod",), (("length", 0.7),), (0.0,),
        (forward, height, _additive(1))), "semi-implicit-euler", "rk4")


def _products(w: Writer, name: str, a: Sequence[Operand], b: Sequence[Operand]) -> list[Ref]:
    """The quaternion product a b, both (x, y, z, w)."""
    terms = ((("", 3, 0), ("", 0, 3), ("", 1, 2), ("-", 2, 1)),
             (("", 3, 1), ("-", 0, 2), ("", 1, 3), ("", 2, 0)),
             (("", 3, 2), ("", 0, 1), ("-", 1, 0), ("", 2, 3)),
             (("", 3, 3), ("-", 0, 0), ("-", 1, 1), ("-", 2, 2)))
    results = []
    for k, row in enumerate(terms):
        total: Ref | None = None
        for n, (sign, i, j) in enumerate(row):
            term = w.do(f"{name}_{k}t{n}", Op.MUL, a[i], b[j], of=f"{name}_{k}")
            total = term if total is None else w.do(
                f"{name}_{k}s{n}", Op.SUB if sign else Op.ADD, total, term, of=f"{name}_{k}")
        assert total
        results.append(total)
    return results


def _cross(w: Writer, name: str, a: Sequence[Operand], b: Sequence[Operand]) -> list[Ref]:
    """The vector a × b."""
    return [w.do(f"{name}_{i}", Op.SUB, w.do(f"{name}_{i}a", Op.MUL, a[j], b[k], of=f"{name}_{i}"),
                 w.do(f"{name}_{i}b", Op.MUL, a[k], b[j], of=f"{name}_{i}"))
            for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1)))]


def spinner() -> SceneFunctions:
    """Euler's equations for moments of inertia 1, 2, 3 kg m²."""
    q, v, phi = argument("q", 4), argument("v", 3), argument("phi", 3)
    w = Writer(q, v, argument("tau", 3))
    a = []
    for i, (j, k, factor) in enumerate(((1, 2, -1), (2, 0, 2), (0, 1, -1))):
        both = w.do(f"both_{i}", Op.MUL, w.at("v", j), w.at("v", k), of=f"a_{i}")
        part = w.do(f"part_{i}", Op.MUL, factor, both, of=f"a_{i}")
        a.append(w.do(f"a_{i}", Op.DIV, w.do(f"sum_{i}", Op.ADD, w.at("tau", i), part), i + 1))
    forward = w.function("forward_dynamics", "ω' in rad/s²", (argument("a", 3),), a)
    w = Writer(q, phi)
    x = [w.at("phi", i) for i in range(3)]
    squares = [w.do(f"square_{i}", Op.MUL, x[i], x[i], of="angle") for i in range(3)]
    both = w.do("both", Op.ADD, w.do("two", Op.ADD, squares[0], squares[1], of="angle"), squares[2],
                of="angle")
    angle = w.do("angle", Op.SQRT, both)
    half = w.do("half", Op.MUL, "1/2", angle)
    still = w.do("still", Op.EQUAL, angle, 0)
    ratio = w.do("ratio", Op.DIV, w.do("sine", Op.SIN, half, of="ratio"), angle)
    chosen = w.do("chosen", Op.SELECT, still, "1/2", ratio)
    turn: list[Operand] = [w.do(f"turn_{i}", Op.MUL, chosen, x[i]) for i in range(3)]
    turn += [w.do("turn_3", Op.COS, half)]
    made = _products(w, "made", [w.at("q", i) for i in range(4)], turn)
    integrated = w.function("integrated", "q ⊕ φ", (argument("q", 4),), made)
    w = Writer(phi, v)
    x, speeds = ([w.at(name, i) for i in range(3)] for name in ("phi", "v"))
    once = _cross(w, "once", x, speeds)
    twice = _cross(w, "twice", x, once)
    rate = []
    for i in range(3):
        half = w.do(f"half_{i}", Op.MUL, "1/2", once[i], of=f"rate_{i}")
        twelfth = w.do(f"twelfth_{i}", Op.DIV, twice[i], 12, of=f"rate_{i}")
        moved = w.do(f"moved_{i}", Op.ADD, speeds[i], half, of=f"rate_{i}")
        rate.append(w.do(f"rate_{i}", Op.ADD, moved, twelfth))
    chart = w.function("chart_rate", "φ' = v + φ × v / 2 + φ × (φ × v) / 12", (argument("u", 3),),
                       rate, internal=True)
    return _stepping(SceneFunctions(
        "spinner", 4, 3, (Coordinate("ball", "spherical", range(4), range(3)),), ("top",), (),
        (0.0, 0.0, 0.0, 1.0), (forward, integrated, chart)), "semi-implicit-euler", "rk4")


def robot(joints: int, steps: int) -> SceneFunctions:
    """Functions as long as those of a robot with many joints; their numbers mean nothing."""
    draw = random.Random(0)
    n = joints

    def function(name: str, out: str) -> FunctionProgram:
        w = Writer(argument("q", n), argument("v", n), argument("tau" if out == "a" else "a", n))
        pool: list[Operand] = [Input(i, j) for i in range(3) for j in range(n)]
        pool += [w.do(f"{'sine' if op is Op.SIN else 'cosine'}_{i}", op, w.at("q", i))
                 for i in range(n) for op in (Op.SIN, Op.COS)]
        for i in range(steps):
            if i % 100 == 0:
                w.heading(f"link {i // 100}")
            op = draw.choice((Op.MUL, Op.ADD, Op.MUL, Op.SUB))
            scaled = draw.random() < 0.1
            first = (number(f"{draw.randrange(1, 999)}/1000") if scaled
                     else draw.choice(pool[-60:]))
            pool.append(w.do(f"link{i // 100}_{i % 100}", op, first, draw.choice(pool[-60:]),
                             of=f"link{i // 3}"))
        return w.function(name, "numbers", (argument(out, n),), pool[-n:])

    coordinates = tuple(Coordinate(f"joint{i}", "revolute", range(i, i + 1), range(i, i + 1))
                        for i in range(n))
    functions = (function("forward_dynamics", "a"), function("inverse_dynamics", "tau"),
                 _additive(n))
    return _stepping(SceneFunctions(
        "robot", n, n, coordinates, tuple(f"link{i}" for i in range(n)), (), (0.0,) * n, functions),
        "semi-implicit-euler", "rk4")


CASES: dict[str, Callable[[], SceneFunctions]] = {
    "slider": slider, "pendulum": pendulum, "spinner": spinner}


def files(functions: SceneFunctions) -> dict[str, str]:
    """All files of the functions, by path."""
    return scene_c.files(functions, BANNER) | scene_python.files(functions, BANNER)


def written(functions: SceneFunctions, folder: Path) -> Path:
    """The folder, with the scene's files in it."""
    for path, text in files(functions).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return folder


def imported(functions: SceneFunctions, folder: Path) -> ModuleType:
    """The generated package, under a name of its own."""
    init = written(functions, folder) / functions.name / "__init__.py"
    name = f"generated_scene_{functions.name}"
    for old in [m for m in sys.modules if m == name or m.startswith(f"{name}.")]:
        del sys.modules[old]
    spec = importlib.util.spec_from_file_location(name, init, submodule_search_locations=[
        str(init.parent)])
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


ARGUMENTS = (2.0, [1.5, 0.0], [0.1, 0.2], [0.3, -0.4], [1.0, 2.0])  # t, p, q, v, tau
