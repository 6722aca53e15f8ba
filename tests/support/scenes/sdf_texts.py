"""SDF files for tests: two links and a joint."""


def inertial(mass: float, com: str = "0 0 0", turn: str = "0 0 0") -> str:
    """An inertia with products, at this pose."""
    return (f"<inertial><pose>{com} {turn}</pose><mass>{mass}</mass><inertia><ixx>0.05</ixx>"
            "<iyy>0.06</iyy><izz>0.07</izz><ixy>0.01</ixy><iyz>-0.005</iyz></inertia></inertial>")


LINK = '<link name="{0}"><pose{2}>{1}</pose>' + inertial(1) + "</link>"


def chain(joint: str, version: str = "1.9", more: str = "") -> str:
    """Links a and b, b turned by a right angle about z, with a joint."""
    return (f'<sdf version="{version}"><model name="m">{LINK.format("a", "0 0 1 0 0 0", "")}'
            f'{LINK.format("b", "0.5 0 1 0 0 1.5707963267948966", "")}{joint}{more}</model></sdf>')


def hinge(axis: str = "<xyz>0 0 1</xyz>", pose: str = "", name: str = "j", kind: str = "revolute",
          parent: str = "a") -> str:
    """A joint that moves b."""
    return (f'<joint name="{name}" type="{kind}"><parent>{parent}</parent><child>b</child>{pose}'
            f"<axis>{axis}</axis></joint>")
