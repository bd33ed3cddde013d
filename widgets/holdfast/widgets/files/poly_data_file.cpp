#include "holdfast/widgets/files/poly_data_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCharArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>

#include <holdfast/base/error.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/widgets/files/legacy_check.h>
#include <holdfast/widgets/files/poly_data_bytes.h>
#include <holdfast/widgets/files/poly_data_normals.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/files/vtp_reader.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 2> kExtensions{".vtp", ".vtk"};

/// A file as VTK read it.
struct PolyDataFile {
  std::string extension;
  vtkSmartPointer<vtkPolyData> polyData;
  LegacyHeader header;  ///< of legacy files
  bool isText = false;
  std::set<std::string> lostKeys;
};

std::string bytesOf(vtkPolyData& polyData, const LegacyHeader& header, std::string_view extension)
{
  if (extension == ".vtp") return vtpBytes(polyData);
  if (extension == ".vtk") return legacyBytes(polyData, header);
  throw OutputError(std::string(extension), "this is no format of VTK's for surfaces; use .vtp or .vtk");
}

class PolyDataSource final : public MeshSource {
 public:
  PolyDataSource(PolyDataFile file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  [[nodiscard]] std::string extension() const override { return file_.extension; }

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
    return withPositions(positions, file_.extension);
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
    result.bytes = bytesOf(*moved, file_.header, extension);
    if (file_.polyData->GetPoints()->GetDataType() != VTK_DOUBLE)
      result.notes.emplace_back("coordinates that were in single precision are written as doubles");
    if (file_.isText && extension == ".vtk")
      result.notes.emplace_back("text became VTK's binary form, since its text does not hold doubles");
    for (const std::string& key : file_.lostKeys)
      result.notes.push_back(fmt::format("the information key \"{}\" of an array is left out", key));
    return result;
  }

 private:
  PolyDataFile file_;
  std::string path_;
};

PolyDataFile readXml(const std::string& bytes, const std::string& path)
{
  VtpContents contents = readVtp(bytes, path);
  return {".vtp", contents.polyData, {}, false, contents.lostKeys};
}

PolyDataFile readLegacy(std::string bytes, const std::string& path)
{
  requireSoundLegacyFile(bytes, path);
  VtkErrorLog log;
  vtkNew<vtkPolyDataReader> reader;
  // Without these only the first array of each kind would be read.
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  // As an array, because VTK takes the length of a string as a 32-bit number.
  vtkNew<vtkCharArray> input;
  input->SetArray(bytes.data(), static_cast<vtkIdType>(bytes.size()), 1);
  reader->SetInputArray(input);
  reader->ReadFromInputStringOn();
  log.watch(*reader);
  log.watch(*reader->GetExecutive());
  reader->Update();
  if (!log.isEmpty()) throw InputError({path, 0, ""}, "VTK cannot read it: " + log.first());
  requireSoundCells(*reader->GetOutput(), path);
  PolyDataFile file{".vtk", reader->GetOutput(), {}, reader->GetFileType() == VTK_ASCII, {}};
  file.header = {reader->GetHeader(), reader->GetFileVersion() / 10};
  return file;
}

std::string lowerExtension(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

PolyDataFile readFile(const std::filesystem::path& path)
{
  const std::string extension = lowerExtension(path);
  if (extension == ".vtp") return readXml(readFileBytes(path), path.string());
  if (extension == ".vtk") return readLegacy(readFileBytes(path), path.string());
  throw InputError({path.string(), 0, ""}, "this is no format of VTK's for surfaces; use .vtp or .vtk");
}

}  // namespace

std::span<const std::string_view> polyDataExtensions()
{
  return kExtensions;
}

MeshDocument readPolyData(const std::filesystem::path& path)
{
  PolyDataFile file = readFile(path);
  Mesh mesh{positionsOf(*file.polyData), polygonsOf(*file.polyData, path.string())};
  return {std::move(mesh), std::make_shared<PolyDataSource>(std::move(file), path.string())};
}

Serialized serializePolyData(const MeshDocument& document, const Positions& positions, std::string_view extension)
{
  if (const auto* source = dynamic_cast<const PolyDataSource*>(document.source.get()))
    return source->withPositions(positions, extension);
  Serialized result{bytesOf(*toPolyData(document.mesh, positions), {}, extension), {}, false};
  if (document.source != nullptr)
    result.notes.push_back("only positions and faces of the " + document.source->extension() + " file are kept in " +
                           std::string(extension));
  return result;
}

}  // namespace holdfast
