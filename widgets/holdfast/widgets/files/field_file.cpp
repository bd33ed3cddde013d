#include "holdfast/widgets/files/field_file.h"

#include <cassert>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/files/poly_data_bytes.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

void addFields(vtkDataSetAttributes& attributes, std::span<const Field> fields, [[maybe_unused]] Index count)
{
  for (const Field& field : fields) {
    assert(static_cast<Index>(field.values.size()) == field.components * count);
    attributes.AddArray(toArray(field));
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
