"""The gufunc target: NumPy generalized ufuncs whose loops call the C kernels.

A loop reads its core dimensions through strides into the kernel's structs, calls the kernel and
writes the results back; nothing else is copied.  Where the kernel exists on vectors, it reads
several elements into these.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_many_lanes import place
from coscrew_codegen.backends.c.c_operations import (
    STRUCTS,
    c_name,
    c_type,
    is_pointer,
    member,
    parameters,
    returned,
)
from coscrew_codegen.backends.library import FamilyKernels
from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument, Quantity
from coscrew_codegen.program.whole_cost import whole_counts

_VECTORS = 256
"""So many vectors hold results of several groups: 8 KiB of stack, a part of a processor's cache."""
_LONG, _LONG_WITH_ONE = 200, 1000
"""Operations from which on a loop whose strides are known takes as long as one for any strides: of
kernels with one input, and with several.  If the first of several is the same for all elements,
what depends on it alone is computed once, which saves up to half of the time."""


@dataclass(frozen=True)
class Copies:
    """The copies of a kernel's loop that are compiled besides the one for any strides."""

    strides: bool  # for the strides of C-ordered arrays
    fma: bool  # for processors with FMA, also that for any strides


@dataclass(frozen=True)
class FirstInput:
    """The first input, loaded once if it is the same for every element (one displacement of many
    coscrews).  The compiler may not do that itself; it saves a third of the time."""

    load_once: str  # declares it, too
    load: str  # for another element, if that is another


@dataclass(frozen=True)
class LaneLoops:
    """Groups of elements that a loop computes at a time: as many as a vector holds."""

    count: str  # of elements in a vector
    groups: int  # computed before any is written
    declarations: tuple[str, ...]
    results: tuple[str, ...]  # the arrays with an entry of each group
    loads: tuple[tuple[str, str], ...]  # before and after the number of elements left
    call: str
    stores: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class GufuncLoop:
    """The inner loop of one gufunc in one precision."""

    name: str  # of the C function
    first: FirstInput | None  # None if it is the only one, or the kernel writes to it
    declarations: tuple[str, ...]
    loads: tuple[str, ...]
    call: str
    stores: tuple[str, ...]
    strided: str  # the definition of the loop over elements with any strides
    definition: str  # of the function that calls it
    core: int  # index of the first core stride among the strides: the number of arguments
    lanes: LaneLoops | None  # None if compilers make vector instructions of the loop


@dataclass(frozen=True)
class Gufunc:
    """One gufunc: its loops and its description for NumPy."""

    name: str
    signature: str
    inputs: int
    outputs: int
    docstring: str  # as lines of C string literals
    required: str  # letters of `requirements.Required`, or "" if all numbers are taken
    loops: tuple[GufuncLoop, ...]


@dataclass(frozen=True)
class Access:
    """Places of a quantity's components, from a pointer and core strides."""

    quantity: str
    type: str
    real: str
    precision: str
    places: tuple[tuple[str, str], ...]  # (member, byte offset)
    vectors: str  # the type that holds a component of several elements
    count: str  # of these elements
    numbered: tuple[tuple[int, str], ...]  # (number of the vector, byte offset)


Worth = Mapping[tuple[str, str, str], Copies]
"""By the names of tier, operation and precision."""


def worth(kernels: FamilyKernels) -> Worth:
    """The copies of the loops of a family's kernels that are faster."""
    return {(tier.name, op.name, precision.name): _copies(op, whole_counts(program, precision))
            for tier in TIERS for precision in kernels.precisions
            for op, program in kernels.of(tier, precision).items()}


def _copies(operation: Operation, counts: Mapping[Op, int]) -> Copies:
    most = _LONG_WITH_ONE if _may_have_one(operation) else _LONG
    return Copies(sum(counts.values()) < most,
                  bool({*counts} & {Op.PRODUCT_ERROR, Op.PRODUCT_REST}))


def gufunc(operation: Operation, precisions: tuple[Precision, ...], docstring: str, tier: Tier,
           copies: Worth, on_vectors: Mapping[tuple[str, str], CFunction] | None = None,
           required: str = "") -> Gufunc:
    """The operation as a gufunc with one loop per precision, which calls the tier's kernel, and the
    one on vectors if there is such: by operation and precision."""
    held = on_vectors or {}
    lines = docstring.replace("\\", "\\\\").replace('"', '\\"').splitlines()
    literal = "\n".join(f'    "{line}\\n"' for line in lines)
    return Gufunc(operation.name, operation.signature, len(operation.inputs),
                  len(operation.outputs), literal, required,
                  tuple(_loop(operation, precision, tier.mark,
                              copies[tier.name, operation.name, precision.name],
                              held.get((operation.name, precision.name)))
                        for precision in precisions))


def access(quantity: Quantity, precision: Precision) -> Access:
    """Returns the place of each component of the quantity in a NumPy array."""
    rank = len(quantity.shape)
    places, numbered = [], []
    for index, (row, column) in enumerate(quantity.indices):
        steps = [f"{n} * s[{axis}]" for axis, n in enumerate((row, column)[:rank]) if n]
        path = member(quantity, index)
        target = path.replace(".", "x->", 1) if path.startswith(".") else f"x{path or '[0]'}"
        offset = " + ".join(["p", *steps])
        places.append((target, offset))
        numbered.append((place(quantity, index), offset))
    return Access(quantity.name, c_type(quantity, precision), precision.c_type, precision.name,
                  tuple(places), _vectors(precision), _count(precision), tuple(numbered))


