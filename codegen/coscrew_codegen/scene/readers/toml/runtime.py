"""`runtime = ["tool.mass", …]`: numbers of a scene that stay arguments of its functions."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.mechanism.model import Body, Model
from coscrew_codegen.scene.mechanism.model import value as value_of
from coscrew_codegen.scene.names import nearest
from coscrew_codegen.scene.patterns import PatternError, expanded
from coscrew_codegen.scene.readers.omissions import FIELDS, adding
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable
from coscrew_codegen.scene.recorded_quantities import XYZ
from coscrew_codegen.scene.scene import Applied, Setting

_MOMENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
_Numbers = dict[str, Fraction]
_Swap = Callable[[str, Scalar], Scalar]  # name, number → the number or its Parameter


def with_parameters(file: TomlTable, model: Model, effects: tuple[Applied, ...],
                    catalogue: tuple[Effect, ...]
                    ) -> tuple[Model, tuple[Applied, ...], tuple[Parameter, ...]]:
    """(model, effects, parameters) with a Parameter in place of each number that `runtime` names.

    A vector gives a parameter for each component: tool.com gives tool.com.x, tool.com.y and
    tool.com.z, also named tool.com.0, tool.com.1 and tool.com.2.
    Raises SceneError for names that are unknown, occur twice, or are not numbers."""
    numbers, others = _candidates(model, effects)
    names = _names(file, numbers)
    parameters: list[Parameter] = []
    for name in names:
        called = _by_letter(name)
        keys = [key for key in numbers if key in (name, called) or _vector(key) == name]
        if name in keys and len(keys) > 1:
            component = next(key for key in keys if key != name)
            file.refuse("runtime", f"{name!r} is a number, and the vector of {component!r}, too; "
                        "rename one")
        if not keys:
            if name in others:
                file.refuse("runtime", f"{name!r} is {others[name]}; wanted a number")
            _refuse_of_element(file, name, tuple(numbers), model, effects, catalogue)
            whole = dict.fromkeys(_vector(key) for key in numbers if _vector(key))
            file.known("runtime", name, "number", (*numbers, *others, *whole))
        for key in keys:
            if any(parameter.name == key for parameter in parameters):
                file.refuse("runtime", f"{key!r} occurs twice")
            parameters.append(Parameter(key, len(parameters), numbers[key]))
    by_name = {parameter.name: parameter for parameter in parameters}

    def swap(name: str, number: Scalar) -> Scalar:
        return by_name.get(name, number)

    return (swapped_model(model, swap), tuple(_swapped(applied, swap) for applied in effects),
            tuple(parameters))


def _names(file: TomlTable, numbers: _Numbers) -> tuple[str, ...]:
    """The names in `runtime`, patterns among them replaced by the numbers that they match, or else
    by the vectors."""
    vectors = tuple(dict.fromkeys(vector for key in numbers if (vector := _vector(key))))
    try:
        return expanded(file.texts("runtime", ()), tuple(numbers), vectors)
    except PatternError as error:
        file.refuse("runtime", str(error))


def _by_letter(name: str) -> str:
    """tool.com.x for tool.com.0."""
    whole, _, last = name.rpartition(".")
    return f"{whole}.{XYZ[int(last)]}" if last in ("0", "1", "2") else name


def _vector(key: str) -> str:
    """The vector or inertia that a number belongs to: tool.com for tool.com.x; else ""."""
    whole, _, last = key.rpartition(".")
    return whole if last in (*XYZ, *_MOMENTS) else ""


def _refuse_of_element(file: TomlTable, name: str, names: tuple[str, ...], model: Model,
                       effects: tuple[Applied, ...], catalogue: tuple[Effect, ...]) -> None:
    """Refuse a name such as JOINT.FIELD or BODY.FIELD, with a list of that element's numbers.

    A joint's own numbers are not in the dynamics; the numbers of effects are, and effects may take
    them from the joint."""
    element, _, field = name.rpartition(".")
    what = ("joint" if any(joint.name == element for joint in model.joints) else
            "body" if any(body.name == element for body in model.bodies) else "")
    if not what:
        return
    there = tuple(dict.fromkeys(_vector(key) or key for key in names
                                if f".{element}." in f".{key}"))
    problem = f"no number {shown(name)}"
    near = nearest(field, [key.rpartition(".")[2] for key in there])
    if near:
        key_of_element = next(key for key in there if key.endswith(f".{near}"))
        file.refuse("runtime", f"{problem}; did you mean {key_of_element!r}?")
    if what == "joint" and field in FIELDS:
        taken = [f"{applied.name}.{parameter.name}" for applied in effects
                 if applied.on == element for parameter in applied.effect.parameters
                 if parameter.model == field]
        if taken and taken[0] in there:
            file.refuse("runtime", f"{problem}; did you mean {taken[0]!r}?")
        joint = next(x for x in model.joints if x.name == element)
        hint = adding(joint, field, model, catalogue, effects)
        problem += "; no effect uses it" + (f": {hint}" if hint else "")
    listed = ", ".join(there) if there else "none"
    file.refuse("runtime", f"{problem}; of {what} {shown(element)} there "
                           f"{'are' if len(there) > 1 else 'is'} {listed}")


def constants(model: Model, effects: tuple[Applied, ...]) -> tuple[str, ...]:
    """Names in `runtime` of all numbers that are no parameters yet."""
    numbers, _ = _candidates(model, effects)
    return tuple(numbers)


def _candidates(model: Model, effects: tuple[Applied, ...]) -> tuple[_Numbers, dict[str, str]]:
    """(numbers by name, descriptions of other values by name)."""
    numbers: _Numbers = {}

    def note(name: str, number: Scalar) -> Scalar:
        numbers[name] = value_of(number)
        return number

    swapped_model(model, note)
    others = {}
    for applied in effects:
        _swapped(applied, note)
        for parameter, value in applied.values.items():
            if value is None:
                others[f"{applied.name}.{parameter}"] = "not given"
            elif isinstance(value, Formula) or (
                    isinstance(value, tuple) and any(isinstance(x, Formula) for x in value)):
                others[f"{applied.name}.{parameter}"] = "a formula"
            elif _of_rest(value):
                others[f"{applied.name}.{parameter}"] = "the coordinates of a joint"
            elif isinstance(value, str) or (isinstance(value, tuple) and isinstance(value[0], str)):
                others[f"{applied.name}.{parameter}"] = "a word"
    return numbers, others


def swapped_model(model: Model, swap: _Swap) -> Model:
    """The model with its bodies' numbers replaced by swap(name in `runtime`, number)."""
    return replace(model, bodies=tuple(_swapped_body(body, swap) for body in model.bodies))


