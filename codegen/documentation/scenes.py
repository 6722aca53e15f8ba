"""The reference of scene files: effects with their equations, keys, integrators."""

from coscrew_codegen.documentation.notation import escaped, markdown
from coscrew_codegen.effects import EFFECTS
from coscrew_codegen.integrators import INTEGRATORS
from coscrew_codegen.render import render
from coscrew_codegen.scene.effect import Effect, ParameterOf
from coscrew_codegen.scene_files.catalogue import notes, where
from coscrew_codegen.scene_files.keys import TABLES, Key


def effects_page(banner: str) -> str:
    """The catalogue of effects, in Markdown."""
    return render("docs/effects.md", banner=banner, effects=[_effect(x) for x in EFFECTS])


def keys_page(banner: str) -> str:
    """The keys of scene files, in Markdown."""
    tables = [{"heading": f"[{table.heading}]" if table.heading else "The file",
               "words": escaped(table.words), "rows": [_row(key) for key in table.keys]}
              for table in TABLES]
    return render("docs/scene_keys.md", banner=banner, tables=tables)


def integrators_page(banner: str) -> str:
    """The integrators, in Markdown."""
    return render("docs/integrators.md", banner=banner, integrators=[
        {"name": x.name, "order": x.order, "good_for": escaped(x.good_for),
         "equation": markdown(x.equation, ("q_m",))} for x in INTEGRATORS])


def _effect(effect: Effect) -> dict[str, object]:
    names = {parameter.name for parameter in effect.parameters} | {"M_jj", "a_0"}
    return {"name": effect.name, "words": escaped(effect.words),
            "equation": markdown(effect.equation, names), "where": where(effect),
            "any_of": " or ".join(f"`{name}`" for name in effect.any_of),
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
