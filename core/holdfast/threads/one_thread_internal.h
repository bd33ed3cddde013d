#pragma once
/// A guard for the libraries below the sparse solvers. It keeps them from starting threads of their own, and from
/// waiting for memory.

namespace holdfast {

/// While this lives, OpenMP regions that the calling thread enters run on it alone. From the first one on, OpenBLAS
/// computes on the thread that calls it. Threads of these libraries wait by spinning. Beside others a factorisation
/// then takes several times as long. Alone they win nothing at the sizes that are solved here (docs/performance.md).
///
/// The first one also makes OpenBLAS take the memory that it computes in and keeps. Without memory OpenBLAS asks the
/// system forever; this throws `std::bad_alloc` instead.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int activeLevels_ = 0;  // of OpenMP, as they were
};

}  // namespace holdfast
