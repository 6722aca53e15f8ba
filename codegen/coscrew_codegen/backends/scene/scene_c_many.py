"""A scene's functions of many states as C: arm_many.h, arm_many.c in double precision and
arm_manyf.c in single.

The same Programs as in arm.c, on vectors with a number of each of several states, as many as a
register holds: the bits are those of one state.  Loops over arm.c's functions where the compiler or
the processor has no such vectors.
"""

from collections.abc import Iterator, Sequence

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_runtime
from coscrew_codegen.backends.scene.scene_c import IN_WORDS
from coscrew_codegen.backends.scene.scene_c_lanes import VectorSection
from coscrew_codegen.backends.scene.scene_c_steps import begun
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import named

LEVEL = "-O2"
"""How to compile it: clang's code takes 0.8 to 0.95 of the time that -O1 gives, for 1.2 times the
compilation."""


@uncollected()
def files(scene: SceneFunctions, banner: str) -> Files:
    """arm_many.h, arm_many.c, arm_manyf.c and coscrew_runtime.h."""
    return _files([VectorSection(p, scene) for p in named(scene.precisions)], scene.name, banner)


@uncollected()
def tier_files(made: SceneTier, banner: str) -> Files:
    """arm_accurate_many.h, arm_accurate_many.c, arm_accurate_manyf.c and coscrew_runtime.h."""
    sections = []
    for precision, scene in made.in_precisions:
        plain = made.called(scene)
        sections.append(VectorSection(precision, scene, plain if plain.functions else None))
    return _files(sections, made.stem, banner)


def _files(sections: Sequence[VectorSection], of: str, banner: str) -> Files:
    name = f"{of}_many"
    return {f"{name}.h": render("scene/many.h", banner=banner, of=of, guard=name.upper(),
                                about=comment_of([*_about(sections, of)]), sections=sections),
            **{f"{name}{x.precision.suffix}.c": _source(x, of, name, banner) for x in sections},
            **scene_c_runtime.files()}


def _source(section: VectorSection, of: str, name: str, banner: str) -> str:
    """The functions of one precision."""
    timed = section.scene.timed and bool(section.scene.steps)
    return render("scene/many.c", banner=banner, name=name, of=of, section=section,
                  upper=section.scene.name.upper(), begun=begun() if timed else "",
                  errors=any(x.exact for x in section.kernels), double="",  # arm.c is refused
                  fingerprint=scene_c_runtime.fingerprint())


def _about(sections: Sequence[VectorSection], of: str) -> Iterator[str]:
    precisions = IN_WORDS[tuple(x.precision.name for x in sections)]
    yield f"{of}: its functions of n states, in {precisions}."
    yield (f"The bits are those of {of}.h's functions.  Row k of an argument begins k strides "
           "behind the first: a stride counts numbers, and 0 says that all states share one row.  "
           "n may be 0.  An output may be an input with the same stride, not 0; else it must "
           "overlap neither inputs nor other outputs, which is not checked.  No heap, no state: "
           "all functions are thread-safe.")
    if sections[0].scene.steps:
        yield ("Runs take all their steps with as many states as a register holds before they turn "
               "to the next ones.  Times and h are double in both precisions: steps begin at "
               "t + k h, rounded.")
    yield ("As many states as a register holds are computed at a time: compile for your processor "
           f"(-march=native, or the oldest one that must run it).  Link with {of}.c.")


TARGET = Target("many states of a scene in C", ("c",), many=files, many_tier=tier_files)
