"""Centre of mass of all links, its motion, and the momentum about it.

Everything is computed from the centre's place in each link's frame, so that rounding errors do not
grow with the distance from the world's origin."""

from collections.abc import Callable, Sequence
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    angular,
    cross,
    linear,
    rotated,
    rotated_back,
    rotation,
    scaled,
    subtract,
    translation,
)
from coscrew_codegen.dynamics.algorithms import crba, energies, frames, rnea
from coscrew_codegen.dynamics.algorithms.bodies import Rigid
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.function_recording import FunctionRecording

Six = tuple[Number, ...]


class Centroid:
    """The centre of mass of all links of a motion without gravity."""

    def __init__(self, x: FunctionRecording, motion: Motion):
        self._x, self._motion, self._links = x, motion, x.tree.links
        self._roots = [n for n, link in enumerate(self._links) if link.parent < 0]

    @cached_property
    def _composites(self) -> list[Rigid]:
        return crba.composites(self._motion, self._x.rigids)

    @cached_property
    def _per_mass(self) -> Number:
        """1 / Σ m."""
        total = self._motion.zero[0]
        for n in self._roots:
            total = total + self._composites[n].m
        return 1 / total

    @cached_property
    def position(self) -> Vector:
        """Σ m c / Σ m, in the world."""
        if len(self._roots) == 1:
            D = self._motion.pose(self._roots[0])
            return add(rotated(rotation(D), self._places[self._roots[0]]), translation(D))
        return self._of_trees

    @cached_property
    def _of_trees(self) -> Vector:
        """The centre of several trees."""
        moment = self._motion.zero
        for n in self._roots:
            D, rigid = self._motion.pose(n), self._composites[n]
            own = add(rotated(rotation(D), rigid.h), scaled(rigid.m, translation(D)))
            moment = add(moment, own)
        return scaled(self._per_mass, moment)

    @cached_property
    def _places(self) -> list[Vector]:
        """The centre in the frame of each link."""
        places: list[Vector] = []
        for n, link in enumerate(self._links):
            with self._motion.part(n, "cm"):
                if link.parent < 0 and len(self._roots) == 1:
                    places.append(scaled(self._per_mass, self._composites[n].h))
                    continue
                D = self._motion.frame(n)
                before = self._of_trees if link.parent < 0 else places[link.parent]
                places.append(rotated_back(rotation(D), subtract(before, translation(D))))
        return places

    @cached_property
    def velocity(self) -> Vector:
        """Σ m v / Σ m."""
        total, momenta = self._motion.zero, energies.momenta(self._x, self._motion)
        for n in self._roots:
            total = add(total, rotated(rotation(self._motion.pose(n)), linear(momenta[n])))
        return scaled(self._per_mass, total)

    def matrix(self) -> list[Sequence[Number]]:
        """A by columns: the momentum (p; L) about the centre, in the world's axes, for a unit
        velocity of each freedom."""
        return self._columns(lambda n, u: (*linear(u), *self._moment(n, u)))

    def jacobian(self) -> list[Sequence[Number]]:
        """J by columns: p / Σ m."""
        return self._columns(lambda n, u: scaled(self._per_mass, linear(u)))

    def _columns(self, of: Callable[[int, Six], Sequence[Number]]) -> list[Sequence[Number]]:
        """Vectors of each freedom's momentum u = B s, in its link's frame, in the world's axes."""
        call, columns = self._motion.recorder.call, []
        for n in range(len(self._links)):
            R = rotation(self._motion.pose(n))
            with self._motion.part(n, "h"):
                for k, s in enumerate(self._motion.subspace(n)):
                    own = of(n, call("product_Bs", self._composites[n].numbers, s))
                    turned = [rotated(R, tuple(own[i:i + 3])) for i in range(0, len(own), 3)]
                    columns.append((n, k, tuple(x for part in turned for x in part)))
        wide = len(columns[0][2])
        results: list[Sequence[Number]] = [self._motion.zero[:1] * wide] * self._x.tree.nv
        for n, k, column in columns:
            frames.enter(self._x.tree, n, k, column, results)
        return results

    def _moment(self, n: int, u: Six) -> Vector:
        """About the centre, from that about the link's origin."""
        return subtract(angular(u), cross(self._places[n], linear(u)))

    def rate(self) -> Six:
        """A a + A' v: the force and the moment about the centre that move all links."""
        motion = self._motion
        net = rnea.transmitted(motion, rnea.net_wrenches(motion, self._x.rigids, None))
        total = (*motion.zero, *motion.zero)
        for n in self._roots:
            R = rotation(motion.pose(n))
            moved = (*rotated(R, linear(net[n])), *rotated(R, self._moment(n, net[n])))
            total = add(total, moved)
        return total
