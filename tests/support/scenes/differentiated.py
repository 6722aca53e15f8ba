"""Tangents and adjoints of a scene's functions against differences in 50 digits."""

from functools import partial

import mpmath
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import SceneFunction
from tests.support.scenes.differences import state
from tests.support.scenes.evaluation import evaluator, without_errors

STEP = mpf(10)**-18
CLOSE = mpf(10)**-24
H = mpf("0.01")
Values = dict[str, list[mpf]]
EVALUATED = partial(evaluator, numbers=without_errors("double"))


def arguments(scene: Scene, functions: SceneFunctions, seed: int) -> Values:
    """A state, and numbers for every other input."""
    given, other = state(scene, functions, seed), state(scene, functions, seed + 50)
    return {**given, "h": [H], "phi": other["a"], "q1": other["q"],
            "c": [mpf(k) / 7 for k in range(9)], "r": [mpf(k) / 3 for k in (1, -2, 4)]}


def results(functions: SceneFunctions, name: str, given: Values) -> Values:
    """The components of each output."""
    program = functions.named(name).program
    numbers = list(EVALUATED(program)([given[a.name] for a in program.inputs]))
    return {a.name: [numbers.pop(0) for _ in range(a.quantity.size)] for a in program.outputs}


def moved(functions: SceneFunctions, function: SceneFunction, scene: Scene, given: Values,
          direction: Values, size: mpf) -> Values:
    """The arguments, along a direction: coordinates along velocities, states along themselves."""
    nv = functions.nv
    after = dict(given)
    for a in function.inputs_in(scene):
        step = [size * d for d in direction[f"d_{a.name}"]]
        if a.is_coordinates:
            whole = results(functions, "integrated", {"q": given[a.name], "phi": step[:nv]})["qo"]
            joints = len(whole) - len(step[nv:])
            after[a.name] = [*whole[:joints], *(
                x + d for x, d in zip(whole[joints:], step[nv:], strict=True))]
        else:
            after[a.name] = [x + d for x, d in zip(given[a.name], step, strict=True)]
    return after


def apart(functions: SceneFunctions, coordinates: bool, one: list[mpf], two: list[mpf]
          ) -> list[mpf]:
    """The difference of two results; of coordinates, two ⊖ one, then that of their states."""
    plain = [y - x for x, y in zip(one, two, strict=True)]
    if coordinates:
        joints = len(plain) - len(functions.states)
        return [*results(functions, "difference", {"q": one, "q1": two})["phi"], *plain[joints:]]
    return plain


def inlined(functions: SceneFunctions, function: SceneFunction, given: Values) -> Values:
    """The results of a function, or of a step, whose tangent also computes them."""
    if not function.step:
        return results(functions, function.name, given)
    name = f"{function.name}_tangent"
    still = {a.name: [mpf(0)] * a.quantity.size
             for a in functions.named(name).program.inputs if a.name.startswith("d_")}
    whole = results(functions, name, {**given, **still})
    return {key: x for key, x in whole.items() if not key.startswith("d_")}


def directions(functions: SceneFunctions, name: str, prefix: str) -> Values:
    """Numbers for the directions or weights that a function takes."""
    return {a.name: [mpf((7 * k + len(a.name)) % 11 - 5) / 4 for k in range(a.quantity.size)]
            for a in functions.named(name).program.inputs if a.name.startswith(prefix)}


def total(a: Values, b: Values, prefixes: tuple[str, str], names: list[str]) -> mpf:
    return mpmath.fsum(x * y for name in names for x, y in zip(
        a[prefixes[0] + name], b[prefixes[1] + name], strict=True))


def check(scene: Scene, function: SceneFunction, seed: int = 3, **at: list[mpf]) -> None:
    """The tangent is a difference, at a state of this seed or with these inputs; w·d_y = g·d_x."""
    one, two = f"{function.name}_tangent", f"{function.name}_adjoint"
    own = () if function.step else (function.name,)
    functions = derive(scene, (*own, one, two, "integrated", "difference"))
    with mpmath.workdps(50):
        given = {**arguments(scene, functions, seed), **at}
        direction, weights = directions(functions, one, "d_"), directions(functions, two, "w_")
        tangent = results(functions, one, {**given, **direction})
        ends = [inlined(functions, function, moved(functions, function, scene, given, direction,
                                                   size)) for size in (-STEP, STEP)]
        keys = [x.name for x in function.outputs_in(scene)]
        for key, x, low, high in zip(keys, function.outputs, *(e.values() for e in ends),
                                     strict=True):
            wanted = [d / (2 * STEP) for d in apart(functions, x.is_coordinates, low, high)]
            largest = max((abs(d) for d in wanted), default=mpf(0))
            for a, b in zip(tangent[f"d_{key}"], wanted, strict=True):
                assert abs(a - b) <= CLOSE * max(largest, 1), (function.name, key)
        adjoint = results(functions, two, {**given, **weights})
        taken = [a.name for a in function.inputs_in(scene)]
        left = total(weights, tangent, ("w_", "d_"), keys)
        right = total(adjoint, direction, ("g_", "d_"), taken)
        size = mpmath.fsum(abs(x) for name in taken for x in adjoint[f"g_{name}"])
        assert abs(left - right) <= mpf(10)**-30 * max(size, 1)


def check_step(its: Scene, integrator: Integrator, **at: list[mpf]) -> None:
    """A, B_tau and B_p are the tangents along unit directions, with these inputs."""
    name = integrator.step_with_tau
    functions = derive(its, (f"{name}_derivatives", f"{name}_tangent"))
    with mpmath.workdps(50):
        given = {**arguments(its, functions, 5), **at}
        whole = results(functions, f"{name}_derivatives", given)
        still = {x: [mpf(0)] * len(y) for x, y in directions(functions, f"{name}_tangent",
                                                             "d_").items()}
        parts = [("A", ("q", "v")), ("B_tau", ("tau",)), ("B_p", ("p",))]
        for matrix, by in parts[:3 if its.parameters else 2]:
            units = [(x, k) for x in by for k in range(len(still[f"d_{x}"]))]
            for column, (x, k) in enumerate(units):
                unit = [mpf(int(i == k)) for i in range(len(still[f"d_{x}"]))]
                tangent = results(functions, f"{name}_tangent", {**given, **still, f"d_{x}": unit})
                wanted = [*tangent["d_qo"], *tangent["d_vo"]]
                own = whole[matrix][column::len(units)]
                for a, b in zip(own, wanted, strict=True):
                    assert abs(a - b) <= mpf(10)**-30 * max(1, *map(abs, wanted)), (matrix, x, k)


def entry(scene: Scene, name: str) -> SceneFunction:
    return next(x for x in functions_of(scene, (name,)) if x.name == name)
