#pragma once
/// Arithmetic without subnormal numbers.

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace holdfast {

/// While this lives, results below 1e-308 are zero, where the processor can do that. This holds on the calling thread
/// and in its loops (`parallelFor`). Numbers between that and zero would take the processor a hundred times as long.
class NoSubnormals {
 public:
  NoSubnormals()
  {
#ifdef __SSE2__
    constexpr unsigned kFlushToZero = 0x8000;
    _mm_setcsr(before_ | kFlushToZero);
#endif
  }
  ~NoSubnormals()
  {
#ifdef __SSE2__
    _mm_setcsr(before_);
#endif
  }
  NoSubnormals(const NoSubnormals&) = delete;
  NoSubnormals& operator=(const NoSubnormals&) = delete;

 private:
#ifdef __SSE2__
  unsigned before_ = _mm_getcsr();
#endif
};

}  // namespace holdfast
