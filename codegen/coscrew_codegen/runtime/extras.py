"""The packages that a command needs besides NumPy, and the extra that installs them."""

from importlib.util import find_spec

GENERATOR = ("sympy", "jinja2", "tqdm", "mpmath", "defusedxml")
EXTRAS = {"codegen": GENERATOR,
          "simulate": (*GENERATOR, "scipy", "gmpy2", "matplotlib", "tabulate"),
          "report": (*GENERATOR, "gmpy2", "matplotlib", "tabulate"),
          "sweep": (*GENERATOR, "scipy", "gmpy2", "matplotlib", "tabulate", "pyarrow", "dask",
                    "distributed", "zarr", "xarray", "pandas")}
"""Modules by extra; `simulate` also installs pyarrow and Pillow, which only .parquet files and
images of heights need."""

COMMANDS = {"generate": "codegen", "certificate": "codegen", "import": "codegen",
            "effects": "codegen", "schema": "codegen", "simulate": "simulate", "check": "simulate",
            "identify": "simulate", "cache": "simulate", "cost": "simulate", "report": "report",
            "sweep": "sweep"}
"""The extra of each command."""


def lacking(what: str, extra: str) -> str | None:
    """The message if packages of an extra are not installed, else None: "simulate needs scipy; run
    `pip install "coscrew[simulate]"`"."""
    missing = [name for name in EXTRAS[extra] if not _installed(name)]
    if not missing:
        return None
    return f'{what} needs {", ".join(missing)}; run `{pip(extra)}`'


def pip(extra: str) -> str:
    """The command that installs an extra."""
    return f'pip install "coscrew[{extra}]"'


def _installed(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except (ImportError, ValueError):
        return False
