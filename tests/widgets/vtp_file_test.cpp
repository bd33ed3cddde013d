#include <array>
#include <optional>
#include <string>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkTypeUInt8Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/mesh/poly_data.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"
#include "support/random.h"
#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

using test::isSameBits;
using test::readByVtk;
using test::textOfRest;
using testing::ElementsAre;
using testing::HasSubstr;

MeshDocument read(const std::string& bytes)
{
  return readVtp(bytes, "mesh.vtp");
}

using Way = std::tuple<int, int, int, int>;

/// Files that VTK's writer makes, in each of its ways: format, compressor, byte order, size of headers.
class VtpOfVtk : public testing::TestWithParam<Way> {
 protected:
  static std::string written(vtkPolyData& polyData)
  {
    const auto [format, compressor, order, header] = GetParam();
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(&polyData);
    writer->SetDataMode(format == 3 ? vtkXMLWriter::Appended : format);
    writer->SetEncodeAppendedData(format == 3);
    writer->SetCompressorType(compressor);
    writer->SetByteOrder(order);
    writer->SetHeaderType(header);
    writer->SetBlockSize(64);  // several blocks
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
  }

  static vtkSmartPointer<vtkPolyData> veryRichPolyData()
  {
    auto polyData = test::richPolyData();
    polyData->GetPointData()->GetVectors()->SetComponentName(1, "across");
    vtkNew<vtkTypeUInt8Array> bytes;
    bytes->SetName("bytes");
    for (int k = 0; k < 6; ++k) bytes->InsertNextValue(static_cast<unsigned char>(50 * k));
    polyData->GetPointData()->AddArray(bytes);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("ids");
    ids->SetNumberOfValues(5);
    ids->FillValue(1L << 40);
    polyData->GetCellData()->SetGlobalIds(ids);
    return polyData;
  }

  /// `polyData` as VTK writes it, written again with other positions, and read by VTK.
  static void expectRestKept(vtkPolyData& polyData)
  {
    const std::string file = written(polyData);
    const MeshDocument document = read(file);
    const Positions moved = document.mesh.positions.array() * (1.0 / 3) + 0.1;
    const std::string other = document.source->withPositions(document.mesh, moved).bytes;
    const auto before = readByVtk(file);
    const auto after = readByVtk(other);
    EXPECT_TRUE(isSameBits(positionsOf(*after), moved));
    EXPECT_EQ(textOfRest(*after), textOfRest(*before));
    EXPECT_TRUE(isSameBits(read(other).mesh.positions, moved));
    EXPECT_EQ(document.source->withPositions(document.mesh, document.mesh.positions).bytes, file);
  }
};

INSTANTIATE_TEST_SUITE_P(
    AllWays, VtpOfVtk,
    testing::Combine(testing::Values(vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended, 3),
                     testing::Values(vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA),
                     testing::Values(vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian),
                     testing::Values(vtkXMLWriter::UInt32, vtkXMLWriter::UInt64)));

TEST_P(VtpOfVtk, AreReadAsByVtk)
{
  const std::string file = written(*veryRichPolyData());
  const Mesh mesh = read(file).mesh;
  const auto byVtk = readByVtk(file);
  EXPECT_TRUE(isSameBits(mesh.positions, positionsOf(*byVtk)));
  EXPECT_EQ(mesh.faces, polygonsOf(*byVtk, "rich.vtp"));
}

TEST_P(VtpOfVtk, KeepAllButTheirPoints)
{
  expectRestKept(*veryRichPolyData());
}

TEST_P(VtpOfVtk, KeepAllWherePointsBecomeDoubles)
{
  auto polyData = veryRichPolyData();
  vtkNew<vtkPoints> single;
  single->SetDataTypeToFloat();
  single->DeepCopy(polyData->GetPoints());
  polyData->SetPoints(single);
  ASSERT_EQ(polyData->GetPoints()->GetDataType(), VTK_FLOAT);
  expectRestKept(*polyData);
}

TEST_P(VtpOfVtk, GetNewNormalsWhereTheyMove)
{
  auto polyData = test::richPolyData();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("n");
  normals->SetNumberOfComponents(3);
  for (int k = 0; k < 6; ++k) normals->InsertNextTuple3(0, 0, -1);
  polyData->GetPointData()->SetNormals(normals);
  const MeshDocument document = read(written(*polyData));
  Positions upright = document.mesh.positions;
  upright.col(2).swap(upright.col(1));
  const Serialized result = document.source->withPositions(document.mesh, upright);
  EXPECT_THAT(result.notes, ElementsAre("6 normals of points recomputed"));
  const auto after = readByVtk(result.bytes);
  vtkDataArray& rotated = *after->GetPointData()->GetNormals();
  EXPECT_EQ(rotated.GetDataType(), VTK_FLOAT);
  EXPECT_NEAR(rotated.GetComponent(2, 1), 1, 1e-6);
}

