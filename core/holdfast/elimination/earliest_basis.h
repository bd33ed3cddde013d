#pragma once
/// \file
/// From any basis of the rows of B to the one that the user's order asks for.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// `dependencies` states every dependent row by some basis of the rows. Returns the dependencies by the basis that the
/// sequential method of section 5 finds: of every circuit the last row is the dependent one. The independent sets of
/// rows are those of a matroid, in which the basis of least weight is reached by exchanges that each lower the weight:
/// a dependent row takes the place of the latest of its partners while that comes after it. Each exchange costs one
/// pass over the dependencies that share the partner.
[[nodiscard]] std::vector<Dependency> byEarliestBasis(std::vector<Dependency> dependencies);

}  // namespace holdfast
