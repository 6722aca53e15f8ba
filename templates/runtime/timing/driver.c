/* Times several loops: each once per round, after an untimed call; the order rotates from round to
   round. */
#define _POSIX_C_SOURCE 199309L
#include <time.h>

typedef void (*kernel)(long n, void *const *arguments);

static double now_ns(void) {
  struct timespec t;
#if defined(CLOCK_MONOTONIC)
  clock_gettime(CLOCK_MONOTONIC, &t);
#else
  timespec_get(&t, TIME_UTC);
#endif
  return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* ns[round][k]: nanoseconds per element of loop k, which is called calls[k] times. */
void time_rounds(long loops, const kernel *run, const long *n, void *const *const *arguments,
    const long *calls, long rounds, double *ns);

void time_rounds(long loops, const kernel *run, const long *n, void *const *const *arguments,
    const long *calls, long rounds, double *ns) {
  for (long round = 0; round < rounds; round++) {
    for (long turn = 0; turn < loops; turn++) {
      const long k = (round + turn) % loops;
      run[k](n[k], arguments[k]);
      const double start = now_ns();
      for (long call = 0; call < calls[k]; call++) { run[k](n[k], arguments[k]); }
      ns[round * loops + k] = (now_ns() - start) / ((double)calls[k] * (double)n[k]);
    }
  }
}
