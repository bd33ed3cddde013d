#include "holdfast/widgets/files/poly_data_file.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLWriter.h>

#include <holdfast/base/error.h>
#include <holdfast/base/same_bits.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/files/vtp_reader.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

template <class Writer>
void write(Writer& writer, vtkPolyData& polyData, const char* extension)
{
  VtkErrorLog log;
  log.watch(writer);
  log.watch(*writer.GetExecutive());
  writer.SetInputData(&polyData);
  writer.WriteToOutputStringOn();
  if (writer.Write() != 0 && log.isEmpty()) return;
  throw OutputError(extension,
                    "VTK cannot write this mesh" + (log.isEmpty() ? " and gives no reason" : ": " + log.first()));
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

std::string bytesOf(vtkPolyData& polyData, std::string_view extension, std::string_view compressor = "")
{
  if (extension == ".vtp") return vtpBytes(polyData, compressor);
  if (extension == ".vtk") return legacyBytes(polyData);
  throw OutputError(std::string(extension), "this is no format of VTK's for surfaces; use .vtp or .vtk");
}

bool areSame(const Positions& a, const Positions& b)
{
  return std::equal(a.data(), a.data() + a.size(), b.data(), b.data() + b.size(), hasSameBits);
}

class PolyDataSource final : public MeshSource {
 public:
  PolyDataSource(VtpContents file, std::string bytes) : file_(std::move(file)), bytes_(std::move(bytes)) {}

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

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions) const override
  {
    return withPositions(rest, positions, ".vtp");
  }

  [[nodiscard]] Serialized withPositions(const Mesh& rest, const Positions& positions, std::string_view extension) const
  {
    assert(positions.rows() == rest.vertexCount());
    if (extension == ".vtp" && areSame(positions, rest.positions)) return {bytes_, {}};
    vtkNew<vtkPolyData> moved;
    // Not a shallow copy: VTK writes notes of its own into arrays, and this document is const.
    moved->DeepCopy(file_.polyData);
    Serialized result{"", refreshNormals(*moved, rest, positions)};
    moved->SetPoints(toPoints(positions));
    result.bytes = bytesOf(*moved, extension, file_.compressor);
    if (file_.polyData->GetPoints()->GetDataType() != VTK_DOUBLE)
      result.notes.emplace_back("coordinates that were in single precision are written as doubles");
    for (const std::string& name : file_.newNames)
      result.notes.push_back(
          fmt::format("an array without a name, or with that of another one, is written as \"{}\"", name));
    for (const std::string& key : file_.lostKeys)
      result.notes.push_back(fmt::format("the information key \"{}\" of an array is left out", key));
    return result;
  }

 private:
  VtpContents file_;
  std::string bytes_;  // the whole file
};

void addFields(vtkDataSetAttributes& attributes, std::span<const Field> fields, [[maybe_unused]] Index count)
{
  for (const Field& field : fields) {
    assert(static_cast<Index>(field.values.size()) == field.components * count);
    attributes.AddArray(toArray(field));
  }
}

/// What normals, of faces or of points, are normal to before and after a deformation, and whether they are out of date.
struct NormalSides {
  NormalSides(Index count) : rest(Positions::Zero(count, 3)), moved(rest), isOutdated(count, 0) {}

  Positions rest;
  Positions moved;
  std::vector<char> isOutdated;
};

NormalSides sidesOfFaces(const Mesh& rest, const Positions& positions)
{
  NormalSides sides(rest.faces.size());
  for (Index f = 0; f < rest.faces.size(); ++f) {
    const auto corners = rest.faces[f];
    sides.rest.row(f) = areaVector(rest.positions, corners);
    sides.moved.row(f) = areaVector(positions, corners);
    sides.isOutdated[f] =
        std::ranges::any_of(corners, [&](Index v) { return positions.row(v) != rest.positions.row(v); });
  }
  return sides;
}

NormalSides sidesOfPoints(const Mesh& rest, const NormalSides& faces)
{
  NormalSides sides(rest.vertexCount());
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (const Index v : rest.faces[f]) {
      sides.rest.row(v) += faces.rest.row(f);
      sides.moved.row(v) += faces.moved.row(f);
      if (faces.isOutdated[f] != 0) sides.isOutdated[v] = 1;
    }
  return sides;
}

