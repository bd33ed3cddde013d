#pragma once
/// A shape change is how a deformed surface differs from the surface at rest: folds, lengths, areas, volumes. Nothing
/// here depends on how the surface is turned. Neighbours are compared with one another, and lengths with lengths.

#include <vector>

#include <holdfast/verdict/rest_surface.h>

namespace holdfast {

/// The sizes of things of one kind, as multiples of those at rest.
struct Ratios {
  double least = 1;
  double most = 1;
  Index shrunkCount = 0;  ///< how many are below their limit
  Index grownCount = 0;   ///< above it
  /// The things beyond the limits: the ends of edges, file faces of triangles, a vertex of each part. Ascending, each
  /// once.
  std::vector<Index> shrunk;
  std::vector<Index> grown;
};

/// An edge that is longer or shorter by this factor has lost its length. In a picture an edge of ten pixels then has 30
/// or 3.
inline constexpr double kLengthLimit = 3;
inline constexpr double kAreaLimit = kLengthLimit * kLengthLimit;
/// The limit is that of a length. A bar that is turned twice round keeps 0.4 of its volume, and looks as it should.
inline constexpr double kVolumeLimit = 3;

/// A change of less than this share of the diagonal is not seen: it is a pixel in a picture of a thousand.
inline constexpr double kVisible = 1e-3;

struct ShapeChange {
  double foldDegrees = 0;         ///< the largest change of a bend that folds; 0 where none does
  std::vector<int> foldedHinges;  ///< of `RestSurface`, ascending
  Ratios lengths;
  Ratios areas;
  Ratios volumes;  ///< of closed parts; negative where a part is turned inside out
};

/// A surface and where it is now. Everything that it refers to must stay alive as long as this.
struct DeformedSurface {
  const SolverMesh& mesh;
  const RestSurface& rest;
  const Positions& atRest;  ///< of the file's vertices
  const Positions& now;     ///< of the file's vertices, finite
};

/// Measures how the surface has changed. O(T), over all cores.
[[nodiscard]] ShapeChange changeOf(const DeformedSurface& surface);

/// Returns the triangles that are turned over: those on the smaller side of folds. O(T).
[[nodiscard]] std::vector<int> invertedTriangles(const RestSurface& rest, const std::vector<int>& foldedHinges);

/// Returns the file faces of triangles, ascending, each once.
[[nodiscard]] std::vector<Index> facesOf(const SolverMesh& mesh, const std::vector<int>& triangles);

}  // namespace holdfast
