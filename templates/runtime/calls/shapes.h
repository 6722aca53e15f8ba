/* Inputs and results of a function, whatever the precision. */
#ifndef COSCREW_SHAPES_H
#define COSCREW_SHAPES_H

#include <stddef.h>

typedef struct {
  ptrdiff_t size; /* how many numbers it has */
  int axes;
  const ptrdiff_t *shape;
} input;
typedef struct {
  ptrdiff_t size;
  int axes, moved; /* number of the input that it begins as, or -1 */
  const ptrdiff_t *shape;
} result;

#endif
