# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them.

In double precision, plain tier.
"""

from coscrew._kernel import double_kernel as kernel


@kernel("(6,6)->(6,6)")
def mat6x6_copy(M):
    """Mo = M.

    (6,6)->(6,6).  M, Mo: 6×6 operator.
    No arithmetic.  Exact.
    """
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    return (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21,
        M_22, M_23, M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44,
        M_45, M_50, M_51, M_52, M_53, M_54, M_55)


@kernel("(6,6)->(6,6)")
def mat6x6_setIdentity(self):
    """self = I.

    (6,6)->(6,6).  self: 6×6 operator.
    No arithmetic.  Exact.
    """
    return (1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1,
        0, 0, 0, 0, 0, 0, 1)


@kernel("(6,6)->(6,6)")
def mat6x6_transposed(M):
    """Mo = M^T.

    (6,6)->(6,6).  M, Mo: 6×6 operator.
    No arithmetic.  Exact.
    """
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    return (M_00, M_10, M_20, M_30, M_40, M_50, M_01, M_11, M_21, M_31, M_41, M_51, M_02, M_12,
        M_22, M_32, M_42, M_52, M_03, M_13, M_23, M_33, M_43, M_53, M_04, M_14, M_24, M_34, M_44,
        M_54, M_05, M_15, M_25, M_35, M_45, M_55)
