"""Translates PTX, the assembly of CUDA's devices, to C: so that a device's program runs on any
processor, instruction by instruction, each rounded as PTX's manual says.

Registers are the bits that they hold.  It knows the instructions that compilers emit for our text;
any other instruction is an error."""

import re
from collections.abc import Collection, Iterator, Sequence

_TYPES = {"f64": ("double", 8), "f32": ("float", 4), "pred": ("uint8_t", 1),
          **{f"{sign}{8 * size}": (f"{word}{8 * size}_t", size) for size in (1, 2, 4, 8)
             for sign, word in (("s", "int"), ("u", "uint"), ("b", "uint"))}}
"""The type in C of each type, and its bytes."""
_SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/", "and": "&", "or": "|", "xor": "^",
          "shl": "<<", "shr": ">>"}
_TESTS = {"lt": "<", "gt": ">", "le": "<=", "ge": ">=", "eq": "==", "ne": "!=", "neu": "!="}
_OF_ONE = {"neg": "-{}", "sqrt": "sqrt{f}({})", "abs": "fabs{f}({})", "not": "~{}"}
_ROUNDED = ("add", "sub", "mul", "div", "sqrt", "fma")

_HEAD = """\
#include <math.h>
#include <stdint.h>
#include <string.h>
typedef struct { unsigned x; } place;
extern place blockIdx, threadIdx;
extern const place gridDim, blockDim;
static double as_f64(uint64_t x) { double y; memcpy(&y, &x, 8); return y; }
static float as_f32(uint32_t x) { float y; memcpy(&y, &x, 4); return y; }
static uint64_t of_f64(double x) { uint64_t y; memcpy(&y, &x, 8); return y; }
static uint32_t of_f32(float x) { uint32_t y; memcpy(&y, &x, 4); return y; }
"""
_PLACES = {"%tid.x": "threadIdx.x", "%ctaid.x": "blockIdx.x", "%ntid.x": "blockDim.x",
           "%nctaid.x": "gridDim.x"}
_TABLE = re.compile(r"\.(?:const|global) \.align (\d+) \.b8 ([\w$]+)\[\d+\] = \{([^}]*)\};")
_FUNCTION = re.compile(r"\.(entry|func)\s*(?:\(([^)]*)\))?\s*([\w$]+)\s*\(([^)]*)\)([^{;]*)([{;])")
_ROOM = re.compile(r"\.(local|param)\s.*?(?:\.(\w+)\s+)([\w$]+)(?:\[(\d+)\])?$", re.DOTALL)
_STATEMENT = re.compile(r"\s*(?:([{}])|([\w$]+):|([^;{}]+);)")
_PARAMETER = re.compile(r"([\w$]+)(?:\[(\d+)\])?$")


def to_c(ptx: str) -> str:
    """C with a function for each kernel, whose arguments are integers of 64 bits and doubles."""
    ptx = re.sub(r"//[^\n]*", "", ptx)
    tables = [f"_Alignas({align}) static const uint8_t {_word(name)}[] = {{{values}}};"
              for align, name, values in _TABLE.findall(ptx)]
    names = {name for _, name, _ in _TABLE.findall(ptx)}
    heads, bodies = [], []
    for result in _FUNCTION.finditer(ptx):
        kind, returned, name, taken, _, end = result.groups()
        parameters = _parameters(returned or "") + _parameters(taken)
        copies = []
        if kind == "entry":
            copies = [f"  char *const {x} = (char *)&{x}_value;" for x in parameters]
            types = ["double" if ".f64" in x else "uint64_t" for x in taken.split(",")]
            values = [f"{kind} {x}_value" for kind, x in zip(types, parameters, strict=True)]
            head = f"void {_word(name)}({', '.join(values)})"
        else:
            head = f"static void {_word(name)}({', '.join(f'char *{x}' for x in parameters)})"
        heads.append(f"{head};")
        if end == "{":
            body = "\n".join(_Body(names).lines(_inside(ptx, result.end())))
            bodies.append("\n".join((f"{head} {{", *copies, body, "}")))
    return "\n".join((_HEAD, *tables, *dict.fromkeys(heads), *bodies, ""))


def _parameters(text: str) -> list[str]:
    """The names of parameters."""
    results = (_PARAMETER.search(x.strip()) for x in text.split(","))
    return [_word(x[1]) for x in results if x]


def _inside(text: str, start: int) -> str:
    """The text in the braces that open before `start`."""
    depth = 1
    for place in range(start, len(text)):
        depth += (text[place] == "{") - (text[place] == "}")
        if not depth:
            return text[start:place]
    raise ValueError("braces are not closed")


def _word(name: str) -> str:
    return name.replace("$", "_")


