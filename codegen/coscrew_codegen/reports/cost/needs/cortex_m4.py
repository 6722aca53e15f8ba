"""Functions of scenes on a Cortex-M4F, and on cores without floating point: their results and
instruction counts, under qemu-user.

Programs need no library to start: they make Linux's system calls.  qemu's log lists the
instructions of each block where it is translated, and names the blocks that are executed.  Where
the compiler or qemu is missing, instructions are estimated from the operations of the function's
Program.
"""

import subprocess
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from shutil import which

import numpy as np

from coscrew_codegen.backends.scene.scene_text import outputs, size
from coscrew_codegen.program import Op
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.whole_cost import whole_counts

COMPILER = ("arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16",
            "-mfloat-abi=hard", "-O2")
EMULATOR = "qemu-arm"
WITHOUT_FLOATS = {
    core: (COMPILER[0], f"-mcpu={cpu}", "-mthumb", "-mfloat-abi=soft", "-O2")
    for core, cpu in (("Cortex-M0+", "cortex-m0plus"), ("Cortex-M3", "cortex-m3"))}
"""Compilers for other cores."""
_SINGLE = 1.5
_DOUBLE = {**dict.fromkeys((Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.SQRT, Op.EXACT_ADD, Op.EXACT_SUB,
                            Op.EQUAL, Op.LESS), 55), Op.PRODUCT_ERROR: 750, Op.PRODUCT_REST: 750}
"""Instructions of an operation: in single precision any; in double precision, which is software,
these, others nearly none.  Fitted to counts for 37 functions of arms with 6 and 7 joints in all
tiers, which they meet within 16 percent."""
_START = """
static int number;
int *__errno(void) { return &number; }
static void call_linux(long what, long a, const void *b, long c) {
  register long r7 __asm__("r7") = what, r0 __asm__("r0") = a, r2 __asm__("r2") = c;
  register const void *r1 __asm__("r1") = b;
  __asm__ volatile("svc 0" : "+r"(r0) : "r"(r7), "r"(r1), "r"(r2) : "memory");
}
__attribute__((used)) static void start(const long *stack) { /* argc stands on it */
  for (long k = 0; k < *stack; k++) call();
  call_linux(4, 1, &result, sizeof result);
  call_linux(1, 0, 0, 0);
}
__attribute__((naked)) void _start(void) { __asm__("mov r0, sp\\n\\tb start"); }
"""


class CountError(RuntimeError):
    """The compiler or qemu fails; the message has its first line."""


def missing() -> tuple[str, ...]:
    """The programs that counting needs and that are not installed."""
    return tuple(x for x in (COMPILER[0], EMULATOR) if not which(x))


def built(folder: Path, stem: str, precision: Precision,
          compiler: Sequence[str] = COMPILER) -> Path:
    """The object of a header's functions in one precision, compiled once; its files lie in this
    folder."""
    core = compiler[1].rpartition("=")[2]
    made = folder / f"{stem}_{precision.name}_{core}.o"
    if not made.exists():
        _run((*compiler, "-ffunction-sections", "-c", folder / f"{stem}{precision.suffix}.c", "-o",
              made))
    return made


def counted(made: Path, header: str, function: FunctionProgram, name: str,
            given: Sequence[np.ndarray], precision: Precision,
            compiler: Sequence[str] = COMPILER) -> tuple[int, np.ndarray]:
    """The instructions of a call, the difference between one call and two; and its results.
    `name` is that of the function in this object.  Raises CountError."""
    source, program = made.with_name(f"{name}_on_m4.c"), made.with_name(name)
    source.write_text(_program(function, header, name, given, precision))
    _run((*compiler, "-Wl,--gc-sections", "-nostartfiles", source, made, "-o", program, "-lm"))
    lengths, log = [], made.with_name(f"{name}.log")
    for more in ((), ("again",)):
        result = _run((EMULATOR, "-d", "in_asm,exec,nochain", "-D", log, program, *more))
        with log.open() as lines:
            lengths.append(_executed(lines))
    return lengths[1] - lengths[0], np.frombuffer(result, precision.numpy_type)


def _executed(log: Iterable[str]) -> int:
    """The instructions of a log: of each block as many as were listed before its first line."""
    sizes: dict[str, int] = {}
    times, listed = Counter[str](), 0
    for line in log:
        if line.startswith("0x"):
            listed += 1
        elif line.startswith("Trace"):
            block = line.split(maxsplit=3)[2]
            if listed:
                sizes[block], listed = listed, 0
            times[block] += 1
    return sum(sizes[block] * count for block, count in times.items())


def estimated(function: FunctionProgram, precision: Precision) -> int:
    """The instructions of a call, estimated from the operations, those of elementary functions
    included."""
    in_double = function.program.wide or precision == DOUBLE
    total = sum(count * (_DOUBLE.get(op, 0) if in_double else _SINGLE)
                for op, count in whole_counts(function.program, precision).items())
    if function.plain:  # single precision, computed first
        total += _SINGLE * sum(whole_counts(function.plain, precision).values())
    return round(total)


def _run(command: Sequence[object]) -> bytes:
    words = [*map(str, command)]
    result = subprocess.run(words, capture_output=True)
    if result.returncode:
        lines = result.stderr.decode(errors="replace").strip().splitlines() or ["no message"]
        raise CountError(f"{words[0]} fails: {lines[0]}")
    return result.stdout


def _program(function: FunctionProgram, header: str, name: str, given: Sequence[np.ndarray],
             precision: Precision) -> str:
    """A program that calls the function with one state, and writes its results."""
    kind, suffix = precision.c_type, precision.suffix
    arguments, lines = [], []
    for a, x in zip(function.inputs, given, strict=True):
        numbers = ", ".join(str(y) if isinstance(y, np.integer) else f"{float(y).hex()}{suffix}"
                            for y in np.ravel(x))
        lines.append(f"static volatile {kind} {a.name}_[] = {{{numbers}}};")
        arguments.append(f"({kind} *){a.name}_" if a.quantity.shape else f"{a.name}_[0]")
    members = outputs(function)
    fields = " ".join(f"{kind} {a.name}[{size(a)}];" for a in members)
    returned = not members[0].quantity.shape
    arguments += [f"result.{a.name}" for a in members[returned:]]
    call = f"{name}({', '.join(arguments)});"
    lines += [f"static struct {{ {fields} }} result;",
              "__attribute__((noinline)) static void call(void) { "
              f"{f'result.{members[0].name}[0] = {call}' if returned else call} }}"]
    return "\n".join((f'#include "{header}.h"', *lines, _START))
