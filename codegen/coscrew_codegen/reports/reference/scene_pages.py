"""The reference of scenes: functions, effects with their equations, keys, integrators, joints."""

from fractions import Fraction
from itertools import groupby

from coscrew_codegen.backends.render import render
from coscrew_codegen.reports.reference.notation import escaped, markdown
from coscrew_codegen.scene.effect import Effect, ParameterOf
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.functions import FUNCTIONS, QUANTITIES
from coscrew_codegen.scene.integrator import Composition, Drift, Scheme, Tableau
from coscrew_codegen.scene.integrators import INTEGRATORS
from coscrew_codegen.scene.joints import KINDS, ONE_COORDINATE, called
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.readers.effect_syntax import alternatives, notes, where
from coscrew_codegen.scene.readers.model_formats import readers
from coscrew_codegen.scene.readers.toml.keys import AXES, TABLES, Key
from coscrew_codegen.scene.scene_function import INPUTS, Depends, Of, SceneFunction, SceneQuantity


def effects_page(banner: str) -> str:
    """The catalogue of effects, in Markdown."""
    return render("docs/effects.md", banner=banner, effects=[_effect(x) for x in EFFECTS])


def keys_page(banner: str) -> str:
    """The keys of scene files, and the formats of models, in Markdown."""
    tables = [{"heading": f"[{table.heading}]" if table.heading else "The file",
               "words": escaped(table.words), "rows": [_row(key) for key in table.keys]}
              for table in TABLES]
    formats = [(x.name, ", ".join(f"`{suffix}`" for suffix in x.suffixes), escaped(x.words),
                f"`coscrew[{x.extra}]`" if x.extra else "") for x in readers()]
    return render("docs/scene_keys.md", banner=banner, tables=tables, formats=formats)


def integrators_page(banner: str) -> str:
    """The integrators, in Markdown."""
    return render("docs/integrators.md", banner=banner, integrators=[
        {"name": x.name, "order": x.order, "good_for": escaped(x.good_for),
         "equation": markdown(x.equation, ("q_m",)), "rows": _tableau(x.scheme),
         "stages": _stages(x.scheme)} for x in INTEGRATORS])


def joints_page(banner: str) -> str:
    """The kinds of joints, in Markdown."""
    return render("docs/joints.md", banner=banner, one_coordinate=called(ONE_COORDINATE),
                  rows=[_joint(kind) for kind in KINDS])


def functions_page(banner: str) -> str:
    """The functions of scenes and their recorded quantities, in Markdown."""
    return render("docs/functions.md", banner=banner,
                  functions=[_function(x) for x in FUNCTIONS if not x.internal],
                  quantities=[_quantity(*x) for x in QUANTITIES.values()])


def functions_stub(banner: str) -> str:
    """The functions that have the same name in every scene, for type checkers."""
    return render("python/_functions.pyi", banner=banner, names=[
        x.name for x in FUNCTIONS
        if x.compute and x.targets is Of.SCENE and not (x.internal or x.needs)])


def _joint(kind: JointKind) -> tuple[str, ...]:
    words = kind.in_words([f"`{key}`" for key in AXES])
    types = [f"`{name}`" for name in (kind.name, *kind.unlimited)]
    urdf = [f"`{name}`" for name in (kind.urdf, *kind.unlimited) if name]
    axes = [f"`{key}`: {of}" for key, of in zip(AXES, kind.axes, strict=False)]
    return (", ".join(types), words, kind.q_words, kind.v_words, "; ".join(axes),
            ", ".join(urdf) or escaped(kind.without_urdf))


def _function(x: SceneFunction) -> tuple[str, ...]:
    takes = {Depends.GEOMETRY: (), Depends.MASSES: ("p",), Depends.EFFECTS: ("t", "p")}[x.depends]
    names = [name for name in INPUTS if name in (*x.takes, *takes)]
    return (f"`{x.name}`", " ".join(f"`{name}`" for name in names), escaped(x.words),
            escaped(x.default.words))


def _quantity(function: SceneFunction, x: SceneQuantity) -> tuple[str, ...]:
    """Runs of equal units are counted: 3 × m/s, 3 × rad/s."""
    own = [unit for unit, _ in function.components_of(x)]
    runs = [(unit, len(list(several))) for unit, several in groupby(own)]
    units = ", ".join(unit if count == 1 else f"{count} × {unit}" for unit, count in runs)
    numbers = "" if len(own) == 1 else f"0 to {len(own) - 1}"
    return (f"`{x.written}`", escaped(units), ", ".join(x.components) or numbers,
            f"`{function.name}`")


def _tableau(scheme: Scheme) -> list[list[str]]:
    """The rows of a Butcher tableau with the numbers of the stages, b last; [] for other schemes.
    """
    if not isinstance(scheme, Tableau):
        return []
    count = len(scheme.b)
    rows = [[str(c), *map(str, row), *[""] * (count - len(row))]
            for c, row in zip(scheme.c, ((), *scheme.a), strict=True)]
    return [["c", *map(str, range(1, count + 1))], ["---"] * (count + 1), *rows,
            ["b", *map(str, scheme.b)]]


def _stages(scheme: Scheme) -> str:
    """Drifts and kicks in order; "" for other schemes."""
    if not isinstance(scheme, Composition):
        return ""
    return ", ".join(f"drift by {_of_step(x.part)}" if isinstance(x, Drift) else
                     f"kick by {_of_step(x.part)} with `{x.by}`" for x in scheme.stages)


def _of_step(part: Fraction) -> str:
    """h, h/2, 3 h/4."""
    above = "h" if part.numerator == 1 else f"{part.numerator} h"
    return above if part.denominator == 1 else f"{above}/{part.denominator}"


def _effect(effect: Effect) -> dict[str, object]:
    names = {parameter.name for parameter in effect.parameters} | {"M_jj", "a_0"}
    return {"name": effect.name, "words": escaped(effect.words),
            "equation": markdown(effect.equation, names), "where": where(effect),
            "any_of": alternatives(effect, [f"`{name}`" for name in effect.any_of]),
            "rows": [_parameter(parameter) for parameter in effect.parameters]}


def _parameter(parameter: ParameterOf) -> tuple[str, ...]:
    return (f"`{parameter.name}`", escaped(parameter.unit), escaped(parameter.words),
            escaped("; ".join(notes(parameter))))


def _row(key: Key) -> tuple[str, ...]:
    given = key.choices and " | ".join(f'"{choice}"' for choice in key.choices)
    default = "required" if key.required else key.default or (
        f'"{key.choices[0]}"' if key.choices else "")
    words = f"{given}: {key.words}" if given else key.words
    return f"`{key.name}`", escaped(words), escaped(default)
