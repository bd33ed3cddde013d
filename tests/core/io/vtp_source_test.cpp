#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/io/text/base64.h>

#include "core/io/vtp_files.h"

namespace holdfast {
namespace {

using test::replaced;
using test::vtpWord;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The file `bytes` written with its points lifted by `height`.
Serialized lifted(const std::string& bytes, double height = 0.5)
{
  const MeshDocument document = readVtp(bytes, "f.vtp");
  Positions positions = document.mesh.positions;
  positions.col(2).array() += height;
  Serialized result = document.source->withPositions(document.mesh, positions);
  const MeshDocument again = readVtp(result.bytes, "again.vtp");
  EXPECT_EQ(again.mesh.positions, positions);
  EXPECT_EQ(again.mesh.faces, document.mesh.faces);
  EXPECT_EQ(document.source->withPositions(document.mesh, document.mesh.positions).bytes, bytes);
  return result;
}

std::string doubles(std::initializer_list<double> values)
{
  std::string bytes;
  for (const double value : values) bytes += toBytes(value, std::endian::little);
  return bytes;
}

/// A triangle whose points are the block at `offset` of appended data.
std::string withAppendedPoints(std::size_t offset, const std::string& more = "")
{
  return replaced(test::vtpTriangle(more), "format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points>",
                  "format=\"appended\" offset=\"" + std::to_string(offset) + "\"/></Points>");
}

const std::string kFlat = doubles({0, 0, 0, 1, 0, 0, 0, 1, 0});
const std::string kLifted = doubles({0, 0, 0.5, 1, 0, 0.5, 0, 1, 0.5});

TEST(VtpSource, ReplacesTheNumbersOfPointsAndKeepsAllOtherBytes)
{
  const std::string file = test::vtpTriangle(test::vtpPointData(R"(type="Int8" Name="a")", "1 2 3") + "<!-- kept -->");
  const Serialized result = lifted(file);
  EXPECT_EQ(result.bytes, replaced(file, "0 0 0 1 0 0 0 1 0", "0 0 0.5 1 0 0.5 0 1 0.5"));
  EXPECT_THAT(result.notes, IsEmpty());
}

TEST(VtpSource, KeepsWhatVtkWouldLoseOrRename)
{
  const std::string arrays =
      R"(<PointData><DataArray type="Int8">1 2 3</DataArray><DataArray type="Int8">4 5 6</DataArray>
<DataArray type="Int8" Name="T">1 2 3<InformationKey name="UNITS_LABEL" location="vtkDataArray">K</InformationKey></DataArray>
<DataArray type="Bit" Name="T">1 0 1</DataArray></PointData>)";
  const Serialized result = lifted(test::vtpTriangle(arrays, "<!-- a word --><FieldData/>\n"));
  EXPECT_THAT(result.bytes, testing::AllOf(HasSubstr(arrays), HasSubstr("<!-- a word --><FieldData/>\n")));
  EXPECT_THAT(result.notes, IsEmpty());
}

TEST(VtpSource, KeepsAsManyArraysAsThereAre)
{
  std::string arrays;
  for (int k = 0; k < 10'001; ++k) arrays += R"(<DataArray type="Int8" Name="a">1</DataArray>)";
  EXPECT_THAT(lifted(test::vtpTriangle("", "<FieldData>" + arrays + "</FieldData>")).bytes, HasSubstr(arrays));
}

TEST(VtpSource, PromotesSinglePrecisionAndSaysSo)
{
  const std::string file =
      replaced(replaced(test::vtpTriangle(), "Float64", "Float32"), "0 0 0 1 0 0 0 1 0", "0 0.1 0 1 0 0 0 1 0");
  const Serialized result = lifted(file);
  EXPECT_THAT(result.notes, ElementsAre("coordinates that were in single precision are written as doubles"));
  EXPECT_EQ(result.bytes, replaced(replaced(file, "Float32", "Float64"), "0 0.1 0 1 0 0 0 1 0",
                                   "0 0.10000000149011612 0.5 1 0 0.5 0 1 0.5"));
}

TEST(VtpSource, NumbersBetweenCommentsChildrenAndReferencesAreReplaced)
{
  const auto withText = [](const std::string& text) {
    return replaced(test::vtpTriangle(), "0 0 0 1 0 0 0 1 0", text);
  };
  const std::string key = R"(<InformationKey name="K" location="L"/>)";
  EXPECT_EQ(lifted(withText("0 0 0 1 " + key + "0<!-- here -->\n0 0 1 0 ")).bytes,
            withText("0 0 0.5 1 0 0.5 0 1 0.5 " + key + "<!-- here -->\n "));
  EXPECT_EQ(lifted(withText("0 0 0 &#49; 0 0 0 1 0")).bytes, withText("0 0 0.5 1 0 0.5 0 1 0.5  "));
  EXPECT_EQ(lifted(withText("<![CDATA[0 0 0 1 0 0 0 1 0]]>")).bytes, withText("<![CDATA[0 0 0.5 1 0 0.5 0 1 0.5]]>"));
  EXPECT_EQ(lifted("<!DOCTYPE x [<!ENTITY b \"0 0 0\">]>" + withText("&b; 1 0 0 0 1 0")).bytes,
            "<!DOCTYPE x [<!ENTITY b \"0 0 0\">]>" + withText("0 0 0.5 1 0 0.5 0 1 0.5 "));
}

TEST(VtpSource, LinesMayEndInCarriageReturns)
{
  const std::string file = replaced(test::vtpTriangle(), "0 0 0 1 0 0 0 1 0", "0 0 0\r\n1 0 0\r\n0 1 0");
  EXPECT_EQ(lifted(file).bytes, replaced(file, "0 0 0\r\n1 0 0\r\n0 1 0", "0 0 0.5\r\n1 0 0.5\r\n0 1 0.5"));
}

TEST(VtpSource, ReplacesInlineBlocks)
{
  const auto withBlock = [](const std::string& data) {
    return replaced(replaced(test::vtpTriangle(), "format=\"ascii\"", "format=\"binary\""), "0 0 0 1 0 0 0 1 0",
                    "\n   " + toBase64(vtpWord(data.size(), 4) + data) + "\n ");
  };
  EXPECT_EQ(lifted(withBlock(kFlat)).bytes, withBlock(kLifted));
}

TEST(VtpSource, ReplacesAppendedBlocksAndMovesThoseBehindThem)
{
  const std::string arrays = R"(<PointData><DataArray type="UInt8" Name="a" format="appended" offset="0"/>
<DataArray type="UInt8" Name="b" format="appended" offset="RR"/></PointData>)";
  const auto file = [&](const std::string& type, const std::string& points) {
    const std::string a = vtpWord(3) + "abc";
    const std::string b = vtpWord(3) + "def";
    const std::string block = vtpWord(points.size()) + points;
    const std::string text =
        withAppendedPoints(a.size(), replaced(arrays, "RR", std::to_string(a.size() + block.size())));
    return test::withVtpAppended(replaced(text, "<DataArray type=\"Float64\"", "<DataArray type=\"" + type + "\""),
                                 a + block + b);
  };
  EXPECT_EQ(lifted(file("Float64", kFlat)).bytes, file("Float64", kLifted));
  std::string floats;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) floats += toBytes(x, std::endian::little);
  EXPECT_EQ(lifted(file("Float32", floats)).bytes, file("Float64", kLifted));
}

