"""A catalogue for tests of scene files: one effect of each place, parameters of each kind."""

from fractions import Fraction

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

ZERO = (Fraction(0),) * 3

GRAVITY = Effect("gravity", "falls", "a = -g", Place.SCENE, (
    ParameterOf("g", "m/s^2", "acceleration of free fall", "vector",
                (*ZERO[:2], Fraction(-981, 100))),),
    gravity=lambda values: values.vector("g"))
VISCOUS = Effect("viscous", "resists", "-d v", Place.JOINT, (
    ParameterOf("d", "N m s/rad", "damping", model="damping", nonnegative=True),))
STRIBECK = Effect("stribeck", "sticks", "…", Place.JOINT, (
    ParameterOf("tau_c", "N m", "friction", model="friction", nonnegative=True),
    ParameterOf("tau_s", "N m", "stiction", nonnegative=True),
    ParameterOf("eps", "rad/s", "width", default=Fraction(1, 1000), positive=True)))
MOTOR = Effect("motor", "drives", "…", Place.JOINT, (
    ParameterOf("kind", "", "which", "choice", "torque", choices=("torque", "pd")),
    ParameterOf("u", "N m", "torque", "formula", of=("torque",)),
    ParameterOf("kp", "N m/rad", "gain", of=("pd",), positive=True),
    ParameterOf("limit", "N m", "largest torque", required=False, model="effort", positive=True)))
STOP = Effect("stop", "ends", "…", Place.JOINT, (
    ParameterOf("lower", "rad", "lower end", default="model", required=False, model="lower"),
    ParameterOf("upper", "rad", "upper end", default="model", required=False, model="upper")),
    any_of=("lower", "upper"), ascending=("lower", "upper"))
ROTOR = Effect("rotor", "turns along", "…", Place.JOINT, (
    ParameterOf("inertia", "kg m^2", "inertia", nonnegative=True),),
    joint_inertia=lambda values: values["inertia"])
PUSH = Effect("push", "pushes", "f", Place.BODY, (
    ParameterOf("force", "N", "force", "formulas"),
    ParameterOf("point", "m", "where", "vector", ZERO),
    ParameterOf("seen_from", "", "body", "body", "world")))
TENDON = Effect("tendon", "pulls", "…", Place.PAIR, (
    ParameterOf("k", "N/m", "stiffness", required=False),
    ParameterOf("d", "N s/m", "damping", required=False)), any_of=("k", "d"))
MIMIC = Effect("mimic", "follows", "…", Place.SCENE, (), mimic=True)
REACTION = Effect("reaction", "tells", "f", Place.JOINT, (), reaction=True)

CATALOGUE = (GRAVITY, MIMIC, MOTOR, PUSH, REACTION, ROTOR, STOP, STRIBECK, TENDON, VISCOUS)
