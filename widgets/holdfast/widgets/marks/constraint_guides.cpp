#include "holdfast/widgets/marks/constraint_guides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/widgets/marks/evenly_spread.h>
#include <holdfast/widgets/marks/mark_set.h>

namespace holdfast {
namespace {

// Half sides of squares and half lengths of lines, in diagonals of the mesh.
constexpr double kPointGuide = 0.035;
constexpr double kMostShared = 24;

// What vertices share reaches so much farther than they lie apart.
constexpr double kMargin = 1.12;

// Vertices share a plane or a line if they are as near to it as this, in diagonals.
constexpr double kSame = 1e-6;

constexpr int kCircleSides = 48;

/// A row that leaves its point free, or bounds it.
struct GuidedPoint {
  Vector3 place;   // as it is now
  Vector3 target;  // as it is stated; of a difference: where the point is
  RowDirections directions;
  PointTolerance within = Exactly{};
  bool isOnMesh = false;
  bool isSelected = false;  // one of the vertices of a selection
  bool isMirrored = false;
};

/// Makes the guides of one constraint.
class GuideMaker {
 public:
  GuideMaker(Index constraint, ConstraintStatus status, const Eigen::AlignedBox3d& box,
             std::vector<ConstraintGuide>& guides)
      : constraint_(constraint), status_(status), box_(box), diagonal_(box.diagonal().norm()), guides_(guides)
  {
  }

  void add(const std::vector<GuidedPoint>& points)
  {
    if (points.empty()) return;
    if (points.front().isMirrored) return addMirror(points.front());
    if (points.front().isSelected && !points.front().isOnMesh && shareOne(points)) return addShared(points);
    std::vector<Index> shown(points.size());
    if (points.front().isSelected)
      shown = evenlySpread(placesOf(points), static_cast<Index>(kMostShared));
    else
      for (std::size_t k = 0; k < shown.size(); ++k) shown[k] = static_cast<Index>(k);
    for (const Index k : shown) {
      const double size = kPointGuide * diagonal_;
      const GuidedPoint& point = points[static_cast<std::size_t>(k)];
      // The nearest to the point of the places that it may go to.
      addOne(point, point.place - point.directions.held(point.place - point.target), {size, size, size});
    }
  }

 private:
  static Positions placesOf(const std::vector<GuidedPoint>& points)
  {
    Positions places(static_cast<Index>(points.size()), 3);
    for (Index k = 0; k < places.rows(); ++k) places.row(k) = points[static_cast<std::size_t>(k)].place;
    return places;
  }

  [[nodiscard]] bool shareOne(const std::vector<GuidedPoint>& points) const
  {
    const GuidedPoint& first = points.front();
    return !first.directions.areAll() && std::ranges::all_of(points, [&](const GuidedPoint& point) {
      return point.directions == first.directions &&
             first.directions.held(point.target - first.target).norm() <= kSame * diagonal_;
    });
  }

  /// One plane or line, as large as the points lie apart.
  void addShared(const std::vector<GuidedPoint>& points)
  {
    const GuidedPoint& first = points.front();
    const Eigen::Matrix3d axes = axesAbout(first.directions.axis());
    Eigen::AlignedBox3d along;
    for (const GuidedPoint& point : points)
      along.extend(Vector3(axes.transpose() * (point.place - first.directions.held(point.place - first.target))));
    const Vector3 half = (kMargin / 2 * along.sizes()).cwiseMax(kPointGuide * diagonal_);
    addOne(first, axes * along.center(), half);
  }

  void addMirror(const GuidedPoint& point)
  {
    const Eigen::Matrix3d axes = axesAbout(point.directions.axis());
    Eigen::AlignedBox3d along;
    for (int k = 0; k < 8; ++k)
      along.extend(Vector3(axes.transpose() * box_.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k))));
    Vector3 center = along.center();
    center.z() = axes.col(2).dot(point.target);
    add(GuideShape::Plane, axes * center, axes, kMargin / 2 * along.sizes());
  }

  /// What `point` is free on at `center`, and what bounds it there.
  void addOne(const GuidedPoint& point, const Vector3& center, const Vector3& half)
  {
    const RowDirections& directions = point.directions;
    const Eigen::Matrix3d axes =
        directions.areAll() ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : axesAbout(directions.axis());
    const bool isPlane = !directions.areAll() && directions.areAlongAxis();
    if (isPlane && !point.isOnMesh) add(GuideShape::Plane, center, axes, half);
    if (!directions.areAll() && !isPlane) add(GuideShape::Line, center, axes, half);
    if (const auto* const ball = std::get_if<WithinBall>(&point.within)) {
      if (isPlane)
        addSlab(center, axes, half, -ball->radius, ball->radius);
      else if (directions.areAll())
        add(GuideShape::Ball, center, axes, Vector3::Constant(ball->radius));
      else
        add(GuideShape::Cylinder, center, axes, {ball->radius, ball->radius, half.z()});
    }
    if (const auto* const box = std::get_if<WithinBox>(&point.within)) add(GuideShape::Box, center, axes, box->half);
    if (const auto* const slab = std::get_if<WithinSlab>(&point.within))
      addSlab(center, slab->normal ? axesAbout(slab->normal->stableNormalized()) : axes, half, slab->low, slab->high);
  }

