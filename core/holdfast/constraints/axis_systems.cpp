#include "holdfast/constraints/axis_systems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace holdfast {
namespace {

// Directions that are parallel or square up to this are so but for the rounding of their numbers. A row
// misses its target by at most this share of its displacement. That is a hundredth of what Holdfast promises.
constexpr double kRoundedAngle = 1e-14;

bool areParallel(const Vector3& a, const Vector3& b)
{
  return a.cross(b).norm() <= kRoundedAngle;
}

/// The first rows that have each of the axes, no more than three, and the rows at odds that end the search.
struct RowsOfAxes {
  std::vector<Index> firsts;
  std::optional<std::array<Index, 2>> atOdds;
};

RowsOfAxes rowsOfAxes(const std::vector<ConstraintRow>& rows)
{
  RowsOfAxes result;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].directions.areAll()) continue;
    const Vector3& axis = rows[r].directions.axis();
    const auto is = [&](Index first) { return areParallel(axis, rows[first].directions.axis()); };
    const auto isAskew = [&](Index first) { return std::abs(axis.dot(rows[first].directions.axis())) > kRoundedAngle; };
    if (std::ranges::any_of(result.firsts, is)) continue;
    if (const auto askew = std::ranges::find_if(result.firsts, isAskew); askew != result.firsts.end()) {
      result.atOdds = {static_cast<Index>(r), *askew};
      return result;
    }
    result.firsts.push_back(static_cast<Index>(r));
  }
  return result;
}

bool isCoordinateAxis(const Vector3& axis)
{
  return std::ranges::any_of(std::array{0, 1, 2}, [&](int k) { return areParallel(axis, Vector3::Unit(k)); });
}

/// The axes of the frame along which a row holds.
std::bitset<3> heldAxes(const RowDirections& directions, const Eigen::Matrix3d& frame)
{
  std::bitset<3> result;
  for (int k = 0; k < 3; ++k)
    result[static_cast<std::size_t>(k)] =
        directions.areAll() || areParallel(directions.axis(), frame.col(k)) == directions.areAlongAxis();
  return result;
}

Vector3 alongAxes(const Vector3& value, const std::bitset<3>& axes, const Eigen::Matrix3d& frame)
{
  Vector3 result = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    if (axes[static_cast<std::size_t>(k)]) result[k] = frame.isIdentity(0) ? value[k] : frame.col(k).dot(value);
  return result;
}

}  // namespace

std::optional<std::array<Index, 2>> rowsAtOdds(const std::vector<ConstraintRow>& rows)
{
  return rowsOfAxes(rows).atOdds;
}

std::optional<Eigen::Matrix3d> commonFrame(const std::vector<ConstraintRow>& rows)
{
  const auto [firsts, atOdds] = rowsOfAxes(rows);
  if (atOdds) return std::nullopt;
  std::vector<Vector3> axes;
  axes.reserve(firsts.size());
  for (const Index first : firsts) axes.push_back(rows[first].directions.axis());
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  if (std::ranges::all_of(axes, isCoordinateAxis)) return frame;
  frame.col(0) = axes.front();
  frame.col(2) = frame.col(0).cross(axes.size() > 1 ? axes[1] : frame.col(0).unitOrthogonal()).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

std::vector<AxisSystem> axisSystems(const ConstraintSystem& system, const Eigen::Matrix3d& frame)
{
  std::array<std::vector<Index>, 3> rowsOf;
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const std::bitset<3> axes = heldAxes(system.rows[r].directions, frame);
    for (std::size_t k = 0; k < 3; ++k)
      if (axes[k]) rowsOf[k].push_back(static_cast<Index>(r));
  }
  std::vector<AxisSystem> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto same = std::ranges::find(result, rowsOf[k], &AxisSystem::rows);
    if (same == result.end())
      result.push_back({std::bitset<3>().set(k), std::move(rowsOf[k]), {}});
    else
      same->axes.set(k);
  }
  for (AxisSystem& some : result)
    for (const Index r : some.rows) {
      ConstraintRow& row = some.system.rows.emplace_back(system.rows[r]);
      row.shift = alongAxes(row.shift, some.axes, frame);
      row.directions = {};
    }
  return result;
}

Columns3 alongAxes(const Columns3& values, const std::bitset<3>& axes, const Eigen::Matrix3d& frame)
{
  Columns3 result(values.rows(), 3);
  for (Index i = 0; i < values.rows(); ++i) result.row(i) = alongAxes(Vector3(values.row(i)), axes, frame);
  return result;
}

Columns3 joinedAxes(std::span<const Columns3> ofSystems, const Eigen::Matrix3d& frame)
{
  Columns3 result = ofSystems.front();
  for (const Columns3& other : ofSystems.subspan(1)) result += other;
  if (!frame.isIdentity(0)) result *= frame.transpose();
  return result;
}

}  // namespace holdfast
