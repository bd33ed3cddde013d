#include "holdfast/widgets/rotation_sphere/sphere_shapes.h"

#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <holdfast/geometry/degree.h>

namespace holdfast {
namespace {

// Rings lie between the shell and the points.
constexpr double kShellRadius = 0.985;
constexpr double kGridRadius = 0.993;
constexpr int kShellRings = 48;
constexpr int kShellMeridians = 96;
constexpr int kSteps = 120;
constexpr int kMeridians = 8;

// Degrees of rotation from ring to ring, and of the last one before the whole turn.
constexpr int kRingDegrees = 45;
constexpr int kLastRing = 315;

// Between the meridians, where data about coordinate axes are.
constexpr double kNameAzimuth = 22.5;
constexpr double kNameRadius = 1.01;

Vector3 onSphere(double fromPole, double azimuth)
{
  return {std::sin(fromPole) * std::cos(azimuth), std::sin(fromPole) * std::sin(azimuth), std::cos(fromPole)};
}

vtkSmartPointer<vtkCellArray> singlePoints(Index count)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(count, count);
  for (vtkIdType k = 0; k < count; ++k) cells->InsertNextCell({k});
  return cells;
}

}  // namespace

vtkSmartPointer<vtkPolyData> sphereShell()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i <= kShellRings; ++i)
    for (int k = 0; k < kShellMeridians; ++k) {
      const Vector3 normal = onSphere(i * std::numbers::pi / kShellRings, k * 2 * std::numbers::pi / kShellMeridians);
      const Vector3 place = kShellRadius * normal;
      points->InsertNextPoint(place.data());
      normals->InsertNextTuple(normal.data());
    }
  for (vtkIdType i = 0; i < kShellRings; ++i)
    for (vtkIdType k = 0; k < kShellMeridians; ++k) {
      const vtkIdType next = (k + 1) % kShellMeridians;
      const vtkIdType row = i * kShellMeridians;
      const vtkIdType below = row + kShellMeridians;
      cells->InsertNextCell({row + k, below + k, below + next, row + next});
    }
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  return data;
}

vtkSmartPointer<vtkPolyData> sphereRings()
{
  std::vector<std::vector<Vector3>> lines;
  for (int degrees = kRingDegrees; degrees <= kLastRing; degrees += kRingDegrees) {
    std::vector<Vector3>& line = lines.emplace_back();
    for (int k = 0; k <= kSteps; ++k)
      line.push_back(kGridRadius * onSphere(degrees / 2.0 * kDegree, k * 2 * std::numbers::pi / kSteps));
  }
  for (int meridian = 0; meridian < kMeridians; ++meridian) {
    std::vector<Vector3>& line = lines.emplace_back();
    for (int k = 0; k <= kSteps; ++k)
      line.push_back(kGridRadius *
                     onSphere(k * std::numbers::pi / kSteps, meridian * 2 * std::numbers::pi / kMeridians));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  setPolylines(*data, lines);
  return data;
}

std::vector<RingName> ringNames()
{
  std::vector<RingName> names;
  for (int degrees = kRingDegrees; degrees <= kLastRing; degrees += kRingDegrees)
    for (const double azimuth : {-90 + kNameAzimuth, 90 + kNameAzimuth})
      names.push_back(
          {std::to_string(degrees) + "\u00b0", kNameRadius * onSphere(degrees / 2.0 * kDegree, azimuth * kDegree)});
  names.push_back({"360\u00b0", -1.05 * Vector3::UnitZ()});
  return names;
}

void setPoints(vtkPolyData& data, const std::vector<Vector3>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) points->SetPoint(static_cast<vtkIdType>(k), places[k].data());
  data.SetPoints(points);
  data.SetVerts(singlePoints(static_cast<Index>(places.size())));
}

void setPolylines(vtkPolyData& data, const std::vector<std::vector<Vector3>>& lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::vector<Vector3>& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vector3& place : line) cells->InsertCellPoint(points->InsertNextPoint(place.data()));
  }
  data.SetPoints(points);
  data.SetLines(cells);
}

Color mixed(const Color& from, const Color& to, double share)
{
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

}  // namespace holdfast