  void addSlab(const Vector3& center, const Eigen::Matrix3d& axes, const Vector3& half, double low, double high)
  {
    for (const double bound : {low, high})
      if (std::isfinite(bound)) add(GuideShape::Plane, center + bound * axes.col(2), axes, half);
    if (std::isfinite(low) && std::isfinite(high))
      add(GuideShape::Distance, center + (low + high) / 2 * axes.col(2), axes, {0, 0, (high - low) / 2});
  }

  void add(GuideShape shape, const Vector3& center, const Eigen::Matrix3d& axes, const Vector3& half)
  {
    guides_.push_back({constraint_, status_, shape, center, axes, half});
  }

  Index constraint_;
  ConstraintStatus status_;
  const Eigen::AlignedBox3d& box_;
  double diagonal_;
  std::vector<ConstraintGuide>& guides_;
};

/// A constraint is redundant only where all of its rows are, and off where one of them is.
ConstraintStatus graver(ConstraintStatus a, ConstraintStatus b)
{
  return isOff(a) || b == ConstraintStatus::Redundant ? a : b;
}

/// Where a row acts: the terms above 0 of a difference, the middle of two partners.
Vector3 placeOf(const ConstraintRow& row, const Weld& weld, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();
  double weight = 0;
  for (const Term& term : row.terms) {
    if (term.coefficient < 0) continue;
    sum += term.coefficient * positions.row(weld.firstVertexOf[term.index]).transpose();
    weight += term.coefficient;
  }
  return sum / weight;
}

}  // namespace

std::vector<ConstraintGuide> constraintGuides(const Model& model, const DeformResult& deformation)
{
  std::vector<ConstraintGuide> guides;
  const ConstraintSystem& system = deformation.details->system;
  Eigen::AlignedBox3d box;
  for (const auto& place : deformation.positions.rowwise()) box.extend(Vector3(place));
  std::vector<GuidedPoint> points;
  ConstraintStatus status = ConstraintStatus::Redundant;
  auto tolerant = system.tolerant.begin();
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const ConstraintRow& row = system.rows[r];
    const bool isTolerant = tolerant != system.tolerant.end() && tolerant->row == static_cast<Index>(r);
    const bool isMirrored = row.kind == RowKind::Mirrored;
    if ((isTolerant || !row.directions.areAll()) && !row.terms.empty() && !(isMirrored && !points.empty())) {
      GuidedPoint& point = points.emplace_back();
      point.place = placeOf(row, model.solverMesh.weld, deformation.positions);
      point.target = row.kind == RowKind::Position ? row.target : isMirrored ? Vector3(row.target / 2) : point.place;
      point.directions = row.directions;
      point.isSelected = row.corners == 0;
      point.isMirrored = isMirrored;
      if (isTolerant) {
        point.within = tolerant->within;
        point.target = tolerant->target;
        point.isOnMesh = tolerant->surface != nullptr;
      }
    }
    if (isTolerant) ++tolerant;
    status = graver(status, rowStatus(*deformation.details, static_cast<Index>(r)));
    if (r + 1 == system.rows.size() || system.rows[r + 1].constraint != row.constraint) {
      GuideMaker(row.constraint, status, box, guides).add(points);
      points.clear();
      status = ConstraintStatus::Redundant;
    }
  }
  return guides;
}

std::array<Vector3, 4> cornersOf(const ConstraintGuide& guide)
{
  std::array<Vector3, 4> corners;
  for (int k = 0; k < 4; ++k)
    corners[static_cast<std::size_t>(k)] =
        guide.center + guide.axes * Vector3(k == 0 || k == 3 ? -guide.half.x() : guide.half.x(),
                                            k < 2 ? -guide.half.y() : guide.half.y(), 0);
  return corners;
}

std::vector<std::array<Vector3, 2>> outlineOf(const ConstraintGuide& guide)
{
  std::vector<std::array<Vector3, 2>> lines;
  const auto at = [&](double x, double y, double z) -> Vector3 {
    return guide.center + guide.axes * guide.half.cwiseProduct(Vector3(x, y, z));
  };
  const auto circle = [&](const auto& place) {
    for (int k = 0; k < kCircleSides; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCircleSides;
      const double next = 2 * std::numbers::pi * (k + 1) / kCircleSides;
      lines.push_back({place(std::cos(angle), std::sin(angle)), place(std::cos(next), std::sin(next))});
    }
  };
  switch (guide.shape) {
    case GuideShape::Plane: {
      const std::array<Vector3, 4> corners = cornersOf(guide);
      for (std::size_t k = 0; k < 4; ++k) lines.push_back({corners[k], corners[(k + 1) % 4]});
      break;
    }
    case GuideShape::Line:
    case GuideShape::Distance:
      lines.push_back({at(0, 0, -1), at(0, 0, 1)});
      break;
    case GuideShape::Ball:
      circle([&](double c, double s) { return at(c, s, 0); });
      circle([&](double c, double s) { return at(0, c, s); });
      circle([&](double c, double s) { return at(s, 0, c); });
      break;
    case GuideShape::Box:
      for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0}) {
          lines.push_back({at(-1, a, b), at(1, a, b)});
          lines.push_back({at(a, -1, b), at(a, 1, b)});
          lines.push_back({at(a, b, -1), at(a, b, 1)});
        }
      break;
    case GuideShape::Cylinder:
      for (const double end : {-1.0, 1.0}) {
        circle([&](double c, double s) { return at(c, s, end); });
        lines.push_back({at(end, 0, -1), at(end, 0, 1)});
        lines.push_back({at(0, end, -1), at(0, end, 1)});
      }
      break;
  }
  return lines;
}

}  // namespace holdfast
