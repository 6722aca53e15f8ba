"""The class of the numbers with which CUDA computes: its operations as instructions of PTX."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.program.values.formats import DOUBLE, Precision, on_device

_REGISTERS = {"double": ("f64", "d", "b64", "l"), "single": ("f32", "f", "b32", "r")}
"""By precision, its type and the constraint of its registers; the same of bits."""
_ERRORS = {"product_error": ("a", "b", "p"), "product_rest": ("a", "b", "p", "h")}


@dataclass(frozen=True)
class CudaOperation:
    """A function that is one instruction on the device; `host` is its result elsewhere."""

    head: str
    declared: str  # x, in which the instruction leaves its result
    instruction: str
    operands: str
    host: str
    result: str = "x"


@dataclass(frozen=True)
class CudaNumber:
    """The class for a precision."""

    precision: Precision
    exact: bool = False  # whether rounding errors of products are computed

    @property
    def name(self) -> str:
        """ksl_number, ksl_numberf."""
        return on_device(self.precision).c_type

    @property
    def move(self) -> str:
        """The instruction between numbers and bits."""
        return f"mov.{_REGISTERS[self.precision.name][2]}"

    @property
    def bits_of(self) -> str:
        """Its operands for the bits of x."""
        _, number, _, bits = _REGISTERS[self.precision.name]
        return f'"={bits}"(bits) : "{number}"(x.value)'

    @property
    def of_bits(self) -> str:
        """Its operands for the number x of these bits."""
        _, number, _, bits = _REGISTERS[self.precision.name]
        return f'"={number}"(x) : "{bits}"(bits)'

    @property
    def sign(self) -> str:
        """The bit of the sign."""
        return hex(1 << 8 * self.precision.bytes - 1)

    @property
    def conversions(self) -> list[CudaOperation]:
        """Conversions from and to double, in which other programs compute."""
        if self.precision == DOUBLE:
            return []
        wide = on_device(DOUBLE).c_type
        return [CudaOperation(f"float ksl_narrowed(const {wide} a)", "float x",
                              "cvt.rn.f32.f64 %0, %1;", _operands("f", "d", "a.value"),
                              "static_cast<float>(a.value)"),
                CudaOperation(f"{wide} ksl_widened(const float a)", "double x",
                              "cvt.f64.f32 %0, %1;", _operands("d", "f", "a"),
                              "static_cast<double>(a)")]

    @property
    def operations(self) -> list[CudaOperation]:
        """Arithmetic and comparisons."""
        f, host = self.precision.suffix, "a.value {} b.value"
        products = {"*": f"ksl_hidden{f}({host})"}
        return [*(self._operation(f"operator{sign}", f"{name} %0, %1, %2;", ("a", "b"),
                                  products.get(sign, host).format(sign))
                  for sign, name in (("+", "add.rn"), ("-", "sub.rn"), ("*", "mul.rn"),
                                     ("/", "div.rn"))),
                self._operation("operator-", "neg %0, %1;", ("a",), "-a.value"),
                self._operation(f"ksl_abs_device{f}", "abs %0, %1;", ("a",), f"fabs{f}(a.value)"),
                self._operation(f"ksl_sqrt_device{f}", "sqrt.rn %0, %1;", ("a",),
                                f"sqrt{f}(a.value)"),
                *(self._comparison(sign, test)
                  for sign, test in (("<", "lt"), (">", "gt"), ("==", "eq")))]

    @property
    def errors(self) -> list[CudaOperation]:
        """a b less the last argument, rounded once, if it is computed."""
        kind, register, _, _ = _REGISTERS[self.precision.name]
        return [CudaOperation(
            f"{self.name} ksl_{name}_device{self.precision.suffix}({self._parameters(taken)})",
            f"{self.precision.c_type} x",
            f"{{ .reg .{kind} c; neg.{kind} c, %3; fma.rn.{kind} %0, %1, %2, c; }}",
            _operands(register, register, "a.value", "b.value", f"{taken[-1]}.value"),
            f"ksl_{name}{self.precision.suffix}({', '.join(f'{x}.value' for x in taken)})")
            for name, taken in _ERRORS.items() if self.exact]

    def _parameters(self, names: Sequence[str]) -> str:
        return ", ".join(f"const {self.name} {x}" for x in names)

    def _operation(self, name: str, instruction: str, taken: Sequence[str], host: str
                   ) -> CudaOperation:
        kind, register, _, _ = _REGISTERS[self.precision.name]
        opcode, _, rest = instruction.partition(" ")
        return CudaOperation(
            f"{self.name} {name}({self._parameters(taken)})", f"{self.precision.c_type} x",
            f"{opcode}.{kind} {rest}",
            _operands(register, register, *(f"{x}.value" for x in taken)), host)

    def _comparison(self, sign: str, test: str) -> CudaOperation:
        kind, register, _, _ = _REGISTERS[self.precision.name]
        return CudaOperation(
            f"bool operator{sign}({self._parameters(('a', 'b'))})", "int x",
            f"{{ .reg .pred p; setp.{test}.{kind} p, %1, %2; selp.s32 %0, 1, 0, p; }}",
            _operands("r", register, "a.value", "b.value"), f"a.value {sign} b.value", "x != 0")


def _operands(result: str, register: str, *values: str) -> str:
    """Constraints: the result x, then the operands read."""
    return f'"={result}"(x) : ' + ", ".join(f'"{register}"({x})' for x in values)
