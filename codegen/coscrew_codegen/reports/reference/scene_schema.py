"""The JSON Schema of scene files, for editors, from the tables the reader uses.

The schema accepts every file that the reader accepts.  It refuses unknown keys, wrong types and
unknown words; conditions that depend on the model or on other keys are left to the reader."""

import json

from coscrew_codegen.backends.render import LICENSE
from coscrew_codegen.scene.effect import Effect, ParameterOf, Place
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.toml.keys import SCENE, Key, TableOf
from coscrew_codegen.scene.readers.toml.trajectories.trajectory_table import KEYS

Schema = dict[str, object]

_NUMBER: Schema = {"$ref": "#/definitions/number"}
_TEXTS: Schema = {"$ref": "#/definitions/texts"}
_VECTOR: Schema = {"$ref": "#/definitions/vector"}
_POSITIVE: Schema = {"$ref": "#/definitions/positive"}
_NONNEGATIVE: Schema = {"$ref": "#/definitions/nonnegative"}
_TRAJECTORY: Schema = {"$ref": "#/definitions/trajectory"}


def schema_text(banner: str) -> str:
    """The text of the schema."""
    definitions = {"number": {"type": ["number", "string"]},  # a string is a constant formula
                   "positive": _bounded("exclusiveMinimum"), "nonnegative": _bounded("minimum"),
                   "vector": _array(3, _NUMBER), "trajectory": _closed(
                       {key: {"type": "string"} for key in KEYS}, ["file", "column"]),
                   "texts": {"type": "array", "items": {"type": "string"}, "uniqueItems": True},
                   **{effect.name: _one(effect) for effect in EFFECTS}}
    document = {"$comment": "\n".join((banner, *LICENSE)),
                "$schema": "http://json-schema.org/draft-07/schema#", "title": "coscrew scene",
                **_table(SCENE), "definitions": definitions}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _array(count: int, items: Schema) -> Schema:
    return {"type": "array", "items": items, "minItems": count, "maxItems": count}


def _bounded(bound: str) -> Schema:
    return {"anyOf": [{"type": "number", bound: 0}, {"type": "string"}]}


def _with_words(words: str, schema: Schema) -> Schema:
    """The schema with a description, which editors show; allOf, since keys next to $ref are
    ignored."""
    return {"description": words} | ({"allOf": [schema]} if "$ref" in schema else schema)


def _closed(properties: Schema, required: list[str]) -> Schema:
    result: Schema = {"type": "object", "properties": properties, "additionalProperties": False}
    return result | ({"required": required} if required else {})


def _by_name(schema: Schema) -> Schema:
    return {"type": "object", "additionalProperties": schema}


def _table(table: TableOf) -> Schema:
    return _closed({key.name: _with_words(key.words, _key(key)) for key in table.keys},
                   [key.name for key in table.keys if key.required])


def _key(key: Key) -> Schema:
    if key.table:
        inner = _table(key.table)
        several: Schema = {"anyOf": [inner, {"type": "array", "items": inner}]}
        interval: Schema = {"anyOf": [_NUMBER, inner]}
        several_of: Schema = {"type": "array", "items": interval}
        entry: Schema = {"anyOf": [_NUMBER, inner, several_of]}
        named: Schema = {"anyOf": [_NUMBER, inner, {**several_of, "minItems": 1}]}
        holding: dict[str, Schema] = {"table": inner, "tables": _by_name(inner),
                                      "interval": interval, "intervals": _by_name(interval),
                                      "ranges": {"anyOf": [_NUMBER, {"type": "array",
                                                 "items": entry}, _by_name(named)]},
                                      "expectations": _by_name(several), "tolerances": _by_name(
                                          {"anyOf": [_POSITIVE, _by_name(_POSITIVE)]})}
        return holding[key.kind]
    if key.choices:
        return {"enum": list(key.choices)}
    moments: Schema = {"type": "array", "anyOf": [_array(3, _NUMBER), _array(6, _NUMBER),
                                                  _array(3, _array(3, _NUMBER))]}
    kinds: dict[str, Schema] = {
        "text": {"type": "string"}, "words": _by_name({"type": "string"}), "texts": _TEXTS,
        "number": _NUMBER, "numbers": {"type": "array", "items": _NUMBER},
        "positive": _POSITIVE, "nonnegative": _NONNEGATIVE, "vector": _VECTOR,
        "quaternion": _array(4, _NUMBER), "moments": moments,
        "coordinates": _by_name({"anyOf": [_NUMBER, {"type": "array", "items": _NUMBER}]})}
    return _effects() if key.kind == "effects" else kinds[key.kind]


def _effects() -> Schema:
    return _closed({effect.name: _with_words(f"{effect.words}: {effect.equation}", _effect(effect))
                    for effect in EFFECTS}, [])


def _one(effect: Effect) -> Schema:
    """The table of one joint, body or pair on which the effect acts."""
    more: Schema = {"body": {"type": "string"}} if effect.place is Place.BODY else {}
    if effect.on_sums:
        more = {"joints": _by_name(_NUMBER)}
    needed = [parameter.name for parameter in effect.parameters
              if parameter.required and parameter.default is None and not parameter.of]
    if effect.parts:
        more = {"bodies": _TEXTS}
    if effect.place is Place.PAIR:
        more = {"bodies": _array(2, {"type": "string"}) | {"uniqueItems": True}}
        needed = ["bodies", *needed]
    values = {x.name: _with_words(_described(x), {"anyOf": [
        _parameter(x), {"type": "array", "items": _NUMBER}]} if x.name == effect.rest else
        _parameter(x)) for x in effect.parameters}
    return _closed(more | values, needed)


def _effect(effect: Effect) -> Schema:
    """The table of the effect, with all joints, bodies or pairs."""
    one: Schema = {"$ref": f"#/definitions/{effect.name}"}
    if effect.place is Place.SCENE:
        return one
    if effect.place is Place.PAIR:
        return _by_name(one)
    if effect.parts:
        own = {x.name: _with_words(_described(x), _parameter(x)) for x in effect.parameters}
        return {"type": "object", "additionalProperties": one,
                "properties": {"bodies": {"anyOf": [{"const": "all"}, _TEXTS]}, **own}}
    several = "joints" if effect.place is Place.JOINT else "bodies"
    values = {parameter.name: {"description": _described(parameter), "anyOf": [
        schema, _by_name(schema), one]}
        for parameter in effect.parameters for schema in [_parameter(parameter)]}
    return {"type": "object", "additionalProperties": one, "properties": {
        several: {"anyOf": [{"const": "all"}, _TEXTS]}, **values}}


def _described(parameter: ParameterOf) -> str:
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    return f"{parameter.words}{unit}"


def _parameter(parameter: ParameterOf) -> Schema:
    number = _POSITIVE if parameter.positive else \
        _NONNEGATIVE if parameter.nonnegative else _NUMBER
    kinds: dict[str, Schema] = {
        "number": number, "vector": _array(3, number),
        "formula": {"anyOf": [number, _TRAJECTORY]},
        "height": {"anyOf": [{"type": "string"}, _closed({"file": {"type": "string"}}, ["file"])]},
        "formulas": _VECTOR, "body": {"type": "string"},
        "choice": {"enum": list(parameter.choices)}, "flag": {"type": "boolean"},
        "matrix": _array(6, _array(6, _NUMBER))}
    if parameter.kind not in kinds:
        raise ValueError(f"parameter {parameter.name!r}: kind {parameter.kind!r} has no schema; "
                         f"wanted one of {', '.join(kinds)}, or an entry for it here")
    return kinds[parameter.kind]
