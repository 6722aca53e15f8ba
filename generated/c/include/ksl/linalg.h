/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Linear algebra on arrays of the Kinematics Subroutine Library: not part of this library. */
#error "ksl/linalg.h is not here: for A x = b see ksl/symmetric.h and ksl_mat3x3_inverted in ksl/mat3x3.h, else use LAPACK"
