"""A C program that compares functions of many elements with those of one: see many_driver.c.

Knows names and types, but no arithmetic.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path

from coscrew_codegen.backends.c.c_operations import c_type, parameters, returned
from coscrew_codegen.program.values.quantity import Argument
from tests.support.compiled import all_headers
from tests.support.compiled.bits_program import Kernel
from tests.support.compiled.c_harness import (
    C11,
    call_of,
    in_parallel,
    is_array,
    is_struct,
    run,
)

DRIVER = Path(__file__).with_name("many_driver.c")
_HEADER = """\
#include <stddef.h>

enum {{ MOST_ARGUMENTS = {most} }};
typedef void (*Call)(ptrdiff_t n, void *const *p, const ptrdiff_t *planes,
    const ptrdiff_t *strides);
typedef struct {{ int size, read, written; }} Argument;

/* A kernel and its functions of many elements in both layouts: with any strides; with 1 of each
   argument; with 0 of the first, 1 of others. */
typedef struct {{
  const char *name;
  int bytes, count;
  Argument arguments[MOST_ARGUMENTS];
  void (*one)(void *const *p);
  Call calls[2], each[2], first[2];
}} Kernel;

extern const Kernel *const tables[];
extern const int tables_count;
"""


def written(folder: Path, parts: Sequence[Sequence[Kernel]], numbers: bool) -> list[Path]:
    """The program's sources: each part's kernels in a file of its own; called with strides that the
    compiler knows, too, if `numbers`."""
    most = max(len(arguments(k)) for part in parts for k in part)
    (folder / "many.h").write_text(_HEADER.format(most=most))
    (folder / "driver.c").write_text(DRIVER.read_text(encoding="utf-8"), encoding="utf-8")
    tables = "".join(f"extern const Kernel table_{n}[];\n" for n in range(len(parts)))
    names = ", ".join(f"table_{n}" for n in range(len(parts)))
    (folder / "tables.c").write_text(
        f'#include "many.h"\n{tables}const Kernel *const tables[] = {{{names}}};\n'
        f"const int tables_count = {len(parts)};\n")
    for n, part in enumerate(parts):
        (folder / f"part_{n}.c").write_text(_part(part, f"table_{n}", numbers))
    return [folder / "driver.c", folder / "tables.c",
            *(folder / f"part_{n}.c" for n in range(len(parts)))]


def by_family(kernels: Sequence[Kernel]) -> list[list[Kernel]]:
    """Parts that compile alongside each other."""
    families = dict.fromkeys(k.operation.family for k in kernels)
    return [[k for k in kernels if k.operation.family == family] for family in families]


def built(folder: Path, kernels: Sequence[Kernel], numbers: bool,
          command: Sequence[str | Path]) -> Path:
    """The program, compiled by this command."""
    sources = written(folder, by_family(kernels), numbers)
    in_parallel([(*command, *C11, "-I", all_headers.include(), "-c", x, "-o", x.with_suffix(".o"))
                 for x in sources])
    program = folder / "many"
    run((*command, *(x.with_suffix(".o") for x in sources), "-o", program, "-lm"))
    return program


def arguments(kernel: Kernel) -> tuple[Argument, ...]:
    """Arguments in the order of the functions of many elements: the returned value comes last."""
    value = returned(kernel.operation)
    return (*parameters(kernel.operation), *([value] if value else []))


def header(kernel: Kernel) -> str:
    """The name of the header that declares them."""
    return "_".join(filter(None, (kernel.operation.family, kernel.tier, "many")))


def _part(kernels: Sequence[Kernel], table: str, numbers: bool) -> str:
    headers = dict.fromkeys(map(header, kernels))
    texts = [line for n, kernel in enumerate(kernels) for line in _functions(kernel, n, numbers)]
    rows = [_row(kernel, n, numbers) for n, kernel in enumerate(kernels)]
    return "\n".join((*(f"#include <ksl/{x}.h>" for x in headers), '#include "many.h"', *texts,
                      f"const Kernel {table}[];", f"const Kernel {table}[] = {{", *rows,
                      "  {0},", "};", ""))


def _functions(kernel: Kernel, number: int, numbers: bool) -> Iterator[str]:
    values = {a.name: _value(kernel, a, n) for n, a in enumerate(arguments(kernel))}
    call = call_of(kernel.operation, kernel.precision, values, kernel.tier)
    yield f"static void one_{number}(void *const *p) {{ {call} }}"
    count = len(arguments(kernel))
    yield from _calls(kernel, f"calls_{number}", [f"strides[{n}]" for n in range(count)])
    if numbers:
        yield from _calls(kernel, f"each_{number}", ["1"] * count)
        yield from _calls(kernel, f"first_{number}", ["0", *["1"] * (count - 1)])


def _value(kernel: Kernel, a: Argument, number: int) -> str:
    """The element at p[number], in the form that the function of one element takes."""
    kind = c_type(a.quantity, kernel.precision)
    return f"(({kind} *)p[{number}])" if is_array(a) else f"(*({kind} *)p[{number}])"


def _calls(kernel: Kernel, name: str, strides: Sequence[str]) -> Iterator[str]:
    for layout in ("many", "planes"):
        passed = ["n"]
        for n, a in enumerate(arguments(kernel)):
            struct = is_struct(a) and layout == "many"
            kind = c_type(a.quantity, kernel.precision) if struct else kernel.precision.c_type
            passed.append(f"({kind} *)p[{n}]")
            passed += [f"planes[{n}]"] * (layout == "planes" and bool(a.quantity.shape))
            passed.append(strides[n])
        yield (f"static void {name}_{layout}(ptrdiff_t n, void *const *p, const ptrdiff_t *planes, "
               "const ptrdiff_t *strides) {\n  (void)planes; (void)strides;\n"
               f"  {kernel.name}_{layout}({', '.join(passed)});\n}}")


def _row(kernel: Kernel, number: int, numbers: bool) -> str:
    read = {a.name for a in kernel.operation.inputs}
    wrote = {a.name for a in kernel.operation.outputs}
    held = ", ".join(f"{{{a.quantity.size}, {a.name in read:d}, {a.name in wrote:d}}}"
                     for a in arguments(kernel))
    pairs = [f"{{{x}_{number}_many, {x}_{number}_planes}}" if x == "calls" or numbers
             else "{NULL, NULL}" for x in ("calls", "each", "first")]
    return (f'  {{"{kernel.name}", {kernel.precision.bytes}, {len(arguments(kernel))}, {{{held}}}, '
            f"one_{number}, {', '.join(pairs)}}},")
