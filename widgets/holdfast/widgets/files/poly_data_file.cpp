#include "holdfast/widgets/files/poly_data_file.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/base/error.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/files/vtp_reader.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

/// Runs a writer of VTK, which writes into a string of its own.
template <class Writer>
void write(Writer& writer, vtkPolyData& polyData, const char* extension)
{
  VtkErrorLog log;
  log.watch(writer);
  log.watch(*writer.GetExecutive());
  writer.SetInputData(&polyData);
  writer.WriteToOutputStringOn();
  const bool isWritten = writer.Write() != 0;
  if (!log.isEmpty()) throw OutputError(extension, "VTK cannot write this mesh: " + log.first());
  if (!isWritten) throw OutputError(extension, "VTK cannot write this mesh and gives no reason");
}

/// In binary form: VTK writes text with 11 digits, and a double needs 17.
std::string legacyBytes(vtkPolyData& polyData)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetHeader("");
  write(*writer, polyData, ".vtk");
  return writer->GetOutputStdString();
}

std::string bytesOf(vtkPolyData& polyData, std::string_view extension)
{
  if (extension == ".vtp") return vtpBytes(polyData);
  if (extension == ".vtk") return legacyBytes(polyData);
  throw OutputError(std::string(extension), "this is no format of VTK's for surfaces; use .vtp or .vtk");
}

class PolyDataSource final : public MeshSource {
 public:
  PolyDataSource(VtpContents file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  [[nodiscard]] std::string extension() const override { return ".vtp"; }

  [[nodiscard]] std::vector<std::string> extras() const override
  {
    std::vector<std::string> names;
    for (vtkFieldData* const arrays :
         {static_cast<vtkFieldData*>(file_.polyData->GetPointData()),
          static_cast<vtkFieldData*>(file_.polyData->GetCellData()), file_.polyData->GetFieldData()})
      for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
        names.push_back(fmt::format("array \"{}\"", arrays->GetArrayName(k)));
    return names;
  }

  [[nodiscard]] Serialized withPositions(const Positions& positions) const override
  {
    return withPositions(positions, ".vtp");
  }

  [[nodiscard]] Serialized withPositions(const Positions& positions, std::string_view extension) const
  {
    const Mesh rest{positionsOf(*file_.polyData), polygonsOf(*file_.polyData, path_)};
    assert(positions.rows() == rest.vertexCount());
    vtkNew<vtkPolyData> moved;
    // Not a shallow copy: VTK writes notes of its own into arrays, and this document is const.
    moved->DeepCopy(file_.polyData);
    Serialized result{"", refreshNormals(*moved, rest, positions), false};
    moved->SetPoints(toPoints(positions));
    result.bytes = bytesOf(*moved, extension);
    if (file_.polyData->GetPoints()->GetDataType() != VTK_DOUBLE)
      result.notes.emplace_back("coordinates that were in single precision are written as doubles");
    for (const std::string& key : file_.lostKeys)
      result.notes.push_back(fmt::format("the information key \"{}\" of an array is left out", key));
    return result;
  }

 private:
  VtpContents file_;
  std::string path_;
};

void addFields(vtkDataSetAttributes& attributes, std::span<const Field> fields, [[maybe_unused]] Index count)
{
  for (const Field& field : fields) {
    assert(static_cast<Index>(field.values.size()) == field.components * count);
    attributes.AddArray(toArray(field));
  }
}

/// A stored normal that is out of date, by its tuple, with the vectors that it is normal to before and after.
struct Outdated {
  vtkIdType tuple = 0;
  Vector3 rest;
  Vector3 moved;
};

std::vector<Index> movedFaces(const Mesh& rest, const Positions& positions)
{
  std::vector<Index> faces;
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f])
      if (positions.row(v) != rest.positions.row(v)) {
        faces.push_back(f);
        break;
      }
  return faces;
}

/// In VTK the cells of a surface are numbered through: vertices, lines, polygons.
std::vector<Outdated> outdatedFaces(const vtkIdType firstPolygon, const Mesh& rest, const Positions& positions)
{
  std::vector<Outdated> outdated;
  for (const Index f : movedFaces(rest, positions))
    outdated.push_back(
        {firstPolygon + f, areaVector(rest.positions, rest.faces[f]), areaVector(positions, rest.faces[f])});
  return outdated;
}