def _swapped_body(body: Body, swap: _Swap) -> Body:
    if body.inertia is None:
        return body
    inertia = body.inertia
    return replace(body, inertia=replace(
        inertia, mass=swap(f"{body.name}.mass", inertia.mass),
        com=_each(f"{body.name}.com", XYZ, inertia.com, swap),
        moments=_each(f"{body.name}.inertia", _MOMENTS, inertia.moments, swap)))


def _swapped(applied: Applied, swap: _Swap) -> Applied:
    values: Mapping[str, Setting] = {
        parameter: _swapped_value(f"{applied.name}.{parameter}", value, swap)
        for parameter, value in applied.values.items()}
    return replace(applied, values=values)


def _swapped_value(name: str, value: Setting, swap: _Swap) -> Setting:
    if isinstance(value, Fraction):
        return swap(name, value)
    if isinstance(value, tuple):
        vector = tuple(x for x in value if isinstance(x, Fraction))
        return _each(name, XYZ, vector, swap) if len(vector) == len(value) == 3 else value
    return value


def _of_rest(value: Setting) -> bool:
    """Returns whether a value is the coordinates of a joint with a quaternion, which are constant.
    """
    return isinstance(value, tuple) and len(value) > 3


def _each(name: str, parts: tuple[str, ...], numbers: tuple[Scalar, ...], swap: _Swap
          ) -> tuple[Scalar, ...]:
    return tuple(swap(f"{name}.{part}", x) for part, x in zip(parts, numbers, strict=True))
