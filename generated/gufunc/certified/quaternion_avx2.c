/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* The loops of the quaternion operations, compiled for AVX2 with FMA on x86-64. */
#if defined(__x86_64__) && defined(__GNUC__)
#define COSCREW_FOR_AVX2
#include "quaternion.c"
#else
typedef int nothing_to_compile;
#endif
