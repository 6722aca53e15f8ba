"""A C program that prints a hash of the bits of each of a scene's functions, and the expected
hashes.

The expected hashes are of the generated Python package, which rounds every operation once on any
machine.  Calls of libm are replaced by stand-ins.  The scene has a free body, a joint, and all
effects that a joint can have, at once.
"""

import functools
from fractions import Fraction
from pathlib import Path
from types import ModuleType

import numpy as np

from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.backends.scene.scene_text import c_name, count
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.mechanism.model import HERE
from tests.support.compiled.bits_program import HEAD, ROWS, hashed, numbers, numbers_and_hashes
from tests.support.scenes.generated_scenes import BANNER, imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Formula, Y, Z, applied, at, chain, inertia, scene

STEPS = 20  # of each integrator, from each of the rows
H = 2.0**-8

_HALF = Fraction(1, 2)
_DAMPING = Parameter("viscous.j1.d", 0, Fraction(2))
_EFFECTS = (
    applied("actuator", "j1", kind="pd", kp=3, kd=2, target=Formula("sin(t)"), limit=5),
    applied("armature", "j1", rotor=1, gear=2), applied("coulomb", "j1", tau_c=2, eps=_HALF),
    applied("stribeck", "j1", tau_c=1, tau_s=2, v_s=_HALF, eps=_HALF),
    applied("limit", "j1", lower=-_HALF, upper=_HALF, k=9, alpha=_HALF),
    applied("spring", "j1", k=7, q0=1), applied("viscous", "j1", d=_DAMPING))


@functools.cache
def functions() -> SceneFunctions:
    """Functions of a free body with another one on a revolute joint."""
    moments = (3, 4, 5, _HALF, Fraction(1, 3), Fraction(-1, 4))
    model = chain((Kind.FREE, Z, HERE, inertia(5, (_HALF, 0, 1), moments)),
                  (Kind.REVOLUTE, Y, at(1, 0, _HALF), inertia(2, (0, _HALF, 1), moments)),
                  name="carrier")
    return derive(scene(model, *_EFFECTS, parameters=(_DAMPING,)))


def source(folder: Path) -> Path:
    """The program, one file beside the scene's own."""
    for path, written in scene_c.files(functions(), BANNER).items():
        (folder / path).write_text(written)
    (folder / "bits.c").write_text(_text())
    return folder / "bits.c"


def _text() -> str:
    called = [(f, p) for p in PRECISIONS for f in scene_calls.callables(functions())]
    name = functions().name
    return "\n".join([
        HEAD, *(f'#include "{name}{p.suffix}.c"' for p in PRECISIONS),
        *map(numbers_and_hashes, PRECISIONS),
        *(_function(f, p) for f, p in called), "int main(void) {",
        *(f"  do_{c_name(functions(), f.name, p)}();" for f, p in called), "  return 0;", "}", ""])


def _function(f: Signature, p: Precision) -> str:
    """void do_carrier_energy(void): all rows."""
    name, real = c_name(functions(), f.name, p), p.c_type
    made = {} if f.moved else {f"out_{x}": shape for x, shape in f.outputs}
    lines = ["uint64_t hash = 14695981039346656037u;"]
    for number, (x, shape) in enumerate(f.inputs):
        lines += [f"static {real} {x}[{ROWS}][{count(shape)}];",
                  *_given(x, number, count(shape), p)]
    lines += [f"static {real} {x}[{ROWS}][{count(shape)}];" for x, shape in made.items()]
    passed = [f"{x}[row]" if shape else f"*{x}[row]" for x, shape in f.inputs]
    call = f"{name}({', '.join((*passed, *(f'{x}[row]' for x in made)))});"
    if f.moved:
        then = " *t[row] += *h[row];" if any(x == "t" for x, _ in f.inputs) else ""
        call = f"for (int step = 0; step < {STEPS}; step++) {{ {call}{then} }}"
    lines += [f"for (int row = 0; row < {ROWS}; row++) {{ {call} }}"]
    hashes = {x: shape for x, shape in f.inputs if x in "qv"} if f.moved else made
    lines += [f"hash = hashed_{p.name}(hash, {x}[0], {count(shape)}, 1, 0);"
              for x, shape in hashes.items()]
    lines += [f'printf("{name} %016llx\\n", (unsigned long long)hash);']
    return "\n".join([f"static NOT_FOLDED void do_{name}(void) {{",
                      *(f"  {line}" for line in lines), "}"])


def _given(name: str, number: int, size: int, p: Precision) -> list[str]:
    """Fills an input: q is near the scene's neutral position; only the sum for it rounds."""
    upper, f = functions().name.upper(), p.suffix
    value, lines = f"number_{p.name}({number}, k, row)", []
    if name in ("q", "p"):
        which = {"q": "NEUTRAL_Q", "p": "DEFAULT_P"}[name]
        lines = [f"static const {p.c_type} first_{name}[] = {upper}_{which}{f.upper()};"]
        value = f"first_{name}[k] + {value} / 16" if name == "q" else f"first_{name}[k]"
    elif name == "h":
        value = f"{H}{f}"
    return [*lines, f"for (int row = 0; row < {ROWS}; row++) {{",
            f"  for (int k = 0; k < {size}; k++) {{ {name}[row][k] = {value}; }}", "}"]


@functools.cache
def wanted(folder: Path) -> list[str]:
    """The lines that it must print."""
    package = imported(functions(), folder)
    modules = {p: getattr(package, p.name) for p in PRECISIONS}
    with np.errstate(all="ignore"):
        return [f"{c_name(functions(), f.name, p)} {_hash(modules[p], f, p):016x}"
                for p in PRECISIONS for f in scene_calls.callables(functions())]


def _hash(module: ModuleType, f: Signature, p: Precision) -> int:
    given = {x: _rows(x, number, shape, p) for number, (x, shape) in enumerate(f.inputs)}
    call = getattr(module, f.name)
    if not f.moved:
        result = call(*given.values())
        result = result if isinstance(result, tuple) else (result,)
    else:
        for _ in range(STEPS):
            given["q"], given["v"] = call(*given.values())
            if "t" in given:
                given["t"] = given["t"] + given["h"]
        result = (given["q"], given["v"])
    assert all(np.isfinite(x).all() for x in result), f.name  # bits of NaN differ
    return hashed(result)


def _rows(name: str, number: int, shape: tuple[int, ...], p: Precision) -> np.ndarray:
    kind = np.dtype(p.numpy_type).type
    result = numbers(p, number, count(shape)).reshape(ROWS, *shape)
    if name == "q":
        return np.array(functions().neutral, kind) + result / kind(16)
    if name == "p":
        return np.broadcast_to(kind([x for _, x in functions().parameters]), result.shape)
    return np.full_like(result, H) if name == "h" else result
