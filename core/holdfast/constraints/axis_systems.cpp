#include "holdfast/constraints/axis_systems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// Directions that are parallel or square up to this are so but for the rounding of their numbers. A row is then off by
// at most this share of its displacement: a hundredth of the residual that is promised.
constexpr double kRoundedAngle = 1e-14;

bool areParallel(const Vector3& a, const Vector3& b)
{
  return a.cross(b).norm() <= kRoundedAngle;
}

bool areSquare(const Vector3& a, const Vector3& b)
{
  return std::abs(a.dot(b)) <= kRoundedAngle;
}

// Where hardly more rows (one in so many, and three) are at odds with the coordinate axes, these are the frame: all
// rows are one problem then in the place of two or three.
constexpr std::size_t kHardlyMore = 10;

/// A direction of rows, up to its sign.
struct CountedAxis {
  Vector3 axis;
  Index count = 0;
};

/// In the order in which rows have them first.
std::vector<CountedAxis> countedAxes(const std::vector<ConstraintRow>& rows)
{
  std::vector<CountedAxis> axes;
  for (const ConstraintRow& row : rows) {
    const RowDirections directions = row.eliminatedDirections();
    if (directions.areAll()) continue;
    const Vector3& axis = directions.axis();
    const auto known =
        std::ranges::find_if(axes, [&](const CountedAxis& some) { return areParallel(some.axis, axis); });
    ++(known == axes.end() ? axes.emplace_back(CountedAxis{axis}) : *known).count;
  }
  return axes;
}

/// The axes of most rows, no more than three, which are square to one another.
std::vector<Vector3> axesOfMost(const std::vector<CountedAxis>& counted)
{
  std::vector<Vector3> axes;
  while (axes.size() < 3) {
    const CountedAxis* most = nullptr;
    for (const CountedAxis& some : counted) {
      const bool fits = std::ranges::all_of(axes, [&](const Vector3& axis) { return areSquare(axis, some.axis); });
      if (fits && (most == nullptr || some.count > most->count)) most = &some;
    }
    if (most == nullptr) break;
    axes.push_back(most->axis);
  }
  return axes;
}

/// The rows with directions that are along none of the axes, ascending.
std::vector<Index> rowsBesides(const std::vector<Vector3>& axes, const std::vector<ConstraintRow>& rows)
{
  std::vector<Index> result;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const RowDirections directions = rows[r].eliminatedDirections();
    const auto isParallel = [&](const Vector3& axis) { return areParallel(axis, directions.axis()); };
    if (!directions.areAll() && std::ranges::none_of(axes, isParallel)) result.push_back(static_cast<Index>(r));
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

/// The matrix that takes rows to coordinates of the frame, with 0 along other axes than these.
Eigen::Matrix3d toAxes(const std::bitset<3>& axes, Eigen::Matrix3d frame)
{
  for (Index k = 0; k < 3; ++k)
    if (!axes[static_cast<std::size_t>(k)]) frame.col(k).setZero();
  return frame;
}

/// Tells whether a tolerance asks something of each coordinate by itself.
struct AsksByCoordinates {
  const RowDirections& directions;

  bool operator()(const Exactly& /*exactly*/) const { return false; }
  bool operator()(const WithinBall& /*ball*/) const { return isAlongCoordinate(); }
  bool operator()(const WithinBox& /*box*/) const { return true; }
  bool operator()(const WithinSlab& slab) const
  {
    return slab.normal ? isCoordinateAxis(slab.normal->stableNormalized()) : isAlongCoordinate();
  }
  bool operator()(const Weighted& /*weighted*/) const
  {
    return directions.areAll() || isCoordinateAxis(directions.axis());
  }

 private:
  [[nodiscard]] bool isAlongCoordinate() const
  {
    return !directions.areAll() && directions.areAlongAxis() && isCoordinateAxis(directions.axis());
  }
};

}  // namespace

bool isByCoordinates(const TolerantRow& tolerant, const RowDirections& directions)
{
  return tolerant.surface == nullptr && std::visit(AsksByCoordinates{directions}, tolerant.within);
}

std::vector<Index> rowsAtOdds(const std::vector<ConstraintRow>& rows)
{
  const std::vector<CountedAxis> counted = countedAxes(rows);
  const std::vector<Index> result = rowsBesides(axesOfMost(counted), rows);
  if (result.empty()) return result;
  const std::vector<Vector3> coordinateAxes{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  std::vector<Index> besidesCoordinates = rowsBesides(coordinateAxes, rows);
  const std::size_t most = result.size() + result.size() / kHardlyMore + 3;  // each axis has a row of its own
  return besidesCoordinates.size() <= std::min(most, kMostTolerantPoints / 2) ? besidesCoordinates : result;
}

std::optional<Eigen::Matrix3d> commonFrame(const std::vector<ConstraintRow>& rows)
{
  const std::vector<CountedAxis> axes = countedAxes(rows);
  for (const CountedAxis& a : axes)
    for (const CountedAxis& b : axes)
      if (&a != &b && !areSquare(a.axis, b.axis)) return std::nullopt;
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  if (std::ranges::all_of(axes, [](const CountedAxis& some) { return isCoordinateAxis(some.axis); })) return frame;
  frame.col(0) = axes.front().axis;
  frame.col(2) = frame.col(0).cross(axes.size() > 1 ? axes[1].axis : frame.col(0).unitOrthogonal()).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

std::vector<AxisSystem> axisSystems(const ConstraintSystem& system, const Eigen::Matrix3d& frame)
{
  std::array<std::vector<Index>, 3> rowsOf;
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const std::bitset<3> axes = heldAxes(system.rows[r].eliminatedDirections(), frame);
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
  for (AxisSystem& some : result) {
    const Eigen::Matrix3d toFrame = toAxes(some.axes, frame).transpose();
    for (const Index r : some.rows) {
      ConstraintRow& row = some.system.rows.emplace_back(system.rows[r]);
      row.shift = toFrame * row.shift;
      row.directions = {};
    }
  }
  return result;
}

Columns3 alongAxes(Columns3 values, const std::bitset<3>& axes, const Eigen::Matrix3d& frame)
{
  const Eigen::Matrix3d toFrame = toAxes(axes, frame);
  parallelBlocks(values.rows(), [&](Index i) { values.row(i) *= toFrame; });
  return values;
}

Columns3 joinedAxes(std::vector<Columns3> ofSystems, const Eigen::Matrix3d& frame)
{
  Columns3 result = std::move(ofSystems.front());
  const auto others = std::span(ofSystems).subspan(1);
  const Eigen::Matrix3d fromFrame = frame.transpose();
  parallelBlocks(result.rows(), [&](Index i) {
    Eigen::RowVector3d sum = result.row(i);
    for (const Columns3& other : others) sum += other.row(i);
    result.row(i) = sum * fromFrame;
  });
  return result;
}

}  // namespace holdfast
