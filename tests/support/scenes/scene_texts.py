"""Scenes whose motions have closed forms, and these closed forms to many digits."""

import mpmath as mp

GRAVITY = 9.81

# A point mass at the end of a horizontal rod of 1 m, released at x = -1.
PENDULUM = """
precision = "both"
[bodies.rod]
[bodies.bob]
mass = 1
[joints.hinge]
type = "revolute"
child = "rod"
axis = [0, 1, 0]
[joints.end]
type = "fixed"
parent = "rod"
child = "bob"
origin.xyz = [0, 0, -1]
[effects.gravity]
[effects.reaction]
joints = ["hinge"]
[start.q]
hinge = 1.5707963267948966
[outputs]
record = ["q", "v", "energy", "position.bob", "reaction.hinge"]
every = 0.05
[run]
duration = 10
integrator = "rk4"
step = 1e-3
rtol = 1e-12
atol = 1e-12
"""

MASS, STIFFNESS, DAMPING = 2, 100, 1

# A block on a damped spring, released 0.1 m from its equilibrium.
SPRING = f"""
precision = "both"
runtime = ["block.mass"]
[bodies.block]
mass = {MASS}
inertia = [0.02, 0.02, 0.02]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
[effects.spring]
joints = "all"
k = {STIFFNESS}
[effects.viscous]
joints = "all"
d = {DAMPING}
[start.q]
slide = 0.1
[outputs]
record = ["q", "v", "a", "energy", "power"]
[run]
duration = 2
integrator = "rk4"
step = 1e-3
rtol = 1e-12
atol = 1e-12
"""

# A brick thrown up, spinning about all of its axes.
BRICK = """
precision = "both"
base = "free"
[bodies.brick]
mass = 2
inertia = [0.1, 0.2, 0.25]
[effects.gravity]
[start.v]
base = [1, 2, 5, 3, -1, 2]
[outputs]
record = ["q", "v", "energy", "momentum", "position.brick", "pose.brick", "twist.brick"]
[run]
duration = 1
integrator = "rk4"
step = 1e-3
rtol = 1e-12
atol = 1e-12
"""

# A spring too stiff for explicit steps: h ω = 20, so that every step multiplies by about -400.
UNSTABLE = SPRING.replace(f"k = {STIFFNESS}", "k = 8e8").replace('"rk4"', '"semi-implicit-euler"')


def pendulum(t: float) -> tuple[mp.mpf, mp.mpf]:
    """Angle and speed of PENDULUM: sin θ/2 = k sn(K - ω t, k), k = sin θ0/2."""
    with mp.workdps(50):
        k, omega = mp.sin(mp.mpf("1.5707963267948966") / 2), mp.sqrt(mp.mpf("9.81"))
        u = mp.ellipk(k**2) - omega * mp.mpf(t)
        sn, dn = (mp.ellipfun(name, u, m=k**2) for name in ("sn", "dn"))
        cn = mp.ellipfun("cn", u, m=k**2)
        return 2 * mp.asin(k * sn), -2 * k * omega * cn * dn / mp.sqrt(1 - (k * sn)**2)


def spring(t: float, mass: float = MASS) -> tuple[mp.mpf, mp.mpf]:
    """Place and speed of SPRING: e^(-a t) (cos w t + a/w sin w t) / 10."""
    with mp.workdps(50):
        t, a = mp.mpf(t), mp.mpf(DAMPING) / (2 * mass)
        w = mp.sqrt(mp.mpf(STIFFNESS) / mass - a**2)
        decay = mp.exp(-a * t) / 10
        return (decay * (mp.cos(w * t) + a / w * mp.sin(w * t)),
                -decay * (a**2 + w**2) / w * mp.sin(w * t))

# Masses, a damping and a gain at run time, and a torque that changes with time.
TIMED = """
runtime = ["lower.mass", "viscous.elbow.d", "actuator.elbow.kp"]
[bodies]
upper = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
lower = { mass = 1, com = [0.05, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
[joints]
shoulder = { type = "spherical", child = "upper" }
elbow = { type = "revolute", parent = "upper", child = "lower", axis = [0, 0.6, 0.8] }
[effects.gravity]
[effects.viscous]
d = { elbow = 0.3 }
[effects.actuator.elbow]
kind = "pd"
kp = 20
kd = 2
target = "0.5*sin(2*pi*t)"
"""
SLIDER = """
runtime = ["stiction.slide.k"]
[bodies]
block = { mass = 1, inertia = [0.1, 0.1, 0.1] }
wheel = { mass = 1, inertia = [0.1, 0.1, 0.1] }
[joints]
slide = { type = "prismatic", child = "block", axis = [1, 0, 0] }
hinge = { type = "revolute", parent = "block", child = "wheel", axis = [0, 1, 0] }
[effects.stiction.slide]
tau_c = 4
tau_s = 5
k = 5e5
d = 1000
[effects.stiction.hinge]
tau_c = 0.1
[effects.actuator.slide]
kind = "torque"
torque = "3 + 1.9*sin(20*pi*t)"
"""
"""A block and a wheel held by stiction, an effect with states."""
