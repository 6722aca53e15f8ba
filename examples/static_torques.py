"""Static joint torques of a Franka Emika Panda that holds a payload: τ_i = h_i · Σ_{k>=i} c_k.

  D_i = D_{i-1} T_x(a_i) R_x(α_i) T_z(d_i) R_z(q_i)    frame of joint and link i in the base
  h_i = hsrz(D_i)                                      screw of the joint's axis
  c_k = CoAd(D_k r_k) (-(m_k g; 0))                    coscrew that supports the weight of link k

all at the base's origin, where coscrews add.  τ_i, in N m, is what motor i must supply to hold
still; joint 1 is vertical, so τ_1 = 0.  The same program in C is examples/static_torques.c; to
compare the two, from the folder above:

  cc -O2 -I generated/c/include examples/static_torques.c \
     -o static_torques -lm
  python examples/static_torques.py ./static_torques

Geometry: modified Denavit-Hartenberg parameters published by Franka.  Masses and centres of mass:
C. Gaz et al., "Dynamic Identification of the Franka Emika Panda Robot With Retrieval of Feasible
Parameters Using Penalty-Based Optimization", IEEE RA-L 2019, in the digits of Franka's robot
description.  Sources differ on the height of link 1's centre; no torque depends on it.
"""

import argparse
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import DTypeLike, NDArray

import coscrew

Array = NDArray[np.floating]

POSTURE = (0.3, -0.6, 0.4, -2.1, 0.5, 1.7, 0.8)  # q, in rad
GRAVITY = (0.0, 0.0, -9.81)  # g in the base's frame, in m/s²
FLANGE = 0.107  # of the flange from joint 7, along its axis, in m
PAYLOAD_MASS = 3.0  # the arm's rated payload, in kg
PAYLOAD_CENTRE = (0.02, -0.01, 0.06)  # of mass, from the flange, in m


def panda(real: DTypeLike) -> NDArray[np.void]:
    """The seven links, rounded to a precision: a, d, (sin α, cos α), mass, centre; m and kg."""
    fields = [("a", real), ("d", real), ("alpha", real, 2), ("mass", real), ("centre", real, 3)]
    return np.array([
        (+0.0000, 0.333, (+0, 1), 4.970684, (+0.003875, +0.002081, -0.047620)),
        (+0.0000, 0.000, (-1, 0), 0.646926, (-0.003141, -0.028720, +0.003495)),
        (+0.0000, 0.316, (+1, 0), 3.228604, (+0.027518, +0.039252, -0.066502)),
        (+0.0825, 0.000, (+1, 0), 3.587895, (-0.053170, +0.104419, +0.027454)),
        (-0.0825, 0.384, (-1, 0), 1.225946, (-0.011953, +0.041065, -0.038437)),
        (+0.0000, 0.000, (+1, 0), 1.666555, (+0.060149, -0.014117, -0.010517)),
        (+0.0880, 0.000, (+1, 0), 0.735522, (+0.010517, -0.004252, +0.061597)),
    ], dtype=fields)


def joint_frames(links: NDArray[np.void], q: Array) -> list[Array]:
    """D_i = D_{i-1} T_x(a_i) R_x(α_i) T_z(d_i) R_z(q_i), each (…,3,4), of q (…,n) in rad."""
    frame, frames = np.eye(3, 4, dtype=q.dtype), []
    for i, link in enumerate(links):
        frame = coscrew.product_ddtx(frame, link["a"])
        frame = coscrew.product_ddrx(frame, link["alpha"])
        frame = coscrew.product_ddtz(frame, link["d"])
        frame = coscrew.product_ddrz(frame, coscrew.dc(q[..., i]))
        frames.append(frame)
    return frames


def support(frame: Array, mass: np.floating, centre: Array) -> Array:
    """c = CoAd(D r) (-(m g; 0)).  D (…,3,4), m in kg, r (3) in m -> (…,6), at the base's origin."""
    g = np.array(GRAVITY, frame.dtype)
    weight = coscrew.coscrew_from_lin_ang(coscrew.product_av(mass, g), np.zeros_like(g))
    return coscrew.product_CoAdtcinv(coscrew.product_dv(frame, centre), weight)


