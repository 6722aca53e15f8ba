"""Scenes that sweeps vary."""

SLIDER = """
runtime = ["block.mass", "block.inertia"]
[bodies.block]
mass = 2
inertia = [1, 1, 1]
[bodies.needle]
mass = 1
inertia = [1, 1, 1]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
limits = { lower = -1, upper = 2, velocity = 3 }
[joints.swivel]
type = "continuous"
parent = "block"
child = "needle"
axis = [0, 0, 1]
[effects.wrench.block]
force = [3, 0, 0]
[effects.limit.slide]
lower = -20
upper = 200
k = 1
[outputs]
record = ["q.slide", "v.slide"]
every = 0.25
[run]
duration = 1
step = 0.015625
integrator = "rk4"
"""
"""A block of mass m = block.mass with a needle of mass 1, pushed by 3 N: q = q0 + v0 t + 1.5 t²/(m
+ 1); all numbers are binary fractions where m + 1 is a power of two."""

BALL = """
base = "free"
[bodies.ball]
mass = 1
inertia = [1, 1, 1]
[bodies.cup]
mass = 1
inertia = [1, 1, 1]
[joints.socket]
type = "spherical"
parent = "ball"
child = "cup"
[effects.gravity]
[run]
duration = 0.1
"""
"""A floating base and a spherical joint: quaternions."""
