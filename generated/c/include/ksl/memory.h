/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Arrays of pointers of the Kinematics Subroutine Library: not part of this library. */
#error "ksl/memory.h is not here: use calloc and free; for the system's memory.h include string.h"
