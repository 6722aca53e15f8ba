"""KSL's functions: their names and types in C, read from the lists in tests/references."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from coscrew_codegen.program.values.formats import PRECISIONS, SINGLE, Precision

REFERENCES = Path(__file__).parents[2] / "references"
TABLE, NAMES = REFERENCES / "ksl_prototypes.txt", REFERENCES / "ksl_names.txt"
MACRO = "macro"
TYPES = {"V": "vec3", "W": "vec4", "M": "mat3x3", "N": "mat4x4", "D": "SE3", "S": "screw",
         "C": "coscrew", "Q": "quaternion", "J": "inertia", "I": "vec3i", "K": "vec4i"}
STEMS = tuple(TYPES.values())


@dataclass(frozen=True)
class Prototype:
    """A function of KSL's: the header, its name, its return type (MACRO if it is one) and
    parameters."""

    header: str
    name: str
    returned: str
    passed: tuple[str, ...]

    @property
    def pointer(self) -> str:
        """C: the type of a pointer to such a function, called is_NAME."""
        passed = ", ".join(self.passed) or "void"
        return f"{self.returned} (*const is_{self.name})({passed})"


def names() -> dict[str, tuple[str, ...]]:
    """Header → the names that KSL declares in it."""
    parts = NAMES.read_text("utf-8").split("[")[1:]
    return {header: tuple(words) for header, *words in (part.replace("]", "").split()
                                                        for part in parts)}


def prototypes() -> tuple[Prototype, ...]:
    """All functions and macros, each in double, then in single precision."""
    return tuple(prototype for line in TABLE.read_text("utf-8").splitlines()
                 if line and not line.startswith("#") for prototype in _of_line(line))


def _of_line(line: str) -> Iterator[Prototype]:
    header, types, *names = line.split()
    returned, _, passed = types.partition(":")
    for name in names:
        for precision, own in zip(PRECISIONS, _names(name), strict=True):
            if own != "-":
                yield Prototype(header, _prefixed(own), _returned(returned, precision), tuple(
                    _spelled(letter, precision) for letter in passed.split(",") if letter))


def _prefixed(name: str) -> str:
    return name.removeprefix(".") if name.startswith(".") else f"ksl_{name}"


def _names(name: str) -> tuple[str, str]:
    """In double and in single precision."""
    double, slash, single = name.partition("/")
    if slash:
        return double, single
    head, underscore, tail = double.partition("_")
    return double, f"{head}f{underscore}{tail}" if head in STEMS else f"{double}f"


def _type(letter: str, precision: Precision) -> str:
    stem = TYPES[letter]
    return f"ksl_{stem}_t" if stem.endswith("i") else f"ksl_{stem}{precision.suffix}_t"


def _returned(letter: str, precision: Precision) -> str:
    real = {"": "void", "m": MACRO, "a": precision.c_type, "i": "int", "b": "bool",
            "e": "ksl_axis_enum_t"}
    return real.get(letter) or _type(letter[0], precision) + {"=": "", "*": " *"}[letter[1]]


def _spelled(letter: str, precision: Precision) -> str:
    real = precision.c_type
    plain = {"a": real, "a!": f"{real} *", "A": f"const {real} *", "p": f"const {real} [2]",
             "p!": f"{real} [2]", "i": "int", "i!": "int *",
             "iA": "const int *", "e": "ksl_axis_enum_t", "...": "..."}
    if letter in plain:
        return plain[letter]
    letter, single, mark = letter[0], letter[1:2] == "f", letter[1:].lstrip("f")
    kind = _type(letter, SINGLE if single else precision)
    return {"": f"const {kind} *", "!": f"{kind} *", "=": kind}[mark]
