"""A C program that compares a scene's functions of many states with those of one, bit for bit.

Rows are allocated one array each and not a number longer than they are, so that sanitizers see what
is read or written beyond them.  A NaN equals any other.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c, scene_c_many, scene_c_tier
from coscrew_codegen.backends.scene.scene_text import c_name, count, many
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature
from coscrew_codegen.program.values.formats import Precision, named
from tests.support.scenes.generated_scenes import BANNER

COUNTS = (0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 70)
"""Numbers of states: for every width one less than it, it, one more; 70 for several blocks."""

_HEAD = """\
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
{include}

static int compared, wrong;
static uint64_t seed = 1;
static uint64_t drawn(void) {{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return seed >> 32;
}}
{memory}
"""

_OF_PRECISION = """
/* An ordinary number, or one that needs more care; of these few. */
static {real} number_{name}(int kind) {{
  static const {real} rare[] = {{0, -0.0{f}, 1e-{tiny}{f}, -1e30{f}, 7e6{f}, 5e3{f},
      ({real})INFINITY, ({real})-INFINITY, ({real})NAN, {least}}};
  const {real} x = ({real})(int)(drawn() & 0xffff) / 16384 - 2;
  if (kind == 'h') return ({real})0.0078125 * (1 + x * x);
  if (kind == 'p') return x * x + ({real})0.125;
  return drawn() % 40 ? x : rare[drawn() % (sizeof rare / sizeof *rare)];
}}

static {real} *rows_{name}(ptrdiff_t n, ptrdiff_t size, ptrdiff_t stride, int kind) {{
  const ptrdiff_t length = !n ? 0 : stride ? (n - 1) * stride + size : size;
  {real} *x = ({real} *)malloc(sizeof *x * (size_t)length + !length);
  for (ptrdiff_t k = 0; k < length; ++k) x[k] = number_{name}(kind);
  return x;
}}

static {real} *copy_{name}(const {real} *from, ptrdiff_t n, ptrdiff_t size, ptrdiff_t stride) {{
  const size_t length = !n ? 0 : (size_t)((n - 1) * stride + size);
  {real} *x = ({real} *)malloc(sizeof *x * length + !length);
  if (length) memcpy(x, from, sizeof *x * length);
  return x;
}}

static void compare_{name}(const char *what, const {real} *a, const {real} *b,
                           ptrdiff_t n, ptrdiff_t size, ptrdiff_t stride) {{
  const ptrdiff_t length = !n ? 0 : (n - 1) * stride + size;
  for (ptrdiff_t k = 0; k < length; ++k) {{
    ++compared;
    if (memcmp(a + k, b + k, sizeof *a) && !(isnan(a[k]) && isnan(b[k])) && ++wrong < 20)
      printf("%s of %d states, number %d: %a, not %a\\n", what, (int)n, (int)k, (double)a[k],
             (double)b[k]);
  }}
}}
"""


@dataclass(frozen=True)
class Compared:
    """Functions to be compared with functions of one state: headers, calls for n states, and
    definitions of malloc and free if they are not C's."""

    include: str
    called: Callable[[Signature, Precision], str]
    memory: str = ""


def written(scene: SceneFunctions, folder: Path) -> tuple[Path, ...]:
    """The program's sources, beside the headers."""
    files = scene_c.files(scene, BANNER) | scene_c_many.files(scene, BANNER)
    for path, content in files.items():
        (folder / path).write_text(content)
    (folder / "lanes.c").write_text(text(scene, _in_lanes(scene, scene.name)))
    return tuple(folder / x for x in ("lanes.c", *sorted(files)) if x.endswith(".c"))


def tier_written(made: SceneTier, folder: Path) -> tuple[Path, ...]:
    """Writes the program of a tier."""
    files = scene_c_tier.files(made, BANNER) | scene_c_many.tier_files(made, BANNER)
    for path, content in files.items():
        (folder / path).write_text(content)
    scene = replace(made.first, precisions=tuple(p.name for p, _ in made.in_precisions))
    (folder / "lanes.c").write_text(text(scene, _in_lanes(scene, made.stem)))
    return tuple(folder / x for x in ("lanes.c", *sorted(files)) if x.endswith(".c"))


def _in_lanes(scene: SceneFunctions, stem: str) -> Compared:
    return Compared(f'#include "{stem}_many.h"', lambda f, p: c_name(many(scene), f.name, p))


def text(scene: SceneFunctions, compared: Compared) -> str:
    """The program; it prints how many numbers were compared, and the first that differ."""
    precisions = named(scene.precisions)
    functions = scene_calls.callables(scene)
    counts = ", ".join(map(str, COUNTS))
    return "\n".join((
        _HEAD.format(include=compared.include, memory=compared.memory),
        *(_OF_PRECISION.format(real=p.c_type, name=p.name, f=p.suffix, tiny=310 if not p.suffix
                               else 40, least="5e-324" if not p.suffix else "1e-45f")
          for p in precisions),
        *(line for p in precisions for f in functions for line in (
            *_function(scene, f, p, compared.called(f, p)),
            *(_run(scene, f, p, compared.called(_of_run(f), p)) if f.moved else ()))),
        "int main(void) {", f"  static const int counts[] = {{{counts}}};",
        "  for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i)",
        "    for (int mode = 0; mode < 4; ++mode) {",
        *(f"      {what}_{c_name(scene, f.name, p)}(counts[i], mode % 2 * 3, mode / 2);"
          for p in precisions for f in functions
          for what in ("test", *(["run"] if f.moved else []))),
        "    }", '  printf("%d\\n", compared);', "  return wrong != 0;", "}", ""))


