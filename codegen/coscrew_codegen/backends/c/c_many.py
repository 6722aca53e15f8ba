"""The library's functions of many elements in C, if selected: ksl/coscrew_many.h and so on.

Two loops over each kernel, which processors run several elements at a time of: over arrays of
structs, and over planes, arrays that hold one component of every element.  Their bits are those of
the kernel.  They are inlined, so that strides that a caller writes as numbers are known to the
compiler.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.operations import Operation, family_named
from coscrew_codegen.backends.c import c_many_lanes, c_operations, c_storage
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument, Quantity

SHARED = "ksl_planes"
"""The header that all others include: it reads and writes planes."""
_HEAD_WIDTH = WIDTH - len("static KSL_INLINED ")


@dataclass(frozen=True)
class Lying:
    """An argument, its number of components, and the calls that read it into vectors and write
    them, if there are such."""

    name: str
    size: int
    read: str
    written: str


@dataclass(frozen=True)
class Many:
    """One kernel's functions of many elements: heads without storage class, bodies."""

    kernel: str  # its name
    rows: str
    rows_body: str
    planes: str
    first: str  # declares and reads what may be shared
    planes_body: str
    precision: Precision
    states: CFunction | None = None  # the kernel on vectors
    lying: Sequence[Lying] = ()  # then: the arguments
    passed: Sequence[str] = ()  # and their names, as that takes them
    rows_by_planes: str = ""


def files(library: Library) -> Files:
    """c/include/ksl/coscrew_many.h and so on; none without the option."""
    return {f"c/include/ksl/{name}.h": text
            for name, text in (_headers(library) if library.many else {}).items()}


def _headers(library: Library) -> Mapping[str, str]:
    """Returns the headers of all tiers, the shared ones, and for each tier one that includes all.
    """
    made = {SHARED: render("c/ksl_planes.h", banner=_banner(library), types=[
        _Access(quantity, precision) for quantity in c_storage.TYPES
        for precision in library.precisions])}
    for tier in TIERS:
        if held := library.having(tier):
            families = [family for family in library.families
                        if any(op.family == family for op in held)]
            made |= {named(family, tier): _header(library, tier, family) for family in families}
            made[f"{tier.umbrella}_many"] = render(
                "c/ksl.h", banner=_banner(library), guard=f"{tier.umbrella.upper()}_MANY_H",
                title=f"All {tier.name} kernels of many elements.",
                includes=[named(family, tier) for family in families])
    return made


def functions(operation: Operation, precision: Precision, tier: str = "",
              states: CFunction | None = None) -> Many:
    """The operation's functions, in a tier if its name is given, on vectors if the kernel is."""
    return _ManyWriter(operation, precision, tier).functions(states)


def named(family: str, tier: Tier) -> str:
    """The header's name: coscrew_many, coscrew_accurate_many."""
    return "_".join(filter(None, (family, tier.mark, "many")))


def _header(library: Library, tier: Tier, family: str) -> str:
    name = named(family, tier)
    on_vectors = {} if tier.marked else library.made(c_many_lanes.kernels)[family]
    made = [functions(op, precision, tier.mark, on_vectors.get((op.name, precision.name)))
            for precision in library.precisions for op in library.having(tier)
            if op.family == family]
    return render(
        "c/many.h", banner=_banner(library), guard=f"KSL_{name.upper()}_H", functions=made,
        title=f"{family_named(family).title}  Many at a time.",
        includes=[name.removesuffix("_many"), *[c_many_lanes.named(family)] * bool(on_vectors),
                  SHARED])


def _banner(library: Library) -> str:
    return library.banner_with("--many")


class _Access:
    """Texts that read a struct from planes and write it to them, for a template."""

    def __init__(self, quantity: Quantity, precision: Precision):
        self.name, self.real = f"ksl_{quantity.name}{precision.suffix}", precision.c_type
        places = [_place(j) for j in range(quantity.size)]
        self.read = listed(f"  const {self.name}_t value = {{{{{{",
                           [f"x[{place}]" for place in places], "}}};", WIDTH)
        array = c_storage.views(quantity, precision)[0][0].split()[-1].partition("[")[0]
        self.write = "\n".join(f"  x[{place}] = value->{array}[{j}];"
                               for j, place in enumerate(places))


def _place(component: int) -> str:
    """Returns the distance of a component from the first."""
    return ("0", "plane")[component] if component < 2 else f"{component} * plane"


