"""Writes a C program that calls every function of the headers, alone and with aliased arguments.

Aliased: an output is the same object as an input, or one is a part of the other (&D.t, &s.lin).
The program compares each aliased result with that of the same values in separate objects, byte by
byte, names those that differ, and returns 0 if none does.  Knows types and layouts, but no
arithmetic.
"""

from collections.abc import Iterator
from itertools import permutations

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.backends.c.c_operations import c_type, parameters
from coscrew_codegen.backends.c.c_storage import TYPES
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import (
    INERTIA,
    MAT3X3,
    MAT4X4,
    MAT6X6,
    SE3,
    Argument,
    Quantity,
)
from tests.support.compiled.c_harness import call_of, distinct, is_array
from tests.support.truth.attack import plain_program

# Where a quantity can lie inside another: whole → part → C members.
PLACES: dict[str, dict[str, tuple[str, ...]]] = {
    "SE3": {"mat3x3": ("R",), "vec3": ("t", "v1")},
    "mat3x3": {"vec3": ("v0", "v2"), "dc": ("at[1]",)},
    "mat4x4": {"vec4": ("v1",), "vec3": ("v3.r",)}, "vec4": {"vec3": ("r",)},
    "screw": {"vec3": ("lin", "ang"), "angular_first": ("at",)},
    "coscrew": {"vec3": ("lin", "ang"), "angular_first": ("at",)},
}

_HEAD = "".join(f"#include <ksl/{tier.umbrella}.h>\n" for tier in TIERS) + """\
#include <limits.h>
#include <stdio.h>

static int failures;

static void hold(int right, const char *what) {{
  if (!right) {{
    failures++;
    fprintf(stderr, "%s\\n", what);
  }}
}}

static void same(const void *a, const void *b, size_t bytes, const char *what) {{
  hold(memcmp(a, b, bytes) == 0, what);
}}

/* count numbers of modest size, others at each call. */
static void fill(void *to, size_t count) {{
  static unsigned seed = 1;
  {real} *x = ({real} *)to;
  for (size_t i = 0; i < count; i++) {{
    seed = seed * 1664525u + 1013904223u;
    x[i] = ({real})((int)(seed >> 16) - 32768) / 4096;
  }}
}}

static const int indices[] = {{INT_MIN, -1, 0, 1, 2, 3, 4, 5, 6, INT_MAX}};
"""

_MAIN = """
int main(void) {
  for (size_t i = 0; i < sizeof tests / sizeof *tests; i++) { tests[i](); }
  return failures != 0;
}
"""

# An entry inside is set in its place, column by column; outside, get returns NaN, set does nothing.
_ELEMENTS = """\
{kind} x, before;
fill(&x, {size});
for (size_t i = 0; i < sizeof indices / sizeof *indices; i++) {{
  for (size_t j = 0; j < sizeof indices / sizeof *indices; j++) {{
    const int row = indices[i], column = indices[j];
    before = x;
    {stem}_set(&x, row, column, 7);
    if (row >= 0 && row < {rows} && column >= 0 && column < {columns}) {{
      before.as_array[column * {rows} + row] = 7;
      hold({stem}_get(&x, row, column) == 7, "{stem}_get inside");
    }} else {{
      hold(isnan({stem}_get(&x, row, column)), "{stem}_get outside");
    }}
    same(&x, &before, sizeof x, "{stem}_set");
  }}
}}"""

_ALLOCATION = """\
{kind} wanted[3], *x = {stem}_alloc(3);
hold(x != NULL, "{stem}_alloc(3)");
memset(wanted, 0, sizeof wanted);
for (size_t i = 0; i < 3; i++) {{ {ones} }}
same(x, wanted, sizeof wanted, "{stem}_alloc holds {holding}");
fill(x, 3 * {size});
free(x);
hold({stem}_alloc(0) == NULL, "{stem}_alloc(0)");
hold({stem}_alloc(-1) == NULL, "{stem}_alloc(-1)");"""

# KSL's allocators return identities of these types, whose ones are here; zeros of all others.
_UNITY = {"mat3x3": (0, 4, 8), "mat4x4": (0, 5, 10, 15), "SE3": (0, 4, 8), "quaternion": (3,)}


def program(precision: Precision, tier: str = "") -> str:
    """The program for one precision: plain kernels and storage, or the kernels of a tier."""
    made = next(t for t in TIERS if t.mark == tier)
    operations = [made.operation(op) for op in OPERATIONS if made.has(plain_program(op))]
    tests = [(op.name, lines) for op in operations
             for lines in (_alone(op, precision, tier), *_aliased(op, precision, tier))]
    tests += [] if tier else _storage(precision)
    functions, names = [], []
    for number, (name, lines) in enumerate(tests):
        body = "\n".join(f"  {line}" for text in lines for line in text.splitlines())
        functions.append(f"static void {name}_{number}(void) {{\n{body}\n}}\n")
        names.append(f"  {name}_{number},")
    # Called through pointers: inlined into one main, they took clang four times as long.
    return "\n".join([_HEAD.format(real=precision.c_type), *functions,
                      "static void (*const tests[])(void) = {", *names, "};", _MAIN])


def _alone(operation: Operation, precision: Precision, tier: str) -> list[str]:
    """A test: one call with separate objects."""
    arguments = distinct(operation)
    return [*_objects(arguments, precision),
            call_of(operation, precision, {a.name: a.name for a in arguments}, tier)]


