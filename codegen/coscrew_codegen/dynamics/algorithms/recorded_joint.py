"""A joint whose operations are recorded: the library's, on Numbers."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.algebra.recording import numbers
from coscrew_codegen.algebra.recording.numbers import Number, Vector
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.scene.mechanism.joint_kind import Displacement, JointState, Numbers


@dataclass(frozen=True)
class RecordedJoint(JointState):
    """A joint in a recording; sines and cosines have names of their own."""

    recorder: Recorder

    def numbers(self, values: Sequence[int]) -> tuple[Number, ...]:
        return self.recorder.numbers(values)

    def rotation(self, axis: Vector, angle: Number) -> tuple[Number, ...]:
        sine_and_cosine = self.recorder.call("dc", angle)
        for symbol, value in zip("sc", sine_and_cosine, strict=True):
            self.recorder.label(symbol, value)
        return self.recorder.call("mat3x3_setFromAxisDC", axis, sine_and_cosine)

    def quaternion_rotation(self, q: Numbers) -> tuple[Number, ...]:
        return self.recorder.call("mat3x3_from_quaternion", q)

    def composed(self, first: Displacement, second: Displacement) -> Displacement:
        return self.recorder.call("product_dd", first, second)

    def turned(self, first: Displacement, R: Numbers) -> Displacement:
        return self.recorder.call("product_ddr", first, R)

    def rotated(self, R: Numbers, a: Vector) -> Vector:
        return numbers.rotated(R, a)

    def rotated_back(self, R: Numbers, a: Vector) -> Vector:
        return numbers.rotated_back(R, a)

    def quaternion_product(self, a: Numbers, b: Numbers) -> tuple[Number, ...]:
        return self.recorder.call("quaternion_product_qq", a, b)

    def quaternion_rotated(self, q: Numbers, a: Vector) -> Vector:
        return self.recorder.call("rotate_qv", q, a)

    def cross(self, a: Vector, b: Vector) -> Vector:
        return numbers.cross(a, b)
