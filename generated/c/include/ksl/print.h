/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Printing to streams of the Kinematics Subroutine Library: not part of this library. */
#error "ksl/print.h is not here: print the members, as in printf(\"%g\", v.x)"
