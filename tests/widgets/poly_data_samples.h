#pragma once
/// \file
/// Files of VTK's formats for tests.

#include <string>

#include <vtkSmartPointer.h>

#include <holdfast/mesh/mesh.h>

#include "support/temporary_folder.h"

class vtkPolyData;

namespace holdfast::test {

/// `mesh` with coordinates that only all 17 digits tell apart, and the odd ones: -0, subnormal, huge.
[[nodiscard]] Mesh withAwkwardCoordinates(Mesh mesh);

/// True where every bit of both is the same, so that -0 is not 0.
[[nodiscard]] bool isSameBits(const Positions& a, const Positions& b);

/// A surface with everything that a file of VTK's may hold besides: a vertex and a line cell, polygons of 3, 4 and 5
/// corners, two scalar arrays and a vector array of the points, ids of the cells, a string of the whole.
[[nodiscard]] vtkSmartPointer<vtkPolyData> richPolyData();

/// All arrays and cells of a surface as text, its points aside. What differs in a value, a type or a name differs here.
[[nodiscard]] std::string textOfRest(vtkPolyData& polyData);

/// The surface in the bytes of a .vtp file as VTK's own reader sees it.
[[nodiscard]] vtkSmartPointer<vtkPolyData> readByVtk(const std::string& bytes);

}  // namespace holdfast::test
