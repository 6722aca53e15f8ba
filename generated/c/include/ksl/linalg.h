/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Linear algebra on arrays of the Kinematics Subroutine Library: not part of this library.
   Reason: matrices here have fixed sizes; LAPACK solves any size, with pivots and error estimates.
   Names:
   ksl_linalg_gramSchmidt, ksl_linalg_gramSchmidtf, ksl_linalg_cholesky_cmo,
   ksl_linalg_cholesky_rmo, ksl_linalg_cholesky_backwardSubstitution_cmo,
   ksl_linalg_cholesky_backwardSubstitution_rmo, ksl_linalg_cholesky_forwardElimination_cmo,
   ksl_linalg_cholesky_forwardElimination_rmo, ksl_linalg_cholesky_solve_cmo,
   ksl_linalg_cholesky_solve_rmo, ksl_linalg_ldlt_cmo, ksl_linalg_ldlt_rmo,
   ksl_linalg_ldlt_backwardSubstitution_cmo, ksl_linalg_ldlt_backwardSubstitution_rmo,
   ksl_linalg_ldlt_forwardElimination_cmo, ksl_linalg_ldlt_forwardElimination_rmo,
   ksl_linalg_ldlt_solve_cmo, ksl_linalg_ldlt_solve_rmo, ksl_linalg_lu_cmo, ksl_linalg_lu_rmo,
   ksl_linalg_lu_full_cmo, ksl_linalg_lu_full_rmo, ksl_linalg_lu_full_specified_cmo,
   ksl_linalg_lu_full_specified_rmo, ksl_linalg_lu_setBMatrix_cmo, ksl_linalg_lu_setBMatrix_rmo,
   ksl_linalg_lu_setCMatrix_cmo, ksl_linalg_lu_setCMatrix_rmo, ksl_linalg_lu_infinityNormB_rmo,
   ksl_linalg_symmetricMatrixInverse_cmo, ksl_linalg_symmetricMatrixInverse_rmo. */
#error "ksl/linalg.h is not here: for A x = b see ksl/symmetric.h and ksl_mat3x3_inverted in ksl/mat3x3.h, for Gram-Schmidt ksl_mat3x3_normalize, else use LAPACK"
