#include <algorithm>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <holdfast/base/error.h>
#include <holdfast/view/poly_data.h>

namespace holdfast {
namespace {

void requireSurface(vtkPolyData& polyData, const std::string& file)
{
  if (const auto strips = polyData.GetNumberOfStrips(); strips > 0)
    throw InputError({file, 0, ""},
                     "there are triangle strips (" + std::to_string(strips) +
                         "), whose triangles have no ids of their own; turn them into polygons first (the "
                         "filter Triangulate of ParaView does)");
  if (polyData.GetNumberOfPolys() == 0)
    throw InputError({file, 0, ""},
                     "there are no polygons, and only surfaces made of polygons can be deformed; give a file "
                     "with POLYGONS or Polys");
}

std::string polygon(vtkIdType id)
{
  return "polygon " + std::to_string(id);
}

/// VTK's readers take offsets as they stand in the file: out of order or past the end they would read anywhere.
void requireOrderedOffsets(vtkCellArray& cells, const std::string& file)
{
  vtkDataArray& offsets = *cells.GetOffsetsArray();
  const vtkIdType cornerCount = cells.GetNumberOfConnectivityIds();
  vtkIdType previous = 0;
  for (vtkIdType i = 0; i < offsets.GetNumberOfTuples(); ++i) {
    const auto offset = static_cast<vtkIdType>(offsets.GetComponent(i, 0));
    if (offset < previous || offset > cornerCount || (i == 0 && offset != 0))
      throw InputError({file, 0, polygon(i)}, "its offset " + std::to_string(offset) +
                                                  " is out of order or past the last corner; the file is damaged, "
                                                  "write it anew");
    previous = offset;
  }
}

void requireFace(const std::vector<Index>& corners, Index pointCount, const InputLocation& here)
{
  if (corners.size() < 3)
    throw InputError(here, "it has " + std::to_string(corners.size()) + " corners; a face needs three or more");
  for (const Index corner : corners)
    if (corner < 0 || corner >= pointCount)
      throw InputError(here, "it refers to point " + std::to_string(corner) +
                                 ", but the points are numbered from 0 to " + std::to_string(pointCount - 1));
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

vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, const Positions& positions)
{
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.faces.size(), mesh.faces.cornerCount());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto corners = mesh.faces[f];
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const Index corner : corners) cells->InsertCellPoint(corner);
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(toPoints(positions));
  polyData->SetPolys(cells);
  return polyData;
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
  requireOrderedOffsets(cells, file);
  Polygons polygons;
  polygons.reserve(cells.GetNumberOfCells(), cells.GetNumberOfConnectivityIds());
  std::vector<Index> corners;
  for (vtkIdType face = 0; face < cells.GetNumberOfCells(); ++face) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells.GetCellAtId(face, count, ids);
    corners.assign(ids, ids + count);
    requireFace(corners, polyData.GetNumberOfPoints(), {file, 0, polygon(face)});
    polygons.add(corners);
  }
  return polygons;
}

}  // namespace holdfast
