/* The processor for which a source is compiled.  On x86-64 every loop is compiled twice, the second
   time, where COSCREW_FOR_AVX2 is defined, for AVX2, with FMA if COSCREW_WITH_FMA; one is chosen at
   run time, and both give the same bits.

   Plain loops must not have FMA: gcc's vectoriser fuses products into sums in spite of its flag
   where sums and differences alternate, which does not occur in compensated loops. */
#ifndef COSCREW_PROCESSORS_H
#define COSCREW_PROCESSORS_H

#ifndef COSCREW_WITH_FMA
#define COSCREW_WITH_FMA 0
#endif
#ifndef COSCREW_ON_VECTORS
#define COSCREW_ON_VECTORS 0 /* whether there are kernels on vectors */
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define COSCREW_HAS_AVX2 1
#else
#define COSCREW_HAS_AVX2 0
#endif

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#if COSCREW_ON_VECTORS
#include <immintrin.h> /* its functions have attributes of their own */
#ifndef __AVX__
#define KSL_REGISTER_BYTES 32 /* clang's attribute defines no __AVX__ */
#endif
#endif
#if COSCREW_WITH_FMA
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#define KSL_HAS_FMA 1 /* clang's attribute defines no __FMA__ */
#else
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#endif
#elif defined(COSCREW_FOR_AVX2)
#if COSCREW_WITH_FMA
#pragma GCC target("avx2,fma,no-avx512f")
#else
#pragma GCC target("avx2,no-fma,no-avx512f")
#endif
#elif COSCREW_HAS_AVX2 && !defined(__clang__)
#pragma GCC target("no-fma,no-avx512f")
#endif

#endif
