"""A scene's functions as C: arm.h declares them, arm.c has them in double precision, armf.c in
single; both include coscrew_runtime.h.

Arrays are plain and matrices row by row.  Results are stored last, when everything has been read:
outputs may alias inputs, also in part.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends import version
from coscrew_codegen.backends.c.c_function import CFunction, FunctionBody, Stored
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.c.c_stores import Layout
from coscrew_codegen.backends.c.tables import c_tables
from coscrew_codegen.backends.nesting import NestingPlan
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_c_columns, scene_c_runtime, scene_text
from coscrew_codegen.backends.scene.scene_c_parts import FunctionParts
from coscrew_codegen.backends.scene.scene_c_steps import step_body
from coscrew_codegen.backends.scene.scene_text import c_name
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import FunctionProgram, IntegratorStep, SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision, named
from coscrew_codegen.scene.identifiers import capitals, numbered

IN_WORDS = {("double",): "double precision only, as selected",
             ("single",): "single precision only, as selected",
             ("double", "single"): "double and (names that end in f) single precision"}


@uncollected()
def files(scene: SceneFunctions, banner: str) -> Files:
    """arm.h, arm.c, armf.c and coscrew_runtime.h.  Raises ValueError for names that C cannot use.
    """
    scene_text.check_names(scene)
    plans = scene_text.plans(scene)
    parts = FunctionParts(scene, plans)
    made = {p: list(functions_of(scene, plans, parts, p)) for p in named(scene.precisions)}
    tables = {p: c_tables.written([f.program for f in scene.functions], p) for p in made}
    remedy = f"{scene.name}f.c has the same functions in single precision" \
        if SINGLE in made else "generate with --precision single"
    sources = [Source(scene.name, scene.name, p, plans, [Section(p, functions, tables[p])],
                      bool(parts.cuts), remedy if p == DOUBLE else "")
               for p, functions in made.items()]
    return {f"{scene.name}.h": header(scene.name, scene.name, about(scene), made, banner,
                                      macros(scene), indices(scene)),
            **{x.path: x.text(banner) for x in sources}, **scene_c_runtime.files()}


@dataclass(frozen=True)
class Section:
    """Functions that compute in one precision, each after those that it calls."""

    working: Precision
    functions: Sequence[CFunction]
    tables: str  # which they read


@dataclass(frozen=True)
class Source:
    """A .c file: functions of a header, whose arguments have one precision."""

    name: str  # of the header
    scene: str
    precision: Precision
    plans: Sequence[NestingPlan]
    sections: Sequence[Section]
    parts: bool  # whether functions are cut
    refused: str  # what to do where double is too short; "" if nothing is computed in it

    @property
    def path(self) -> str:
        """Its place in the output folder."""
        return f"{self.name}{self.precision.suffix}.c"

    def text(self, banner: str) -> str:
        """Returns all of it."""
        functions = [x for section in self.sections for x in section.functions]
        bodies, planned = [x.body for x in functions], {x.program.name for x in self.plans}
        names = scene_text.legend(self.plans, [  # without steps, whose variables are no symbols
            x.body for x in functions if x.internal or x.name in planned])
        return render("scene/scene.c", banner=banner, name=self.name, upper=self.scene.upper(),
                      precision=self.precision, names=[comment_of(names)] if names else [],
                      parts=self.parts, columns=any(scene_c_columns.ABOVE in x for x in bodies),
                      sections=self.sections,
                      **included(bodies, self.refused))


def included(bodies: Iterable[str], refused: str = "") -> dict[str, object]:
    """The template's data for the inclusions of these bodies of functions."""
    return {"errors": scene_c_runtime.with_errors(bodies), "double": refused,
            "fingerprint": scene_c_runtime.fingerprint()}


def header(name: str, scene: str, about: Sequence[str],
           functions: Mapping[Precision, Sequence[CFunction]], banner: str,
           macros: Sequence[tuple[str, str]] = (), indices: Sequence[str] = ()) -> str:
    """The header that declares public functions, by precision."""
    public = [{"functions": results} for x in functions.values()
              if (results := [f for f in x if not f.internal])]
    return render("scene/scene.h", banner=banner, about=comment_of([*about]), macros=macros,
                  indices=indices, guard=name.upper(), upper=scene.upper(), sections=public)


def macros(scene: SceneFunctions) -> list[tuple[str, str]]:
    """The macros of a scene and their values: version, sizes, initializers."""
    values = [("GENERATOR_VERSION", f"{version.number()}  /* 1.2.3 is 10203 */"),
              ("GENERATOR_VERSION_STRING", f'"{version.VERSION}"'),
              ("NQ", str(scene.nq)), ("NV", str(scene.nv))]
    if scene.parameters:
        values.append(("NP", str(len(scene.parameters))))
    return [*values, *(entry for p in named(scene.precisions) for entry in _defaults(scene, p))]


def about(scene: SceneFunctions) -> list[str]:
    """Returns the comment at the top of a scene's header, in paragraphs."""
    return [
        f"{scene.name}: dynamics of a scene, in {IN_WORDS[scene.precisions]}.",
        "SI units.  Arrays are plain, matrices row by row.  Pointers must be valid and "
        "quaternions of norm 1; inputs must be finite, and are not checked: a NaN need not show, "
        "since not every result depends on every input.  Outputs may overlap inputs.  No heap, no "
        "state: all functions are thread-safe.",
        *scene_text.order_in_words(scene),
        *_named_places(scene)]


