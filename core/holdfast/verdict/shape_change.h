#pragma once
/// How a deformed surface differs from the surface at rest: folds, lengths, areas, volumes. Nothing here depends on how
/// the surface is turned: neighbours are compared with one another, lengths with lengths.

#include <vector>

#include <holdfast/verdict/rest_surface.h>

namespace holdfast {

/// How many times as large as at rest things of one kind are.
struct Ratios {
  double least = 1;
  double most = 1;
  Index shrunkCount = 0;  ///< how many are below their limit
  Index grownCount = 0;   ///< above it
  /// Those beyond the limits: the ends of edges, file faces of triangles, a vertex of each part; ascending, each once.
  std::vector<Index> shrunk;
  std::vector<Index> grown;
};

/// An edge that is longer or shorter by this factor has lost its length: in a picture one of ten pixels has 30 or 3.
inline constexpr double kLengthLimit = 3;
inline constexpr double kAreaLimit = kLengthLimit * kLengthLimit;
/// As a length: a bar that is turned twice round keeps 0.4 of its volume, and looks as it should.
inline constexpr double kVolumeLimit = 3;

/// A change of less than this share of the diagonal is a pixel in a picture of a thousand: it is not seen.
inline constexpr double kVisible = 1e-3;

struct ShapeChange {
  double foldDegrees = 0;         ///< the largest change of a bend that folds; 0 where none does
  std::vector<int> foldedHinges;  ///< of `RestSurface`, ascending
  Ratios lengths;
  Ratios areas;
  Ratios volumes;  ///< of closed parts; negative where a part is turned inside out
};

/// A surface and where it is now. All of it stays alive as long as this.
struct DeformedSurface {
  const SolverMesh& mesh;
  const RestSurface& rest;
  const Positions& atRest;  ///< of the file's vertices
  const Positions& now;     ///< of the file's vertices, finite
};

/// O(T), over all cores.
[[nodiscard]] ShapeChange changeOf(const DeformedSurface& surface);

/// The triangles that are turned over: those on the smaller side of folds. O(T).
[[nodiscard]] std::vector<int> invertedTriangles(const RestSurface& rest, const std::vector<int>& foldedHinges);

/// The file faces of triangles, ascending, each once.
[[nodiscard]] std::vector<Index> facesOf(const SolverMesh& mesh, const std::vector<int>& triangles);

}  // namespace holdfast
