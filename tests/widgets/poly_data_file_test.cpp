#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/poly_data_bytes.h>
#include <holdfast/widgets/files/poly_data_file.h>
#include <holdfast/widgets/mesh/poly_data.h>

#include "support/meshes.h"
#include "widgets/poly_data_samples.h"

namespace holdfast {
namespace {

using test::isSameBits;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Each promise holds in both formats of VTK.
class PolyDataFormat : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] MeshDocument readBack(const std::string& bytes) const
  {
    return readPolyData(folder_.file("mesh" + GetParam(), bytes));
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> readByVtk(const std::string& bytes) const
  {
    const std::string path = folder_.file("again" + GetParam(), bytes).string();
    if (GetParam() == ".vtp") return readBy<vtkXMLPolyDataReader>(path);
    return readBy<vtkPolyDataReader>(path);
  }

  [[nodiscard]] std::string bytesOf(vtkPolyData& polyData) const
  {
    return GetParam() == ".vtp" ? vtpBytes(polyData) : legacyBytes(polyData, {"a title", 4});
  }

 private:
  template <class Reader>
  static vtkSmartPointer<vtkPolyData> readBy(const std::string& path)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Both, PolyDataFormat, testing::Values(".vtp", ".vtk"),
                         [](const auto& format) { return format.param.substr(1); });

TEST_P(PolyDataFormat, DoublesSurviveBitForBit)
{
  const Mesh mesh = test::withAwkwardCoordinates(test::icosphere(1));
  const MeshDocument first = readBack(serializePolyData({mesh, nullptr}, mesh.positions, GetParam()).bytes);
  EXPECT_TRUE(isSameBits(first.mesh.positions, mesh.positions));
  EXPECT_EQ(first.mesh.faces, mesh.faces);

  const Positions moved = mesh.positions * (1.0 / 3);
  const MeshDocument second = readBack(first.source->withPositions(moved).bytes);
  EXPECT_TRUE(isSameBits(second.mesh.positions, moved));
  EXPECT_EQ(second.mesh.faces, mesh.faces);
}

TEST_P(PolyDataFormat, PolygonsAreTheFacesAndAllElseIsKept)
{
  const auto original = test::richPolyData();
  const MeshDocument document = readBack(bytesOf(*original));
  ASSERT_EQ(document.mesh.faces.size(), 3);
  EXPECT_THAT(document.mesh.faces[2], ElementsAre(0, 1, 3, 4, 5));
  EXPECT_EQ(document.source->extension(), GetParam());

  const auto result = readByVtk(document.source->withPositions(document.mesh.positions * 2).bytes);
  EXPECT_EQ(result->GetNumberOfVerts(), 1);
  EXPECT_EQ(result->GetNumberOfLines(), 1);
  EXPECT_EQ(result->GetNumberOfPolys(), 3);
  EXPECT_EQ(result->GetPoint(3)[0], 4);
  ASSERT_NE(result->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(result->GetPointData()->GetScalars()->GetName(), "temperature");
  EXPECT_EQ(result->GetPointData()->GetScalars()->GetComponent(5, 0), 1.0 / 3 * 6);
  ASSERT_NE(result->GetPointData()->GetArray("label"), nullptr);
  EXPECT_EQ(result->GetPointData()->GetArray("label")->GetDataType(), VTK_INT);
  EXPECT_EQ(result->GetPointData()->GetArray("label")->GetComponent(5, 0), 42);
  ASSERT_NE(result->GetPointData()->GetVectors(), nullptr);
  EXPECT_EQ(result->GetPointData()->GetVectors()->GetComponent(5, 2), 0.7 * 18);
  ASSERT_NE(result->GetCellData()->GetArray("material"), nullptr);
  EXPECT_EQ(result->GetCellData()->GetArray("material")->GetComponent(4, 0), 50);
  auto* author = vtkStringArray::SafeDownCast(result->GetFieldData()->GetAbstractArray("author"));
  ASSERT_NE(author, nullptr);
  EXPECT_EQ(author->GetValue(0), "somebody");
}

TEST_P(PolyDataFormat, TheSameMeshGivesTheSameBytes)
{
  const MeshDocument document = readBack(bytesOf(*test::richPolyData()));
  EXPECT_EQ(document.source->withPositions(document.mesh.positions).bytes,
            document.source->withPositions(document.mesh.positions).bytes);
  EXPECT_THAT(document.source->withPositions(document.mesh.positions).notes, IsEmpty());
}

TEST_P(PolyDataFormat, SinglePrecisionIsWrittenAsDoubles)
{
  auto polyData = test::richPolyData();
  vtkNew<vtkPoints> single;
  single->SetDataTypeToFloat();
  single->DeepCopy(polyData->GetPoints());
  polyData->SetPoints(single);
  ASSERT_EQ(polyData->GetPoints()->GetDataType(), VTK_FLOAT);

  const MeshDocument document = readBack(bytesOf(*polyData));
  const Positions moved = document.mesh.positions.array() + 1.0 / 3;
  const Serialized result = document.source->withPositions(moved);
  EXPECT_TRUE(isSameBits(readBack(result.bytes).mesh.positions, moved));
  EXPECT_THAT(result.notes, ElementsAre(HasSubstr("single precision")));
}

TEST(PolyDataFile, ChangesFormatWithAllItsArrays)
{
  const TemporaryFolder folder;
  const MeshDocument xml = readPolyData(folder.file("rich.VTP", vtpBytes(*test::richPolyData())));
  const std::string legacy = serializePolyData(xml, xml.mesh.positions, ".vtk").bytes;
  EXPECT_THAT(legacy, HasSubstr("temperature"));
  EXPECT_EQ(readPolyData(folder.file("rich.vtk", legacy)).mesh.faces, xml.mesh.faces);
}

TEST(PolyDataFile, LegacyKeepsItsTitleAndItsAge)
{
  const TemporaryFolder folder;
  const MeshDocument document = readPolyData(folder.file("square.vtk", test::squareAsLegacyText()));
  const Serialized result = document.source->withPositions(document.mesh.positions);
  EXPECT_THAT(result.bytes, HasSubstr("Version 4.2\na square\nBINARY"));
  EXPECT_THAT(result.notes, ElementsAre(HasSubstr("binary")));
}

TEST(PolyDataFile, OtherFormatsLeaveANote)
{
  struct Obj final : MeshSource {
    [[nodiscard]] std::string extension() const override { return ".obj"; }
    [[nodiscard]] std::vector<std::string> extras() const override { return {}; }
    [[nodiscard]] Serialized withPositions(const Positions& /*positions*/) const override { return {}; }
  };
  const MeshDocument document{test::tetrahedron(), std::make_shared<Obj>()};
  EXPECT_THAT(serializePolyData(document, document.mesh.positions, ".vtp").notes, ElementsAre(HasSubstr(".obj")));
}

TEST(PolyDataFile, UnknownExtensionIsRefusedForWriting)
{
  const MeshDocument document{test::tetrahedron(), nullptr};
  EXPECT_THROW((void)serializePolyData(document, document.mesh.positions, ".vtu"), OutputError);
}

}  // namespace
}  // namespace holdfast
