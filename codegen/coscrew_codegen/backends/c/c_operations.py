"""The C target: functions, comments and names of both precisions.

Results are stored last: outputs may alias inputs.
"""

import re

from coscrew_codegen.accuracy import bounds
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_function import CFunction, FunctionBody, Stored, documented
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.program import Program, renamed
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument, Quantity, in_words
from coscrew_codegen.program.whole_cost import whole_cost

STRUCTS = ("vec3", "vec4", "mat3x3", "mat4x4", "SE3", "screw", "coscrew", "mat6x6", "quaternion",
           "inertia", "spatial_inertia")

# Conversions name two types; in single precision both get an f.
_CONVERSION = re.compile(r"_(from|to)(SE3|Mat4x4)")

_MEMBERS = {
    "vec3": tuple("xyz"), "vec4": tuple("xyzw"), "quaternion": tuple("xyzw"),
    "inertia": ("m", "mt.x", "mt.y", "mt.z", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Izx"),
    "spatial_inertia": ("m", "h.x", "h.y", "h.z", "xx", "yy", "zz", "xy", "xz", "yz"),
}

def c_type(quantity: Quantity, precision: Precision) -> str:
    """The type of one value: ksl_SE3f_t, double."""
    return type_name(quantity.name, precision) if quantity.name in STRUCTS else precision.c_type


def type_name(name: str, precision: Precision) -> str:
    """ksl_SE3_t, ksl_SE3f_t."""
    return f"ksl_{name}{precision.suffix}_t"


def c_name(name: str, precision: Precision) -> str:
    """The function's C name.

    Single precision adds an f to the type that the name starts with (ksl_coscrewf_copy) and to one
    that it ends in (ksl_mat4x4f_toSE3f), else to the name (ksl_product_CoAdcf).  Products of
    quaternions lose their prefix in single precision, as in KSL (ksl_quaternion_product_qq,
    ksl_product_qqf)."""
    if name.startswith("quaternion_product_") and precision.suffix:
        name = name.removeprefix("quaternion_")
    if kind := next((kind for kind in STRUCTS if f"{name}_".startswith(f"{kind}_")), ""):
        tail = name.removeprefix(kind)
        tail += precision.suffix if _CONVERSION.fullmatch(tail) else ""
        return f"ksl_{kind}{precision.suffix}{tail}"
    return f"ksl_{name}{precision.suffix}"


def member(quantity: Quantity, index: int) -> str:
    """Returns what C writes after a value's name for component `index` (row by row)."""
    row, column = quantity.indices[index]
    if quantity.name in _MEMBERS:
        return f".{_MEMBERS[quantity.name][row]}"
    if quantity.name in ("screw", "coscrew"):
        return f".m{row}"
    if quantity.name in ("mat3x3", "mat4x4", "SE3"):
        return f".m{row}{column}"
    if quantity.name == "mat6x6":
        return f".at[{column}][{row}]"
    return f"[{index}]" if quantity.shape else ""


def returned(operation: Operation) -> Argument | None:
    """The output that C returns, if there is one."""
    first = operation.outputs[0]
    return first if operation.by_value or first.quantity == SCALAR else None


def parameters(operation: Operation) -> tuple[Argument, ...]:
    """The C parameters, in order."""
    arguments = {a.name: a for a in (*operation.inputs, *operation.outputs)}
    value = returned(operation)
    names = operation.order or [n for n in arguments if value is None or n != value.name]
    return tuple(arguments[name] for name in names)


def is_pointer(operation: Operation, argument: Argument) -> bool:
    """Returns whether C passes the argument's address: true of structs, and of numbers that are
    outputs."""
    if argument.quantity.name in STRUCTS:
        return not operation.by_value or argument in operation.outputs[1:]
    return not argument.quantity.shape and argument in operation.outputs


def prototype(operation: Operation, precision: Precision, tier: str = "") -> str:
    """'void ksl_product_Ads(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so)', with the
    suffix `_tier` if there is a tier."""
    value = returned(operation)
    kind = c_type(value.quantity, precision) if value else "void"
    name = c_name(operation.name, precision) + (f"_{tier}" if tier else "")
    declared = [_declared(operation, a, precision) for a in parameters(operation)]
    return listed(f"{kind} {name}(", declared, ")", WIDTH - 16)


def _declared(operation: Operation, argument: Argument, precision: Precision) -> str:
    const = "" if argument.name in {a.name for a in operation.outputs} else "const "
    star = "*" if is_pointer(operation, argument) else ""
    array = argument.quantity.shape and argument.quantity.name not in STRUCTS
    size = f"[{argument.quantity.size}]" if array else ""
    return f"{const}{c_type(argument.quantity, precision)} {star}{argument.name}{size}"


def function(operation: Operation, program: Program, precision: Precision,
             tier: str = "") -> CFunction:
    """The operation as a C function, with the suffix `_tier` if there is a tier."""
    return _Writer(operation, program, precision, tier).function()


class _Writer:
    """Writes one function of the library; structs are passed by address, numbers by value."""

    def __init__(self, operation: Operation, program: Program, precision: Precision, tier: str):
        self.operation, self.precision, self.tier = operation, precision, tier
        parameter = {a.name for a in parameters(operation)}
        names = {step.name: f"{step.name}_" if step.name in parameter else step.name
                 for step in program.instructions}
        self.program = renamed(program, names) if parameter & names.keys() else program

    def function(self) -> CFunction:
        name = c_name(self.operation.name, self.precision) + (f"_{self.tier}" if self.tier else "")
        return documented(name, self._words(), prototype(self.operation, self.precision, self.tier),
                          FunctionBody(self.program, self.precision, self._stored()))

    def _words(self) -> list[str]:
        remark = f"  {self.operation.remark}" if self.operation.remark else ""
        return [f"{self.operation.statement}.{remark}",
                f"{in_words(parameters(self.operation))}.",
                f"{whole_cost(self.program, self.precision).capitalize()}.",
                bounds.in_words(self.program) or self.operation.tested_bounds]

    def _stored(self) -> Stored:
        value, outputs = returned(self.operation), self.operation.outputs
        targets = [self._access(a, i) for a in outputs for i in range(a.quantity.size)]
        struct = c_type(value.quantity, self.precision) if value and value.quantity.shape else ""
        return Stored(lambda x: self._access(self.program.inputs[x.argument], x.index), targets,
                      {a.name for a in outputs}, value.name if value else "", struct)

    def _access(self, argument: Argument, index: int) -> str:
        path = member(argument.quantity, index)
        if not is_pointer(self.operation, argument):
            return argument.name + path
        return argument.name + path.replace(".", "->", 1) if path else f"*{argument.name}"
