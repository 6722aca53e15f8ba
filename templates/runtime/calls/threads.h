/* Shares the states of a call among threads, which wait between calls. */
#ifndef COSCREW_THREADS_H
#define COSCREW_THREADS_H

#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L /* signals of threads, clocks; before any other header */
#endif

#include <fenv.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stddef.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/* Pieces of n states, which threads take one after the other: large ones first, small ones last, so
   that a thread that starts late computes less and all end together. */
typedef struct pieces {
  void (*compute)(const void *call, ptrdiff_t first, ptrdiff_t n);
  const void *call;
  ptrdiff_t n, threads, next;
  fenv_t rounding;           /* the caller's, so that all threads round alike */
  ptrdiff_t places, working; /* threads that may still join; those that have joined and not ended */
  struct pieces *also;       /* another call with places */
} pieces;
enum { PIECE = 1024 }; /* states of the least piece */
enum { MOST = 256 };   /* threads */
enum { YIELDS = 200 }; /* of the processor before a thread sleeps: under 0.1 ms if none wants it */
enum { WAIT = 10 };    /* seconds without a call after which a thread ends */

static void take_pieces(pieces *all) {
  ptrdiff_t first = __atomic_load_n(&all->next, __ATOMIC_RELAXED);
  while (first < all->n) {
    const ptrdiff_t rest = all->n - first;
    const ptrdiff_t half = rest / (2 * all->threads) / 16 * 16; /* of what each thread takes */
    const ptrdiff_t wanted = half < PIECE ? PIECE : half, size = rest < wanted ? rest : wanted;
    if (__atomic_compare_exchange_n(
            &all->next, &first, first + size, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
      all->compute(all->call, first, size);
      first = __atomic_load_n(&all->next, __ATOMIC_RELAXED);
    }
  }
}

/* Threads that wait for calls, at first awake, as calls often follow each other in a loop: to wake
   one takes some pieces' time, to start one more. */
typedef struct {
  pid_t process;
  pthread_mutex_t lock;
  pthread_cond_t called, ended;
  pieces *calls;            /* with places */
  ptrdiff_t begun;          /* how many calls were */
  ptrdiff_t started, spare; /* threads; those that compute nothing, less all places */
} pool;

/* Wait, awake for a while, until there is a call or none has come for WAIT seconds; holds the lock
   before and after. */
static void wait_awhile(pool *its) {
  if (!its->calls) {
    const ptrdiff_t begun = its->begun;
    pthread_mutex_unlock(&its->lock);
    for (int k = 0; k < YIELDS && __atomic_load_n(&its->begun, __ATOMIC_RELAXED) == begun; k++)
      sched_yield();
    pthread_mutex_lock(&its->lock);
  }
  struct timespec end;
  clock_gettime(CLOCK_REALTIME, &end);
  end.tv_sec += WAIT;
  int late = 0;
  while (!its->calls && !late) late = pthread_cond_timedwait(&its->called, &its->lock, &end);
}

static void *wait_for_calls(void *given) {
  pool *its = (pool *)given;
  sigset_t signals; /* which Python's threads handle */
  sigfillset(&signals);
  pthread_sigmask(SIG_BLOCK, &signals, NULL);
  pthread_mutex_lock(&its->lock);
  for (;;) {
    wait_awhile(its);
    if (!its->calls) break;
    pieces *all = its->calls;
    all->places--;
    if (!all->places) its->calls = all->also;
    __atomic_fetch_add(&all->working, 1, __ATOMIC_RELAXED);
    pthread_mutex_unlock(&its->lock);
    fesetenv(&all->rounding);
    take_pieces(all);
    pthread_mutex_lock(&its->lock);
    its->spare++;
    if (!__atomic_sub_fetch(&all->working, 1, __ATOMIC_RELEASE))
      pthread_cond_broadcast(&its->ended); /* `all` may be gone */
  }
  its->started--;
  its->spare--;
  pthread_mutex_unlock(&its->lock);
  return NULL;
}

/* This process's.  After a fork its parent's is of no use: no thread waits, and it may be locked
   for ever. */
static pool *own_pool(void) {
  static pool *latest;
  const pid_t process = getpid();
  pool *found = __atomic_load_n(&latest, __ATOMIC_ACQUIRE);
  if (found && found->process == process) return found;
  pool *made = (pool *)malloc(sizeof *made);
  if (!made) return NULL;
  *made = (pool){ process, PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER,
      PTHREAD_COND_INITIALIZER, NULL, 0, 0, 0 };
  if (__atomic_compare_exchange_n(&latest, &found, made, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE))
    return made;
  free(made);
  return found;
}

/* Offer places to waiting threads and start those that lack, or as many as can be started. */
static void begin_call(pool *its, pieces *all) {
  const ptrdiff_t places = all->places;
  pthread_t thread;
  pthread_mutex_lock(&its->lock);
  all->also = its->calls;
  its->calls = all;
  for (its->spare -= places; its->spare < 0 && its->started < MOST; its->spare++, its->started++) {
    if (pthread_create(&thread, NULL, wait_for_calls, its)) break;
    pthread_detach(thread);
  }
  __atomic_fetch_add(&its->begun, 1, __ATOMIC_RELAXED);
  pthread_mutex_unlock(&its->lock);
  for (ptrdiff_t k = 0; k < places; k++) pthread_cond_signal(&its->called);
}

/* Take back the places that are left, and wait for the threads that have joined, at first awake. */
static void end_call(pool *its, pieces *all) {
  pthread_mutex_lock(&its->lock);
  pieces **at = &its->calls;
  while (*at && *at != all) at = &(*at)->also;
  if (*at) *at = all->also;
  its->spare += all->places;
  pthread_mutex_unlock(&its->lock);
  for (int k = 0; k < YIELDS && __atomic_load_n(&all->working, __ATOMIC_ACQUIRE); k++)
    sched_yield();
  if (!__atomic_load_n(&all->working, __ATOMIC_ACQUIRE)) return;
  pthread_mutex_lock(&its->lock);
  while (__atomic_load_n(&all->working, __ATOMIC_ACQUIRE))
    pthread_cond_wait(&its->ended, &its->lock);
  pthread_mutex_unlock(&its->lock);
}

/* Compute n states in so many threads, this one included, or in fewer if no more can be started. */
static inline void share(void (*compute)(const void *, ptrdiff_t, ptrdiff_t), const void *call,
    ptrdiff_t n, ptrdiff_t threads) {
  const ptrdiff_t most = n / PIECE < MOST ? n / PIECE : MOST;
  const ptrdiff_t wanted = threads < most ? threads : most;
  pool *its = wanted < 2 ? NULL : own_pool();
  if (!its) {
    compute(call, 0, n);
    return;
  }
  pieces all = { compute, call, n, wanted, .places = wanted - 1 };
  fegetenv(&all.rounding);
  begin_call(its, &all);
  take_pieces(&all);
  end_call(its, &all);
}

#endif
