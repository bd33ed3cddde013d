#pragma once
/// \file
/// Whether a deformation is the one of least energy among those that meet the constraints.

#include <filesystem>

#include <nlohmann/json.hpp>

#include <holdfast/deform/model.h>
#include <holdfast/operators/operators.h>

#include "support/plain_mesh.h"

namespace holdfast::test {

/// The gradient of |A u - f|^2 / 2, u the displacement and f what rotations ask of the detail, against the directions
/// that constraints leave free; u in units of the diagonal.
struct FreeGradient {
  double largest = 0;  ///< entry of the projection of A^T (A u - f) on null(B): zero at the minimum
  double bound = 0;    ///< entry that rounding the coordinates of the file to doubles can make: eps |A|^T |A| |p|
};

/// A cosine up to this is that of a right angle: rounding leaves 1e-14 at most on meshes of half a million vertices.
inline constexpr double kRightAngle = 1e-12;

/// Judges deformations of one mesh under one list of constraints by one set of weights. The operators and the rotations
/// are those of the solver; nothing else is. No two constraints may share a vertex. Throws `std::runtime_error` for
/// constraints that are neither fixed vertices, nor handles, nor points.
class EnergyCheck {
 public:
  EnergyCheck(const std::filesystem::path& rest, const std::filesystem::path& constraints, Weights weights);

  [[nodiscard]] FreeGradient freeGradient(const PlainMesh& written) const;

  /// The cosine of the angle between A u - f and A (v - u), with u and v the displacements of two meshes that both meet
  /// the constraints. It is zero for every v where u is the minimum, and sees smooth errors of u that no single entry
  /// of the gradient betrays. 0 where the two meshes are the same.
  [[nodiscard]] double cosineTowards(const PlainMesh& written, const PlainMesh& other) const;

 private:
  [[nodiscard]] Columns3 displacement(const PlainMesh& written) const;
  void project(Columns3& gradient) const;
  void projectPoint(Columns3& gradient, const nlohmann::json& at) const;

  Model model_;
  PlainMesh rest_;
  nlohmann::json constraints_;
  SparseMatrix A_;
  Columns3 f_;
};

}  // namespace holdfast::test
