/* Compares functions of many elements with those of one, byte by byte: in both layouts, with elements
   that are shared, apart and unaligned, with outputs that are inputs, for several n.  Prints what
   differs, then how many comparisons there were. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "many.h"

enum { MOST_ELEMENTS = 67, MOST_APART = 3, PAD = 5, UNTOUCHED = 0xA5 };
static const int counts[] = {-1, 0, 1, 2, 7, 67};

/* How a call's arguments lie. */
typedef struct {
  int n, planes, apart, shift, shared, alias; /* shared: index of an input; alias: output */
} Case;

typedef struct {
  char *memory;
  size_t bytes;
  ptrdiff_t plane, stride; /* as the function takes them */
} Operand;

static long comparisons, failures;

/* The place of a component in memory, in numbers from the first. */
static ptrdiff_t place(const Operand *x, int planes, int size, int i, int j) {
  return planes ? j * x->plane + i * x->stride : j + size * i * x->stride;
}

static void number(char *to, int bytes, unsigned seed) {
  static const float few[] = {0, -0.0f, 1, -1, 2, 0.5f, 0.25f, -3, 1e-40f, -1e-30f, 1e9f, -7e6f, 1e30f,
      -3e38f, INFINITY, NAN};
  seed = (seed + 1) * 2654435761u;
  seed ^= seed >> 15;
  const float some = (float)((int)(seed >> 9) - (1 << 22)) / 0x1p21f;
  const double x = seed % 5 ? (double)some : (double)few[seed >> (seed % 7 ? 29 : 28)];
  const float narrow = (float)x;
  memcpy(to, bytes == 8 ? (const void *)&x : &narrow, (size_t)bytes);
}

/* Memory that ends where the operand ends, so that sanitizers see what lies outside. */
static Operand operand(const Kernel *f, const Case *c, int argument) {
  const int size = f->arguments[argument].size, last = c->n > 0 ? c->n - 1 : 0;
  Operand x = {NULL, 0, 0, c->shared & 1 << argument ? 0 : c->apart};
  x.plane = c->planes ? last * x.stride + 1 + PAD : 1;
  const ptrdiff_t numbers = c->n > 0 ? place(&x, c->planes, size, last, size - 1) + 1 : 0;
  x.bytes = (size_t)((numbers + c->shift) * f->bytes);
  x.memory = malloc(x.bytes ? x.bytes : 1);
  if (!x.memory) abort();
  memset(x.memory, UNTOUCHED, x.bytes);
  for (int i = 0; f->arguments[argument].read && i < c->n; ++i)
    for (int j = 0; j < size; ++j)
      number(x.memory + (place(&x, c->planes, size, i, j) + c->shift) * f->bytes, f->bytes,
             (unsigned)((argument * 40 + j) * MOST_ELEMENTS + (x.stride ? i : 0)));
  return x;
}

/* Element by element, by the function of one, on aligned copies. */
static void wanted(const Kernel *f, const Case *c, Operand *const *x) {
  double rooms[MOST_ARGUMENTS][36];
  void *one[MOST_ARGUMENTS];
  for (int a = 0; a < f->count; ++a) one[a] = rooms[a];
  for (int i = 0; i < c->n; ++i) {
    for (int write = 0; write < 2; ++write) {
      for (int a = 0; a < f->count; ++a) {
        if (!(write ? f->arguments[a].written : f->arguments[a].read)) continue;
        for (int j = 0; j < f->arguments[a].size; ++j) {
          char *inside = (char *)rooms[a] + j * f->bytes;
          char *outside = x[a]->memory
              + (place(x[a], c->planes, f->arguments[a].size, i, j) + c->shift) * f->bytes;
          memcpy(write ? outside : inside, write ? inside : outside, (size_t)f->bytes);
        }
      }
      if (!write) f->one(one);
    }
  }
}