TEST(VtpSource, ABlockThatAnotherArrayHasTooStays)
{
  const std::string array =
      R"(<PointData><DataArray type="Float64" Name="rest" NumberOfComponents="3" format="appended" offset="0"/>
<DataArray type="UInt8" Name="a" format="appended" offset="80"/></PointData>)";
  const std::string data = vtpWord(72) + kFlat + vtpWord(3) + "abc";
  const std::string file = test::withVtpAppended(withAppendedPoints(0, array), data);
  const std::string expected =
      test::withVtpAppended(withAppendedPoints(data.size(), array), data + vtpWord(72) + kLifted);
  EXPECT_EQ(lifted(file).bytes, expected);
}

TEST(VtpSource, PiecesMayShareTheirPoints)
{
  const std::string text = withAppendedPoints(0);
  const std::size_t begin = text.find("<Piece");
  const std::string piece = text.substr(begin, text.find("</Piece>") + 8 - begin);
  const std::string two = replaced(text, piece, piece + piece);
  const std::string file = test::withVtpAppended(two, vtpWord(72) + kFlat);
  const MeshDocument document = readVtp(file, "f.vtp");
  Positions positions = document.mesh.positions;
  positions.bottomRows(3).col(2).setConstant(0.5);
  const std::string bytes = document.source->withPositions(document.mesh, positions).bytes;
  EXPECT_EQ(readVtp(bytes, "f.vtp").mesh.positions, positions);
}

TEST(VtpSource, PiecesKeepArraysOfTheirOwn)
{
  const std::string text = test::vtpTriangle();
  const std::size_t begin = text.find("<Piece");
  const std::string piece = text.substr(begin, text.find("</Piece>") + 8 - begin);
  const std::string other =
      replaced(piece, "</Piece>", test::vtpPointData(R"(type="Int8" Name="b")", "1 2 3") + "</Piece>");
  EXPECT_THAT(lifted(replaced(text, piece, piece + other)).bytes, HasSubstr("Name=\"b\""));
}