def _named_places(scene: SceneFunctions) -> Iterator[str]:
    tables = _tables(scene)
    prefixes = [prefix for prefix, (names, _) in tables.items() if names]
    if not prefixes:
        return
    named = ", ".join(f"{scene.name.upper()}_{prefix}_…" for prefix in prefixes)
    example = f", as in q[{_enumerator(scene, 'Q', -1)}]" if "Q" in prefixes else ""
    yield f"Names of these indices (the first of several coordinates): {named}{example}."
    messages = [f"{prefix}_{stem} {scene_text.printable(name)}" for prefix in prefixes
                if prefix != "TAU"
                for name, stem in zip(tables[prefix][0], numbered(tables[prefix][0]), strict=True)
                if stem != capitals(name) or not name.isascii()]
    if messages:
        yield ("Of names that differ only in case, or in characters that C's names cannot have: "
               f"{', '.join(messages)}.")


def indices(scene: SceneFunctions) -> list[str]:
    """Enumerations of indices: of q, v, tau, p and bodies."""
    return [listed("enum { ", [f"{_enumerator(scene, prefix, n)} = {place}"
                               for n, place in enumerate(places)], " };")
            for prefix, (_, places) in _tables(scene).items() if places]


def _enumerator(scene: SceneFunctions, prefix: str, number: int) -> str:
    """ARM_Q_ELBOW."""
    return f"{scene.name.upper()}_{prefix}_{numbered(_tables(scene)[prefix][0])[number]}"


def _tables(scene: SceneFunctions) -> dict[str, tuple[Sequence[str], Sequence[int]]]:
    """Names and their indices, by the prefix of their enumerators."""
    joints = [x.joint for x in scene.coordinates]
    return {"Q": (joints, [x.q.start for x in scene.coordinates]),
            "V": (joints, [x.v.start for x in scene.coordinates]),
            "TAU": (joints, [x.v.start for x in scene.coordinates]),
            "P": ([name for name, _ in scene.parameters], range(len(scene.parameters))),
            "BODY": (scene.bodies, range(len(scene.bodies)))}


def _defaults(scene: SceneFunctions, precision: Precision) -> Iterator[tuple[str, str]]:
    """Initializers: the neutral q, and the default values of parameters."""
    lists = {"NEUTRAL_Q": scene.neutral, "DEFAULT_P": [value for _, value in scene.parameters]}
    for name, values in lists.items():
        if values:
            numbers = [scene_text.literal(x, precision) + precision.suffix for x in values]
            text = listed("{", numbers, "}", WIDTH - 2).replace("\n", " \\\n")
            yield f"{name}{precision.suffix.upper()}", text


def functions_of(scene: SceneFunctions, plans: Sequence[NestingPlan], parts: FunctionParts,
                 precision: Precision) -> Iterator[CFunction]:
    """All emitted functions, each after those that it calls; those that are cut come last, so that
    a file begins with a whole one."""
    for function, plan in sorted(zip(scene.functions, plans, strict=True),
                                 key=lambda x: x[0].name in parts.cuts):
        if function.name in parts.cuts:
            yield from parts.above(function, precision)
            body = parts.body(function, precision)
        else:
            body = _body(function, plan, precision)
        yield _function(scene, function, body, precision)
    yield from (_step(scene, step, precision) for step in scene.steps)


def _function(scene: SceneFunctions, function: FunctionProgram, body: str, precision: Precision
              ) -> CFunction:
    outputs = scene_text.outputs(function)
    parameters = [*(arguments.read(a, precision) for a in function.inputs),
                  *(arguments.written(a, precision) for a in outputs)]
    shapes = [f"{a.name}: {' × '.join(map(str, a.quantity.shape))}."
              for a in outputs if len(a.quantity.shape) > 1]
    comment = comment_of([scene_text.printable(scene_text.sentence(function.words)), *shapes,
                          *filter(None, [function.rounding]), scene_text.cost(function)])
    head = arguments.head(c_name(scene, function.name, precision), parameters,
                          _storage(precision, function.internal))
    return CFunction(function.name, comment, head, body, function.internal)


def _storage(precision: Precision, internal: bool = False) -> str:
    return "KSL_FUNCTION" if precision.device else "static" if internal else ""


def _body(function: FunctionProgram, plan: NestingPlan, precision: Precision) -> str:
    """The body of a function that is written whole."""
    outputs = scene_text.outputs(function)
    stored = Stored(scene_text.access(plan.program), arguments.targets(outputs),
                    [a.name for a in outputs])
    headings = [(number, scene_text.printable(words)) for number, words in function.headings]
    layout = None if precision.device else Layout(scene_text.rows(outputs), function.internal)
    return FunctionBody(plan.program, precision, stored, plan, headings, layout=layout).text()


def _step(scene: SceneFunctions, step: IntegratorStep, precision: Precision) -> CFunction:
    """A step, which moves q and v in place."""
    real = precision.c_type
    declared = {"t": f"{real} t", "h": f"{real} h",
                "p": f"const {real} p[{len(scene.parameters)}]",
                "q": f"{real} q[{scene.nq}]", "v": f"{real} v[{scene.nv}]",
                "tau": f"const {real} tau[{scene.nv}]"}
    inputs = scene_text.step_inputs(scene, step.takes_tau)
    return CFunction(step.name, comment_of([f"{step.words}.  In place."]),
                 arguments.head(c_name(scene, step.name, precision),
                                [declared[x] for x in inputs], _storage(precision)),
                 step_body(scene, step, precision, partial(c_name, scene, precision=precision)))


TARGET = Target("scene in C", ("c",), scene=files)
