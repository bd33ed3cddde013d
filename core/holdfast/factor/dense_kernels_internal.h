#pragma once
/// Dense matrices by Eigen, compiled for several processors. All are stored column by column, `ld` numbers apart; of
/// symmetric ones only the lower triangle is looked at.

#include <vector>

namespace holdfast {

struct DenseKernels {
  /// A = L L^T in place, n x n. Returns the place of the first pivot that is not positive, from 1; 0 where there is
  /// none.
  int (*cholesky)(int n, double* A, int ld);

  /// B <- B L^-T, B m x n.
  void (*solveRight)(int m, int n, const double* L, int ldL, double* B, int ldB);

  /// C <- scale C + factor A A^T, C n x n, A n x k; `scale` is 0 or 1.
  void (*symmetricUpdate)(int n, int k, double factor, const double* A, int ldA, double scale, double* C, int ldC);

  /// C <- scale C + factor A B^T, C m x n, A m x k, B n x k; `scale` is 0 or 1.
  void (*update)(int m, int n, int k, double factor, const double* A, const double* B, int ldAB, double scale,
                 double* C, int ldC);
};

/// Those that the processor can run, the fastest first.
[[nodiscard]] std::vector<const DenseKernels*> runnableDenseKernels();

/// The fastest.
[[nodiscard]] const DenseKernels& denseKernels();

}  // namespace holdfast
