/* What templates/runtime/calls/threads.h promises; nothing here depends on time.  Where
   threads must meet, a break is a deadlock, which an alarm ends after minutes.  Prints the law that
   does not hold. */
#define _POSIX_C_SOURCE 200809L
#include <fenv.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static int left = 1000; /* threads that can still be started */

static int created(pthread_t *thread, void *(*run)(void *), void *given) {
  return left-- > 0 ? pthread_create(thread, NULL, run, given) : 1;
}
static time_t ahead = -1000000; /* seconds by which a clock is: threads wait so much longer, or not at all */

static int told(clockid_t clock, struct timespec *now) {
  const int failed = clock_gettime(clock, now);
  now->tv_sec += __atomic_load_n(&ahead, __ATOMIC_RELAXED);
  return failed;
}
#define pthread_create(thread, attributes, run, given) created(thread, run, given)
#define clock_gettime(clock, now) told(clock, now)
#include "runtime/calls/threads.h"
#undef pthread_create
#undef clock_gettime

enum { N = 20000, DEADLOCK = 600 };

static void check(int holds, const char *law) {
  if (holds) return;
  printf("%s\n", law);
  fflush(stdout);
  _exit(1);
}

/* A call: y = x / 3; the first pieces end when so many threads are there. */
typedef struct {
  const double *x;
  double *y;
  ptrdiff_t meeting, *met;
} quotients;

static void divide(const void *call, ptrdiff_t first, ptrdiff_t n) {
  const quotients *q = (const quotients *)call;
  __atomic_fetch_add(q->met, 1, __ATOMIC_RELAXED);
  while (__atomic_load_n(q->met, __ATOMIC_RELAXED) < q->meeting) sched_yield();
  for (ptrdiff_t k = first; k < first + n; k++) {
    volatile double three = 3;
    q->y[k] = q->x[k] / three;
  }
}

static double numbers[N], alone[N];

/* Quotients of n numbers by several threads, at least `meeting` of them, have the bits of one. */
static void divided(ptrdiff_t n, ptrdiff_t threads, ptrdiff_t meeting, const char *law) {
  double *y = (double *)malloc(sizeof numbers);
  ptrdiff_t met = 0;
  const quotients q = { numbers, y, meeting, &met };
  memset(y, 0, sizeof numbers);
  share(divide, &q, n, threads);
  check(!memcmp(y, alone, (size_t)n * sizeof *y), law);
  free(y);
}

static void by_one(void) {
  ptrdiff_t met = 0;
  const quotients q = { numbers, alone, 0, &met };
  divide(&q, 0, N);
}

static void *caller(void *given) {
  const ptrdiff_t number = *(const ptrdiff_t *)given;
  for (ptrdiff_t k = 0; k < 60; k++) {
    divided(N - 100 * k, 2 + (number + k) % 4, 0, "several callers at once: the bits of one thread");
    divided(2048 + k, 2, 2, "several callers at once: each with its threads");
  }
  return NULL;
}

static void callers_at_once(void) {
  enum { CALLERS = 6 };
  pthread_t threads[CALLERS];
  ptrdiff_t given[CALLERS];
  for (ptrdiff_t k = 0; k < CALLERS; k++) {
    given[k] = k;
    check(!pthread_create(&threads[k], NULL, caller, &given[k]), "threads can be started");
  }
  for (ptrdiff_t k = 0; k < CALLERS; k++) pthread_join(threads[k], NULL);
}

static void all_exit_well(pid_t child, const char *law) {
  int status = -1;
  if (!child) {
    alarm(DEADLOCK);
    divided(N, 3, 3, law);
    check(own_pool()->started == 2, law);
    exit(0);
  }
  check(child > 0 && waitpid(child, &status, 0) == child && !status, law);
}

/* So many threads that wait at last. */
static void wait_for(ptrdiff_t threads) {
  pool *its = own_pool();
  for (ptrdiff_t found = -1; found != threads; sched_yield()) {
    pthread_mutex_lock(&its->lock);
    found = its->started;
    check(its->spare <= found, "no more threads wait than there are");
    pthread_mutex_unlock(&its->lock);
  }
}

/* Of threads that do not wait long; from then on they do. */
static void ends(void) {
  for (int k = 0; k < 100; k++) {
    divided(N, 4, 4, "threads that end are started again");
    if (k % 10 == 0) wait_for(0);
  }
  wait_for(0);
  check(!own_pool()->spare && !own_pool()->calls, "no thread waits when all have ended");
  __atomic_store_n(&ahead, 1000000, __ATOMIC_RELAXED);
}

static volatile int going = 1;

static void *calls_until_told(void *given) {
  while (__atomic_load_n(&going, __ATOMIC_RELAXED)) divided(N, 2, 0, "calls while another thread forks");
  return given;
}

static void forks(void) {
  all_exit_well(fork(), "a child starts its own threads");
  pool *its = own_pool();
  pthread_mutex_lock(&its->lock);
  const pid_t child = fork(); /* as if another thread had the lock */
  if (child) pthread_mutex_unlock(&its->lock);
  all_exit_well(child, "a child of a process whose threads are locked");
  pthread_t other;
  check(!pthread_create(&other, NULL, calls_until_told, NULL), "threads can be started");
  for (int k = 0; k < 20; k++) all_exit_well(fork(), "a child of a process that computes");
  __atomic_store_n(&going, 0, __ATOMIC_RELAXED);
  pthread_join(other, NULL);
}

int main(int count, char **words) {
  alarm(DEADLOCK);
  for (int k = 0; k < N; k++) numbers[k] = 1 + k;
  by_one();

  ends();
  left = 1000;
  divided(2047, 2, 0, "few states: without threads");
  check(left == 1000, "few states: without threads");

  left = 0;
  divided(N, 4, 0, "no thread can be started: the caller computes");
  left = 1;
  divided(N, 4, 2, "one thread can be started: two compute");
  left = 1000;
  divided(N, 4, 4, "threads can be started again");
  check(own_pool()->started == 3 && left == 998, "threads that wait are not started again");

  for (int k = 0; k < 2000; k++) divided(4096, 2 + k % 3, 2 + k % 3, "call after call");
  check(own_pool()->started == 3, "call after call: no more threads");

  fesetround(FE_UPWARD);
  double nearest[N];
  memcpy(nearest, alone, sizeof alone);
  by_one();
  check(memcmp(nearest, alone, sizeof alone), "rounding upward changes bits");
  divided(N, 3, 3, "threads round as the caller does");
  fesetround(FE_TONEAREST);
  by_one();
  divided(N, 3, 3, "threads round as the caller does, again");

  sigset_t one; /* would end the process if a thread that waits took it */
  int taken = 0;
  sigemptyset(&one);
  sigaddset(&one, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &one, NULL);
  check(!kill(getpid(), SIGUSR1) && !sigwait(&one, &taken) && taken == SIGUSR1, "signals are the caller's");

  callers_at_once();
  check(own_pool()->spare == own_pool()->started && !own_pool()->calls, "after calls all threads wait");
  if (count == 1 || strcmp(words[1], "unforked")) forks();
  return 0;
}
