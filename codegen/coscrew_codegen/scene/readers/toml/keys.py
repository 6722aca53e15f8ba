"""The tables and keys of scene files: the only list of them.

The readers take names and choices from here; the documentation and the JSON Schema show it.
"""

from collections.abc import Callable
from dataclasses import dataclass

from coscrew_codegen.program.values.formats import CHOICES
from coscrew_codegen.scene.functions import QUANTITIES
from coscrew_codegen.scene.integrators import NAMES
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism.inertia_checks import ERROR, WARN
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.loop import LOOP_KINDS
from coscrew_codegen.scene.mechanism.notices import ACCEPT
from coscrew_codegen.scene.recorded_quantities import STATES
from coscrew_codegen.scene.scene import Run
from coscrew_codegen.scene.units import UNITS

BASES = {kind.name: kind for kind in sorted(KINDS, key=lambda x: x.nv) if kind.base}
TYPES = {word: kind for kind in KINDS for word in (kind.name, *kind.unlimited)}


@dataclass(frozen=True)
class Key:
    """A key of a table."""

    name: str
    words: str  # description with units
    kind: str = "text"  # text, texts, number, numbers, positive, nonnegative, vector (3 numbers),
    # quaternion (4), moments (3 or 6 numbers or a 3×3 matrix), coordinates (by joint: a number or a
    # list), expectations (by quantity), tolerances (by function), ranges (by joint), intervals (by
    # name), interval (a number, or `table`), words (texts by name), effects; table and tables (by
    # name) have `table`
    choices: tuple[str, ...] = ()  # of a text; the first is the default unless there is another
    default: str = ""  # in TOML
    required: bool = False
    table: "TableOf | None" = None
    joints: Callable[[JointKind], bool] | None = None  # of a joint: which kinds have it; None: all


