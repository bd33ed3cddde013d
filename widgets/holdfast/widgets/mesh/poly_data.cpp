#include "holdfast/widgets/mesh/poly_data.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkTypeInt32Array.h>

#include <holdfast/base/error.h>

namespace holdfast {
namespace {

void requireSurface(vtkPolyData& polyData, const std::string& file)
{
  if (const auto strips = polyData.GetNumberOfStrips(); strips > 0)
    throw InputError({file, 0, ""}, fmt::format("there are triangle strips ({}), whose triangles have no ids of their "
                                                "own; turn them into polygons first (the filter Triangulate of "
                                                "ParaView does)",
                                                strips));
  if (polyData.GetNumberOfPolys() == 0)
    throw InputError({file, 0, ""},
                     "there are no polygons, and only surfaces made of polygons can be deformed; give a file "
                     "with POLYGONS or Polys");
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
  polyData->SetPolys(toCells(mesh.faces));
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
  std::vector<Index> corners;
  for (vtkIdType face = 0; face < cells.GetNumberOfCells(); ++face) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells.GetCellAtId(face, count, ids);
    corners.assign(ids, ids + count);
    for (const Index corner : corners)
      if (corner < 0 || corner >= polyData.GetNumberOfPoints())
        throw InputError({file, 0, fmt::format("polygon {}", face)},
                         fmt::format("it refers to point {}, but the points are numbered from 0 to {}", corner,
                                     polyData.GetNumberOfPoints() - 1));
    polygons.add(corners);
  }
  return polygons;
}

}  // namespace holdfast