/// The array that holds normals: the one that the file declares as such, or the one that is called so.
vtkDataArray* storedNormals(vtkDataSetAttributes& attributes)
{
  vtkDataArray* normals = attributes.GetNormals();
  if (normals == nullptr) normals = attributes.GetArray("Normals");
  return normals != nullptr && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
}

/// The `total` normals from tuple `first` on, in a copy: the original belongs to the file as it was read. Returns how
/// many changed.
std::ptrdiff_t refresh(vtkDataSetAttributes& attributes, const NormalSides& sides, vtkIdType first, Index total)
{
  const std::ptrdiff_t count = std::count(sides.isOutdated.begin(), sides.isOutdated.begin() + total, 1);
  if (count == 0) return 0;
  vtkDataArray& normals = *storedNormals(attributes);
  const auto result = vtkSmartPointer<vtkDataArray>::Take(normals.NewInstance());
  result->DeepCopy(&normals);
  for (Index k = 0; k < total; ++k) {
    if (sides.isOutdated[k] == 0) continue;
    Vector3 stored;
    result->GetTuple(first + k, stored.data());
    const double side = stored.dot(sides.rest.row(k)) < 0 ? -1 : 1;
    const Vector3 normal = side * sides.moved.row(k).normalized().transpose();
    result->SetTuple(first + k, normal.data());
  }
  result->Modified();
  attributes.AddArray(result);
  return count;
}

}  // namespace

MeshDocument readPolyData(const std::filesystem::path& path)
{
  std::string bytes = readFileBytes(path);
  VtpContents file = readVtp(bytes, path.string());
  Mesh mesh{positionsOf(*file.polyData), polygonsOf(*file.polyData, path.string())};
  return {std::move(mesh), std::make_shared<PolyDataSource>(std::move(file), std::move(bytes))};
}

Serialized serializePolyData(const MeshDocument& document, const Positions& positions, std::string_view extension)
{
  if (const auto* source = dynamic_cast<const PolyDataSource*>(document.source.get()))
    return source->withPositions(document.mesh, positions, extension);
  Serialized result{bytesOf(*toPolyData(document.mesh, positions), extension), {}};
  if (document.source != nullptr)
    result.notes.push_back(
        fmt::format("only positions and faces of the {} file are kept in {}", document.source->extension(), extension));
  return result;
}

std::string vtpBytes(vtkPolyData& polyData, std::string_view compressor)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorType(compressor == "vtkZLibDataCompressor"   ? vtkXMLWriter::ZLIB
                            : compressor == "vtkLZ4DataCompressor"  ? vtkXMLWriter::LZ4
                            : compressor == "vtkLZMADataCompressor" ? vtkXMLWriter::LZMA
                                                                    : vtkXMLWriter::NONE);
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
  vtkDataSetAttributes* const ofPoints = polyData.GetPointData();
  vtkDataSetAttributes* const ofCells = polyData.GetCellData();
  if (storedNormals(*ofPoints) == nullptr && storedNormals(*ofCells) == nullptr) return {};
  std::vector<std::string> notes;
  const auto note = [&](std::ptrdiff_t count, const char* where) {
    if (count > 0) notes.push_back(fmt::format("{} normals of {} recomputed", count, where));
  };
  const NormalSides faces = sidesOfFaces(rest, positions);
  if (storedNormals(*ofPoints) != nullptr)
    note(refresh(*ofPoints, sidesOfPoints(rest, faces), 0, rest.vertexCount()), "points");
  // In VTK the cells of a surface are numbered through: vertices, lines, polygons.
  const vtkIdType firstPolygon = polyData.GetNumberOfVerts() + polyData.GetNumberOfLines();
  // A strip has one normal for all its triangles, which says little: it stays.
  if (storedNormals(*ofCells) != nullptr)
    note(refresh(*ofCells, faces, firstPolygon, polyData.GetNumberOfPolys()), "faces");
  return notes;
}

}  // namespace holdfast
