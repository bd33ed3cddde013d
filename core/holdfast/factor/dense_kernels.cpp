#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast {

namespace any {
extern const DenseKernels kKernels;
}

#ifdef __x86_64__

namespace avx2 {
extern const DenseKernels kKernels;
}
namespace avx512 {
extern const DenseKernels kKernels;
}

std::vector<const DenseKernels*> runnableDenseKernels()
{
  std::vector<const DenseKernels*> kernels;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) kernels.push_back(&avx512::kKernels);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) kernels.push_back(&avx2::kKernels);
  kernels.push_back(&any::kKernels);
  return kernels;
}

#else

std::vector<const DenseKernels*> runnableDenseKernels()
{
  return {&any::kKernels};
}

#endif

const DenseKernels& denseKernels()
{
  static const DenseKernels& best = *runnableDenseKernels().front();
  return best;
}

}  // namespace holdfast
