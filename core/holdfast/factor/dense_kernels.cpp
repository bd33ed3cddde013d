#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast {

namespace any {
extern const DenseKernels kernels;
}

#ifdef __x86_64__

namespace avx2 {
extern const DenseKernels kernels;
}
namespace avx512 {
extern const DenseKernels kernels;
}

const DenseKernels& denseKernels()
{
  static const DenseKernels& best = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                                        ? avx512::kernels
                                    : __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? avx2::kernels
                                                                                                      : any::kernels;
  return best;
}

#else

const DenseKernels& denseKernels()
{
  return any::kernels;
}

#endif

}  // namespace holdfast
