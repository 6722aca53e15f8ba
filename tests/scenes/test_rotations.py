"""Rotations are right to 50 digits, right angles are exact, and rotations compose in the stated
order."""

from fractions import Fraction as F

import mpmath
import pytest

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.rotations import SNAP
from tests.support.cases import for_all

mpmath.mp.dps = 60

ANGLES = ("0", "1.57079632679", "-1.5707963267948966", "3.14159265359", "-3.141592653589793",
          "0.7853981633974483", "0.1", "-2.5", "6.283185307179586", "1e-12", "1e-10", "12345.678")


def matrix(R):
    return mpmath.matrix(3, 3) + mpmath.matrix([[mpmath.mpf(x.numerator) / x.denominator
                                                 for x in R[3 * i:3 * i + 3]] for i in range(3)])


def about(axis, angle):
    """exp(angle axis~), by its series in 60 digits."""
    x, y, z = (mpmath.mpf(a) for a in axis)
    norm = mpmath.sqrt(x * x + y * y + z * z)
    return mpmath.expm(mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]) * (angle / norm))


def number(text):
    return mpmath.mpf(F(text).numerator) / F(text).denominator


def distance(A, B):
    return max(abs(x) for x in A - B)


@pytest.mark.parametrize("roll", ANGLES)
@for_all(yaw=ANGLES[:7:2], pitch=ANGLES[:7])
def test_rpy_is_yaw_pitch_roll(roll, pitch, yaw):
    R = rotations.from_rpy(F(roll), F(pitch), F(yaw))
    truth = (about((0, 0, 1), number(yaw)) * about((0, 1, 0), number(pitch))
             * about((1, 0, 0), number(roll)))
    assert distance(matrix(R), truth) < 4 * float(SNAP)
    assert distance(matrix(R) * matrix(R).T, mpmath.eye(3)) < 4 * float(SNAP)


@pytest.mark.parametrize("angles", [("0.3", "-1.1", "2.9"), ("0.01", "0.02", "1e-3")])
def test_slanted_rotations_are_good_to_fifty_digits(angles):
    R = rotations.from_rpy(*map(F, angles))
    truth = (about((0, 0, 1), number(angles[2])) * about((0, 1, 0), number(angles[1]))
             * about((1, 0, 0), number(angles[0])))
    assert distance(matrix(R), truth) < mpmath.mpf(10)**-48


@pytest.mark.parametrize("axis", [(1, 2, -3), (0, 0, 5), (1, 1, 0)])
@pytest.mark.parametrize("angle", ["0.3", "-2.75", "100"])
def test_axis_angle_is_the_exponential(axis, angle):
    R = rotations.from_axis_angle(tuple(map(F, axis)), F(angle))
    assert distance(matrix(R), about(axis, number(angle))) < mpmath.mpf(10)**-47


@pytest.mark.parametrize("quaternion", [("0.5", "0.5", "0.5", "0.5"), ("0", "-0.8", "0", "0.6"),
                                        ("0.1", "-0.7", "0.3", "2")])
def test_quaternions_turn_like_their_axis_and_angle(quaternion):
    *vector, scalar = map(number, quaternion)
    angle = 2 * mpmath.atan2(mpmath.norm(vector), scalar)
    R = rotations.from_quaternion(tuple(map(F, quaternion)))
    truth = about(vector, angle)
    assert distance(matrix(R), truth) < mpmath.mpf(10)**-48


@pytest.mark.parametrize("quarter", ["1.57079632679", "1.5707963267949", "1.5707963267948966",
                                     "1.570796326794896619231321691639751442"])
def test_right_angles_are_exact_however_they_are_written(quarter):
    assert rotations.from_rpy(F(quarter), F(0), F(0)) == (1, 0, 0, 0, 0, -1, 0, 1, 0)
    assert rotations.from_rpy(F(0), F(quarter), -F(quarter)) == (0, 1, 0, 0, 0, -1, -1, 0, 0)
    assert rotations.from_axis_angle((F(0), F(2), F(0)), F(quarter)) == (0, 0, 1, 0, 1, 0, -1, 0, 0)


