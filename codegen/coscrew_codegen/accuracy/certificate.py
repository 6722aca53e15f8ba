"""Certificates: the bounds of every value of a function over its stated ranges, a line each, as
checkers of our own rules, which need only fractions, read them."""

from collections.abc import Iterator
from dataclasses import replace
from math import isfinite

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.pair_certificate import CertifiedPairs, NotedCarrier, component_names
from coscrew_codegen.accuracy.range_proofs import of_mixture, values
from coscrew_codegen.accuracy.rounding_rules import ValueBounds, above
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs
from coscrew_codegen.accuracy.tiers.compensated import Carrying
from coscrew_codegen.accuracy.tiers.mixed import Mixture, mixed
from coscrew_codegen.accuracy.tiers.tier import Tier
from coscrew_codegen.accuracy.vector_lengths import Length
from coscrew_codegen.program import (
    Constant,
    Input,
    Op,
    Operand,
    Program,
    Ref,
)
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.elementary.sincos_error import ERROR as SINCOS_ERROR
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_program import FixedProgram
from coscrew_codegen.program.fixed.fixed_value import FixedValue
from coscrew_codegen.program.roundoff import RoundedRange, Upward
from coscrew_codegen.program.scene_functions import ArgumentRanges, FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, Precision


def certificate(function: FunctionProgram, precision: Precision, wide: bool = False) -> str:
    """The certificate of the plain function in a precision, for the results that have a bound; ""
    if none has one.  A `wide` function computes in double, and rounds its results to the precision.
    """
    if wide:
        function = replace(function, program=function.program.fine or function.program)
    rule = FloatRounding(DOUBLE if wide else precision)
    its = values(function.program, function.ranges, precision, rule)
    most = float(precision.limit("max"))
    proved = [k for k, x in enumerate(its.results) if isfinite(x.size + x.error)
              and (not wide or x.size + x.error <= most)]
    if not proved:
        return ""
    its = values(function.program, _finite(function.ranges, precision), precision, rule)
    lines = [*_head(function, precision, rule.precision), *_lines(function, its, proved)]
    names, program = component_names(function.program), function.program
    for k in proved:
        name, x = _name(program.results[k], program), its.results[k]
        if wide:
            own = Upward(precision.u) * (x.size + x.error) + Upward(precision.eta)
            lines.append(" ".join([precision.name, names[k], name, *_figures(x.rounded(own))]))
        else:
            lines.append(f"# {names[k]} is {name}")
    return "\n".join(lines) + "\n"


def _head(function: FunctionProgram, precision: Precision, computed: Precision) -> Iterator[str]:
    wide = "" if computed is precision else f", computed in {computed.name}"
    yield f"# {function.name} in {precision.name} precision{wide}: for every value a line with its"
    yield "# operation, name, operands, largest size, largest error, largest error of its rounding."
    yield "# Before turns, lines of input_length have components of a vector, a rule, vectors that"
    yield "# it takes, and bounds of its length and its error's, of turns before rounding."
    yield "# First: digits and least exponent of the format; error of sine and cosine in ulps."
    yield f"{computed.digits} {computed.least_exponent} {SINCOS.error(computed)}"


def _lines(function: FunctionProgram, its: ValueBounds, proved: list[int]) -> Iterator[str]:
    program, groups = function.program, _groups(function)
    needed = _needed(program, [program.results[k] for k in proved], its)
    for x in sorted(x for x in needed if isinstance(x, Input)):
        yield " ".join(["input", _name(x, program), *groups.get(x, ()), *_figures(its.of(x))])
    written = set[str]()
    for step in program.instructions:
        if Ref(step.name) in needed:
            lengths = [_of_length(x, program) for x in its.proof(step)]
            yield from dict.fromkeys(x for x in lengths if x not in written)
            written.update(lengths)
            yield " ".join([step.op.value, step.name, *(_name(x, program) for x in step.operands),
                            *([f"{step.name},"] if lengths else ()),
                            *_figures(its.by_name[step.name])])


def of_tier(function: FunctionProgram, tier: Tier, precision: Precision) -> str:
    """The certificate of the function in a tier that is proved otherwise than the plain one, for
    the results that have a bound; "" if none has one."""
    if tier.on_request:
        if not (function.accuracy and function.accuracy.stated):
            return ""
        from coscrew_codegen.accuracy.precision_tuning.choice import (
            chosen,  # imported on use: few scenes need it
        )
        return of_pairs(function, precision, chosen(function.program, function.accuracy).mixture)
    if precision in tier.widened:
        return certificate(function, precision, wide=True)
    return of_pairs(function, precision) if precision in tier.pairs else ""


def of_pairs(function: FunctionProgram, precision: Precision, mixture: Mixture | None = None
             ) -> str:
    """The certificate of the function with all instructions, or those that a mixture names, in
    pairs; "" if no result has a bound."""
    plain, noted = function.program.fine or function.program, list[NotedCarrier]()
    bounds = of_mixture(plain, function.ranges, precision, mixture)
    proved = [k for k, x in enumerate(bounds) if isfinite(x.size + x.error)]
    if not proved or not function.ranges:
        return ""

    def carrier(program: Program, precision: Precision, how: Carrying) -> NotedCarrier:
        noted.append(NotedCarrier(program, precision, how))
        return noted[0]

    emitted = mixed(plain, mixture, carrier) if mixture else in_pairs(plain, precision, carrier)
    rule = CertifiedPairs(precision, noted[0], emitted, proved, mixture)
    ranges = _finite(function.ranges, precision)
    rule.start(ranges.sizes(precision), _groups(function))
    values(plain, ranges, precision, rule)
    return "\n".join((*_pair_header(function, precision), *rule.lines)) + "\n"


