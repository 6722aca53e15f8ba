"""Implausible bodies of published robots, each on a joint of its own; figures are those of the
files: ARMAR-4 (pip's armar 1.1.0), Stretch RE1 with a dexterous wrist (hello-robot-stretch-urdf
0.1.2), iCub Nancy01, Genova03 and Lisboa01 (icub-models 3.2.0); and what Schunk's files lack."""

CHAIN = """<robot name="{name}">
<link name="ground"/>
<link name="{body}"><inertial>{inertial}</inertial></link>
<link name="next"><inertial><mass value="1"/><origin xyz="0.1 0.05 0.2"/>
<inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="first" type="revolute"><parent link="ground"/><child link="{body}"/>
<axis xyz="0 0 1"/><limit effort="9" velocity="9" lower="-9" upper="9"/></joint>
<joint name="second" type="revolute"><parent link="{body}"/><child link="next"/>
<origin xyz="0 0.1 0.1"/><axis xyz="0 1 0"/>
<limit effort="9" velocity="9" lower="-9" upper="9"/></joint>
</robot>"""


def _inertial(mass: str, com: str, xx: str, yy: str, zz: str, xy: str = "0", xz: str = "0",
              yz: str = "0") -> str:
    return (f'<mass value="{mass}"/><origin xyz="{com}"/><inertia ixx="{xx}" iyy="{yy}" izz="{zz}" '
            f'ixy="{xy}" ixz="{xz}" iyz="{yz}"/>')


BODIES = {
    "armr_sho3": (_inertial("0.51", "0 -0.0575318 0.0134998", "0", "0.0575321", "0.0195"),
                  "no distribution of mass"),
    "link_straight_gripper": (
        _inertial("0.147853", "0.002409 -0.011138 0.028861", "9.5E-07", "0.000119", "5.9E-05",
                  "-4E-06", "-1E-06", "6E-06"), "moments"),
    "l_ankle_1": (_inertial("0.643", "2.65892e-05 -0.00082253 0.0102574", "4.76593", "0.0040935",
                            "0.0036688", "9.7426e-06", "2.68085e-05", "-0.000353796"),
                  "no distribution of mass"),
    "torso_1": (_inertial("0", "0 0 0", "0.0004544", "0.001141", "0.001236", "-4.263e-05",
                          "-3.889e-08"), "its mass is zero, its moments are not"),
    "lwa_link": ('<mass value="2"/><origin xyz="0 0.1 0.05"/>', "lacks <inertia>"),
    "sdh_link": ('<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>', "lacks <mass>"),
}
"""Body → its <inertial> and the expected error."""


def robot(body: str) -> str:
    """A URDF of two revolute joints; the first moves the body."""
    return CHAIN.format(name="robot", body=body, inertial=BODIES[body][0])