def holding_torques(screws: Sequence[Array], supports: Sequence[Array],
                    parents: Sequence[int]) -> Array:
    """τ_i = h_i · (sum of c_k over i and all it carries).  n of (…,6), n of (…,6) -> (…,n).

    Joint i stands on joint parents[i] < i, or on the base if that is -1.  N m, or N along an axis.
    """
    loads = list(supports)
    for i in reversed(range(len(loads))):
        if parents[i] >= 0:
            loads[parents[i]] = coscrew.add_cc(loads[parents[i]], loads[i])
    return np.stack([coscrew.dot_cs(c, h) for c, h in zip(loads, screws, strict=True)], axis=-1)


def static_torques(q: Array) -> Array:
    """τ of the Panda with its payload, in N m and in q's precision.  (…,7) -> (…,7)."""
    links = panda(q.dtype)
    frames = joint_frames(links, q)
    supports = [support(D, link["mass"], link["centre"])
                for D, link in zip(frames, links, strict=True)]
    flange = coscrew.product_ddtz(frames[-1], q.dtype.type(FLANGE))
    payload = support(flange, q.dtype.type(PAYLOAD_MASS), np.array(PAYLOAD_CENTRE, q.dtype))
    supports[-1] = coscrew.add_cc(payload, supports[-1])
    return holding_torques([coscrew.hsrz(D) for D in frames], supports, range(-1, 6))


def torques_in_c(program: Path) -> tuple[Array, Array]:
    """Double and single torques as the compiled static_torques.c prints them, bit for bit."""
    done = subprocess.run([program.resolve()], stdout=subprocess.PIPE, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines() if not line.startswith("#")]
    double, single = (np.array([float.fromhex(row[column]) for row in rows]) for column in (1, 2))
    return double, single.astype(np.float32)


def table(columns: Mapping[str, Array], form: str) -> str:
    """One line per joint, one column per entry, each number formatted by `form`."""
    width = 2 + max(len(name) for name in columns)
    width = max(width, *(2 + len(format(x, form)) for values in columns.values() for x in values))
    lines = ["joint" + "".join(f"{name:>{width}}" for name in columns)]
    for joint, values in enumerate(zip(*columns.values(), strict=True), start=1):
        lines.append(f"{joint:5}" + "".join(f"{format(x, form):>{width}}" for x in values))
    return "\n".join(lines)


def main() -> None:
    """Prints the torques in Python, and beside them those of the C program if it is given."""
    parser = argparse.ArgumentParser(description="Static joint torques of a Panda with a payload.")
    parser.add_argument("program", type=Path, nargs="?", help="compiled examples/static_torques.c")
    program = parser.parse_args().program
    if program and not program.is_file():
        parser.error(f"program: no file {program}; compile examples/static_torques.c first")

    double = static_torques(np.array(POSTURE, np.float64))
    single = static_torques(np.array(POSTURE, np.float32))
    results = {"Python double": double, "Python single": single}
    differences = {"single - double": single - double}
    if program:
        c_double, c_single = torques_in_c(program)
        results = {"Python double": double, "C double": c_double,
                   "Python single": single, "C single": c_single}
        differences = {"C - Python, double": c_double - double,
                       "C - Python, single": c_single - single} | differences

    print(f"Panda at q = {POSTURE} rad, holding {PAYLOAD_MASS:g} kg at {PAYLOAD_CENTRE} m from "
          f"its flange\n\nstatic joint torques, in N m\n{table(results, '.15f')}\n\n"
          f"differences, in N m\n{table(differences, '.1e')}\n")
    if program:
        for name, values in list(differences.items())[:2]:
            print(f"largest |{name}|: {np.abs(values).max():.1e} N m")
    else:
        print("C program not given: compile examples/static_torques.c and pass its path to compare")


if __name__ == "__main__":
    main()
