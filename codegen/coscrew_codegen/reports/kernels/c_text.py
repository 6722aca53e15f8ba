"""Writes the C text of every kernel in three loops, for timing.  Knows types and layouts, no
arithmetic.

A loop receives pointers to all inputs, then to all outputs (separate arrays even for kernels that
work in place, so that calls can be repeated), then to a zero."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_operations import (
    STRUCTS,
    c_name,
    c_type,
    is_pointer,
    member,
    parameters,
    returned,
)
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Op, Operand, Program, Ref
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.reports.timing.buffers import plane_length

_CACHE = 16384  # bytes of inputs and outputs, half of a small first-level cache

# Typical latencies in cycles, to find the result that is ready last.
_CYCLES = {Op.DIV: 13, Op.SQRT: 18, Op.SIN: 60, Op.COS: 60, Op.ATAN2: 90, Op.NEG: 1, Op.ABS: 1,
           Op.SELECT: 1, Op.LESS: 3, Op.EQUAL: 3}


@dataclass(frozen=True)
class Variant:
    """A kernel: an operation in a tier, perhaps with further outputs, and its program."""

    operation: Operation
    precision: Precision
    tier: str
    program: Program

    @property
    def name(self) -> str:
        """Its name in the headers, without ksl_."""
        name = c_name(self.operation.name, self.precision).removeprefix("ksl_")
        return "_".join(filter(None, (name, tier_named(self.tier).mark)))

    @property
    def elements(self) -> int:
        """The number of elements that fit the first-level cache: a multiple of 16 from 16 to 256.
        """
        arguments = (*self.operation.inputs, *self.operation.outputs)
        size = sum(a.quantity.size for a in arguments) * self.precision.bytes
        return max(16, min(256, _CACHE // size // 16 * 16))


@dataclass(frozen=True)
class _Loops:
    """The contents of the template's holes."""

    name: str
    rows: str
    row: str
    planes: str
    plane: str
    links: str
    link: str


def kernels_text(variants: Sequence[Variant]) -> str:
    """The C text for variants of one tier."""
    return render("report/kernels.c", header=tier_named(variants[0].tier).umbrella,
                  kernels=list(map(_loops, variants)))


def last_component(program: Program) -> int:
    """The number of the result that is ready last: at the end of the longest path of latencies."""
    ready: dict[str, int] = {}

    def when(operand: Operand) -> int:
        return ready[operand.name] if isinstance(operand, Ref) else 0

    for step in program.instructions:
        ready[step.name] = max(map(when, step.operands)) + _CYCLES.get(step.op, 4)
    return max(range(len(program.results)), key=lambda i: when(program.results[i]))


def _loops(variant: Variant) -> _Loops:
    rows, row = _rows(variant)
    planes, plane = _planes(variant)
    links, link = _chain(variant)
    return _Loops(variant.name, "\n  ".join(rows), "\n    ".join(row), "\n  ".join(planes),
                  "\n    ".join(plane), "\n  ".join(links), "\n    ".join(link))


def _rows(variant: Variant) -> tuple[list[str], list[str]]:
    """out[i] = kernel(in[i]); arguments that are updated in place are copied first."""
    pointers, copies, values = [], [], {}
    for number, a, read in _numbered(variant.operation):
        kind, size = _declaration(a, variant.precision)
        const, name = ("const ", f"{a.name}_in") if read else ("", f"{a.name}_out")
        star = f"(*{name}){size}" if size else f"*{name}"
        pointers.append(f"{const}{kind} {star} = arguments[{number}];")
        if not read and a in variant.operation.inputs:
            copies.append(f"memcpy(&{name}[i], &{a.name}_in[i], sizeof {name}[i]);")
        values[a.name] = f"{name}[i]"
    return pointers, [*copies, _call(variant, values)]


def _planes(variant: Variant) -> tuple[list[str], list[str]]:
    """Components gathered from planes, the kernel, results scattered to planes."""
    real, stride = variant.precision.c_type, plane_length(variant.elements, variant.precision.bytes)
    pointers: list[str] = []
    gathers: list[str] = []
    scatters: list[str] = []
    for number, a, read in _numbered(variant.operation):
        const, name = ("const ", f"{a.name}_in") if read else ("", f"{a.name}_out")
        pointers.append(f"{const}{real} (*{name})[{stride}] = arguments[{number}];")
        for k in range(a.quantity.size):
            local, plane = f"{a.name}{member(a.quantity, k)}", f"{name}[{k}][i]"
            (gathers if read else scatters).append(
                f"{local} = {plane};" if read else f"{plane} = {local};")
    call = _call(variant, {a.name: a.name for a in _distinct(variant.operation)})
    return pointers, [*_locals(variant), *gathers, call, *scatters]


def _chain(variant: Variant) -> tuple[list[str], list[str]]:
    """Every input depends on the last result of the previous call: in + 0 · out, with a zero that
    compilers cannot see; all results are stored."""
    operation, real = variant.operation, variant.precision.c_type
    outputs = [(a, k) for a in operation.outputs for k in range(a.quantity.size)]
    last, component = outputs[last_component(variant.program)]
    pointers, links = [], []
    for number, a, read in _numbered(operation):
        if read:
            kind, size = _declaration(a, variant.precision)
            star = f"(*{a.name}_in){size}" if size else f"*{a.name}_in"
            pointers.append(f"const {kind} {star} = arguments[{number}];")
            links += [f"{a.name}{m} = {a.name}_in[0]{m} + fed;"
                      for m in (member(a.quantity, k) for k in range(a.quantity.size))]
    zero = len(operation.inputs) + len(operation.outputs)
    pointers += [f"const {real} zero = *(const {real} *)arguments[{zero}];", f"{real} fed = zero;"]
    call = _call(variant, {a.name: a.name for a in _distinct(operation)})
    kept = ", ".join(f'"m"({a.name})' for a in operation.outputs)
    return pointers, [*_locals(variant), *links, call,
                      f"fed = zero * {last.name}{member(last.quantity, component)};",
                      f'__asm__ volatile("" ::{kept});']


def _numbered(operation: Operation) -> list[tuple[int, Argument, bool]]:
    """(number, argument, whether it is read): all inputs, then all outputs."""
    both = [(a, True) for a in operation.inputs] + [(a, False) for a in operation.outputs]
    return [(number, a, read) for number, (a, read) in enumerate(both)]


def _distinct(operation: Operation) -> tuple[Argument, ...]:
    return tuple({a.name: a for a in (*operation.inputs, *operation.outputs)}.values())


def _declaration(argument: Argument, precision: Precision) -> tuple[str, str]:
    """Type and, of a plain array, size."""
    array = argument.quantity.shape and argument.quantity.name not in STRUCTS
    return c_type(argument.quantity, precision), f"[{argument.quantity.size}]" if array else ""


def _locals(variant: Variant) -> list[str]:
    return [f"{kind} {a.name}{size};" for a in _distinct(variant.operation)
            for kind, size in [_declaration(a, variant.precision)]]


def _call(variant: Variant, values: dict[str, str]) -> str:
    """The statement that calls the kernel; `values` gives the lvalue of each argument."""
    operation, value = variant.operation, returned(variant.operation)

    def passed(a: Argument) -> str:
        return f"&{values[a.name]}" if is_pointer(operation, a) else values[a.name]

    result = f"{values[value.name]} = " if value else ""
    return f"{result}ksl_{variant.name}({', '.join(map(passed, parameters(operation)))});"