TEST(VtpSource, StatesNewRanges)
{
  const std::string stated =
      R"(type="Float64" RangeMin="0" RangeMax="1" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0)"
      R"(<InformationKey name="L2_NORM_RANGE" location="vtkDataArray" length="2"><Value index="0"> 0 </Value>)"
      R"(<Value index="1">1</Value></InformationKey>)";
  const std::string plain = R"(type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0)";
  const std::string bytes = lifted(replaced(test::vtpTriangle(), plain, stated), 2).bytes;
  EXPECT_THAT(bytes, testing::AllOf(HasSubstr("RangeMin=\"2\" RangeMax=\"2.23606797749979\""),
                                    HasSubstr("> 2 </Value>"), HasSubstr(">2.23606797749979</Value>")));
}

TEST(VtpSource, NormalsFollowTheFacesThatMovedOnTheSideOfTheStoredOnes)
{
  const std::string fields =
      R"(<PointData Normals="n"><DataArray type="Float32" Name="n" NumberOfComponents="3">0 0 -1 0 0 -1 0.0 0 -1</DataArray></PointData>
<CellData><DataArray type="Float64" Name="Normals" NumberOfComponents="3">0 1 0 0 0 1</DataArray></CellData>)";
  const std::string line = R"(<Lines><DataArray type="Int32" Name="connectivity">0 1</DataArray>
<DataArray type="Int32" Name="offsets">2</DataArray></Lines>)";
  const std::string file =
      replaced(test::vtpTriangle(line + fields), "NumberOfPolys=\"1\"", "NumberOfLines=\"1\" NumberOfPolys=\"1\"");
  const MeshDocument document = readVtp(file, "f.vtp");
  Positions upright = document.mesh.positions;
  upright.row(2) << 0, 0, 1;
  const Serialized result = document.source->withPositions(document.mesh, upright);
  EXPECT_THAT(result.notes, ElementsAre("3 normals of points recomputed", "1 normals of faces recomputed"));
  EXPECT_THAT(result.bytes, testing::AllOf(HasSubstr(">-0 1 -0 -0 1 -0 -0 1 -0<"), HasSubstr(">0 1 0 0 -1 0<")))
      << "the first cell is a line";
}

TEST(VtpSource, NormalsOfPointsThatNoMovedFaceHasStay)
{
  const std::string text = test::vtpTriangle(test::vtpPointData(
      R"(type="Float64" Name="Normals" NumberOfComponents="3")", "0.6 0 0.80 0.6 0 0.80 0.6 0 0.80"));
  const std::size_t begin = text.find("<Piece");
  const std::string piece = text.substr(begin, text.find("</Piece>") + 8 - begin);
  const MeshDocument document = readVtp(replaced(text, piece, piece + piece), "f.vtp");
  Positions positions = document.mesh.positions;
  positions(5, 0) = 0.5;
  const Serialized result = document.source->withPositions(document.mesh, positions);
  EXPECT_THAT(result.notes, ElementsAre("3 normals of points recomputed"));
  EXPECT_THAT(result.bytes,
              testing::AllOf(HasSubstr("0.6 0 0.80 0.6 0 0.80 0.6 0 0.80"), HasSubstr(">0 0 1 0 0 1 0 0 1<")));
}

TEST(VtpSource, NormalsOfWholeTypesStayAndANoteSaysSo)
{
  const std::string normals =
      test::vtpPointData(R"(type="Int8" Name="Normals" NumberOfComponents="3")", "0 0 1 0 0 1 0 0 1");
  const Serialized result = lifted(test::vtpTriangle(normals));
  EXPECT_THAT(result.notes, ElementsAre("normals kept from before: \"Normals\" is of the type Int8"));
  EXPECT_THAT(result.bytes, HasSubstr(normals));
}

TEST(VtpSource, NamesWhatOtherFormatsLose)
{
  const MeshDocument document =
      readVtp(test::vtpTriangle(test::vtpPointData(R"(type="Int8" Name="a")", "1 2 3")), "f.vtp");
  EXPECT_TRUE(document.source->isText());
  EXPECT_THAT(serializeMesh(document, document.mesh.positions, ".vtk").notes,
              ElementsAre("left behind, because the format changes from .vtp to .vtk: array \"a\""));
}

TEST(Base64, IsThatOfTheStandard)
{
  for (const auto& [bytes, text] : {std::pair("", ""),
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}}) {
    EXPECT_EQ(toBase64(bytes), text);
    EXPECT_EQ(fromBase64(text, std::string(bytes).size()), bytes);
  }
  EXPECT_EQ(toBase64("\xFF\xFE\xFB"), "//77");
  EXPECT_EQ(fromBase64("//77", 3), "\xFF\xFE\xFB");
  EXPECT_EQ(fromBase64("Zm9v====", 4), std::nullopt) << "filling is no letter";
}

}  // namespace
}  // namespace holdfast
