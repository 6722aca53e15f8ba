"""Tangents and adjoints of a scene's functions against differences in 50 digits."""

from functools import partial

import mpmath
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.functions.arguments_in_scene import inputs_of, outputs_of
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
            "c": [mpf(k) / 7 for k in range(9)]}


def results(functions: SceneFunctions, name: str, given: Values) -> Values:
    """The components of each output."""
    program = functions.named(name).program
    numbers = list(EVALUATED(program)([given[a.name] for a in program.inputs]))
    return {a.name: [numbers.pop(0) for _ in range(a.quantity.size)] for a in program.outputs}


def moved(functions: SceneFunctions, function: SceneFunction, scene: Scene, given: Values,
          direction: Values, size: mpf) -> Values:
    """The arguments, along a direction; coordinates along velocities."""
    after = dict(given)
    for a in inputs_of(function, scene):
        step = [size * d for d in direction[f"d_{a.name}"]]
        after[a.name] = (results(functions, "integrated", {"q": given[a.name], "phi": step})["qo"]
                         if a.is_coordinates else
                         [x + d for x, d in zip(given[a.name], step, strict=True)])
    return after


def apart(functions: SceneFunctions, coordinates: bool, one: list[mpf], two: list[mpf]
          ) -> list[mpf]:
    """The difference of two results; of coordinates, two ⊖ one."""
    if coordinates:
        return results(functions, "difference", {"q": one, "q1": two})["phi"]
    return [y - x for x, y in zip(one, two, strict=True)]


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


def check(scene: Scene, function: SceneFunction, seed: int = 3) -> None:
    """The tangent is a difference; w·d_y = g·d_x."""
    one, two = f"{function.name}_tangent", f"{function.name}_adjoint"
    own = () if function.step else (function.name,)
    functions = derive(scene, (*own, one, two, "integrated", "difference"))
    with mpmath.workdps(50):
        given = arguments(scene, functions, seed)
        direction, weights = directions(functions, one, "d_"), directions(functions, two, "w_")
        tangent = results(functions, one, {**given, **direction})
        ends = [inlined(functions, function, moved(functions, function, scene, given, direction,
                                                   size)) for size in (-STEP, STEP)]
        keys = [x.name for x in outputs_of(function, scene)]
        for key, x, low, high in zip(keys, function.outputs, *(e.values() for e in ends),
                                     strict=True):
            wanted = [d / (2 * STEP) for d in apart(functions, x.is_coordinates, low, high)]
            largest = max((abs(d) for d in wanted), default=mpf(0))
            for a, b in zip(tangent[f"d_{key}"], wanted, strict=True):
                assert abs(a - b) <= CLOSE * max(largest, 1), (function.name, key)
        adjoint = results(functions, two, {**given, **weights})
        taken = [a.name for a in inputs_of(function, scene)]
        left = total(weights, tangent, ("w_", "d_"), keys)
        right = total(adjoint, direction, ("g_", "d_"), taken)
        size = mpmath.fsum(abs(x) for name in taken for x in adjoint[f"g_{name}"])
        assert abs(left - right) <= mpf(10)**-30 * max(size, 1)


def entry(scene: Scene, name: str) -> SceneFunction:
    return next(x for x in functions_of(scene, (name,)) if x.name == name)
