#pragma once
/// The multifrontal factorisation (Duff and Reid, 1983; Liu, 1992) is Cholesky's, but for signs.

#include <memory>

#include <holdfast/factor/packed_factor.h>
#include <holdfast/words/result.h>

namespace holdfast {

/// Returns L of the matrix whose lower triangle in the order of elimination is `lower`. `lower` has the pattern that
/// `symbolic` was made of. Fails where a pivot does not have the sign of its column. The bits are the same for any
/// number of threads. O(sum of width times height squared of supernodes).
[[nodiscard]] Result<std::unique_ptr<const PackedFactor>> factorizeMultifrontal(
    const std::shared_ptr<const SymbolicFactor>& symbolic, SparseMatrix lower);

}  // namespace holdfast
