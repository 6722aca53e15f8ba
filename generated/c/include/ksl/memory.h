/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Arrays of pointers of the Kinematics Subroutine Library: not part of this library.
   Reason: one allocator for each type of C, of arrays of pointers to rows, which nothing here takes.
   Names:
   ksl_array2D_alloc, ksl_array2D_free, ksl_array2Db_alloc, ksl_array2Db_free, ksl_array2Dc_alloc,
   ksl_array2Dc_free, ksl_array2Df_alloc, ksl_array2Df_free, ksl_array2Di_alloc, ksl_array2Di_free,
   ksl_array2Dui_alloc, ksl_array2Dui_free, ksl_array_free, ksl_arrayb_free, ksl_arrayc_free,
   ksl_arrayf_free, ksl_arrayi_free, ksl_arrayui_free. */
#error "ksl/memory.h is not here: use calloc and free; for the system's memory.h include string.h"
