#pragma once
/// \file
/// Keeps the libraries below the sparse solvers from starting threads of their own.

namespace holdfast {

/// While this lives, OpenMP regions that the calling thread enters run on it alone; and from the first one on, for
/// good, OpenBLAS computes on the thread that calls it. CHOLMOD starts four threads whatever the machine has, those of
/// OpenBLAS wait by spinning, and where they share cores with one another or with other programs a factorisation takes
/// several times as long; alone on a machine they win nothing for the sizes that are solved here (docs/benchmarks.md).
/// Libraries that are not there are passed over.
class OneThread {
 public:
  OneThread() noexcept;
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int activeLevels_ = 0;  // of OpenMP, as they were
};

}  // namespace holdfast
