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
  const Positions moved = 2 * document.mesh.positions;
  EXPECT_EQ(document.source->withPositions(document.mesh, moved).bytes,
            document.source->withPositions(document.mesh, moved).bytes);
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

/// A box of eight points in single precision; `surface` are its cells, `more` other elements of the piece.
std::string boxText(const std::string& counts, const std::string& surface, const std::string& more = "",
                    const std::string& before = "")
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n" + before +
         "<PolyData><Piece NumberOfPoints=\"8\" " + counts + ">\n" + more +
         "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 4.0 0 0 4 3 0 0 3 0 "
         "0 0 2 4 0 2 4 3 2 0 3 2.0</DataArray></Points>\n" +
         surface + "</Piece></PolyData>\n</VTKFile>\n";
}

std::string cellsText(const std::string& kind, const std::string& corners, const std::string& ends)
{
  return "<" + kind + "><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">" + corners +
         "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + ends + "</DataArray></" + kind +
         ">\n";
}

std::string boxWith(const std::string& more, const std::string& before = "")
{
  return boxText("NumberOfPolys=\"2\"", cellsText("Polys", "0 3 2 1 4 5 6 7", "4 8"), more, before);
}

std::string dataArray(const std::string& attributes, const std::string& values)
{
  return "<DataArray " + attributes + " format=\"ascii\">" + values + "</DataArray>\n";
}

TEST_F(PolyDataFormat, WhatDoesNotMoveIsTheFileItself)
{
  const std::string eight = "1 0 1 0 1 0 1 0";
  for (const std::string& bytes :
       {boxWith(""), boxWith("", "<!-- <AppendedData> none -->\n"),
        boxWith("<!-- <AppendedData encoding=\"raw\"> _ -->"),
        boxWith("<PointData>" + dataArray("type=\"Bit\" Name=\"sel\"", eight) + "</PointData>"),
        boxWith("<PointData>" + dataArray("type=\"Int8\" Name=\"T\"", eight) +
                dataArray("type=\"Float32\" Name=\"T\"", eight) + "</PointData>"),
        boxWith("<PointData>" + dataArray("type=\"Float32\"", eight) + "</PointData>"),
        boxText("NumberOfStrips=\"1\"", cellsText("Strips", "0 1 3 2 7 6 4 5", "8")),
        vtpBytes(*test::richPolyData(), "vtkLZ4DataCompressor")}) {
    SCOPED_TRACE(bytes.substr(0, 300));
    const MeshDocument document = readBack(bytes);
    const Serialized same = document.source->withPositions(document.mesh, document.mesh.positions);
    EXPECT_EQ(same.bytes, bytes);
    EXPECT_THAT(same.notes, IsEmpty());
  }
}

TEST_F(PolyDataFormat, TrianglesOfStripsAreFacesOfOneSideAfterThePolygons)
{
  const MeshDocument strips =
      readBack(boxText("NumberOfStrips=\"2\"", cellsText("Strips", "0 1 3 2 2 6 0 4 1", "6 9")));
  ASSERT_EQ(strips.mesh.faces.size(), 3);
  EXPECT_THAT(strips.mesh.faces[0], ElementsAre(0, 1, 3));
  EXPECT_THAT(strips.mesh.faces[1], ElementsAre(1, 2, 3));
  EXPECT_THAT(strips.mesh.faces[2], ElementsAre(0, 4, 1)) << "triangles that name a point twice are none";
  const MeshDocument both = readBack(boxText("NumberOfPolys=\"1\" NumberOfStrips=\"1\"",
                                             cellsText("Strips", "4 5 7", "3") + cellsText("Polys", "0 3 2 1", "4")));
  ASSERT_EQ(both.mesh.faces.size(), 2);
  EXPECT_THAT(both.mesh.faces[0], ElementsAre(0, 3, 2, 1));
  const Positions moved = 2 * both.mesh.positions;
  EXPECT_EQ(readBack(both.source->withPositions(both.mesh, moved).bytes).mesh.faces, both.mesh.faces);
}

TEST_F(PolyDataFormat, CompressionStaysWhereSomethingMoves)
{
  for (const char* const compressor : {"vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor"}) {
    const MeshDocument document = readBack(vtpBytes(*test::richPolyData(), compressor));
    const Positions moved = 2 * document.mesh.positions;
    const std::string bytes = document.source->withPositions(document.mesh, moved).bytes;
    EXPECT_THAT(bytes, HasSubstr("compressor=\"" + std::string(compressor) + "\""));
    EXPECT_TRUE(isSameBits(readBack(bytes).mesh.positions, moved));
  }
}

TEST_F(PolyDataFormat, ArraysWithoutANameOfTheirOwnGetOne)
{
  const std::string eight = "1 0 1 0 1 0 1 0";
  const MeshDocument document = readBack(boxWith(
      "<PointData>" + dataArray("type=\"Int8\" Name=\"T\"", eight) + dataArray("type=\"Bit\" Name=\"T\"", eight) +
      dataArray("type=\"Int8\"", "1 2 3 4 5 6 7 8") + dataArray("type=\"Int8\"", eight) + "</PointData>"));
  const Serialized result = document.source->withPositions(document.mesh, 2 * document.mesh.positions);
  EXPECT_THAT(result.notes,
              testing::IsSupersetOf({HasSubstr("\"T 2\""), HasSubstr("\"unnamed\""), HasSubstr("\"unnamed 2\"")}));
  const auto back = readByVtk(result.bytes);
  ASSERT_NE(back->GetPointData()->GetArray("T 2"), nullptr);
  EXPECT_EQ(back->GetPointData()->GetArray("T 2")->GetDataType(), VTK_BIT);
  EXPECT_EQ(back->GetPointData()->GetArray("T 2")->GetComponent(6, 0), 1);
  ASSERT_NE(back->GetPointData()->GetArray("unnamed"), nullptr);
  EXPECT_EQ(back->GetPointData()->GetArray("unnamed")->GetComponent(7, 0), 8);
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
