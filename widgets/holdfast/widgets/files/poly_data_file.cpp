#include "holdfast/widgets/files/poly_data_file.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/base/error.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/widgets/files/poly_data_normals.h>
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

}  // namespace holdfast