def test_opposite_slanted_turns_leave_no_residue():
    turn = rotations.from_rpy(F("0.3"), F("0.2"), F("-0.7"))
    back = tuple(turn[3 * j + i] for i in range(3) for j in range(3))
    assert rotations.product(turn, back) == rotations.IDENTITY


def test_only_what_is_within_the_tolerance_snaps():
    beyond = SNAP * F(1001, 1000)
    for one in (F(1), F(-1)):
        for off in (SNAP, -SNAP):
            assert rotations.snapped((one + off, off, -off)) == (one, 0, 0)
            assert rotations.snapped((off, one)) == (0, one)
        for off in (beyond, -beyond):
            assert rotations.snapped((one + off, F(0), F(0))) == (one + off, 0, 0)
            assert rotations.snapped((one, off, F(0))) == (one, off, 0)
    assert rotations.snapped((F(2), F(1, 2), SNAP)) == (2, F(1, 2), 0)
    assert rotations.snapped((2 + SNAP / 2, F(0), F(0))) == (2 + SNAP / 2, 0, 0)


def test_entries_near_one_stay_where_others_stand_beside_them():
    """The cosine of 1e-6 is within 1e-12 of 1, but the sine is not within 1e-12 of 0: neither is
    snapped."""
    small = F(1, 10**6)
    cosine = 1 - small**2 / 2
    turn = (cosine, -small, F(0), small, cosine, F(0), F(0), SNAP, 1 - SNAP)
    assert rotations.snapped(turn) == (*turn[:7], 0, 1)


@pytest.mark.parametrize("rough", ["1.5708", "-1.570796", "3.1416", "1.5707963"])
def test_rough_right_angles_stay_rotations(rough):
    """Sines near 1 are left alone where the cosine beside them is not zero."""
    R = matrix(rotations.from_rpy(F(rough), F(0), F(rough)))
    truth = about((0, 0, 1), number(rough)) * about((1, 0, 0), number(rough))
    assert distance(R, truth) < float(SNAP)
    assert distance(R * R.T, mpmath.eye(3)) < float(SNAP)


def test_axes_are_normalised_and_snapped():
    assert rotations.unit((F(0), F(-3), F(0))) == (0, -1, 0)
    assert rotations.unit((F("6e-17"), F(0), F("0.9999"))) == (0, 0, 1)
    assert rotations.unit((F(10)**-300, F(0), F(0))) == (1, 0, 0)
    axis = rotations.unit((F(1), F(2), F(2)))
    assert all(abs(x - y) < F(1, 10**49)
               for x, y in zip(axis, (F(1, 3), F(2, 3), F(2, 3)), strict=True))
    with pytest.raises(ValueError, match="zero"):
        rotations.unit((F(0),) * 3)
    with pytest.raises(ValueError, match="zero"):
        rotations.from_quaternion((F(0),) * 4)


def test_moments_turn_with_their_frame():
    """R I R^T: invariants stay, and a quarter turn about z exchanges xx and yy exactly."""
    moments = tuple(map(F, ("1", "2", "3", "0.1", "0.2", "-0.3")))
    quarter = rotations.from_rpy(F(0), F(0), F("1.5707963267949"))
    assert rotations.rotated(quarter, moments) == (2, 1, 3, F("-0.1"), F("0.3"), F("0.2"))
    turned = rotations.rotated(rotations.from_rpy(F("0.4"), F("-1.2"), F("2")), moments)
    assert abs(sum(turned[:3]) - 6) < F(1, 10**47)


def test_the_same_angles_give_the_same_fractions():
    angles = F("0.123"), F("-1.5"), F("2.25")
    before = rotations.from_rpy(*angles)
    with mpmath.workdps(15):
        assert rotations.from_rpy(*angles) == before