std::string appendedByVtk(vtkPolyData& polyData)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&polyData);
  writer->SetCompressorTypeToNone();
  writer->EncodeAppendedDataOff();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

TEST(VtpFile, DoublesSurviveBitForBit)
{
  const Mesh mesh = test::withAwkwardCoordinates(test::icosphere(1));
  const std::string bytes = serializeMesh({mesh, nullptr}, mesh.positions, ".vtp").bytes;
  const auto byVtk = readByVtk(bytes);
  EXPECT_TRUE(isSameBits(positionsOf(*byVtk), mesh.positions));
  EXPECT_EQ(polygonsOf(*byVtk, "mesh.vtp"), mesh.faces);
  const MeshDocument again = read(bytes);
  EXPECT_TRUE(isSameBits(again.mesh.positions, mesh.positions));
  EXPECT_EQ(again.mesh.faces, mesh.faces);
}

TEST(VtpFile, PiecesAreJoinedAsByVtk)
{
  std::string two = appendedByVtk(*test::richPolyData());
  const std::size_t begin = two.find("<Piece");
  const std::size_t end = two.find("</Piece>") + 8;
  two.insert(end, two.substr(begin, end - begin));
  const MeshDocument document = read(two);
  const auto byVtk = readByVtk(two);
  EXPECT_EQ(document.mesh.vertexCount(), 12);
  EXPECT_TRUE(isSameBits(document.mesh.positions, positionsOf(*byVtk)));
  EXPECT_EQ(document.mesh.faces, polygonsOf(*byVtk, "two.vtp"));
  const Positions moved = document.mesh.positions.rowwise() + Eigen::RowVector3d(0.1, 0.2, 0.3);
  const auto after = readByVtk(document.source->withPositions(document.mesh, moved).bytes);
  EXPECT_TRUE(isSameBits(positionsOf(*after), moved));
  EXPECT_EQ(textOfRest(*after), textOfRest(*byVtk)) << "both pieces name the same data";
}

TEST(LegacyVtkFile, HasPositionsAndFacesBitForBit)
{
  const Mesh mesh = test::withAwkwardCoordinates(test::icosphere(1));
  const test::TemporaryFolder folder;
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(folder.file("mesh.vtk", serializeMesh({mesh, nullptr}, mesh.positions, ".vtk").bytes).c_str());
  reader->Update();
  EXPECT_TRUE(isSameBits(positionsOf(*reader->GetOutput()), mesh.positions));
  EXPECT_EQ(polygonsOf(*reader->GetOutput(), "mesh.vtk"), mesh.faces);
}

TEST(LegacyVtkFile, LeavesArraysBehindWithANote)
{
  const MeshDocument document = read(appendedByVtk(*test::richPolyData()));
  EXPECT_THAT(serializeMesh(document, document.mesh.positions, ".vtk").notes,
              ElementsAre(HasSubstr("changes from .vtp to .vtk: array \"temperature\", array \"label\"")));
}

/// Reading `bytes` gives the mesh that they hold or an `InputError`.
std::optional<Mesh> meshOf(const std::string& bytes)
{
  try {
    return read(bytes).mesh;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Only the end of the XML may be missing without loss.
TEST(DamagedVtpFiles, CutShortNeverGiveAnotherMesh)
{
  const std::string bytes = appendedByVtk(*test::richPolyData());
  const std::optional<Mesh> mesh = meshOf(bytes);
  ASSERT_TRUE(mesh);
  std::size_t refused = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::optional<Mesh> cut = meshOf(bytes.substr(0, length));
    refused += cut ? 0 : 1;
    if (cut) {
      EXPECT_TRUE(isSameBits(cut->positions, mesh->positions) && cut->faces == mesh->faces) << length;
    }
  }
  EXPECT_GT(refused, bytes.size() / 2);
}

/// VTK's own reader crashes on some of these.
TEST(DamagedVtpFiles, WithOtherNumbersAreReadOrRefused)
{
  const std::string bytes = appendedByVtk(*test::richPolyData());
  test::Random random(11);
  std::size_t refused = 0;
  for (int round = 0; round < 500; ++round) {
    std::string damaged = bytes;
    const auto place = damaged.find_first_of("0123456789", random.integer(0, damaged.size() - 1));
    if (place == std::string::npos) continue;
    const std::array<const char*, 6> numbers{"", "-1", "99999999", "4294967296", "9223372036854775807", "1e9"};
    damaged.replace(place, 1, numbers[random.integer(0, 5)]);
    refused += meshOf(damaged) ? 0 : 1;
  }
  EXPECT_GT(refused, 50U);
}

}  // namespace
}  // namespace holdfast
