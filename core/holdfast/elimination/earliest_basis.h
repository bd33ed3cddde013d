#pragma once
/// \file
/// From any basis of the rows of B to the one that the user's order asks for.

#include <optional>
#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// The basis is not exchanged for one in which a coefficient is larger than this: circuits that lead through many faces
/// grow like powers, and with them the rounding of all that is said of them.
inline constexpr double kLargestCoefficient = 1e6;

/// `dependencies` states every dependent row by some basis of the rows. Returns the dependencies by the basis that the
/// sequential method of section 5 finds: of every circuit the last row is the dependent one. The independent sets of
/// rows are those of a matroid, in which the basis of least weight is reached by exchanges that each lower the weight:
/// a dependent row takes the place of one of its partners that comes after it. Where that would make a coefficient
/// larger than `kLargestCoefficient` it is left undone. Each exchange costs one pass over the dependencies. They come
/// back ascending by row.
[[nodiscard]] std::vector<Dependency> byEarliestBasis(const std::vector<Dependency>& dependencies);

/// A dependent row that takes the place of a row of the basis.
struct Exchange {
  Index entering;
  Index leaving;
};

/// Where the largest coefficient is, if it exceeds `kLargestCoefficient`.
[[nodiscard]] std::optional<Exchange> largestCoefficient(const std::vector<Dependency>& dependencies);

}  // namespace holdfast
