#pragma once
/// \file
/// Keeps the libraries below the sparse solvers from starting threads of their own, and from waiting for memory.

namespace holdfast {

/// While this lives, OpenMP regions that the calling thread enters run on it alone; and from the first one on, for
/// good, OpenBLAS computes on the thread that calls it. CHOLMOD starts four threads whatever the machine has, those of
/// OpenBLAS wait by spinning, and where they share cores with one another or with other programs a factorisation takes
/// several times as long; alone on a machine they win nothing for the sizes that are solved here (docs/benchmarks.md).
/// Libraries that are not there are passed over.
///
/// The first one also has OpenBLAS take the memory that it computes in, which it keeps: where there is none, OpenBLAS
/// asks the system for ever. Throws `std::bad_alloc` instead.
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
