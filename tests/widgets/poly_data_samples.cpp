#include "widgets/poly_data_samples.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <holdfast/widgets/mesh/poly_data.h>

#include "support/random.h"

namespace holdfast::test {
namespace {

template <class Array>
vtkSmartPointer<Array> numbered(const char* name, int components, vtkIdType count, double step)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count * components; ++i)
    array->SetComponent(i / components, static_cast<int>(i % components), step * static_cast<double>(i + 1));
  return array;
}

vtkSmartPointer<vtkCellArray> oneCell(std::initializer_list<vtkIdType> ids)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell(ids);
  return cells;
}

}  // namespace

Mesh withAwkwardCoordinates(Mesh mesh)
{
  Random random(7);
  for (double& coordinate : mesh.positions.reshaped()) coordinate += random.uniform(-0.1, 0.1) / 3;
  mesh.positions(0, 0) = -0.0;
  mesh.positions(1, 0) = std::numeric_limits<double>::denorm_min();
  mesh.positions(2, 0) = std::numeric_limits<double>::max();
  return mesh;
}

bool isSameBits(const Positions& a, const Positions& b)
{
  const auto isSame = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(a.data(), a.data() + a.size(), b.data(), b.data() + b.size(), isSame);
}

vtkSmartPointer<vtkPolyData> richPolyData()
{
  Mesh mesh{Positions(6, 3), {}};
  mesh.positions << 0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0.1, 0, 1, 0;
  mesh.faces.add({0, 1, 4, 5});
  mesh.faces.add({1, 2, 3});
  mesh.faces.add({0, 1, 3, 4, 5});
  auto polyData = toPolyData(mesh, mesh.positions);
  polyData->SetVerts(oneCell({5}));
  polyData->SetLines(oneCell({0, 3}));
  polyData->GetPointData()->SetScalars(numbered<vtkDoubleArray>("temperature", 1, 6, 1.0 / 3));
  polyData->GetPointData()->AddArray(numbered<vtkIntArray>("label", 1, 6, 7));
  polyData->GetPointData()->SetVectors(numbered<vtkDoubleArray>("velocity", 3, 6, 0.7));
  polyData->GetCellData()->AddArray(numbered<vtkIntArray>("material", 1, 5, 10));
  vtkNew<vtkStringArray> author;
  author->SetName("author");
  author->InsertNextValue("somebody");
  polyData->GetFieldData()->AddArray(author);
  return polyData;
}

}  // namespace holdfast::test