def _function(scene: SceneFunctions, f: Signature, p: Precision, called: str) -> Iterator[str]:
    """void test_arm_energy(n, gap between rows, whether t, h and p are the same for all states)."""
    name, real, of = c_name(scene, f.name, p), p.c_type, p.name
    both = {x for x, _ in f.inputs} & {x for x, _ in f.outputs}
    sizes = {x: count(shape) for x, shape in (*f.inputs, *f.outputs)}
    yield f"static void test_{name}(ptrdiff_t n, ptrdiff_t gap, int shared) {{"
    yield "  (void)shared;"
    for x, size in sizes.items():
        stride = f"shared ? 0 : {size} + gap" if x in ("t", "h", "p") else f"{size} + gap"
        yield f"  const ptrdiff_t {x}_stride = {stride};"
        yield f"  {real} *{x} = rows_{of}(n, {size}, {x}_stride, '{x[0]}');"
    for x, _ in f.outputs:
        yield f"  {real} *{x}_one = copy_{of}({x}, n, {sizes[x]}, {x}_stride);"
    passed = [*f.inputs, *(x for x in f.outputs if x[0] not in both)]
    outputs = {x for x, _ in f.outputs}
    one = ", ".join(f"{x}{'_one' if x in outputs else ''} + k * {x}_stride" if shape or x in outputs
                    else f"{x}[k * {x}_stride]" for x, shape in passed)
    yield f"  for (ptrdiff_t k = 0; k < n; ++k) {name}({one});"
    order = [x for x, _ in (*f.read, *f.outputs)]
    yield f"  {called}(n, {', '.join(f'{x}, {x}_stride' for x in order)});"
    for x in outputs:
        yield f'  compare_{of}("{name}: {x}", {x}, {x}_one, n, {sizes[x]}, {x}_stride);'
    taken = [x for x, _ in f.read if x not in ("t", "h", "p") and sizes[x] == sizes[order[-1]]]
    if not f.moved and taken and len(f.outputs) == 1:  # in place
        last = order[-1]
        places = [taken[0] if x == last else x for x in order]
        yield f"  {called}(n, {', '.join(f'{x}, {x}_stride' for x in places)});"
        yield (f'  compare_{of}("{name} in place", {taken[0]}, {last}_one, n && !gap ? n : 0, '
               f"{sizes[last]}, {last}_stride);")
    yield from (f"  free({x});" for x in (*sizes, *(f"{x}_one" for x in outputs)))
    yield "}"


def _of_run(step: Signature) -> Signature:
    """The function that takes many such steps."""
    return replace(step, name=step.name.replace("step", "run", 1))


def _run(scene: SceneFunctions, f: Signature, p: Precision, run: str) -> Iterator[str]:
    """void run_arm_step_leapfrog(n, gap between rows, whether p is the same for all states): five
    steps and, of few states, none."""
    name, real, of = c_name(scene, f.name, p), p.c_type, p.name
    arrays = {x: count(shape) for x, shape in f.inputs if shape}
    yield f"static void run_{name}(ptrdiff_t n, ptrdiff_t gap, int shared) {{"
    yield "  const ptrdiff_t steps = n > 1 ? 5 : 0;"
    yield "  const double t = 0.1, h = 0.01;"
    yield "  (void)shared;"
    for x, size in arrays.items():
        stride = f"shared ? 0 : {size} + gap" if x == "p" else f"{size} + gap"
        yield f"  const ptrdiff_t {x}_stride = {stride};"
        yield f"  {real} *{x} = rows_{of}(n, {size}, {x}_stride, '{x}');"
    for x in ("q", "v"):
        yield f"  {real} *{x}_one = copy_{of}({x}, n, {arrays[x]}, {x}_stride);"
    yield "  for (ptrdiff_t step = 0; step < steps; ++step) {"
    yield "    volatile double passed = (double)step * h; /* rounded */"
    yield f"    const {real} now = ({real})(t + passed);"
    yield "    (void)now;"
    given = {"t": "now", "h": f"({real})h", "p": "p + k * p_stride"}
    one = ", ".join(given.get(x, f"{x}_one + k * {x}_stride") for x, _ in f.inputs)
    yield f"    for (ptrdiff_t k = 0; k < n; ++k) {name}({one});"
    yield "  }"
    rows = ", ".join(x if x in ("t", "h") else f"{x}, {x}_stride" for x, _ in f.inputs)
    yield "  (void)t;"
    yield f"  {run}(n, steps, {rows});"
    for x in ("q", "v"):
        yield f'  compare_{of}("run of {name}: {x}", {x}, {x}_one, n, {arrays[x]}, {x}_stride);'
    yield from (f"  free({x});" for x in (*arrays, "q_one", "v_one"))
    yield "}"
