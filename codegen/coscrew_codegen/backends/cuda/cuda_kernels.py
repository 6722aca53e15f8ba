"""The functions of a CUDA header that programs call: of one state, of n states, and runs.

Knows names, types and strides; no arithmetic.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.python_extension.scene_calls import callables
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene.scene_text import c_name, count, marked
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature
from coscrew_codegen.program.values.formats import DOUBLE, Precision, on_device


@dataclass(frozen=True)
class Taken:
    """An argument: of one state, and of n states."""

    name: str
    type: str
    size: int
    const: str = ""  # "const " if it is only read
    value: bool = False  # whether one state's is passed by value

    @property
    def one(self) -> str:
        """The parameter for one state."""
        return f"{self.type} {self.name}" if self.value else f"{self.const}{self.type} *{self.name}"

    @property
    def several(self) -> str:
        """The parameters for n states."""
        return f"{self.const}{self.type} *{self.name}, ptrdiff_t {self.name}_stride"

    @property
    def at(self) -> str:
        """Text that is passed for state k."""
        return (f"{self.name}[k * {self.name}_stride]" if self.value
                else f"{self.name} + k * {self.name}_stride")

    @property
    def number(self) -> str:
        """Text that is passed to a function on numbers of the class."""
        return self.name if self.value else f"ksl_numbers({self.name})"


@dataclass(frozen=True)
class CudaKernel:
    """A function of one state and its kernel; names are given by their endings; `shared` are types
    and names of arguments that all states share."""

    scene: SceneFunctions
    name: str
    precision: Precision
    words: str
    shared: Sequence[tuple[str, str]]
    taken: Sequence[Taken]
    body: str  # of the function of one state

    def _name(self, what: str) -> str:
        return c_name_of(self.scene, self.name, self.precision, what)

    @property
    def comment(self) -> str:
        """Comment above the kernels."""
        return comment_of([self.words])

    @property
    def device(self) -> str:
        """The head of the function of one state."""
        return arguments.head(self._name("device"), [
            *map(" ".join, self.shared), *(x.one for x in self.taken)], "KSL_FUNCTION")

    @property
    def kernel(self) -> str:
        """The head of the kernel."""
        return arguments.head(self._name("kernel"), self._parameters, "KSL_KERNEL")

    @property
    def each(self) -> str:
        """The call for state k."""
        passed = [*(name for _, name in self.shared), *(x.at for x in self.taken)]
        return listed(f"{self._name('device')}(", passed, ");", WIDTH - 8).replace("\n", "\n    ")

    @property
    def launch(self) -> str:
        """The head of the function that starts the kernel."""
        return listed(f"static inline KSL_UNUSED cudaError_t {self._name('launch')}(",
                      [*self._parameters, "cudaStream_t stream = 0"], ")", WIDTH - 2)

    @property
    def started(self) -> str:
        """The start of the kernel."""
        passed = ["n", *(name for _, name in self.shared),
                  *(f"{x.name}, {x.name}_stride" for x in self.taken)]
        return listed(f"{self._name('kernel')}<<<ksl_blocks(n), KSL_BLOCK, 0, stream>>>(", passed,
                      ");", WIDTH - 4).replace("\n", "\n  ")

    @property
    def _parameters(self) -> list[str]:
        return ["ptrdiff_t n", *map(" ".join, self.shared), *(x.several for x in self.taken)]


def c_name_of(scene: SceneFunctions, name: str, precision: Precision, what: str) -> str:
    """arm_energy_device, arm_energy_accurate_kernelf."""
    return f"{scene.name}_{name}_{marked(scene.mark, what)}{precision.suffix}"


def kernels(scene: SceneFunctions, on_numbers: SceneFunctions, precision: Precision
            ) -> Iterator[CudaKernel]:
    """Yields the kernels of all public functions; steps have runs, too."""
    for function in callables(scene):
        name = c_name(scene, function.name, precision)
        called = c_name(on_numbers, function.name, precision)
        taken = _taken(function, precision)
        body = listed(f"  {called}(", [x.number for x in taken], ");", WIDTH - 2)
        yield CudaKernel(scene, function.name, precision,
                         f"{name} of one state, and of n, one a thread.", (), taken,
                         body.replace("\n", "\n  "))
        if function.moved:
            yield CudaKernel(
                scene, function.name.replace("step", "run", 1), precision,
                f"{name} so many times, from the time t on: of one state, and of n, one a thread.",
                (("ptrdiff_t", "steps"), *((DOUBLE.c_type, x.name) for x in taken if x.value)),
                [x for x in taken if not x.value], _run(called, taken, precision))


def _taken(function: Signature, precision: Precision) -> list[Taken]:
    real = precision.c_type
    return [Taken(x, real, count(shape)) if written else
            Taken(x, real, count(shape), "const ", not shape)
            for x, shape, written in function.arguments]


def _run(step: str, taken: Sequence[Taken], precision: Precision) -> str:
    """Times and step lengths are double, and rounded in each step, as when steps are called one by
    one."""
    number = on_device(precision).c_type
    passed = {"t": f"{number}(ksl_begun_device(t, h, static_cast<double>(i)))",
              "h": f"{number}(ksl_number(h))"}
    moved = [x for x in taken if not x.const]
    passed |= {x.name: f"{x.name}_state" for x in moved}
    rooms = ", ".join(f"{x.name}_state[{max(x.size, 1)}]" for x in moved)
    return render("cuda/run", number=number, moved=moved, rooms=rooms, call=listed(
        f"{step}(", [passed.get(x.name, x.number) for x in taken], ");", WIDTH - 8)).rstrip("\n")
