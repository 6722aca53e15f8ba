/* A function of a scene in one precision, as calls from Python know it, and these calls.

   Included once per precision. */
#include "objects.h"
#include "shapes.h"

#include "real.h"

/* The function of n states: pointers to each input and output, and the steps between their rows. */
typedef void IN(rows)(ptrdiff_t n, const REAL *const *x, const ptrdiff_t *steps, REAL *const *y,
    const ptrdiff_t *places);

typedef struct {
  int inputs, outputs, p; /* p: number of the input with the parameters, or -1 */
  ptrdiff_t numbers;      /* of all inputs in one state, at least 1 */
  const input *takes;
  const result *results;
  int (*refused)(const REAL *p);
  IN(rows) *states;
  const anything *lanes;
} IN(function);

/* Tell how many bytes all objects of Python begin with. */
void IN(know)(size_t size);

/* Compute n states in so many threads. */
void IN(many)(const IN(function) *f, ptrdiff_t n, const REAL *const *x, const ptrdiff_t *steps,
    REAL *const *y, const ptrdiff_t *places, ptrdiff_t threads);

/* The results; of arguments that are not taken, those of the function that checks them. */
void *IN(called)(void *self, const IN(function) *f, void *const *arguments, ptrdiff_t n,
    void *names);
