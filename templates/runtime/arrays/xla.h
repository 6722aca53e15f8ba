/* XLA's foreign function interface: buffers of rows, a row a state, and the processor's mode.  An
   argument with one row is shared by all states; one state's buffers may lack the axis of rows. */
#ifndef COSCREW_XLA_H
#define COSCREW_XLA_H

#include <stddef.h>
#include <stdint.h>
#include <xla/ffi/api/c_api.h>

/* XLA computes with subnormal numbers flushed to zero; functions of many states have their bits
   without. */
#if defined(__SSE2__)
#include <xmmintrin.h>
typedef unsigned ksl_mode;
static inline ksl_mode gradual(void) {
  const ksl_mode kept = _mm_getcsr();
  _mm_setcsr(kept & ~0x8040u);
  return kept;
}
static inline void restored(ksl_mode mode) { _mm_setcsr(mode); }
#elif defined(__aarch64__)
typedef uint64_t ksl_mode;
static inline void restored(ksl_mode mode) { __asm__ volatile("msr fpcr, %0" : : "r"(mode)); }
static inline ksl_mode gradual(void) {
  ksl_mode kept;
  __asm__ volatile("mrs %0, fpcr" : "=r"(kept));
  restored(kept & ~(ksl_mode)0x1000000);
  return kept;
}
#else
typedef int ksl_mode;
static inline ksl_mode gradual(void) { return 0; }
static inline void restored(ksl_mode mode) { (void)mode; }
#endif

static inline const XLA_FFI_Buffer *argument(const XLA_FFI_CallFrame *frame, int which) {
  return (const XLA_FFI_Buffer *)frame->args.args[which];
}

static inline const XLA_FFI_Buffer *result(const XLA_FFI_CallFrame *frame, int which) {
  return (const XLA_FFI_Buffer *)frame->rets.rets[which];
}

static inline ptrdiff_t rows(const XLA_FFI_Buffer *x) {
  return x->rank > 1 ? (ptrdiff_t)x->dims[0] : 1;
}

static inline ptrdiff_t width(const XLA_FFI_Buffer *x) { return (ptrdiff_t)x->dims[x->rank - 1]; }

static inline ptrdiff_t stride(const XLA_FFI_Buffer *x, ptrdiff_t states) {
  return rows(x) == states ? width(x) : 0;
}

/* Whether XLA asks for the version of the interface, or for something but the results. */
static inline int answered(const XLA_FFI_CallFrame *frame) {
  XLA_FFI_Extension_Base *asked = frame->extension_start;
  if (asked != NULL && asked->type == XLA_FFI_Extension_Metadata) {
    XLA_FFI_Api_Version *version = &((XLA_FFI_Metadata_Extension *)asked)->metadata->api_version;
    version->major_version = XLA_FFI_API_MAJOR;
    version->minor_version = XLA_FFI_API_MINOR;
    return 1;
  }
  return frame->stage != XLA_FFI_ExecutionStage_EXECUTE;
}

#endif