std::vector<Outdated> outdatedPoints(const Mesh& rest, const Positions& positions)
{
  std::vector<char> isOutdated(rest.vertexCount(), 0);
  for (const Index f : movedFaces(rest, positions))
    for (const Index v : rest.faces[f]) isOutdated[v] = 1;

  Positions before = Positions::Zero(rest.vertexCount(), 3);
  Positions after = Positions::Zero(rest.vertexCount(), 3);
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f])
      if (isOutdated[v]) {
        before.row(v) += areaVector(rest.positions, rest.faces[f]);
        after.row(v) += areaVector(positions, rest.faces[f]);
      }

  std::vector<Outdated> outdated;
  for (Index v = 0; v < rest.vertexCount(); ++v)
    if (isOutdated[v]) outdated.push_back({v, before.row(v), after.row(v)});
  return outdated;
}

/// The array that holds normals: the one that the file declares as such, or the one that is called so.
vtkDataArray* storedNormals(vtkDataSetAttributes& attributes)
{
  vtkDataArray* normals = attributes.GetNormals();
  if (normals == nullptr) normals = attributes.GetArray("Normals");
  return normals != nullptr && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
}

/// A copy of `normals` with those that are outdated made anew; the original belongs to the file as it was read.
vtkSmartPointer<vtkDataArray> refreshed(vtkDataArray& normals, const std::vector<Outdated>& outdated)
{
  auto result = vtkSmartPointer<vtkDataArray>::Take(normals.NewInstance());
  result->DeepCopy(&normals);
  for (const Outdated& entry : outdated) {
    Vector3 stored;
    result->GetTuple(entry.tuple, stored.data());
    const double side = stored.dot(entry.rest) < 0 ? -1 : 1;
    const Vector3 normal = side * entry.moved.normalized();
    result->SetTuple(entry.tuple, normal.data());
  }
  result->Modified();
  return result;
}

}  // namespace

MeshDocument readPolyData(const std::filesystem::path& path)
{
  VtpContents file = readVtp(readFileBytes(path), path.string());
  Mesh mesh{positionsOf(*file.polyData), polygonsOf(*file.polyData, path.string())};
  return {std::move(mesh), std::make_shared<PolyDataSource>(std::move(file), path.string())};
}

Serialized serializePolyData(const MeshDocument& document, const Positions& positions, std::string_view extension)
{
  if (const auto* source = dynamic_cast<const PolyDataSource*>(document.source.get()))
    return source->withPositions(positions, extension);
  Serialized result{bytesOf(*toPolyData(document.mesh, positions), extension), {}, false};
  if (document.source != nullptr)
    result.notes.push_back(
        fmt::format("only positions and faces of the {} file are kept in {}", document.source->extension(), extension));
  return result;
}

std::string vtpBytes(vtkPolyData& polyData)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  write(*writer, polyData, ".vtp");
  return writer->GetOutputString();
}

Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                       std::span<const Field> faceFields)
{
  const auto polyData = toPolyData(mesh, positions);
  addFields(*polyData->GetPointData(), pointFields, mesh.vertexCount());
  addFields(*polyData->GetCellData(), faceFields, mesh.faces.size());
  return {vtpBytes(*polyData), {}};
}

std::vector<std::string> refreshNormals(vtkPolyData& polyData, const Mesh& rest, const Positions& positions)
{
  std::vector<std::string> notes;
  const auto refresh = [&](vtkDataSetAttributes& attributes, const std::vector<Outdated>& outdated, const char* where) {
    vtkDataArray* normals = storedNormals(attributes);
    if (normals == nullptr || outdated.empty()) return;
    attributes.AddArray(refreshed(*normals, outdated));
    notes.push_back(std::to_string(outdated.size()) + " normals of " + where + " recomputed");
  };
  if (storedNormals(*polyData.GetPointData()) != nullptr)
    refresh(*polyData.GetPointData(), outdatedPoints(rest, positions), "points");
  const vtkIdType firstPolygon = polyData.GetNumberOfVerts() + polyData.GetNumberOfLines();
  if (storedNormals(*polyData.GetCellData()) != nullptr)
    refresh(*polyData.GetCellData(), outdatedFaces(firstPolygon, rest, positions), "faces");
  return notes;
}

}  // namespace holdfast
