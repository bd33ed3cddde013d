#pragma once
/// Between Holdfast's meshes and VTK's.

#include <algorithm>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

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

/// The triangles k among `triangles` for which `isIn(k)`, which is called twice for each.
template <typename Predicate>
[[nodiscard]] vtkSmartPointer<vtkCellArray> toCells(const Polygons& triangles, const Predicate& isIn)
{
  vtkTypeInt32 count = 0;
  for (Index k = 0; k < triangles.size(); ++k) count += isIn(k) ? 1 : 0;
  // Fresh memory takes longer than what is written into it, and OpenGL has no longer numbers.
  vtkNew<vtkTypeInt32Array> starts;
  vtkNew<vtkTypeInt32Array> corners;
  starts->SetNumberOfValues(count + 1);
  corners->SetNumberOfValues(3 * count);
  for (vtkTypeInt32 k = 0; k <= count; ++k) starts->SetValue(k, 3 * k);
  vtkTypeInt32* next = corners->GetPointer(0);
  for (Index k = 0; k < triangles.size(); ++k)
    if (isIn(k)) next = std::ranges::copy(triangles[k], next).out;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(starts, corners);
  return cells;
}

/// The faces of `mesh` at `positions` (vertexCount x 3): polygons only, no attributes. Faces of fewer than three
/// corners are left out.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, const Positions& positions);

/// A copy, called as the field.
[[nodiscard]] vtkSmartPointer<vtkDoubleArray> toArray(const Field& field);

[[nodiscard]] Positions positionsOf(vtkPolyData& polyData);

/// Throws `InputError` about `file` where a cell begins or ends outside the list of corners, or has fewer corners than
/// its kind needs: VTK would read past its buffers.
void requireSoundCells(vtkPolyData& polyData, const std::string& file);

/// The faces of `polyData`, whose cells are sound: face f is its f-th polygon, and triangles of strips follow. Throws
/// `InputError` about `file` where there is neither, and where a corner is no point.
[[nodiscard]] Polygons polygonsOf(vtkPolyData& polyData, const std::string& file);

}  // namespace holdfast