class _Body:
    """The statements of a function; `tables` are names of addresses."""

    def __init__(self, tables: Collection[str]):
        self.addresses = set(tables)

    def lines(self, text: str) -> Iterator[str]:
        """C, a line for each statement."""
        for brace, label, statement in _STATEMENT.findall(text):
            if brace:
                yield brace
            elif label:
                yield f"{_word(label)}:;"
            elif statement.startswith("."):
                yield self._declared(statement)
            else:
                yield self._guarded(re.sub(r"\s+", " ", statement))

    def _declared(self, statement: str) -> str:
        """Declarations of registers, and of room on the stack or for parameters."""
        if match := re.match(r"\.reg\s+\.(\w+)\s+%?([\w$]+)(?:<(\d+)>)?$", statement):
            kind, name, count = match.groups()
            size = _TYPES[kind][1]
            return f"uint{8 * size}_t {_word(name)}{f'[{count}]' if count else ''};"
        if match := _ROOM.match(statement):
            space, kind, name, count = match.groups()
            self.addresses |= {name} if space == "local" else set()
            return f"_Alignas(16) char {_word(name)}[{count or _TYPES[kind][1]}];"
        if statement.startswith((".pragma", ".loc", ".file")):
            return ""
        raise ValueError(f"PTX not known: {statement}")

    def _guarded(self, statement: str) -> str:
        """A statement that a predicate may guard."""
        if match := re.match(r"@(!?)(%p\d+) (.*)", statement):
            return f"if ({match[1]}{self._value(match[2])}) {{ {self._statement(match[3])} }}"
        return self._statement(statement)

    def _statement(self, statement: str) -> str:
        opcode, _, rest = statement.partition(" ")
        name, *marks = opcode.split(".")
        if name == "ret":
            return "return;"
        if name == "bra":
            return f"goto {_word(rest)};"
        if name == "call":
            return self._call(rest)
        operands = [x.strip() for x in rest.split(",")]
        if name in ("ld", "st"):
            place, register = operands[::-1] if name == "ld" else operands
            value = self._value(register)
            size = _TYPES[marks[-1]][1]
            return (f"memcpy(&{value}, {self._place(place)}, {size});" if name == "ld" else
                    f"{{ const uint{8 * size}_t x = (uint{8 * size}_t){value}; "
                    f"memcpy({self._place(place)}, &x, {size}); }}")
        if {"ftz", "approx", "sat", "full"} & set(marks) or (
                marks[-1] in ("f64", "f32") and name in _ROUNDED and "rn" not in marks):
            raise ValueError(f"not rounded to nearest: {statement}")
        target, *given = operands
        return f"{self._value(target)} = {self._expression(name, marks, given)};"

    def _call(self, rest: str) -> str:
        match = re.match(r"(?:\((\w+)\), )?([\w$]+), \(([^)]*)\)$", rest)
        if not match:
            raise ValueError(f"PTX not known: call {rest}")
        returned, name, taken = match.groups()
        passed = ", ".join(filter(None, (returned, *(x.strip() for x in taken.split(",")))))
        return f"{_word(name)}({passed});"

    def _place(self, text: str) -> str:
        """The address in brackets."""
        base, _, offset = text.strip("[]").partition("+")
        start = f"(uintptr_t){self._value(base)}" if base.startswith("%") else _word(base)
        return f"((char *)({start}) + {offset or 0})"

    def _value(self, text: str) -> str:
        """The bits of an operand."""
        if text in _PLACES:
            return _PLACES[text]
        if match := re.match(r"%(\D+)(\d+)$", text):
            return f"{match[1]}[{match[2]}]"
        if match := re.match(r"0[df]([0-9A-Fa-f]+)$", text):
            return f"0x{match[1]}{'ull' if len(match[1]) > 8 else 'u'}"
        if text in self.addresses:
            return f"(uint64_t)(uintptr_t){_word(text)}"
        return f"({text}ll)" if re.match(r"-?\d+$", text) else _word(text.lstrip("%"))

    def _expression(self, name: str, marks: Sequence[str], given: Sequence[str]) -> str:
        """The bits of a result."""
        kind = marks[-1] if marks else ""
        values = [self._value(x) for x in given]
        if name in ("mov", "cvta"):
            return values[0]
        if name == "selp":
            return f"{values[2]} ? {values[0]} : {values[1]}"
        if name == "setp":
            a, b = (_as(kind, x) for x in values)
            return f"{a} {_TESTS[marks[0]]} {b}"
        if name == "cvt":
            return _of(marks[-2], f"({_TYPES[marks[-2]][0]}){_as(kind, values[0])}")
        if name == "bfe":
            return f"({values[0]} >> {values[1]}) & ((1u << {values[2]}) - 1)"
        if name == "shl" or name == "shr":
            return _of(kind, f"{_as(kind, values[0])} {_SIGNS[name]} {values[1]}")
        read = [_as(kind, x) for x in values]
        if name == "mul" and marks[0] in ("wide", "hi"):
            wide = f"{'' if kind.startswith('s') else 'u'}int64_t"
            product = f"(uint64_t)(({wide}){read[0]} * ({wide}){read[1]})"
            return product if marks[0] == "wide" else f"(uint32_t)({product} >> 32)"
        if name == "mad" and marks[0] == "lo":
            return _of(kind, f"{read[0]} * {read[1]} + {read[2]}")
        f = "f" if kind == "f32" else ""
        if name == "fma":
            return _of(kind, f"fma{f}({', '.join(read)})")
        if name in _OF_ONE:
            return _of(kind, _OF_ONE[name].format(read[0], f=f))
        if name in _SIGNS:
            return _of(kind, f"{read[0]} {_SIGNS[name]} {read[1]}")
        raise ValueError(f"PTX not known: {name}.{'.'.join(marks)} {', '.join(given)}")


def _as(kind: str, bits: str) -> str:
    """These bits as a value of a type."""
    return f"as_{kind}({bits})" if kind in ("f64", "f32") else f"({_TYPES[kind][0]}){bits}"


def _of(kind: str, value: str) -> str:
    """The bits of a value."""
    if kind in ("f64", "f32"):
        return f"of_{kind}({value})"
    return f"(uint{8 * _TYPES[kind][1]}_t)({value})"
