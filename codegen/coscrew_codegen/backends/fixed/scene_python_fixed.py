"""A scene in fixed point as a module of its Python package: arm/fixed.py, in pure NumPy on integers
of 64 bits, with the same bits as C."""

from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.accuracy.scene_tiers import headings_in
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.fixed.c_integers import aligned, integer, nested
from coscrew_codegen.backends.fixed.scene_c_fixed import MARK, bounds_in_words
from coscrew_codegen.backends.nesting import CALL, PRODUCT, SIGN, SUM, Language
from coscrew_codegen.backends.numpy.numpy_operations import statement
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program import Instruction, Op
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_program import Products

_SPELLING = {Op.ADD: ("{} + {}", SUM), Op.SUB: ("{} - {}", SUM), Op.NEG: ("-{}", SIGN),
             Op.MUL: ("{} * {}", PRODUCT), Op.HIGH_PRODUCT: ("high_product({}, {})", CALL),
             Op.SIN: ("sincos({}, {})[0]", CALL), Op.COS: ("sincos({}, {})[1]", CALL)}


@uncollected()
def files(made: FixedScene, banner: str) -> Files:
    """The module."""
    name = made.plain.name
    kernel = nested(fixed_sine.kernel(), _LANGUAGE, lambda x: "r", {}, 90)
    shapes = {a.name: tuple(a.quantity.shape) for f in made.functions for a in f.plain.inputs}
    functions = [_function(f, x) for x in Products for f in made.functions]
    text = render(
        "scene/fixed.py", banner=banner, name=name, promise=made.tier.promise,
        half_pi=fixed_sine.HALF_PI, two_over_pi=fixed_sine.TWO_OVER_PI,
        kernel=_body(kernel.lines), s=kernel.results[0], c=kernel.results[1],
        formats=[*_table("BITS", [(repr(x), [v.bits for v in made.arguments[x]], shape)
                                  for x, shape in shapes.items()]),
                 *_table("LARGEST", [(repr(x), [int(v.largest) for v in made.arguments[x]], shape)
                                     for x, shape in shapes.items()]),
                 *_table("RESULT_BITS", [row for x in Products for f in made.functions
                                         for row in _bits(f, x)])],
        functions=functions)
    return {f"{name}/{made.tier.mark}.py": text}


_Row = tuple[str, Sequence[int], tuple[int, ...]]
"""A key of a table, integers, and the shape of their array."""


def _bits(f: FixedFunction, products: Products) -> Iterator[_Row]:
    """The bits of each output's components, by function and output."""
    start, values = 0, f.programs[products].results
    for a in scene_text.outputs(f.plain):
        yield (repr((f.plain.name + MARK[products], a.name)),
               [x.bits for x in values[start:start + a.quantity.size]], tuple(a.quantity.shape))
        start += a.quantity.size


def _table(name: str, rows: Sequence[_Row]) -> Iterator[str]:
    """A dictionary of arrays of integers."""
    yield f"{name} = {{"
    for key, values, shape in rows:
        yield listed(f"    {key}: np.array([", list(map(str, values)), f"]).reshape({shape}),")
    yield "}"


def _function(f: FixedFunction, products: Products) -> dict[str, str]:
    fixed, outputs = f.programs[products], scene_text.outputs(f.plain)
    headings = {place: scene_text.printable(words)
                for place, words in headings_in(f.plain, fixed.program)}
    text = nested(fixed.program, _LANGUAGE, scene_text.access(fixed.program), headings,
                  scene_text.VALUE_WIDTH)
    names = ", ".join(a.name for a in f.plain.inputs)
    given = [f"{a.name}=({a.name}, {tuple(a.quantity.shape)})" for a in f.plain.inputs]
    lines = [listed(f"lead, ({names},) = _arguments(", given, ")", WIDTH - 4),
             *map(statement, text.assigned)]
    made, start = [], 0
    for a in outputs:
        parts = text.results[start:start + a.quantity.size]
        start += a.quantity.size
        made.append(listed(f"_assembled(lead, {tuple(a.quantity.shape)}, ", parts, ")", WIDTH - 12))
    lines.append(f"return {', '.join(made)}")
    words = [*scene_text.words(f.plain, costs=False)[:2], bounds_in_words(f, fixed.results)]
    docstring = "\n\n    ".join("\n    ".join(wrap(scene_text.printable(x), WIDTH - 8))
                                for x in words)
    return {"name": f.plain.name + MARK[products], "arguments": names, "docstring": docstring,
            "body": _body(lines)}


def _body(lines: Iterable[str]) -> str:
    return "\n".join(f"    {row}" for line in lines for row in line.split("\n"))


def _spelling(step: Instruction) -> tuple[str, int]:
    if step.op is Op.WIDE_PRODUCT:
        return aligned(step, "({} * {})", "{}")
    if step.op is Op.ROUNDED_SHIFT:
        return ("rounded_shift({}, {})" if integer(step.operands[1]) else "({})"), CALL
    return _SPELLING[step.op]


_LANGUAGE = Language(_spelling, lambda x: str(integer(x)), "", "# ", "{function}({arguments})")

TARGET = Target("scene in fixed point in Python", ("python",), fixed=files)
