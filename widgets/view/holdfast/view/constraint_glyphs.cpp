#include <algorithm>
#include <cmath>
#include <optional>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/deform/outcomes.h>
#include <holdfast/view/constraint_glyphs.h>

namespace holdfast {
namespace {

// Of the diameter of a single point's ball.
constexpr double kSelectedSize = 0.45;
constexpr double kLineSize = 0.22;

ConstraintStatus statusOf(RowStatus row, double residual, double limit)
{
  if (row == RowStatus::Conflicting) return ConstraintStatus::Conflicting;
  if (residual > limit) return ConstraintStatus::Missed;
  return row == RowStatus::Redundant ? ConstraintStatus::Redundant : ConstraintStatus::Met;
}

bool isOff(const ConstraintMark& mark)
{
  return mark.status == ConstraintStatus::Conflicting || mark.status == ConstraintStatus::Missed;
}

/// Points, lines and a colour for each point.
struct GlyphData {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;

  GlyphData()
  {
    points->SetDataTypeToDouble();
    colors->SetNumberOfComponents(3);
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colors);
  }

  vtkIdType add(const Vector3& place, ConstraintStatus status)
  {
    const Color color = glyphColor(status);
    colors->InsertNextTuple3(std::round(255 * color.red), std::round(255 * color.green), std::round(255 * color.blue));
    return points->InsertNextPoint(place.data());
  }
};

void show(const GlyphData& glyphs, vtkActor& actor)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(glyphs.data);
  actor.SetMapper(mapper);
}

struct Ball {
  Vector3 place;
  ConstraintStatus status;
};

void showBalls(const std::vector<Ball>& balls, vtkActor& actor)
{
  GlyphData glyphs;
  for (const Ball& ball : balls) glyphs.cells->InsertNextCell({glyphs.add(ball.place, ball.status)});
  glyphs.data->SetVerts(glyphs.cells);
  show(glyphs, actor);
  vtkProperty& property = *actor.GetProperty();
  property.RenderPointsAsSpheresOn();
  property.SetAmbient(0.25);
  property.SetDiffuse(0.75);
  property.SetSpecular(0.35);
  property.SetSpecularPower(30);
}

void showLines(const std::vector<ConstraintMark>& marks, vtkActor& actor)
{
  GlyphData glyphs;
  for (const ConstraintMark& mark : marks)
    if (isOff(mark))
      glyphs.cells->InsertNextCell({glyphs.add(mark.place, mark.status), glyphs.add(mark.target, mark.status)});
  glyphs.data->SetLines(glyphs.cells);
  show(glyphs, actor);
  actor.GetProperty()->LightingOff();
}

/// Where a row acts, and where it wants that to be: a row that says how one place lies to another acts on the one.
/// Nothing for a row without terms.
std::optional<ConstraintMark> placeOf(const ConstraintRow& row, const Weld& weld, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();  // B x
  Vector3 place = Vector3::Zero();
  double weight = 0;
  for (const PointTerm& term : row.terms) {
    const Vector3 part = term.weight * positions.row(weld.firstVertexOf[term.vertex]).transpose();
    sum += part;
    if (term.weight < 0) continue;
    place += part;
    weight += term.weight;
  }
  if (row.terms.empty()) return std::nullopt;
  if (row.kind == RowKind::Position) return ConstraintMark{sum, row.target};
  place /= weight;
  return ConstraintMark{place, place + (row.target - sum) / weight};
}

}  // namespace

std::vector<ConstraintMark> constraintMarks(const Model& model, const Deformation& deformation)
{
  const Weld& weld = model.solverMesh.weld;
  const std::vector<double> residuals = rowResiduals(deformation.system, weld, deformation.positions);
  const double limit = residualLimit(model.solverMesh, deformation.system);
  std::vector<ConstraintMark> marks;
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    const ConstraintRow& row = deformation.system.rows[r];
    auto mark = placeOf(row, weld, deformation.positions);
    if (!mark) continue;
    mark->status = statusOf(deformation.diagnosis.status[r], residuals[r], limit);
    mark->isSinglePoint = row.kind == RowKind::Relative || !deformation.system.points[row.constraint].terms.empty();
    marks.push_back(*mark);
  }
  return marks;
}

Color glyphColor(ConstraintStatus status)
{
  switch (status) {
    case ConstraintStatus::Redundant:
      return {1, 1, 1};
    case ConstraintStatus::Conflicting:
      return {0.90, 0.22, 0.05};
    case ConstraintStatus::Missed:
      return {0.72, 0.25, 0.60};
    case ConstraintStatus::Independent:
    case ConstraintStatus::Met:
    case ConstraintStatus::Disabled:
      break;
  }
  return {0.14, 0.15, 0.18};
}

ConstraintGlyphs::ConstraintGlyphs(std::vector<ConstraintMark> marks)
{
  // Of several in one place the last is seen: the gravest.
  std::stable_sort(marks.begin(), marks.end(),
                   [](const ConstraintMark& a, const ConstraintMark& b) { return a.status < b.status; });
  std::vector<Ball> large;
  std::vector<Ball> small;
  for (const ConstraintMark& mark : marks) {
    (mark.isSinglePoint ? large : small).push_back({mark.place, mark.status});
    if (isOff(mark)) small.push_back({mark.target, mark.status});
  }
  showBalls(large, *points_);
  showBalls(small, *selected_);
  showLines(marks, *lines_);
}

ConstraintGlyphs::~ConstraintGlyphs() = default;

void ConstraintGlyphs::setBallPixels(double pixels)
{
  points_->GetProperty()->SetPointSize(static_cast<float>(pixels));
  selected_->GetProperty()->SetPointSize(static_cast<float>(kSelectedSize * pixels));
  lines_->GetProperty()->SetLineWidth(static_cast<float>(kLineSize * pixels));
}

std::vector<vtkActor*> ConstraintGlyphs::actors() const
{
  return {selected_, points_, lines_};
}

}  // namespace holdfast
