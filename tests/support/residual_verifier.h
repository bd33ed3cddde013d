#pragma once
/// \file
/// Judges a written mesh by its constraint file: recomputes every residual from the two mesh files and the constraints
/// alone, by formulas that share nothing with the solver.

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/elimination/diagnosis.h>

#include "support/plain_mesh.h"

namespace holdfast::test {

/// What constraints are missed by.
struct Verification {
  long points = 0;                ///< how many points were measured
  double largest = 0;             ///< distance from where a point should be, model units
  std::string worst;              ///< the constraint that it belongs to
  std::set<std::string> inexact;  ///< constraints with a pin that should have been copied and differs in a bit
};

/// Measures the enabled constraints of a constraint file or a point list (`.csv`) that are not named in `leftOut`. Of
/// rigid regions, and of relative constraints without an offset, it is distances that are to be kept: the rotation is
/// for the solver to find. Of vertices on a plane or a line that was fitted it is measured whether they lie on any.
/// Throws `std::runtime_error` for unknown types, and for `near` on faces that are not triangles. Sums are taken in
/// long double. O(faces) for each `near`, O(vertices^2) for each rigid region and mirror.
[[nodiscard]] Verification verify(const PlainMesh& rest, const PlainMesh& written,
                                  const std::filesystem::path& constraints, const std::set<std::string>& leftOut);

/// The largest residual that Holdfast promises, as a share of the bounding box's diagonal.
inline constexpr double kPromisedResidual = 1e-12;

/// Tells whether the mesh file `written` has the faces of `rest` and meets the constraints as promised: residuals up to
/// `kPromisedResidual` of the diagonal, pins bit for bit.
[[nodiscard]] testing::AssertionResult meetsConstraints(const std::filesystem::path& rest,
                                                        const std::filesystem::path& written,
                                                        const std::filesystem::path& constraints,
                                                        const std::set<std::string>& leftOut = {});

}  // namespace holdfast::test
