#include "holdfast/widgets/files/field_file.h"

#include <algorithm>
#include <cassert>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/files/poly_data_file.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

void addFields(vtkDataSetAttributes& attributes, std::span<const Field> fields, [[maybe_unused]] Index count)
{
  for (const Field& field : fields) {
    assert(static_cast<Index>(field.values.size()) == field.components * count);
    vtkNew<vtkDoubleArray> array;
    array->SetName(field.name.c_str());
    array->SetNumberOfComponents(static_cast<int>(field.components));
    array->SetNumberOfValues(static_cast<vtkIdType>(field.values.size()));
    std::copy(field.values.begin(), field.values.end(), array->GetPointer(0));
    attributes.AddArray(array);
  }
}

}  // namespace

Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                       std::span<const Field> faceFields)
{
  const auto polyData = toPolyData(mesh, positions);
  addFields(*polyData->GetPointData(), pointFields, mesh.vertexCount());
  addFields(*polyData->GetCellData(), faceFields, mesh.faces.size());
  return {vtpBytes(*polyData), {}};
}

}  // namespace holdfast
