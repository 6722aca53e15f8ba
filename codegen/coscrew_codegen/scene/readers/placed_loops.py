"""Closed loops between frames that files place on bodies."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism.joint_kind import Direction
from coscrew_codegen.scene.mechanism.loop import FRAME, HINGE, ClosedLoop, LoopEnd, LoopKind
from coscrew_codegen.scene.mechanism.model import HERE, Body, Joint, Placement
from coscrew_codegen.scene.mechanism.rotations import turned


@dataclass
class PlacedLoops:
    """The loops of a file, and the frames, fixed to bodies, that welds hold together."""

    loops: list[ClosedLoop] = field(default_factory=list)
    frames: list[Body | Joint] = field(default_factory=list)

    def close(self, name: str, kind: LoopKind, places: Iterable[tuple[str, Placement]],
              axis: Direction = Joint.axis, new_body: Callable[[str], str] = str,
              new_joint: Callable[[str], str] = str) -> None:
        """Add the closure of two frames on bodies; of a hinge, with the axis in these frames.  A
        frame that is turned in its body becomes a body on it, NAME/first or NAME/second."""
        ends: list[LoopEnd] = []
        for (body, at), word in zip(places, ("first", "second"), strict=True):
            if kind is HINGE:
                ends.append(LoopEnd(body, at.t, axis=turned(at.R, axis)))
            elif kind is FRAME and at.R != HERE.R:
                frame = new_body(f"{name}/{word}")
                self.frames += (Body(frame), Joint(new_joint(f"{frame}/frame"), FIXED, body, frame,
                                                   at))
                ends.append(LoopEnd(frame))
            else:
                ends.append(LoopEnd(body, at.t))
        first, second = ends
        self.loops.append(ClosedLoop(name, kind, first, second))
