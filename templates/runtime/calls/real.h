/* The number type of the code after it: float if SINGLE_PRECISION is 1, otherwise double.  Headers
   that compute with both types are included once for each; IN(name) is name_double or name_single.
   */
#undef REAL
#undef OTHER_REAL
#undef REAL_NUMBER
#undef OTHER_NUMBER
#undef IN

#if defined(SINGLE_PRECISION) && SINGLE_PRECISION
#define REAL float
#define OTHER_REAL double
#define REAL_NUMBER SINGLE
#define OTHER_NUMBER DOUBLE
#define IN(name) name##_single
#else
#define REAL double
#define OTHER_REAL float
#define REAL_NUMBER DOUBLE
#define OTHER_NUMBER SINGLE
#define IN(name) name##_double
#endif