/* Bit by bit, but any NaN is any other. */
static int same(const char *a, const char *b, size_t bytes, int size) {
  for (size_t at = 0; at < bytes; at += (size_t)size) {
    if (memcmp(a + at, b + at, (size_t)size) == 0) continue;
    double x[2] = {0, 0};
    float y[2] = {0, 0};
    memcpy(size == 8 ? (void *)&x[0] : &y[0], a + at, (size_t)size);
    memcpy(size == 8 ? (void *)&x[1] : &y[1], b + at, (size_t)size);
    if (!(size == 8 ? isnan(x[0]) && isnan(x[1]) : isnan(y[0]) && isnan(y[1]))) return 0;
  }
  return 1;
}

static void compare(const Kernel *f, const Case *c, Call call) {
  Operand own[2][MOST_ARGUMENTS], *x[2][MOST_ARGUMENTS];
  for (int k = 0; k < 2; ++k)
    for (int a = 0; a < f->count; ++a) {
      own[k][a] = operand(f, c, a);
      x[k][a] = &own[k][a];
    }
  const int output = c->alias / MOST_ARGUMENTS, input = c->alias % MOST_ARGUMENTS;
  for (int k = 0; c->alias && k < 2; ++k) x[k][output] = x[k][input];
  void *p[MOST_ARGUMENTS];
  ptrdiff_t planes[MOST_ARGUMENTS], strides[MOST_ARGUMENTS];
  for (int a = 0; a < f->count; ++a) {
    p[a] = x[1][a]->memory + c->shift * f->bytes;
    planes[a] = x[1][a]->plane;
    strides[a] = x[1][a]->stride;
  }
  wanted(f, c, x[0]);
  call(c->n, p, planes, strides);
  for (int a = 0; a < f->count; ++a) {
    ++comparisons;
    if (!same(x[0][a]->memory, x[1][a]->memory, x[0][a]->bytes, f->bytes)) {
      ++failures;
      printf("%s: argument %d differs: n %d, %s, stride %d, shift %d, shared %x, alias %d\n", f->name,
             a, c->n, c->planes ? "planes" : "rows", c->apart, c->shift, (unsigned)c->shared, c->alias);
    }
  }
  for (int k = 0; k < 2; ++k)
    for (int a = 0; a < f->count; ++a) free(own[k][a].memory);
}

static int may_be_one(const Kernel *f, int output, int input) {
  const Argument *o = &f->arguments[output], *x = &f->arguments[input];
  return o->written && !o->read && x->read && !x->written && o->size == x->size;
}

/* All cases of a layout; calls with strides as numbers where there are such. */
static void check(const Kernel *f, Case c) {
  const int first = 1;
  for (size_t k = 0; k < sizeof counts / sizeof *counts; ++k) {
    c.n = counts[k];
    for (c.shift = 0; c.shift < 2; ++c.shift) {
      for (c.apart = 1; c.apart <= MOST_APART; c.apart += 2) {
        c.alias = c.shared = 0;
        compare(f, &c, f->calls[c.planes]);
        if (c.apart == 1 && f->each[c.planes]) compare(f, &c, f->each[c.planes]);
        for (c.shared = 1; c.shared < 1 << f->count; ++c.shared) {
          int inputs = 1;
          for (int a = 0; a < f->count; ++a)
            inputs &= !(c.shared & 1 << a) || !f->arguments[a].written;
          if (!inputs) continue;
          compare(f, &c, f->calls[c.planes]);
          if (c.apart == 1 && c.shared == first && f->first[c.planes])
            compare(f, &c, f->first[c.planes]);
        }
      }
      c.shared = 0;
      c.apart = 1;
      for (int output = 1; output < f->count; ++output)
        for (int input = 0; input < f->count; ++input) {
          if (!may_be_one(f, output, input)) continue;
          c.alias = output * MOST_ARGUMENTS + input;
          compare(f, &c, f->calls[c.planes]);
          if (f->each[c.planes]) compare(f, &c, f->each[c.planes]);
        }
    }
  }
}

int main(void) {
  for (int k = 0; k < tables_count; ++k)
    for (const Kernel *f = tables[k]; f->name; ++f)
      for (int planes = 0; planes < 2; ++planes) {
        const Case c = {0, planes, 1, 0, 0, 0};
        check(f, c);
      }
  printf("%ld comparisons, %ld differ\n", comparisons, failures);
  return failures != 0;
}
