#pragma once
/// \file
/// A task for any mesh: both ends held, and points of every kind between them.

#include <string>

#include "support/plain_mesh.h"
#include "support/random.h"

namespace holdfast::test {

/// The most points of each kind (on vertices, on edges, in faces).
inline constexpr std::size_t kMostPointsOfAKind = 300;

/// The text of a constraint file. The lowest 8 % along the longest axis are fixed; the highest 8 % are a handle, turned
/// by 20 degrees and shifted by a tenth of the diagonal. Of the vertices between them, every twentieth or fewer carry a
/// point each, moved by a smooth field of a few hundredths of the diagonal. No two constraints share a place, so that
/// all can be met and each is a component of its own.
[[nodiscard]] std::string generatedConstraints(const PlainMesh& mesh, Random& random);

}  // namespace holdfast::test
