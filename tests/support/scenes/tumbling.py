"""A floating base with an arm, whose momentum only gravity changes."""

TUMBLING = """
[bodies]
hull = { mass = 3, com = [0.1, 0, 0.02], inertia = [0.3, 0.2, 0.4] }
arm = { mass = 1, com = [0, 0.3, 0], inertia = [0.05, 0.01, 0.05] }
[joints]
base = { type = "free", child = "hull" }
elbow = { type = "continuous", parent = "hull", child = "arm", axis = [1, 0, 0] }
[effects.gravity]
[start.v]
base = [0.1, 0.2, 0.3, 1.5, -0.7, 2.1]
elbow = 0.4
"""
