/* Judges the elementary functions of one argument by the C library's in long double.

   elementary_attack FIRST LAST STRIDE takes the arguments number FIRST, FIRST + STRIDE, … below
   LAST: in single precision those of these bits, with SINGLE undefined pseudo-random doubles.  It
   prints for each function: the largest error of normal results in ulps of the true value, and
   where; that of smaller ones in the least subnormal number, and where; how many special values or
   signs are wrong, and the last such argument.  Arguments below zero must give the same bits where
   the function is odd or even; exp is judged there too. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ksl/elementary.h"

#ifdef SINGLE
typedef float Real;
typedef uint32_t Bits;
#define OWN(name) ksl_##name##f
enum { DIGITS = 24, LEAST_EXPONENT = -126 };
static const long double most = 0x1.ffffffp127L; /* rounds to infinity */
#else
typedef double Real;
typedef uint64_t Bits;
#define OWN(name) ksl_##name
enum { DIGITS = 53, LEAST_EXPONENT = -1022 };
static const long double most = 0x1.fffffffffffff8p1023L;
#endif

typedef struct {
  double error[2]; /* of normal results, of smaller ones */
  Real where[2], strange;
  uint64_t wrong;
} Found;

static Bits bits_of(Real x) {
  Bits bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static Real of_bits(Bits bits) {
  Real x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

#ifdef SINGLE
static Real argument(uint64_t number) { return of_bits((Bits)number); }
#else
static uint64_t mixed(uint64_t z) { /* splitmix64 */
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/* Of any exponent; up to 1, 32 or 2^23; and next to multiples of pi/2. */
static Real argument(uint64_t number) {
  const uint64_t bits = mixed((number + 1) * 0x9e3779b97f4a7c15u);
  const Real part = (Real)(bits >> 11) * 0x1p-53;
  switch (number % 5) {
    case 0: return of_bits(bits >> 1);
    case 1: return part;
    case 2: return part * 32;
    case 3: return part * 0x1p23;
    default: return of_bits(bits_of(rint(part * 0x1p40) * 1.5707963267948966) + bits % 3);
  }
}
#endif

static void judge(Real x, Real got, long double truth, Found *found) {
  if (isnan(truth) || fabsl(truth) >= most || truth == 0) {
    const Real wanted = truth == 0 ? (Real)truth : (Real)copysignl(INFINITY, truth);
    if (isnan(truth) ? !isnan(got) : bits_of(got) != bits_of(wanted)) {
      found->wrong++, found->strange = x;
    }
    return;
  }
  const int exponent = ilogbl(truth), small = exponent < LEAST_EXPONENT;
  const double error = (double)ldexpl(fabsl((long double)got - truth),
                                      DIGITS - 1 - (small ? LEAST_EXPONENT : exponent));
  if (!(error <= found->error[small])) { found->error[small] = error, found->where[small] = x; }
}

static void mirrored(Real x, Real got, Real wanted, Found *found) {
  if (!isnan(wanted) && bits_of(got) != bits_of(wanted)) { found->wrong++, found->strange = x; }
}

#define EACH(odd, even, other) odd(sin) even(cos) odd(tanh) other(exp)
#define NAME(name) #name,
static const char *const names[] = {EACH(NAME, NAME, NAME)};
#define INDEX(name) INDEX_##name,
enum { EACH(INDEX, INDEX, INDEX) COUNT };

#define JUDGE(name) \
  const Real name##_x = OWN(name)(x); \
  judge(x, name##_x, name##l((long double)x), &found[INDEX_##name]);
#define ODD(name) JUDGE(name) mirrored(-x, OWN(name)(-x), -name##_x, &found[INDEX_##name]);
#define EVEN(name) JUDGE(name) mirrored(-x, OWN(name)(-x), name##_x, &found[INDEX_##name]);
#define OTHER(name) \
  JUDGE(name) judge(-x, OWN(name)(-x), name##l(-(long double)x), &found[INDEX_##name]);

int main(int count, char **words) {
  static Found found[COUNT];
  if (count != 4) { return 2; }
  const uint64_t last = strtoull(words[2], NULL, 10), stride = strtoull(words[3], NULL, 10);
  for (uint64_t i = strtoull(words[1], NULL, 10); i < last; i += stride) {
    const Real x = argument(i);
    EACH(ODD, EVEN, OTHER)
  }
  for (int n = 0; n < COUNT; n++) {
    const Found *f = &found[n];
    printf("%s %.6f %a %.6f %a %llu %a\n", names[n], f->error[0], (double)f->where[0], f->error[1],
           (double)f->where[1], (unsigned long long)f->wrong, (double)f->strange);
  }
}
