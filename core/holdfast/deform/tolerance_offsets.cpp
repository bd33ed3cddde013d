#include "holdfast/deform/tolerance_offsets.h"

#include <algorithm>
#include <limits>

namespace holdfast {
namespace {

/// `directions` by coordinates of the frame.
RowDirections inFrame(const RowDirections& directions, const Eigen::Matrix3d& frame)
{
  if (directions.areAll()) return directions;
  const Vector3 axis = frame.transpose() * directions.axis();
  return directions.areAlongAxis() ? RowDirections::along(axis) : RowDirections::across(axis);
}

struct AllowedBy {
  const ToleranceUnits& units;
  RowDirections directions;  // by coordinates of the frame

  AllowedOffset operator()(const Exactly& /*exactly*/) const { return {.directions = directions, .isZero = true}; }
  AllowedOffset operator()(const WithinBall& ball) const
  {
    return {.directions = directions, .radius = ball.radius / units.diagonal};
  }
  AllowedOffset operator()(const WithinBox& box) const
  {
    AllowedOffset result;
    for (Index k = 0; k < 3; ++k)
      result.slabs.push_back(
          {units.frame.row(k).transpose(), -box.half[k] / units.diagonal, box.half[k] / units.diagonal});
    return result;
  }
  AllowedOffset operator()(const WithinSlab& slab) const
  {
    const Vector3 normal =
        slab.normal ? Vector3(units.frame.transpose() * slab.normal->stableNormalized()) : directions.axis();
    return {.directions = directions, .slabs = {{normal, slab.low / units.diagonal, slab.high / units.diagonal}}};
  }
  AllowedOffset operator()(const Weighted& weighted) const
  {
    const double w = weighted.weight / units.weightScale;
    return {.directions = directions, .weight = w * w};
  }
};

/// Brings a place that is meant to lie within a tolerance there in doubles, too.
struct WithinInDoubles {
  const Vector3& target;
  const RowDirections& directions;

  /// Far from the origin doubles may lie farther apart than the radius: no more is promised there than their distance.
  Vector3 operator()(const WithinBall& ball, Vector3 offset) const
  {
    constexpr int kMostTries = 4;
    for (int k = 0; k < kMostTries && directions.held(Vector3(target + offset) - target).norm() > ball.radius; ++k)
      offset -= std::numeric_limits<double>::epsilon() * directions.held(offset);
    return offset;
  }
  Vector3 operator()(const WithinBox& box, const Vector3& offset) const
  {
    return offset.cwiseMax(-box.half).cwiseMin(box.half);
  }
  Vector3 operator()(const auto& /*other*/, const Vector3& offset) const { return offset; }
};

}  // namespace

AllowedOffset allowedOffset(const TolerantRow& tolerant, const RowDirections& directions, const ToleranceUnits& units)
{
  return std::visit(AllowedBy{units, inFrame(directions, units.frame)}, tolerant.within);
}

void takeOffsets(ConstraintSystem& system, const Positions& offsets)
{
  for (std::size_t i = 0; i < system.tolerant.size(); ++i) {
    const TolerantRow& tolerant = system.tolerant[i];
    ConstraintRow& row = system.rows[tolerant.row];
    const Vector3 offset = std::visit(
        [&](const auto& within) {
          return WithinInDoubles{tolerant.target, row.directions}(within, offsets.row(static_cast<Index>(i)));
        },
        tolerant.within);
    row.target = tolerant.target + offset;
    row.shift = tolerant.shift + offset;
  }
}

std::vector<Index> rowsOfTolerant(const ConstraintSystem& system)
{
  std::vector<Index> rows;
  rows.reserve(system.tolerant.size());
  for (const TolerantRow& tolerant : system.tolerant) rows.push_back(tolerant.row);
  return rows;
}

Index rowInPart(const AxisElimination& part, Index row)
{
  if (part.rows.empty()) return row;
  return std::ranges::lower_bound(part.rows, row) - part.rows.begin();
}

}  // namespace holdfast