def _aliased(operation: Operation, precision: Precision, tier: str) -> Iterator[list[str]]:
    """Tests: each pair of an output and another argument in each way they can overlap; then, for
    each output, all arguments in it at once."""
    if operation.by_value:
        return
    outputs = {a.name for a in operation.outputs}
    passed = [a for a in parameters(operation) if a.quantity.shape]
    may_be_one = operation.name.endswith("_swap")  # others' outputs differ
    for whole, part in permutations(passed, 2):
        if outputs >= {whole.name, part.name} and not may_be_one:
            continue
        if whole.name in outputs or part.name in outputs and whole.quantity != part.quantity:
            for place in _places(whole.quantity, part.quantity):
                yield _shared(operation, precision, tier, whole, {part: place})
    for whole in operation.outputs:
        within = {a: _places(whole.quantity, a.quantity)[0] for a in passed
                  if a != whole and _places(whole.quantity, a.quantity)
                  and (may_be_one or a not in operation.outputs)}
        if len(within) > 1:
            yield _shared(operation, precision, tier, whole, within)


def _places(whole: Quantity, part: Quantity) -> tuple[str, ...]:
    """C expressions for a `part` inside a `whole`: the whole itself, or these members."""
    if whole == part:
        return ("",)
    return tuple(f".{member}" for member in PLACES.get(whole.name, {}).get(part.name, ()))


def _shared(operation: Operation, precision: Precision, tier: str, whole: Argument,
            parts: dict[Argument, str]) -> list[str]:
    """`whole` and, inside it, `parts`: once as objects of their own, once as one, `shared`."""
    arguments = distinct(operation)
    alone = {a.name: a.name for a in arguments}
    shared = alone | {whole.name: "shared"} | {a.name: f"shared{at}" for a, at in parts.items()}
    results = {a: at for a, at in parts.items() if a in operation.outputs}
    updated = [a for a in operation.inputs  # by both calls
               if a in operation.outputs and a not in (whole, *parts)]
    what = ", ".join(f"{a.name} is {whole.name}{at}" for a, at in parts.items())
    return [
        *_objects(arguments, precision),
        *(f"memcpy(&{a.name}, &{whole.name}{at}, sizeof {a.name});" for a, at in parts.items()),
        f"{c_type(whole.quantity, precision)} shared{_size(whole)};",
        f"memcpy(&shared, &{whole.name}, sizeof shared);",
        *(f"{c_type(a.quantity, precision)} {a.name}_before = {a.name};" for a in updated),
        call_of(operation, precision, shared, tier),
        *(f"{a.name} = {a.name}_before;" for a in updated),
        call_of(operation, precision, alone, tier),
        *(f"memcpy(&{whole.name}{at}, &{a.name}, sizeof {a.name});" for a, at in results.items()),
        f'same(&shared, &{whole.name}, sizeof shared, "{operation.name}: {what}");',
    ]


def _objects(arguments: tuple[Argument, ...], precision: Precision) -> list[str]:
    return [f"{c_type(a.quantity, precision)} {a.name}{_size(a)}; "
            f"fill(&{a.name}, {a.quantity.size});" for a in arguments]


def _size(argument: Argument) -> str:
    return f"[{argument.quantity.size}]" if is_array(argument) else ""


def _storage(precision: Precision) -> Iterator[tuple[str, list[str]]]:
    """Tests of functions that only move numbers: constructors, get and set, alloc."""
    for quantity in TYPES:
        stem = f"ksl_{quantity.name}{precision.suffix}"
        rows, columns = quantity.rows_columns
        about = {"kind": f"{stem}_t", "stem": stem, "size": quantity.size, "rows": rows,
                 "columns": columns}
        by_rows = [column * rows + row for row, column in quantity.indices]
        array = "as_array" if columns > 1 else "at"
        if quantity not in (INERTIA, MAT6X6):  # inertia's constructor is an operation
            yield f"{stem}_by_rows", _constructed(stem, stem, by_rows, array)
        if quantity in (MAT3X3, MAT4X4, SE3):
            yield f"{stem}_by_columns", _constructed(stem, f"{stem}_cmo", sorted(by_rows), array)
        if quantity == SE3:
            yield f"{stem}_identity_is_one", [
                f"const {stem}_t x = {stem}_identity();",
                f"static const {stem}_t one = {{{{{{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}}}}}};",
                f'same(&x, &one, sizeof x, "{stem}_identity");']
        if columns > 1:
            yield f"{stem}_elements", [_ELEMENTS.format(**about)]
        places = _UNITY.get(quantity.name, ())
        yield f"{stem}_allocated", [_ALLOCATION.format(
            ones=" ".join(f"wanted[i].{array}[{place}] = 1;" for place in places),
            holding="identities" if places else "zeros", **about)]


def _constructed(stem: str, function: str, places: list[int], array: str) -> list[str]:
    """Argument number k + 1 of the constructor is found at places[k]."""
    numbers = ", ".join(str(k + 1) for k in range(len(places)))
    return [f"const {stem}_t x = {function}({numbers});",
            *(f'hold(x.{array}[{place}] == {k + 1}, "{function}: argument {k + 1}");'
              for k, place in enumerate(places))]
