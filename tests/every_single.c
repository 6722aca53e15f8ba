/* Judges the elementary functions of one single-precision argument by the C library's in long double.

   every_single FIRST LAST STRIDE takes the arguments whose bits are FIRST, FIRST + STRIDE, … below
   LAST <= 2^31, and prints for each function: the largest error of normal results in ulps of the
   true value, and where; that of smaller ones in the least subnormal number, and where; how many
   special values or signs are wrong, and the last such argument.  Arguments below zero must have
   the same bits where the function is odd or even; exp is judged there too. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ksl/elementary.h"

typedef struct {
  double error[2]; /* of normal results, of smaller ones */
  uint32_t where[2], strange;
  uint64_t wrong;
} Found;

static uint32_t bits_of(float x) {
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static float of_bits(uint32_t bits) {
  float x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* x 2^n, n from -1022 to 1023. */
static double scaled(double x, int n) {
  const uint64_t bits = (uint64_t)(1023 + n) << 52;
  double power;
  memcpy(&power, &bits, sizeof power);
  return x * power;
}

static void judge(uint32_t x, float got, long double truth, Found *found) {
  if (isnan(truth) || fabsl(truth) >= 0x1.ffffffp127L || truth == 0) {
    const float wanted = truth == 0 ? (float)truth : copysignf(INFINITY, (float)truth);
    if (isnan(truth) ? !isnan(got) : bits_of(got) != bits_of(wanted)) {
      found->wrong++, found->strange = x;
    }
    return;
  }
  const double size = fabs((double)truth);
  uint64_t exponent;
  memcpy(&exponent, &size, sizeof exponent);
  const int e = (int)(exponent >> 52) - 1023, small = e < -126;
  const double error = scaled((double)fabsl((long double)got - truth), 23 - (small ? -126 : e));
  if (!(error <= found->error[small])) { found->error[small] = error, found->where[small] = x; }
}

static void mirrored(uint32_t x, float got, float wanted, Found *found) {
  if (!isnan(wanted) && bits_of(got) != bits_of(wanted)) { found->wrong++, found->strange = x; }
}

#define EACH(odd, even, other) odd(sin) even(cos) odd(tanh) other(exp)
#define NAME(name) #name,
static const char *const names[] = {EACH(NAME, NAME, NAME)};
#define INDEX(name) INDEX_##name,
enum { EACH(INDEX, INDEX, INDEX) COUNT };

#define JUDGE(name) \
  const float name##_x = ksl_##name##f(x); \
  judge(i, name##_x, name##l((long double)x), &found[INDEX_##name]);
#define ODD(name) JUDGE(name) mirrored(below, ksl_##name##f(-x), -name##_x, &found[INDEX_##name]);
#define EVEN(name) JUDGE(name) mirrored(below, ksl_##name##f(-x), name##_x, &found[INDEX_##name]);
#define OTHER(name) \
  JUDGE(name) judge(below, ksl_##name##f(-x), name##l(-(long double)x), &found[INDEX_##name]);

int main(int count, char **words) {
  static Found found[COUNT];
  if (count != 4) { return 2; }
  const uint32_t last = (uint32_t)strtoul(words[2], NULL, 0);
  const uint32_t stride = (uint32_t)strtoul(words[3], NULL, 0);
  for (uint32_t i = (uint32_t)strtoul(words[1], NULL, 0); i < last; i += stride) {
    const float x = of_bits(i);
    const uint32_t below = i | 0x80000000u;
    EACH(ODD, EVEN, OTHER)
  }
  for (int n = 0; n < COUNT; n++) {
    const Found *f = &found[n];
    printf("%s %.6f %a %.6f %a %llu %a\n", names[n], f->error[0], (double)of_bits(f->where[0]),
           f->error[1], (double)of_bits(f->where[1]), (unsigned long long)f->wrong,
           (double)of_bits(f->strange));
  }
}
