#pragma once
/// \file
/// Normals that a file stored with its mesh, brought up to date after a deformation.

#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

class vtkPolyData;

namespace holdfast {

/// Makes the stored normals of `polyData`, whose polygons and points are `rest`, right for other positions; its points
/// stay. A normal is left alone where no vertex that it depends on moved, else it becomes the area-weighted normal of
/// the faces around a point, or of the face, on the side on which the stored one was. Returns a note for each array
/// that changed. O(corners).
[[nodiscard]] std::vector<std::string> refreshNormals(vtkPolyData& polyData, const Mesh& rest,
                                                      const Positions& positions);

}  // namespace holdfast
