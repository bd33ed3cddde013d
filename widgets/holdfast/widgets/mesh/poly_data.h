#pragma once
/// Between Holdfast's meshes and VTK's.

#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <holdfast/mesh/field.h>
#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Points of doubles, a copy of `positions`.
[[nodiscard]] vtkSmartPointer<vtkPoints> toPoints(const Positions& positions);

/// In the place of all that `data` holds: points that are drawn; lines, or polygons, through points of their own.
void setPoints(vtkPolyData& data, const std::vector<Vector3>& places);
void setLines(vtkPolyData& data, const std::vector<std::vector<Vector3>>& lines);
void setPolygons(vtkPolyData& data, const std::vector<std::vector<Vector3>>& polygons);

[[nodiscard]] vtkSmartPointer<vtkCellArray> toCells(const Polygons& polygons);

/// The `count` triangles k among `triangles` for which `isIn(k)`.
template <typename Predicate>
[[nodiscard]] vtkSmartPointer<vtkCellArray> toCells(const Polygons& triangles, Index count, const Predicate& isIn)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  // Fresh memory takes longer than what is written into it, and OpenGL has no longer numbers.
  cells->Use32BitStorage();
  cells->AllocateExact(count, 3 * count);
  for (Index k = 0; k < triangles.size(); ++k)
    if (isIn(k)) cells->InsertNextCell({triangles[k][0], triangles[k][1], triangles[k][2]});
  return cells;
}

/// The faces of `mesh` at `positions` (vertexCount x 3): polygons only, no attributes.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, const Positions& positions);

/// A copy, called as the field.
[[nodiscard]] vtkSmartPointer<vtkDoubleArray> toArray(const Field& field);

[[nodiscard]] Positions positionsOf(vtkPolyData& polyData);

/// Throws `InputError` about `file` where a cell begins or ends outside the list of corners, or has fewer corners than
/// its kind needs: VTK would read past its buffers.
void requireSoundCells(vtkPolyData& polyData, const std::string& file);

/// The polygons of `polyData`, whose cells are sound: face f is its f-th polygon. Throws `InputError` about `file`
/// where there is no polygon, where one has a corner that is no point, and where there are triangle strips.
[[nodiscard]] Polygons polygonsOf(vtkPolyData& polyData, const std::string& file);

}  // namespace holdfast
