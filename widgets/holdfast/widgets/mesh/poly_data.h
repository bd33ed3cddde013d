#pragma once
/// These functions turn Holdfast's meshes into VTK's and VTK's into Holdfast's.

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

/// Copies `positions` into points of doubles.
[[nodiscard]] vtkSmartPointer<vtkPoints> toPoints(const Positions& positions);

/// Replaces all that `data` holds by points that are drawn.
void setPoints(vtkPolyData& data, const std::vector<Vector3>& places);
/// Replaces all that `data` holds by lines through points of their own.
void setLines(vtkPolyData& data, const std::vector<std::vector<Vector3>>& lines);
/// Replaces all that `data` holds by polygons through points of their own.
void setPolygons(vtkPolyData& data, const std::vector<std::vector<Vector3>>& polygons);

/// Copies polygons into cells.
[[nodiscard]] vtkSmartPointer<vtkCellArray> toCells(const Polygons& polygons);

/// Makes cells of the triangles k among `triangles` for which `isIn(k)` holds. `isIn` is called twice for each.
template <typename Predicate>
[[nodiscard]] vtkSmartPointer<vtkCellArray> toCells(const Polygons& triangles, const Predicate& isIn)
{
  vtkTypeInt32 count = 0;
  for (Index k = 0; k < triangles.size(); ++k) count += isIn(k) ? 1 : 0;
  // Fresh memory takes longer than what is written into it, and OpenGL has no longer numbers.
  vtkNew<vtkTypeInt32Array> starts;
  vtkNew<vtkTypeInt32Array> corners;
  starts->SetNumberOfValues(vtkIdType{count} + 1);
  corners->SetNumberOfValues(vtkIdType{3} * count);
  for (vtkTypeInt32 k = 0; k <= count; ++k) starts->SetValue(k, 3 * k);
  vtkTypeInt32* next = corners->GetPointer(0);
  for (Index k = 0; k < triangles.size(); ++k)
    if (isIn(k)) next = std::ranges::copy(triangles[k], next).out;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(starts, corners);
  return cells;
}

/// Makes polygons of the faces of `mesh` at `positions` (vertexCount x 3), without attributes. Faces of fewer than
/// three corners are left out.
///
///     const vtkSmartPointer<vtkPolyData> surface = toPolyData(model.mesh, result.positions);
///     surface->GetPointData()->AddArray(toArray(fieldOf(model, result, FieldKind::Displacement)));
///     mapper->SetInputData(surface);
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, const Positions& positions);

/// Copies a field into an array of the same name.
[[nodiscard]] vtkSmartPointer<vtkDoubleArray> toArray(const Field& field);

/// Copies the points of `polyData` into positions, one row for each.
[[nodiscard]] Positions positionsOf(vtkPolyData& polyData);

/// Checks the cells of `polyData`, because VTK would read past its buffers where they are wrong. Throws `InputError`
/// about `file` where a cell begins or ends outside the list of corners. It does the same where a cell has fewer
/// corners than its kind needs.
void requireSoundCells(vtkPolyData& polyData, const std::string& file);

/// Returns the faces of `polyData`, whose cells are sound (`requireSoundCells`). Face f is its f-th polygon. Triangles
/// of strips follow. Throws `InputError` about `file` where there is neither, and where a corner is no point.
[[nodiscard]] Polygons polygonsOf(vtkPolyData& polyData, const std::string& file);

}  // namespace holdfast
