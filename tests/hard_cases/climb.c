/* Climbs to inputs with large errors: hill climbing, started again and again.

   The kernel, its domain and its truth in long double are in the file CASE, made by climb.py.
   climb SEED SECONDS [PARAMETERS …], the parameters of earlier champions, prints for each group of
   results: its error in u, parameters, inputs, outputs; and then rows of inputs and outputs that
   it cannot judge.  Time is the processor's. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include CASE
#define SUSPECTS 8

static uint64_t state;

static uint64_t bits(void) { /* splitmix64 */
  uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

static double uniform(double low, double high) {
  return low + (high - low) * ((double)(bits() >> 11) * 0x1p-53);
}

static int below(int n) { return (int)(bits() % (uint64_t)n); }

static double normal(void) {
  return sqrt(-2 * log(uniform(0x1p-60, 1))) * cos(uniform(0, 6.283185307179586));
}

/* Anywhere to π, tiny, just below π, around the ends of series, and beyond π where that may be. */
static double an_angle(double largest) {
  static const double ends[] = {1, 2, 3, 1.5707963267948966, 0.7853981633974483};
  switch (below(largest > 4 ? 5 : 4)) {
    case 0: return uniform(0, 3.141592653589793);
    case 1: return exp(uniform(-30, 0));
    case 2: return 3.141592653589793 - exp2(-uniform(0, 56));
    case 3: return ends[below(5)] + (below(2) ? 1 : -1) * exp2(-uniform(0, 56));
    default: return exp(uniform(1, log(largest)));
  }
}

/* A unit vector anywhere, near a plane or an axis, or in one. */
static void a_direction(double *x) {
  const int kind = below(3);
  for (;;) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
      x[i] = normal();
      if (kind == 1 && below(5) < 3) { x[i] *= exp2(-uniform(0, 60)); }
      if (kind == 2 && below(5) < 3) { x[i] = 0; }
      square += x[i] * x[i];
    }
    if (square == 0) { continue; }
    for (int i = 0; i < 3; i++) { x[i] /= sqrt(square); }
    return;
  }
}

static void a_turn(double *x, double largest) {
  const double angle = an_angle(largest);
  a_direction(x);
  for (int i = 0; i < 3; i++) { x[i] *= angle; }
}

static void a_lever(double *x) {
  const double size = below(2) ? exp2(uniform(-40, 40)) : 1;
  const int uneven = below(4) == 0;
  a_direction(x);
  for (int i = 0; i < 3; i++) { x[i] *= size * (uneven ? exp2(uniform(-30, 0)) : 1); }
}

/* A third combination of two rows, except for little; or any. */
static void rows(double *p) {
  const double a = normal(), b = below(3) ? normal() : 0, off = exp2(-uniform(0, 60));
  for (int i = 0; i < 3; i++) { a_lever(p + 3 * i); }
  if (below(2)) {
    const int last = 3 * below(3), first = (last + 3) % 9, second = (last + 6) % 9;
    for (int i = 0; i < 3; i++) {
      p[last + i] = a * p[first + i] + b * p[second + i] + off * p[last + i];
    }
  }
}

static void draw(double *p) {
  for (const char *kind = KINDS; *kind; kind++) {
    switch (*kind) {
      case 't': a_turn(p, LARGEST); p += 3; break;
      case 'u': a_direction(p); p += 3; break;
      case 'l': a_lever(p); p += 3; break;
      case 'a': p[0] = (below(2) ? 1 : -1) * an_angle(3); p += 1; break;
      case 'f': p[0] = below(3) ? uniform(0, 1) : below(3) / 2.0; p += 1; break;
      case 'q': {
        const double half = an_angle(3) / 2, sign = below(2) ? 1 : -1;
        a_direction(p);
        for (int i = 0; i < 3; i++) { p[i] *= sign * sin(half); }
        p[3] = sign * cos(half);
        p += 4;
        break;
      }
      case 'r': rows(p); p += 9; break;
      case 'm': p[0] = below(2) ? uniform(-20, 20) : 0; p += 1; break;
    }
  }
}

static double changed(double x, double other) {
  switch (below(7)) {
    case 0: return (double)((REAL)x + (REAL)(below(9) - 4) * (REAL)(fabs(x) * U));
    case 1: return x * (1 + normal() * exp2(-uniform(0, 54)));
    case 2: return ldexp(x, below(7) - 3);
    case 3: return other;
    case 4: return below(10) < 7 ? -x : 0;
    case 5: return x + normal() * exp2(-uniform(0, 60));
    default: return x * (1 + normal() * 0.1);
  }
}