def _loop(operation: Operation, precision: Precision, tier: str, copies: Copies,
          states: CFunction | None) -> GufuncLoop:
    arguments = (*operation.inputs, *operation.outputs)
    starts = _starts(arguments)

    def kind(number: int) -> str:
        return f"{arguments[number].quantity.name}_{precision.name}"

    def moving(verb: str, numbers: range) -> tuple[str, ...]:
        return tuple(f"{verb}({kind(n)}, {_pointer(arguments[n])}, {n}, {starts[n]});"
                     for n in numbers)

    inputs = len(operation.inputs)
    fixed = _may_have_one(operation)
    distinct = tuple({a.name: a for a in arguments}.values())
    name, x = f"{operation.name}_{precision.name}", _pointer(arguments[0])
    way = f"DENSE{'_OR_ONE' * fixed}" if copies.strides else "ANY"
    return GufuncLoop(
        name=name,
        first=FirstInput(
            f"LOAD_FIRST({kind(0)}, {_declared(arguments[0], precision).rstrip(';')}, {x});",
            f"LOAD_OTHER({kind(0)}, {x});") if fixed else None,
        declarations=tuple(_declared(a, precision) for a in distinct[fixed:]),
        loads=moving("LOAD", range(int(fixed), inputs)),
        call=_call(operation, precision, tier),
        stores=moving("STORE", range(inputs, len(arguments))),
        strided=f"STRIDED{'_WITH_FMA' * copies.fma}({name})",
        definition=f"LOOP{'_ON_VECTORS' * (states is not None)}({name}, {len(arguments)}, "
                   f"{way}, {_dense(arguments, precision)})",
        core=len(arguments),
        lanes=_lanes(operation, precision, states) if states else None,
    )


def _may_have_one(operation: Operation) -> bool:
    """Returns whether the first of several inputs is only read."""
    return len(operation.inputs) > 1 and operation.inputs[0] not in operation.outputs


def _lanes(operation: Operation, precision: Precision, states: CFunction) -> LaneLoops:
    arguments = (*operation.inputs, *operation.outputs)
    sizes, starts = {a.name: a.quantity.size for a in arguments}, _starts(arguments)
    results = {a.name: a.quantity.size for a in operation.outputs}
    groups = _VECTORS // sum(results.values())
    count, inputs = _count(precision), len(operation.inputs)

    def vectors(name: str) -> str:
        return f"{name}[g]" if name in results else name

    def lines(verb: str, numbers: range) -> tuple[tuple[str, str], ...]:
        return tuple((f"{verb}_lanes_{a.quantity.name}_{precision.name}({vectors(a.name)}, "
                      f"data[{n}] + j * step[{n}], step[{n}], core + {starts[n]}, ", ");")
                     for n in numbers for a in (arguments[n],))

    return LaneLoops(
        count, groups,
        tuple(f"{_vectors(precision)} {name}{f'[{groups}]' * (name in results)}[{size}];"
              for name, size in sizes.items()), tuple(results),
        lines("load", range(inputs)), f"{states.name}({', '.join(map(vectors, sizes))});",
        lines("store", range(inputs, len(arguments))))


def _vectors(precision: Precision) -> str:
    return f"ksl_states{precision.suffix}"


def _count(precision: Precision) -> str:
    return f"KSL_LANES{precision.suffix.upper()}"


def _starts(arguments: Sequence[Argument]) -> list[int]:
    """The indices of the arguments' first core strides among the core strides."""
    ranks = [len(a.quantity.shape) for a in arguments]
    return [sum(ranks[:n]) for n in range(len(ranks))]


def _call(operation: Operation, precision: Precision, tier: str) -> str:
    passed = ", ".join(f"&{a.name}" if is_pointer(operation, a) else a.name
                       for a in parameters(operation))
    value = returned(operation)
    result = f"{value.name} = " if value else ""
    name = c_name(operation.name, precision) + (f"_{tier}" if tier else "")
    return f"{result}{name}({passed});"


def _declared(argument: Argument, precision: Precision) -> str:
    kind = c_type(argument.quantity, precision)
    array = argument.quantity.shape and argument.quantity.name not in STRUCTS
    return f"{kind} {argument.name}" + (f"[{argument.quantity.size}]" if array else "") + ";"


def _pointer(argument: Argument) -> str:
    array = argument.quantity.shape and argument.quantity.name not in STRUCTS
    return argument.name if array else f"&{argument.name}"


def _dense(arguments: tuple[Argument, ...], precision: Precision) -> str:
    """The outer strides, then the core strides, of C-ordered arrays as an initializer."""
    outer = [a.quantity.size * precision.bytes for a in arguments]
    core = [stride for a in arguments for stride in
            (a.quantity.rows_columns[1] * precision.bytes, precision.bytes)[-len(a.quantity.shape):]
            if a.quantity.shape]
    return ", ".join(map(str, (*outer, *core)))
