#pragma once
/// MUMPS, a multifrontal solver that Debian has as well, beside which our factorisation is measured.

#include <memory>

#include <holdfast/numbers/types.h>

namespace holdfast::bench {

/// L L^T of a symmetric positive definite matrix by MUMPS, in the order that it chooses, on one process. Throws
/// `std::runtime_error` with MUMPS's number where it fails.
class MumpsFactor {
 public:
  /// Analyses the matrix, of which the lower triangle is given.
  explicit MumpsFactor(const SparseMatrix& lower);
  ~MumpsFactor();
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;

  void factorize();
  /// Solves for three columns of ones.
  void solve();
  [[nodiscard]] double entries() const;
  [[nodiscard]] double operations() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace holdfast::bench