static REAL inputs[INPUTS], outputs[OUTPUTS];

/* Inputs whose errors tell nothing here: NaN, or so large that it may be another branch near π; or two
   ways are right. */
static REAL suspects[2][SUSPECTS][INPUTS + OUTPUTS];
static uint64_t seen[2];

static void suspect(int finite) { /* each that is seen is kept with the same probability */
  const uint64_t n = seen[finite]++, at = n < SUSPECTS ? n : bits() % (n + 1);
  if (at >= SUSPECTS) { return; }
  memcpy(suspects[finite][at], inputs, sizeof inputs);
  memcpy(suspects[finite][at] + INPUTS, outputs, sizeof outputs);
}

/* The error of a group, in u; negative where it tells nothing. */
static double error_of(const double *p, int group) {
  long double errors[JUDGED], sizes[JUDGED], size = 0, worst = 0;
  made(p, inputs);
  evaluate(inputs, outputs);
#ifdef OPPOSITE
  if (opposite(inputs)) { return suspect(1), -1; } /* either way is right: 60 digits tell */
#endif
  judged(inputs, outputs, errors, sizes);
  for (int i = 0; i < JUDGED; i++) {
    if (PLACES[group][i]) {
      size = fmaxl(size, fabsl(sizes[i]));
      worst = errors[i] <= worst ? worst : errors[i];
      if (isnan(worst)) { return suspect(0), -1; }
    }
  }
  for (int i = 0; i < INPUTS; i++) {
    if (BESIDE[group][i]) { size = fmaxl(size, fabsl((long double)inputs[i])); }
  }
  if (!(size > LEAST)) { return 0; }
  const double found = (double)(worst / (size * (long double)U));
  return found < 1000 ? found / (1 + SLOPE[group] * turned(inputs)) : (suspect(1), -1);
}

static double champion[GROUPS][PARAMETERS], best[GROUPS];

static void climb(int group) {
  double p[PARAMETERS], child[PARAMETERS], mine = -1;
  if (best[group] > 0 && below(3) == 0) {
    memcpy(p, champion[group], sizeof p);
    for (int n = below(4); n > 0; n--) {
      const int i = below(PARAMETERS);
      p[i] = changed(p[i], p[below(PARAMETERS)]);
    }
    mine = error_of(p, group);
  } else {
    for (int n = 0; n < 300; n++) {
      draw(child);
      const double found = error_of(child, group);
      if (found > mine) { mine = found, memcpy(p, child, sizeof p); }
    }
  }
  for (int idle = 0; idle < 1500 && mine >= 0; idle++) {
    memcpy(child, p, sizeof p);
    for (int n = 1 + below(3); n > 0; n--) {
      const int i = below(PARAMETERS);
      child[i] = changed(child[i], child[below(PARAMETERS)]);
      if (!isfinite(child[i])) { child[i] = 0; }
    }
    const double found = error_of(child, group);
    if (found >= mine) {
      idle = found > mine ? 0 : idle;
      mine = found, memcpy(p, child, sizeof p);
    }
  }
  if (mine > best[group]) { best[group] = mine, memcpy(champion[group], p, sizeof p); }
}

int main(int count, char **words) {
  const double seconds = atof(words[2]);
  const int rounds = atoi(words[3]) > GROUPS ? atoi(words[3]) : GROUPS;
  state = strtoull(words[1], NULL, 10);
  for (int g = 0, w = 4; g < GROUPS && w + PARAMETERS <= count; g++, w += PARAMETERS) {
    for (int i = 0; i < PARAMETERS; i++) { champion[g][i] = strtod(words[w + i], NULL); }
    best[g] = error_of(champion[g], g);
  }
  for (int n = 0; n < rounds || (double)clock() / CLOCKS_PER_SEC < seconds; n++) {
    climb(n % GROUPS);
  }
  for (int g = 0; g < GROUPS; g++) {
    printf("%.6f", error_of(champion[g], g));
    for (int i = 0; i < PARAMETERS; i++) { printf(" %a", champion[g][i]); }
    for (int i = 0; i < INPUTS; i++) { printf(" %a", (double)inputs[i]); }
    for (int i = 0; i < OUTPUTS; i++) { printf(" %a", (double)outputs[i]); }
    printf("\n");
  }
  for (int kind = 0; kind < 2; kind++) {
    for (uint64_t n = 0; n < seen[kind] && n < SUSPECTS; n++) {
      printf("?");
      for (int i = 0; i < INPUTS + OUTPUTS; i++) { printf(" %a", (double)suspects[kind][n][i]); }
      printf("\n");
    }
  }
  return 0;
}
