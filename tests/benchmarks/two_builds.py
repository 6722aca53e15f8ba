"""Times every gufunc of two builds of the extension modules against each other.

    .venv/bin/python -m tests.benchmarks.two_builds OLD NEW

OLD and NEW are folders with `_gufunc.*.so`, `accurate/_gufunc.*.so`, `certified/_gufunc.*.so`, as
in generated/python/coscrew.  Both modules run in one process, in turn, on the same arrays; a case
counts as the ratio of its least times, new/old.  Their results are compared bit by bit.
"""

import argparse
import time
from collections.abc import Callable, Iterator
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType

import numpy as np

COUNTS = (1_000, 100_000)
LAYOUTS = ("dense", "one first operand", "every second element", "transposed")
REPEATS = {1_000: 15, 100_000: 4}


def modules(folder: Path, name: str) -> dict[str, ModuleType]:
    """The extension modules of a build, by tier."""
    results = {}
    for tier in ("", "accurate", "certified"):
        path, = (x for x in (folder / tier).glob("_gufunc.*") if x.name.endswith(
            tuple(EXTENSION_SUFFIXES)))
        loader = ExtensionFileLoader(f"{name}{tier}._gufunc", str(path))
        spec = spec_from_loader(loader.name, loader)
        assert spec
        results[tier or "plain"] = module_from_spec(spec)
        loader.exec_module(results[tier or "plain"])
    return results


def arrays(ufunc: np.ufunc, count: int, kind: type, layout: str, random: np.random.Generator
           ) -> Iterator[np.ndarray]:
    """Inputs, then outputs, so laid out."""
    signature = ufunc.signature or ",".join(["()"] * ufunc.nargs)  # None of scalars
    shapes = [tuple(int(x) for x in part.strip("()").split(",") if x)
              for side in signature.split("->") for part in side.split("),(")]
    for number, shape in enumerate(shapes):
        step = 2 if layout == "every second element" else 1
        rows = 1 if layout == "one first operand" and number == 0 else count
        if layout == "transposed" and len(shape) == 2:
            made = random.normal(size=(rows, *shape[::-1])).astype(kind).swapaxes(-1, -2)
        else:
            made = random.normal(size=(rows * step, *shape)).astype(kind)[::step]
        yield made[0] if rows < count else made


def best(calls: tuple[Callable[[], object], ...], repeats: int) -> list[float]:
    """The least time of each, called in turn."""
    least = [np.inf] * len(calls)
    for _ in range(repeats):
        for k, call in enumerate(calls):
            start = time.perf_counter()
            call()
            least[k] = min(least[k], time.perf_counter() - start)
    return least


def compared(old: np.ufunc, new: np.ufunc, count: int, kind: type, layout: str) -> float | None:
    """The ratio of times; None if the layout does not apply.  The results have the same bits."""
    if layout == "one first operand" and old.nin < 2:
        return None
    given = list(arrays(old, count, kind, layout, np.random.default_rng(1)))
    if layout == "transposed" and all(x.ndim < 3 for x in given):
        return None
    inputs, outputs = given[:old.nin], tuple(given[old.nin:])
    results = [f(*inputs) for f in (old, new)]
    for x, y in zip(*(r if isinstance(r, tuple) else (r,) for r in results), strict=True):
        same = np.where(np.isnan(x), 0, x).tobytes() == np.where(np.isnan(y), 0, y).tobytes()
        assert same and (np.isnan(x) == np.isnan(y)).all(), (old.__name__, kind, layout)
    before, after = best((lambda: old(*inputs, out=outputs), lambda: new(*inputs, out=outputs)),
                         REPEATS[count])
    return after / before


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--every", type=int, default=1, help="only every so many gufuncs")
    options = parser.parse_args()
    olds, news = modules(options.old, "old"), modules(options.new, "new")
    print(f"{'tier':10}{'layout':22}{'elements':>9}{'cases':>7}{'median':>8}{'90 %':>7}  worst")
    with np.errstate(all="ignore"):
        for tier, layout, count in ((t, x, n) for t in olds for x in LAYOUTS for n in COUNTS):
            names = [x for x in dir(olds[tier]) if isinstance(getattr(olds[tier], x), np.ufunc)]
            taken = [x for x in names if f"unchecked_{x}" not in names][::options.every]
            ratios = {f"{name} {kind.__name__}": ratio for name in taken
                      for kind in (np.float64, np.float32) if (ratio := compared(
                          getattr(olds[tier], name), getattr(news[tier], name), count, kind,
                          layout)) is not None}
            worst = max(ratios, key=lambda x: ratios[x])
            median, high = np.quantile(list(ratios.values()), (0.5, 0.9))
            print(f"{tier:10}{layout:22}{count:9}{len(ratios):7}{median:8.2f}{high:7.2f}  "
                  f"{ratios[worst]:.2f} {worst}", flush=True)


if __name__ == "__main__":
    main()
