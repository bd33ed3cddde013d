#include "widgets/poly_data_samples.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <sstream>

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

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

std::string textOf(vtkAbstractArray* array)
{
  if (array == nullptr) return "none";
  std::ostringstream text;
  text << (array->GetName() == nullptr ? "" : array->GetName()) << ' ' << array->GetClassName() << ' '
       << array->GetNumberOfComponents();
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    text << ' ' << (array->GetComponentName(c) == nullptr ? "-" : array->GetComponentName(c));
  text.precision(17);
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k) text << ' ' << array->GetVariantValue(k).ToString();
  return text.str() + "\n";
}

std::string textOf(vtkFieldData& fields)
{
  std::string text;
  for (int k = 0; k < fields.GetNumberOfArrays(); ++k) text += textOf(fields.GetAbstractArray(k));
  if (auto* attributes = vtkDataSetAttributes::SafeDownCast(&fields))
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
      text += textOf(attributes->GetAbstractAttribute(type));
  return text;
}

std::string textOf(vtkCellArray& cells)
{
  std::string text;
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells.GetCellAtId(cell, count, ids);
    for (vtkIdType k = 0; k < count; ++k) text += std::to_string(ids[k]) + " ";
    text += "\n";
  }
  return text;
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

std::string textOfRest(vtkPolyData& polyData)
{
  return textOf(*polyData.GetVerts()) + textOf(*polyData.GetLines()) + textOf(*polyData.GetStrips()) +
         textOf(*polyData.GetPolys()) + textOf(*polyData.GetPointData()) + textOf(*polyData.GetCellData()) +
         textOf(*polyData.GetFieldData());
}

vtkSmartPointer<vtkPolyData> readByVtk(const std::string& bytes)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  return reader->GetOutput();
}

}  // namespace holdfast::test
