#include "holdfast/widgets/mesh/poly_data.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkTypeInt32Array.h>

#include <holdfast/mesh/stated_places.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

void requireSurface(vtkPolyData& polyData, const std::string& file)
{
  if (polyData.GetNumberOfPolys() == 0 && polyData.GetNumberOfStrips() == 0)
    throw InputError({file, 0, ""},
                     "there are no polygons, and only surfaces made of polygons can be deformed; give a file "
                     "with POLYGONS or Polys");
}

/// Calls `visit(cell, corners)` for each cell, whose corners are points.
template <class Visit>
void forEachCell(vtkPolyData& polyData, vtkCellArray& cells, const char* kind, const std::string& file,
                 const Visit& visit)
{
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells.GetCellAtId(cell, count, ids);
    const std::vector<Index> corners(ids, ids + count);
    for (const Index corner : corners)
      if (corner < 0 || corner >= polyData.GetNumberOfPoints())
        throw InputError({file, 0, fmt::format("{} {}", kind, cell)},
                         fmt::format("it refers to point {}, but the points are numbered from 0 to {}", corner,
                                     polyData.GetNumberOfPoints() - 1));
    visit(corners);
  }
}

/// Adds every second triangle of a strip in reverse order, so that all have the same side up. Triangles that name a
/// point twice only continue the strip.
void addStrip(Polygons& polygons, const std::vector<Index>& strip)
{
  for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
    const Index a = strip[k];
    const Index b = strip[k + 1 + k % 2];
    const Index c = strip[k + 2 - k % 2];
    if (a != b && b != c && c != a) polygons.add({a, b, c});
  }
}

void requireSoundKind(vtkCellArray& cells, vtkIdType leastCorners, const char* kind, const std::string& file)
{
  vtkDataArray& offsets = *cells.GetOffsetsArray();
  const vtkIdType cornerCount = cells.GetNumberOfConnectivityIds();
  const auto offset = [&](vtkIdType i) { return static_cast<vtkIdType>(offsets.GetComponent(i, 0)); };
  if (offsets.GetNumberOfTuples() < 1 || offset(0) != 0)
    throw InputError({file, 0, kind + std::string("s")},
                     "their first offset is not 0; the file is damaged, write it anew");
  for (vtkIdType i = 1; i < offsets.GetNumberOfTuples(); ++i)
    if (offset(i) < offset(i - 1) + leastCorners || offset(i) > cornerCount)
      throw InputError({file, 0, fmt::format("{} {}", kind, i - 1)},
                       fmt::format("it goes from corner {} to before corner {} of {}, and needs at least {}; leave it "
                                   "out or write the file anew",
                                   offset(i - 1), offset(i), cornerCount, leastCorners));
}

vtkSmartPointer<vtkCellArray> addCells(vtkPolyData& data, const std::vector<std::vector<Vector3>>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const std::vector<Vector3>& cell : corners) {
    if (cell.empty()) continue;
    cells->InsertNextCell(static_cast<int>(cell.size()));
    for (const Vector3& place : cell) cells->InsertCellPoint(points->InsertNextPoint(place.data()));
  }
  data.Initialize();
  data.SetPoints(points);
  return cells;
}

vtkNew<vtkTypeInt32Array> copyOf(std::span<const int> numbers)
{
  vtkNew<vtkTypeInt32Array> copy;
  copy->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  std::ranges::copy(numbers, copy->GetPointer(0));
  return copy;
}

}  // namespace

vtkSmartPointer<vtkPoints> toPoints(const Positions& positions)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(positions.rows());
  std::copy_n(positions.data(), positions.size(), coordinates->GetPointer(0));
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

void setPoints(vtkPolyData& data, const std::vector<Vector3>& places)
{
  const auto count = static_cast<Index>(places.size());
  vtkNew<vtkCellArray> cells;
  for (Index k = 0; k < count; ++k) cells->InsertNextCell({k});
  data.Initialize();
  data.SetPoints(toPoints(Eigen::Map<const Positions>(count > 0 ? places.front().data() : nullptr, count, 3)));
  data.SetVerts(cells);
}

void setLines(vtkPolyData& data, const std::vector<std::vector<Vector3>>& lines)
{
  data.SetLines(addCells(data, lines));
}

void setPolygons(vtkPolyData& data, const std::vector<std::vector<Vector3>>& polygons)
{
  data.SetPolys(addCells(data, polygons));
}

vtkSmartPointer<vtkCellArray> toCells(const Polygons& polygons)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(copyOf(polygons.starts()), copyOf(polygons.corners()));
  return cells;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, const Positions& positions)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(toPoints(positions));
  if (facesWithoutSurface(mesh.faces).empty())
    polyData->SetPolys(toCells(mesh.faces));
  else
    polyData->SetPolys(toCells(surfaceOf(mesh).faces));
  return polyData;
}

vtkSmartPointer<vtkDoubleArray> toArray(const Field& field)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(static_cast<int>(field.components));
  array->SetNumberOfValues(static_cast<vtkIdType>(field.values.size()));
  std::copy(field.values.begin(), field.values.end(), array->GetPointer(0));
  return array;
}

void requireSoundCells(vtkPolyData& polyData, const std::string& file)
{
  requireSoundKind(*polyData.GetVerts(), 1, "vertex cell", file);
  requireSoundKind(*polyData.GetLines(), 2, "line", file);
  requireSoundKind(*polyData.GetPolys(), 3, "polygon", file);
  requireSoundKind(*polyData.GetStrips(), 3, "strip", file);
}

Positions positionsOf(vtkPolyData& polyData)
{
  Positions positions(polyData.GetNumberOfPoints(), 3);
  for (Index v = 0; v < positions.rows(); ++v) polyData.GetPoint(v, positions.row(v).data());
  return positions;
}

Polygons polygonsOf(vtkPolyData& polyData, const std::string& file)
{
  requireSurface(polyData, file);
  vtkCellArray& cells = *polyData.GetPolys();
  Polygons polygons;
  polygons.reserve(cells.GetNumberOfCells(), cells.GetNumberOfConnectivityIds());
  forEachCell(polyData, cells, "polygon", file, [&](const std::vector<Index>& corners) { polygons.add(corners); });
  forEachCell(polyData, *polyData.GetStrips(), "strip", file,
              [&](const std::vector<Index>& strip) { addStrip(polygons, strip); });
  if (polygons.isEmpty()) throw InputError({file, 0, ""}, "no strip has a triangle of three different points");
  return polygons;
}

}  // namespace holdfast
