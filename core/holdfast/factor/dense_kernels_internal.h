#pragma once
/// These kernels compute with dense matrices by Eigen, compiled for several processors. All matrices are stored column
/// by column, `ld` numbers apart. Of symmetric ones only the lower triangle is looked at.

#include <vector>

namespace holdfast {

struct DenseKernels {
  /// Computes L with A = L L^T in place, n x n. Returns the place of the first pivot that is not positive, from 1, or 0
  /// where there is none.
  int (*cholesky)(int n, double* A, int ld);

  /// Computes B <- B L^-T. B is m x n.
  void (*solveRight)(int m, int n, const double* L, int ldL, double* B, int ldB);

  /// Computes C <- scale C + factor A A^T. C is n x n, and A is n x k. `scale` is 0 or 1.
  void (*symmetricUpdate)(int n, int k, double factor, const double* A, int ldA, double scale, double* C, int ldC);

  /// Computes C <- scale C + factor A B^T. C is m x n, A is m x k, and B is n x k. `scale` is 0 or 1.
  void (*update)(int m, int n, int k, double factor, const double* A, const double* B, int ldAB, double scale,
                 double* C, int ldC);
};

/// Returns the kernels that the processor can run, the fastest first.
[[nodiscard]] std::vector<const DenseKernels*> runnableDenseKernels();

/// Returns the fastest kernels that the processor can run.
[[nodiscard]] const DenseKernels& denseKernels();

}  // namespace holdfast