@dataclass(frozen=True)
class TableOf:
    """A table: its heading and its keys."""

    heading: str  # "" for the file itself
    words: str
    keys: tuple[Key, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the keys."""
        return tuple(key.name for key in self.keys)


def _written(number: float) -> str:
    """The number without padding of the exponent: 1e-9, not 1e-09."""
    return f"{number:g}".replace("e-0", "e-")


CYLINDER = TableOf("bodies.NAME.shape.cylinder", "A cylinder about z.", (
    Key("radius", "in m", "positive", required=True),
    Key("length", "in m", "positive", required=True)))

SHAPE = TableOf("bodies.NAME.shape", "A homogeneous solid about the centre of mass: one of these "
                "keys.", (
    Key("box", "lengths of the edges along x, y, z in m", "vector"),
    Key("cylinder", "a cylinder about z", "table", table=CYLINDER),
    Key("sphere", "radius in m", "positive")))

BODY = TableOf("bodies.NAME", "A body; without keys, a frame without mass.", (
    Key("mass", "in kg", "nonnegative"),
    Key("com", "centre of mass in m, in the body's frame", "vector", default="[0, 0, 0]"),
    Key("inertia", "moments about the centre of mass in kg m²: xx, yy, zz and, if not zero, "
        "xy, xz, yz; or the symmetric 3×3 matrix", "moments", default="[0, 0, 0]"),
    Key("shape", "the solid whose moments, with `mass`, are the inertia; instead of `inertia`",
        "table", table=SHAPE)))

_PLACE = (
    Key("xyz", "position in m", "vector", default="[0, 0, 0]"),
    Key("rpy", "roll, pitch, yaw in rad, about the parent's fixed x, y, z: R = R_z R_y R_x",
        "vector"),
    Key("quaternion", "unit quaternion x, y, z, w: the scalar last", "quaternion"),
    Key("axis", "axis of rotation, of any length", "vector"),
    Key("angle", "angle about `axis` in rad", "number"))
_ONE_ROTATION = "its rotation is given by at most one of rpy, quaternion, axis with angle"

ORIGIN = TableOf("joints.NAME.origin", f"The joint's frame in the parent's; {_ONE_ROTATION}.",
                 _PLACE)

PLACE = TableOf("attach.NAME.place", f"The attached body's frame in the other's; {_ONE_ROTATION}.",
                _PLACE)

_ARGUMENTS = Key("arguments", "of a model that is a file of xacro: values by name", "words")
_PACKAGES = Key("packages", "of a model that is a file of xacro: folders by the package's name, "
                "for `$(find PACKAGE)`, seen from the scene", "words", default="searched beside "
                "the file and above it")
_LEAVE_OUT = Key("leave_out", "of a model that is a file of MuJoCo or an SDF: groups of elements "
                 "that the scene does without; errors name them", "texts", default="[]")

OF_MODEL = (
    Key("prefix", "begins the names of its bodies, joints and effects here", default='"NAME_"'),
    Key("base", "whether its root, if no joint moves it, is fixed to that body or, on the world, "
        "moves freely", choices=tuple(BASES)),
    _ARGUMENTS, _PACKAGES, _LEAVE_OUT)
"""Keys of a model that is attached."""

ATTACH = TableOf("attach.NAME", "A body that is fixed to one of the model, as a payload to a "
                 "flange, or with `model` the robot of another file, as a gripper: effects, "
                 "`record` and functions name its bodies and joints like the model's own.", (
    Key("to", "the body it is fixed to", required=True),
    Key("place", "its frame in that body's, or that of the world of `model`", "table",
        table=PLACE),
    Key("model", "a file next to the scene, in one of the formats of models; instead of `mass` and "
        "the keys after it"),
    *OF_MODEL, *BODY.keys))

FRAME = TableOf("frames.NAME", "A frame that is fixed to a body of the model, as a tool's centre "
                f"point: a body without mass; {_ONE_ROTATION}.", (
    Key("to", "the body it is fixed to", required=True), *_PLACE))

LIMITS = TableOf("joints.NAME.limits", "Limits for effects, which use them by \"model\": without "
                 "such an effect nothing stops the joint.", (
    Key("lower", "lower end of the range in rad or m; not of a continuous joint", "number"),
    Key("upper", "upper end of the range in rad or m; not of a continuous joint", "number"),
    Key("effort", "largest torque or force in N m or N", "nonnegative"),
    Key("velocity", "largest speed in rad/s or m/s", "nonnegative")))

MIMIC = TableOf("joints.NAME.mimic", "If the scene has [effects.mimic], the joint follows another: "
                "q = multiplier q_joint + offset.", (
    Key("joint", "the joint it follows", required=True),
    Key("multiplier", "ratio of the velocities", "number", default="1"),
    Key("offset", "in rad or m", "number", default="0")))


def _moves(kind: JointKind) -> bool:
    return kind.moves


def _one_coordinate(kind: JointKind) -> bool:
    return kind.one_coordinate


AXES = ("axis", "axis2")
"""The keys of a joint's axes."""


def _axis(number: int) -> Key:
    """The key of a joint's first or second axis, and what it is of each kind that has it."""
    words = "; ".join(f"of {kind.name} joints the {kind.axes[number]}"
                      for kind in KINDS if len(kind.axes) > number)
    return Key(AXES[number], f"in the joint's frame, of any length: {words}", "vector",
               joints=lambda kind: len(kind.axes) > number)


JOINT = TableOf("joints.NAME", "A joint between two bodies.", (
    Key("type", "how it moves, see Joints; continuous is revolute without a range",
        choices=tuple(TYPES), required=True),
    Key("parent", "the body it is fixed to", default='"world"'),
    Key("child", "the body it moves", required=True),
    Key("origin", "its frame in the parent's", "table", table=ORIGIN),
    _axis(0), _axis(1),
    Key("limits", "limits of its range, torque and speed; of a spherical joint `upper`, the "
        "largest angle by which it turns", "table", table=LIMITS,
        joints=lambda kind: kind.one_coordinate or kind.by_angle),
    Key("damping", "in N m s/rad or N s/m; acts by [effects.viscous]", "nonnegative",
        joints=_moves),
    Key("friction", "in N m or N; acts by [effects.coulomb] or [effects.stribeck]",
        "nonnegative", joints=_moves),
    Key("mimic", "which joint it follows", "table", table=MIMIC, joints=_one_coordinate)))

LOOP = TableOf("loops.NAME", "A closed loop: holds a point of one body to a point of another, "
               "besides the joints; either may be \"world\".", (
    Key("kind", "; ".join(f"{x.name}: {x.words}" for x in LOOP_KINDS.values()),
        choices=tuple(LOOP_KINDS), required=True),
    Key("bodies", "the first and the second body; of a `frame` also two of `frames`, which are "
        "turned; of all but a law", "texts"),
    Key("first", "the point in the first body's frame, in m", "vector", default="[0, 0, 0]"),
    Key("second", "the point in the second body's frame, in m", "vector", default="[0, 0, 0]"),
    Key("axis", "of a hinge: its axis in the first body's frame, of any length", "vector"),
    Key("axis2", "of a hinge: its axis in the second body's frame", "vector",
        default="the same numbers as `axis`"),
    Key("length", "of a rod, in m", "positive"),
    Key("joints", "of a law: weights of joints' coordinates, whose sum is s", "coordinates"),
    Key("leaders", "of a law: weights of the coordinates whose sum is r", "coordinates",
        default="none"),
    Key("polynomial", "of a law: [c0, c1, …] of s = c0 + c1 r + c2 r² + …", "numbers")))


def _by_kind(of: str) -> str:
    """q or v of each kind of joint."""
    return "; ".join(f"{kind.name} {kind.q_words if of == 'q' else kind.v_words}"
                     for kind in KINDS if kind.moves)


START = TableOf("start", "The state at the start of a run; by default zero, without rotation.", (
    Key("q", f"by joint: {_by_kind('q')}", "coordinates"),
    Key("v", f"by joint: {_by_kind('v')}", "coordinates"),
    Key("x", "by effect, as \"stiction.elbow\": its states", "coordinates")))

_RECORDED = ", ".join(f'"{x}"' for x in (
    *UNITS, STATES, *(quantity.written for _, quantity in QUANTITIES.values()),
    "EFFECT.WHERE.torque"))

OUTPUTS = TableOf("outputs", "What a run records.", (
    Key("record", f"quantities: {_RECORDED}, …; by default also \"x\" if effects have states",
        "texts", default='["q", "v"]'),
    Key("every", "s between samples; a sample lies at the end of a step, so that this may shorten "
        "steps", "positive", default="0.01")))

RUN = TableOf("run", "How a run is integrated.", (
    Key("duration", "in s", "positive", default=_written(Run().duration)),
    Key("integrator", "see Integrators", choices=NAMES),
    Key("step", "in s", "positive", default=_written(Run().step)),
    Key("rtol", "relative tolerance of SciPy's integrators", "positive",
        default=_written(Run().rtol)),
    Key("atol", "absolute tolerance of SciPy's integrators", "positive",
        default=_written(Run().atol))))

EXPECT = TableOf('expect."QUANTITY"', "A condition for `coscrew check`: |quantity(at) - value| <= "
                 "rtol |value| + atol.  A table, or a list of tables.  At least one of rtol and "
                 "atol is required.", (
    Key("at", "time in s", "nonnegative", required=True),
    Key("value", "in the quantity's unit", "number", required=True),
    Key("rtol", "relative tolerance", "nonnegative", default="0"),
    Key("atol", "absolute tolerance", "nonnegative", default="0")))

ACCURACY = TableOf("accuracy", "How accurate functions are in the mixed tier.", (
    Key("FUNCTION", "how far rounding may move its outputs, in their unit; or a table of this by "
        "output", "positive"),))

ENDS = TableOf("ranges.ARGUMENT.NAME", "A range that is not symmetric about zero.", (
    Key("lower", "lower end", "number", required=True),
    Key("upper", "upper end", "number", required=True)))

_BY_JOINT = ("a number, the largest size of all its components; a list with an entry for each "
             "joint that has coordinates; or a table by joint.  An entry is a number, `{ lower = "
             "…, upper = … }`, or for a joint with several numbers a list of these")
_OR_LIMITS = 'also "limits", between the limits of joints, which must have them'

RANGES = TableOf("ranges", "The ranges of the arguments of functions, for which functions state "
                 "proved bounds of their errors.  Numbers are in SI units.", (
    Key("q", f"positions: {_BY_JOINT}; {_OR_LIMITS}.  Quaternions have norm 1 and no entry",
        "ranges", table=ENDS, default="the limits of joints that have them"),
    Key("v", f"velocities, as q; {_OR_LIMITS}", "ranges", table=ENDS,
        default="the limits of joints that have them"),
    Key("a", "accelerations, as q", "ranges", table=ENDS),
    Key("tau", f"torques and forces of joints, as q; {_OR_LIMITS}", "ranges", table=ENDS),
    Key("p", "run-time parameters, by name: a number, the largest size, or both ends", "intervals",
        table=ENDS, default="sizes up to the scene's values"),
    Key("t", "time: a number, its end, from 0; or both ends", "interval", table=ENDS)))

SCENE = TableOf("", "The file itself.", (
    Key("model", "a file next to the scene that holds the model, in one of the formats of models; "
        "without it the tables `bodies` and `joints` are the model, beside it they add to it"),
    _ARGUMENTS, _PACKAGES, _LEAVE_OUT,
    Key("base", "whether the root, if no joint moves it, is fixed or moves freely",
        choices=tuple(BASES), default="as the model's file says, else fixed"),
    Key("name", "name of the files and the package, and prefix of the C functions: a C identifier",
        default="the file's name"),
    Key("precision", 'of runs, and of the files of `coscrew generate`; "both" runs both and shows '
        'the difference.  "double" is necessary if a number exceeds single precision\'s range '
        "(1.2e-38 to 3.4e38)", choices=CHOICES, default="runs in double, files in both"),
    Key("implausible", '"warn" accepts inertias that no body has, that are massless or '
        "incomplete, and reports them; on the command line --implausible warn",
        choices=(ERROR, WARN)),
    Key("falling", '"accept" where bodies with free joints are meant to fall: no notice says that '
        "nothing holds them against gravity", choices=(WARN, ACCEPT)),
    Key("functions", "what is generated: names of functions; \"default\" and \"all\" stand for "
        "several", "texts", default='["default"]'),
    Key("tiers", "in which the functions, steps excepted, are generated besides plain: accurate, "
        "certified, mixed, pairs, fixed", "texts", default='["plain"]'),
    Key("accuracy", "how accurate functions in single precision are in the mixed tier, which they "
        "then have", "tolerances", table=ACCURACY),
    Key("ranges", "in which the arguments of functions lie, for proved bounds of errors", "table",
        table=RANGES),
    Key("runtime", "numbers that stay arguments of functions: BODY.mass, BODY.com, BODY.inertia, "
        "EFFECT.WHERE.PARAMETER", "texts", default="[]"),
    Key("attach", "bodies and models that are fixed to bodies, by name", "tables", table=ATTACH),
    Key("frames", "frames that are fixed to bodies, by name", "tables", table=FRAME),
    Key("bodies", "the bodies, by name", "tables", table=BODY),
    Key("joints", "the joints, by name", "tables", table=JOINT),
    Key("loops", "closed loops of the model, by name", "tables", table=LOOP),
    Key("effects", "what acts: see Effects", "effects"),
    Key("start", "the state at the start of a run", "table", table=START),
    Key("outputs", "what a run records", "table", table=OUTPUTS),
    Key("run", "how a run is integrated", "table", table=RUN),
    Key("expect", "conditions on a run, by quantity", "expectations", table=EXPECT)))

TABLES = (SCENE, ATTACH, PLACE, FRAME, BODY, SHAPE, CYLINDER, JOINT, ORIGIN, LIMITS, MIMIC,
          LOOP, ACCURACY, RANGES, ENDS, START, OUTPUTS, RUN, EXPECT)
"""All tables except those of effects."""
TABLE_WITH = {name: table.heading for table in (OUTPUTS, RUN) for name in table.names}
"""The headings of tables by keys that no other table of scenes has."""
