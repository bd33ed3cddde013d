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

class PolyDataFormat : public testing::Test {
 protected:
  [[nodiscard]] MeshDocument readBack(const std::string& bytes) const
  {
    return readPolyData(folder_.file("mesh.vtp", bytes));
  }

  template <class Reader = vtkXMLPolyDataReader>
  [[nodiscard]] vtkSmartPointer<vtkPolyData> readByVtk(const std::string& bytes) const
  {
    vtkNew<Reader> reader;
    reader->SetFileName(folder_.file("again", bytes).c_str());
    reader->Update();
    return reader->GetOutput();
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(PolyDataFormat, DoublesSurviveBitForBit)
{
  const Mesh mesh = test::withAwkwardCoordinates(test::icosphere(1));
  const MeshDocument first = readBack(serializePolyData({mesh, nullptr}, mesh.positions, ".vtp").bytes);
  EXPECT_TRUE(isSameBits(first.mesh.positions, mesh.positions));
  EXPECT_EQ(first.mesh.faces, mesh.faces);

  const Positions moved = mesh.positions * (1.0 / 3);
  const MeshDocument second = readBack(first.source->withPositions(first.mesh, moved).bytes);
  EXPECT_TRUE(isSameBits(second.mesh.positions, moved));
  EXPECT_EQ(second.mesh.faces, mesh.faces);
}

TEST_F(PolyDataFormat, PolygonsAreTheFacesAndAllElseIsKept)
{
  const auto original = test::richPolyData();
  const MeshDocument document = readBack(vtpBytes(*original));
  ASSERT_EQ(document.mesh.faces.size(), 3);
  EXPECT_THAT(document.mesh.faces[2], ElementsAre(0, 1, 3, 4, 5));
  EXPECT_EQ(document.source->extension(), ".vtp");

  const auto result = readByVtk(document.source->withPositions(document.mesh, document.mesh.positions * 2).bytes);
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

TEST_F(PolyDataFormat, TheSameMeshGivesTheSameBytes)
{
  const MeshDocument document = readBack(vtpBytes(*test::richPolyData()));
  EXPECT_EQ(document.source->withPositions(document.mesh, document.mesh.positions).bytes,
            document.source->withPositions(document.mesh, document.mesh.positions).bytes);
  EXPECT_THAT(document.source->withPositions(document.mesh, document.mesh.positions).notes, IsEmpty());
}

TEST_F(PolyDataFormat, SinglePrecisionIsWrittenAsDoubles)
{
  auto polyData = test::richPolyData();
  vtkNew<vtkPoints> single;
  single->SetDataTypeToFloat();
  single->DeepCopy(polyData->GetPoints());
  polyData->SetPoints(single);
  ASSERT_EQ(polyData->GetPoints()->GetDataType(), VTK_FLOAT);

  const MeshDocument document = readBack(vtpBytes(*polyData));
  const Positions moved = document.mesh.positions.array() + 1.0 / 3;
  const Serialized result = document.source->withPositions(document.mesh, moved);
  EXPECT_TRUE(isSameBits(readBack(result.bytes).mesh.positions, moved));
  EXPECT_THAT(result.notes, ElementsAre(HasSubstr("single precision")));
}

TEST_F(PolyDataFormat, LegacyFilesHaveAllArraysAndEveryBit)
{
  const MeshDocument document = readBack(vtpBytes(*test::richPolyData()));
  const Positions moved = document.mesh.positions * (1.0 / 3);
  const auto legacy = readByVtk<vtkPolyDataReader>(serializePolyData(document, moved, ".vtk").bytes);
  EXPECT_TRUE(isSameBits(positionsOf(*legacy), moved));
  EXPECT_EQ(polygonsOf(*legacy, ""), document.mesh.faces);
  EXPECT_STREQ(legacy->GetPointData()->GetScalars()->GetName(), "temperature");
  EXPECT_EQ(legacy->GetCellData()->GetNumberOfArrays(), 1);
}

TEST(PolyDataFile, OtherFormatsLeaveANote)
{
  struct Obj final : MeshSource {
    [[nodiscard]] std::string extension() const override { return ".obj"; }
    [[nodiscard]] std::vector<std::string> extras() const override { return {}; }
    [[nodiscard]] Serialized withPositions(const Mesh& /*rest*/, const Positions& /*positions*/) const override
    {
      return {};
    }
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