def _finite(ranges: ArgumentRanges | None, precision: Precision) -> ArgumentRanges:
    """The ranges; where none is stated, all numbers of the precision."""
    assert ranges
    most = float(precision.limit("max"))
    return replace(ranges, intervals=tuple(tuple((max(low, -most), min(high, most))
                                                 for low, high in each)
                                           for each in ranges.intervals))


def _pair_header(function: FunctionProgram, precision: Precision) -> Iterator[str]:
    yield f"# {function.name} in pairs of {precision.name} precision: for every value a line as"
    yield "# without pairs; the last number bounds the error of the numbers that stand for it."
    yield "# Before and after it, indented: instructions, with the largest size of the result and"
    yield "# the most that its rounding loses; 'x is what x loses, exact less computed; and which"
    yield "# numbers' sum is the value.  First: digits and least exponent of the format; error of"
    yield "# sine and cosine in ulps, and relative error of these as pairs."
    yield (f"{precision.digits} {precision.least_exponent} {SINCOS.error(precision)} "
           f"{above(SINCOS_ERROR.error(precision)).hex()}")


def of_fixed(function: FunctionProgram, fixed: FixedProgram) -> str:
    """The certificate of the function in fixed point."""
    return "\n".join(_fixed_lines(function, fixed)) + "\n"


def _fixed_lines(function: FunctionProgram, fixed: FixedProgram) -> Iterator[str]:
    program = fixed.program
    yield f"# {function.name} in fixed point: for every value a line with its operation, name,"
    yield "# operands, bits, largest size, largest error, largest error of its rounding.  A number"
    yield "# x is the integer x 2^bits; @ states the bits of constants, and of operands that are an"
    yield "# integer with other bits, thus a multiple.  First: error of sine and cosine, and the"
    yield "# error more for each quarter turn of the angle."
    yield " ".join(map(str, fixed_sine.errors()))
    bits = {_name(x.operand, program): x.bits for each in fixed.inputs for x in each}
    bits |= {line.name: line.value.bits for line in fixed.lines}

    def word(x: FixedValue) -> str:
        name = _name(x.operand, program) if not isinstance(x.operand, Constant) else x.stands_for
        return name if bits.get(name) == x.bits else f"{name}@{x.bits}"

    known = {line.name: line for line in fixed.lines}
    needed = {word(x).partition("@")[0] for x in fixed.results}
    for name in reversed(known):
        if name in needed:
            needed.update(word(x).partition("@")[0] for x in known[name].operands)
    for x in (x for each in fixed.inputs for x in each):
        if (name := _name(x.operand, program)) in needed:
            yield " ".join(["input", name, str(x.bits), *_figures(x.bounds)])
    for name, line in known.items():
        if name in needed:
            yield " ".join([_WORDS.get(line.op, line.op.value), name, *map(word, line.operands),
                            str(line.value.bits), *_figures(line.value.bounds)])
    for place, result in zip(component_names(program), fixed.results, strict=True):
        yield f"# {place} is {word(result)}"


_WORDS = {Op.WIDE_PRODUCT: "mul", Op.HIGH_PRODUCT: "high", Op.ROUNDED_SHIFT: "shift",
          Op.MUL: "shift"}
"""Words for operations on integers; factors of integers are shifts to the left."""


def _groups(function: FunctionProgram) -> dict[Operand, tuple[str]]:
    """The quaternion of each input that belongs to one."""
    return {x: (f"quaternion{n}",) for n, each in enumerate(function.ranges.quaternions)
            for x in each} if function.ranges else {}


def _of_length(x: Length, program: Program) -> str:
    """The line of the length of a vector; a component alone has a comma after it."""
    names = [",".join(_name(y, program) for y in each) for each in (x.components, *x.given)]
    name = names[0] if len(x.components) > 1 else f"{names[0]},"
    return " ".join(["input_length", name, x.rule, *names[1:], *(
        float(y).hex() for y in (x.size, x.error, 0))])


def _needed(program: Program, results: list[Operand], its: ValueBounds) -> set[Operand]:
    """The operands on which these results and their bounds depend, and they themselves."""
    needed = set(results)
    for step in reversed(program.instructions):
        if Ref(step.name) in needed:
            needed.update(step.operands)
            for x in its.proof(step):
                needed.update(x.components)
    return needed


def _name(x: Operand, program: Program) -> str:
    """q[3], a name, or a constant as a fraction."""
    if isinstance(x, Input):
        return f"{program.inputs[x.argument].name}[{x.index}]"
    if isinstance(x, Constant):
        return str(x.double)
    assert isinstance(x, Ref)
    return x.name


def _figures(x: RoundedRange) -> tuple[str, ...]:
    return tuple(float(y).hex() for y in (x.size, x.error, x.own))
