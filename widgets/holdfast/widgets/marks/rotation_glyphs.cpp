#include "holdfast/widgets/marks/rotation_glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/marks/evenly_spread.h>
#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {
namespace {

// Shares of the diagonal of the model's bounding box.
constexpr double kLongestArrow = 0.075;
constexpr double kOutline = 0.0011;

// A share of the longest arrow.
constexpr double kArrowShaft = 0.035;
constexpr double kArrowHead = 0.11;
constexpr double kHeadLength = 0.30;

// The least angle of the longest arrow, and the angle below which there is none.
constexpr double kFullDegrees = 90;
constexpr double kLeastDegrees = 0.5;

constexpr int kArrowSides = 8;

/// A ring around the axis of an arrow; of radius 0 at its tip.
struct Ring {
  double height;
  double radius;
};

using ArrowProfile = std::array<Ring, 5>;

/// From tail to tip. Short arrows are thinner than long ones, and mostly head.
ArrowProfile profileOf(double length, double longest, double outline)
{
  const double size = longest * std::sqrt(length / longest);
  const double neck = std::max(length - kHeadLength * size, 0.3 * length);
  const double shaft = kArrowShaft * size + outline;
  const double head = kArrowHead * size + outline;
  return {
      {{-outline, 0}, {-outline, shaft}, {neck - outline, shaft}, {neck - outline, head}, {length + 3 * outline, 0}}};
}

class ArrowMesh {
 public:
  ArrowMesh() { points_->SetDataTypeToDouble(); }

  void add(const RotationArrow& arrow, const ArrowProfile& profile)
  {
    const Vector3 axis = arrow.along.normalized();
    const Vector3 x = axis.unitOrthogonal();
    const Vector3 y = axis.cross(x);
    const vtkIdType first = points_->GetNumberOfPoints();
    for (const Ring& ring : profile)
      for (int side = 0; side < kArrowSides; ++side) {
        const double angle = 2 * std::numbers::pi * side / kArrowSides;
        const Vector3 across = std::cos(angle) * x + std::sin(angle) * y;
        points_->InsertNextPoint(Vector3(arrow.tail + ring.height * axis + ring.radius * across).data());
      }
    for (vtkIdType ring = 0; ring + 1 < static_cast<vtkIdType>(profile.size()); ++ring)
      for (vtkIdType side = 0; side < kArrowSides; ++side) {
        const vtkIdType low = first + ring * kArrowSides;
        const vtkIdType next = (side + 1) % kArrowSides;
        cells_->InsertNextCell({low + side, low + next, low + kArrowSides + next, low + kArrowSides + side});
      }
  }

  void show(vtkPolyData& data) const
  {
    data.SetPoints(points_);
    data.SetPolys(cells_);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
};

/// Faces use what belongs to a part.
std::vector<Index> spreadVertices(const Model& model)
{
  const SolverMesh& mesh = model.solverMesh;
  std::vector<Index> used;
  for (Index unknown = 0; unknown < mesh.unknownCount(); ++unknown)
    if (mesh.componentOf[unknown] >= 0) used.push_back(mesh.weld.firstVertexOf[unknown]);
  return evenlySpread(model.mesh.positions, used, kRotationArrows);
}

}  // namespace

std::vector<RotationArrow> rotationArrows(const Model& model, const std::vector<Index>& vertices,
                                          const Positions& positions, const Columns3& q, double longest)
{
  std::vector<RotationArrow> arrows;
  double largest = kFullDegrees;
  for (const Index vertex : vertices) {
    const Vector3 log = q.row(model.solverMesh.weld.unknownOf[vertex]);
    const double degrees = angleDegrees(log);
    if (degrees < kLeastDegrees) continue;
    arrows.push_back({vertex, positions.row(vertex), degrees * log.normalized()});
    largest = std::max(largest, degrees);
  }
  for (RotationArrow& arrow : arrows) arrow.along *= longest / largest;
  return arrows;
}

RotationGlyphs::RotationGlyphs(const Model& model) : model_(model)
{
  showData(*outlines_, *outlineData_);
  showData(*arrows_, *arrowData_);
  arrows_->GetProperty()->SetColor(0.10, 0.11, 0.14);
  arrows_->GetProperty()->SetInterpolationToFlat();
  // Only the inner sides of the outlines are seen, around the arrows that lie before these.
  outlines_->GetProperty()->SetColor(1, 1, 1);
  outlines_->GetProperty()->LightingOff();
  outlines_->GetProperty()->FrontfaceCullingOn();
}

void RotationGlyphs::set(const Positions& positions, const Columns3& q)
{
  if (vertices_.empty()) vertices_ = spreadVertices(model_);
  const double diagonal = model_.solverMesh.diagonal;
  const double longest = kLongestArrow * diagonal;
  ArrowMesh arrows;
  ArrowMesh outlines;
  if (q.rows() > 0)
    for (const RotationArrow& arrow : rotationArrows(model_, vertices_, positions, q, longest)) {
      if (!isHidden_.empty() && isHidden_[arrow.vertex] != 0) continue;
      const double length = arrow.along.norm();
      arrows.add(arrow, profileOf(length, longest, 0));
      outlines.add(arrow, profileOf(length, longest, kOutline * diagonal));
    }
  arrows.show(*arrowData_);
  outlines.show(*outlineData_);
}

}  // namespace holdfast
