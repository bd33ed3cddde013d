#pragma once
/// The energy of shapes whose rotations are found. It keeps them as rigid as possible, over edges or with the detail
/// beside them.

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/operators/operators.h>
#include <holdfast/rotation/rotation_options.h>

namespace holdfast {

/// Below this length `RotationSource::FoundSmooth` keeps detail rather than lengths of edges. It is a share of the
/// diameter of the smallest sphere around the mesh. From 0.01 on creases are wider than the triangles of ordinary
/// meshes; at 0.1 long bends stretch edges.
inline constexpr double kBendingLength = 0.03;

/// A rotation for each unknown, of length 1.
using UnknownRotations = std::vector<Eigen::Quaterniond>;

/// Constraints hold a rigid region like this, and leave it the rest to turn by.
struct RegionHold {
  enum class Kind : char { None, AtPlace, AboutAxis, Whole };
  Kind kind = Kind::None;
  Vector3 rest = Vector3::Zero();   ///< unless `None`: a point of the region
  Vector3 place = Vector3::Zero();  ///< where it stays
  Vector3 axis = Vector3::Zero();   ///< through it, of length 1: with `AboutAxis`
};

/// Which rotations may change.
struct FreeRotations {
  enum class Kind : char { Given, Own, OfRegion };

  /// Rotations that `system` gives are given. So are those of rigid regions in which one is given. Any other rigid
  /// region has one rotation. Regions that overlap are one.
  FreeRotations(const ConstraintSystem& system, Index unknownCount);

  std::vector<Kind> kindOf;                 ///< of each unknown
  std::vector<std::vector<Index>> regions;  ///< unknowns of each that may rotate, ascending
  std::vector<RegionHold> holds = {};       ///< of each region; none: nothing holds them
};

/// E(u, R) = sum over the rows k of |(A (p0 + u))_k - R v_k|^2, with v = A p0. R v_k uses the rotations of one or two
/// unknowns, as the mean of both terms.
///
/// Each edge has a row sqrt(w_ij) (p_i - p_j) with the rotations of its ends. So E is the energy over spokes of Sorkine
/// and Alexa (2007). `FoundSmooth` adds the weighted rows of the Laplacian, each with the rotation of its unknown.
///
/// For each of u and R the best is found exactly while the other stays, so E never rises.
class RotationEnergy {
 public:
  RotationEnergy(const SolverMesh& mesh, const Operators& operators, RotationSource source);

  /// Returns A. It is the same for all u, so it is factorised once.
  [[nodiscard]] const std::shared_ptr<const EnergyMatrix>& A() const noexcept { return A_; }

  /// Returns what A u is nearest to for the best u under the rotations `R`: the mean of R v_k, less v_k. Rows x 3,
  /// model units.
  [[nodiscard]] Columns3 wanted(const UnknownRotations& R) const;

  /// Returns the best of the free rotations for the displacement `u`. The rotation of a region is the best for any
  /// place of the region that its hold allows. The rotations in `R` are the start. O(n), over all cores, with the same
  /// bits for any number of them.
  [[nodiscard]] UnknownRotations fitted(const Columns3& u, const FreeRotations& free, UnknownRotations R) const;

  /// Returns the length of which `RotationOptions::change` is a share, in model units. It is the diagonal of the box,
  /// and with `FoundSmooth` the diameter of the smallest sphere.
  [[nodiscard]] double size() const noexcept { return size_; }

  /// Returns E, in squares of model units.
  [[nodiscard]] double value(const Columns3& u, const UnknownRotations& R) const;

 private:
  [[nodiscard]] Eigen::Quaterniond fittedRegion(const std::vector<Index>& region, const RegionHold& hold,
                                                const Columns3& u, const Columns3& deformed,
                                                const UnknownRotations& R) const;

  Positions rest_;
  std::vector<std::array<int, 2>> unknownsOf_;  // of each row: whose rotations it has; twice the same where it has one
  std::shared_ptr<const EnergyMatrix> A_;
  Columns3 v_;
  double size_;
};

}  // namespace holdfast
