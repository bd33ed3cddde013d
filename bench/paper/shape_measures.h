#pragma once
/// \file
/// How near two shapes of a surface are, and how much a deformation stretches it.

#include <vector>

#include <holdfast/constraints/selection.h>
#include <holdfast/deform/model.h>

namespace holdfast::paper {

/// Root of the mean square, and the largest.
struct Spread {
  double rms = 0;
  double largest = 0;
};

/// Of the sizes of `values`; zero of none.
[[nodiscard]] Spread spreadOf(const std::vector<double>& values);

/// From where each of `vertices` went, `shape`, to where the point of `other` went, `otherShape`, that is nearest to it
/// at rest.
[[nodiscard]] Spread distanceBetween(const Model& model, const Positions& shape, const std::vector<Index>& vertices,
                                     const Model& other, const Positions& otherShape);

/// Relative changes of length of the edges between `vertices`.
[[nodiscard]] Spread stretchOf(const Model& model, const Positions& shape, const std::vector<Index>& vertices);

/// Every vertex of the file.
[[nodiscard]] std::vector<Index> allVertices(const Model& model);

/// Returns the vertices that `selection` names, curves among them, ascending.
[[nodiscard]] std::vector<Index> verticesOf(const Model& model, const Selection& selection);

}  // namespace holdfast::paper
