#pragma once
/// \file
/// What bounds everything else: how fast all cores together read memory and multiply matrices.

namespace holdfast::bench {

/// Bytes per second of one pass over half a GiB, each core through its own part.
[[nodiscard]] double bytesReadPerSecond();

/// Operations per second of dense products in double precision (dgemm), each core with matrices of its own.
[[nodiscard]] double operationsPerSecond();

}  // namespace holdfast::bench