class _ManyWriter:
    """Writes the two functions of a kernel; `i` counts elements."""

    def __init__(self, operation: Operation, precision: Precision, tier: str):
        self.operation, self.precision = operation, precision
        self.name = c_operations.c_name(operation.name, precision) + (f"_{tier}" if tier else "")
        self.value = c_operations.returned(operation)
        self.written = {a.name for a in operation.outputs}
        self.read = {a.name for a in operation.inputs}
        self.parameters = (*c_operations.parameters(operation),
                           *([self.value] if self.value else []))

    def functions(self, states: CFunction | None) -> Many:
        arguments = {a.name: a for a in (*self.operation.inputs, *self.operation.outputs)}
        return Many(self.name, self._head("many", planes=False), "    " + self._rows() + ";",
                    self._head("planes", planes=True), self._first(),
                    "\n".join(f"    {line}" for line in self._planes()), self.precision,
                    states, list(map(self._lying, self.parameters)), list(arguments),
                    self._rows_by_planes())

    def _lying(self, a: Argument) -> Lying:
        x, f, size = a.name, self.precision.suffix, str(a.quantity.size)
        plane = f"{x}_plane" if a.quantity.shape else "1"
        numbers, steps = f"{x} + i * {x}_stride", (plane, f"{x}_stride", "last")
        read = (numbers, size, *steps, f"{x}_states")
        written = (f"{x}_states", size, numbers, *steps)

        def call(way: str, passed: Sequence[str]) -> str:
            text = listed(f"ksl_states{f}_{way}_planes(", passed, ");", WIDTH - 4)
            return text.replace("\n", "\n    ")

        return Lying(x, a.quantity.size, call("of", read) if x in self.read else "",
                     call("to", written) if x in self.written else "")

    def _rows_by_planes(self) -> str:
        """The call for arrays of structs: components are next to each other."""
        passed = ["n"]
        for a in self.parameters:
            const, x = "" if a.name in self.written else "const ", a.name
            number = f"({const}{self.precision.c_type} *)" if _is_struct(a) else ""
            passed += [f"{number}{x}", "1", f"{a.quantity.size} * {x}_stride"] if (
                a.quantity.shape) else [x, f"{x}_stride"]
        return "  " + listed(f"{self.name}_planes(", passed, ");", WIDTH - 2).replace("\n", "\n  ")

    def _head(self, mark: str, planes: bool) -> str:
        declared = ["ptrdiff_t n"]
        for a in self.parameters:
            const = "" if a.name in self.written else "const "
            kind = (self.precision.c_type if planes or not _is_struct(a)
                    else c_operations.c_type(a.quantity, self.precision))
            declared.append(f"{const}{kind} *{a.name}")
            declared += [f"ptrdiff_t {a.name}_plane"] * (planes and bool(a.quantity.shape))
            declared.append(f"ptrdiff_t {a.name}_stride")
        return listed(f"void {self.name}_{mark}(", declared, ")", _HEAD_WIDTH)

    def _call(self, passed: Sequence[str], result: str) -> str:
        text = f"{result} = {self.name}(" if result else f"{self.name}("
        return listed(text, passed, ")", WIDTH - 4).replace("\n", "\n    ")

    def _rows(self) -> str:
        passed = [self._row(a) for a in c_operations.parameters(self.operation)]
        value = self.value
        return self._call(passed, f"{value.name}[i * {value.name}_stride]" if value else "")

    def _row(self, a: Argument) -> str:
        x = a.name
        if c_operations.is_pointer(self.operation, a):
            return f"{x} + i * {x}_stride"
        if a.quantity.shape and not _is_struct(a):
            return f"{x} + {a.quantity.size} * i * {x}_stride"
        return f"{x}[i * {x}_stride]"

    @property
    def _hoisted(self) -> str:
        """The first input, if it is a struct: it is read once where all elements share it, which
        compilers may not do, and which saves a quarter of the time."""
        a = self.operation.inputs[0]
        return a.name if _is_struct(a) and a.name not in self.written else ""

    def _first(self) -> str:
        x = self._hoisted
        if not x:
            return ""
        kind = c_operations.c_type(self.operation.inputs[0].quantity, self.precision)
        return (f"  {kind} {x}_i;\n"
                f"  if (n > 0) {x}_i = {_stem(kind)}_of_planes({x}, {x}_plane);\n")

    def _planes(self) -> Iterator[str]:
        for a in self.parameters:
            yield from self._declared(a) if a.quantity.shape else ()
        passed = [self._local(a) for a in c_operations.parameters(self.operation)]
        yield self._call(passed, self._result()) + ";"
        for a in self.parameters:
            yield from self._stored(a) if a.name in self.written and a.quantity.shape else ()

    def _result(self) -> str:
        if self.value is None:
            return ""
        x = self.value.name
        return f"{x}_i" if self.value.quantity.shape else f"{x}[i * {x}_stride]"

    def _declared(self, a: Argument) -> Iterator[str]:
        x, const = a.name, "" if a.name in self.written else "const "
        kind = c_operations.c_type(a.quantity, self.precision)
        local = f"{const}{kind} {x}_i" + ("" if _is_struct(a) else f"[{a.quantity.size}]")
        if x == self._hoisted:
            local = f"if ({x}_stride) {x}_i"
        if x not in self.read:
            yield f"{local};"
        elif _is_struct(a):
            yield f"{local} = {_stem(kind)}_of_planes({x} + i * {x}_stride, {x}_plane);"
        else:
            yield listed(f"{local} = {{", _components(a), "};", WIDTH - 4).replace("\n", "\n    ")

    def _stored(self, a: Argument) -> Iterator[str]:
        x = a.name
        if _is_struct(a):
            kind = _stem(c_operations.c_type(a.quantity, self.precision))
            yield f"{kind}_to_planes(&{x}_i, {x} + i * {x}_stride, {x}_plane);"
        else:
            yield from (f"{place} = {x}_i[{j}];" for j, place in enumerate(_components(a)))

    def _local(self, a: Argument) -> str:
        x = a.name
        if a.quantity.shape:
            return f"&{x}_i" if c_operations.is_pointer(self.operation, a) else f"{x}_i"
        return (f"{x} + i * {x}_stride" if c_operations.is_pointer(self.operation, a)
                else f"{x}[i * {x}_stride]")


def _is_struct(a: Argument) -> bool:
    return a.quantity.name in c_operations.STRUCTS


def _stem(kind: str) -> str:
    return kind.removesuffix("_t")


def _components(a: Argument) -> list[str]:
    """The components of an element that lies in planes."""
    x = a.name
    places = [_place(j).replace("plane", f"{x}_plane") for j in range(a.quantity.size)]
    return [f"{x}[{place} + i * {x}_stride]" for place in places]


TARGET = Target("C headers of many elements", ("c",), library=files)
