#pragma once
/// `chooseOffsets` chooses where points go that need not reach their targets: of all places that are near enough it
/// takes those of the least energy.

#include <array>
#include <map>
#include <vector>

#include <Eigen/Dense>

#include <holdfast/constraints/row_directions.h>
#include <holdfast/matrices/sparse_products.h>
#include <holdfast/numbers/types.h>

namespace holdfast {

/// A slab says low <= normal . r <= high of an offset r. The normal has length 1; bounds may be infinite.
struct AllowedSlab {
  Vector3 normal;
  double low = 0;
  double high = 0;
};

/// An allowed offset says what the offset r of a point from its target may be, and what it costs.
struct AllowedOffset {
  RowDirections directions = {};        ///< what follows asks for the part of r that these hold; the rest is free
  double radius = 0;                    ///< |r| <= radius where it is above 0
  std::vector<AllowedSlab> slabs = {};  ///< all of which hold
  double weight = 0;                    ///< adds weight |r|^2 / 2 to the energy
  bool isZero = false;                  ///< r = 0
  double damping = 0;                   ///< adds damping |r|^2 / 2 for the part of r that is free
};

/// Points pull at one another along one axis of the frame. Some of them follow from the others.
struct AxisPull {
  /// k x k, positive definite: how the pulls of k points grow with their offsets y. Axes may have the same matrix.
  const Eigen::MatrixXd* stiffness = nullptr;
  Eigen::VectorXd pull;  ///< of these points where all offsets are 0
  SparseRows offsets;    ///< points x k: the offsets of all points along this axis are `offsets` y + `constant`
  Eigen::VectorXd constant;
  SparseRows fixed;  ///< sums of y that have to be `fixedTo`
  Eigen::VectorXd fixedTo;
  /// `ChosenOffsets::contradicted` has these numbers: of what each sum comes from, and of what a point's constant does.
  std::vector<std::vector<Index>> fixedBy = {};
  std::map<Index, std::vector<Index>> constantBy = {};
};

/// Chosen offsets say where points go.
struct ChosenOffsets {
  Positions offsets;               ///< points x 3, coordinates of the frame
  std::vector<char> isAtBound;     ///< 1 where a bound keeps the point from going farther
  std::vector<char> isOutOfReach;  ///< 1 where it follows from others, and no place that they may have is near enough
  /// Says of each point that is fixed against what is fixed before it what it contradicts. A point is named by its
  /// place; the number k of what a sum or a constant comes from is written as -1 - k, so that both differ.
  std::map<Index, std::vector<Index>> contradicted;
};

/// Minimises the sum over the three axes of y^T stiffness y / 2 + pull^T y, and of what offsets cost, over all offsets
/// that are allowed. Points that are out of reach do not count; of two that exclude one another that is the later.
///
/// A primal-dual interior-point method (Boyd and Vandenberghe, Convex Optimization, 11.7) takes some 30 steps of
/// O(k^3). A step costs a fifth where all axes have the same matrix and no point follows from others. The offsets are
/// allowed to the last bit, but for points that follow from others. Lengths may have any unit.
[[nodiscard]] ChosenOffsets chooseOffsets(const std::array<AxisPull, 3>& axes,
                                          const std::vector<AllowedOffset>& allowed);

}  // namespace holdfast
