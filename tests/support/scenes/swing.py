"""A driven, damped pendulum whose mass and torque are set at run time."""

SWING = """
runtime = ["bob.mass", "actuator.pivot.torque"]
[bodies]
bob = { mass = 2, com = [0, 0, -0.5], inertia = [0.01, 0.01, 0.01] }
[joints]
pivot = { type = "continuous", child = "bob", axis = [0, 1, 0], damping = 0.1 }
[effects.gravity]
[effects.viscous]
joints = "all"
d = "model"
[effects.actuator.pivot]
kind = "torque"
torque = 0
[start.q]
pivot = 0.5
[outputs]
record = ["q", "v", "energy"]
"""
