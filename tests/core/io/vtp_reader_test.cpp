#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/formats/block_compressor.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/words/error.h>

#include "core/io/vtp_files.h"

namespace holdfast {
namespace {

using test::replaced;
using testing::ElementsAre;
using testing::HasSubstr;

std::string faultOf(const std::string& bytes)
{
  try {
    (void)readVtp(bytes, "f.vtp");
  } catch (const InputError& error) {
    EXPECT_THAT(error.reason(), testing::ContainsRegex("[:;] .+")) << "says what to do";
    return error.what();
  }
  return "no fault";
}

std::string faultOfPointData(const std::string& attributes, const std::string& values)
{
  return faultOf(test::vtpTriangle(test::vtpPointData(attributes, values)));
}

TEST(VtpReader, ReadsWhatItsTestsBuildOn)
{
  EXPECT_EQ(faultOfPointData(R"(type="Int8" Name="a" format="ascii")", "1 -2 3"), "no fault");
  const Mesh mesh = readVtp(test::vtpTriangle(), "f.vtp").mesh;
  EXPECT_EQ(mesh.positions.row(1), Eigen::RowVector3d(1, 0, 0));
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
}

TEST(VtpReader, TakesGlobalIdsForLabels)
{
  const std::string points = R"(<PointData GlobalIds="node"><DataArray type="Int64" Name="node" format="ascii">)"
                             "70 90 80</DataArray></PointData>";
  const std::string cells = R"(<CellData GlobalIds="element"><DataArray type="Int32" Name="element" format="ascii">)"
                            "5</DataArray></CellData>";
  const Mesh mesh = readVtp(test::vtpTriangle(points + cells), "f.vtp").mesh;
  EXPECT_THAT(mesh.labels.vertices, ElementsAre(70, 90, 80));
  EXPECT_THAT(mesh.labels.faces, ElementsAre(5));
}

TEST(VtpReader, TakesNoOtherNumbersForLabels)
{
  const std::string undeclared = test::vtpPointData(R"(type="Int64" Name="node" format="ascii")", "70 90 80");
  EXPECT_THAT(readVtp(test::vtpTriangle(undeclared), "f.vtp").mesh.labels.vertices, testing::IsEmpty());
  const std::string real = R"(<PointData GlobalIds="x"><DataArray type="Float64" Name="x" format="ascii">)"
                           "70 90 80</DataArray></PointData>";
  EXPECT_THAT(readVtp(test::vtpTriangle(real), "f.vtp").mesh.labels.vertices, testing::IsEmpty());
}

TEST(VtpReader, NamesTypesThatAreNotKnown)
{
  const std::string whole =
      "<FieldData><DataArray Name=\"a\" NumberOfTuples=\"1\" format=\"ascii\">1</DataArray></FieldData>";
  EXPECT_THAT(faultOf(test::vtpTriangle("", whole)), HasSubstr("f.vtp:2: DataArray: \"a\": its type is ''"));
  EXPECT_THAT(faultOfPointData(R"(type="Float63" Name="a" format="ascii")", "1 2 3"),
              HasSubstr("f.vtp:6: DataArray: \"a\": its type is 'Float63'"));
  EXPECT_THAT(faultOfPointData(R"(type="Float64" Name="a" format="text")", "1 2 3"), HasSubstr("its format is 'text'"));
}

TEST(VtpReader, NamesTextsThatAreNumbers)
{
  EXPECT_THAT(faultOfPointData(R"(type="String" Name="a" format="ascii")", "1 2 3"),
              HasSubstr("its last text has no end"));
  EXPECT_THAT(faultOfPointData(R"(type="String" Name="a" format="ascii")", "1.5 2.5 3.5"),
              HasSubstr("'1.5' is no number that it can hold"));
  EXPECT_THAT(faultOfPointData(R"(type="String" Name="a" format="ascii")", "65 0 66 0"),
              HasSubstr("it has 2 tuples where 3 must be"));
}

/// Blocks of zeros as they are stored: how many, their size and that of the last one, the sizes when compressed.
std::string compressedZeros(std::size_t blocks, std::size_t size)
{
  const std::string block = findCompressor("vtkZLibDataCompressor")->compress(std::string(size, '\0'));
  std::string data = test::vtpWord(blocks) + test::vtpWord(size) + test::vtpWord(0);
  for (std::size_t k = 0; k < blocks; ++k) data += test::vtpWord(block.size());
  for (std::size_t k = 0; k < blocks; ++k) data += block;
  return data;
}

constexpr const char* kByZlib = "compressor=\"vtkZLibDataCompressor\"";

TEST(VtpReader, WhatCompressionExplainsOnceIsRead)
{
  EXPECT_EQ(faultOf(test::withVtpFields(compressedZeros(3, 1 << 20), {0}, kByZlib)), "no fault");
}

TEST(VtpReader, ArraysThatShareOneBlockTakeNoMoreThanTheFileExplains)
{
  EXPECT_THAT(faultOf(test::withVtpFields(compressedZeros(2, 1 << 20), std::vector<std::size_t>(1000, 0), kByZlib)),
              HasSubstr("share their data"));
  EXPECT_THAT(faultOf(test::withVtpFields(test::vtpWord(1 << 20) + std::string(1 << 20, 'x'),
                                          std::vector<std::size_t>(200, 0))),
              HasSubstr("share their data"));
  EXPECT_EQ(faultOf(test::withVtpFields(test::vtpWord(3) + "abc", {0, 0, 0})), "no fault") << "they fit into the file";
}

TEST(VtpReader, EntitiesMakeNoTextLongerThanTheFile)
{
  const std::string entity = "<!DOCTYPE x [<!ENTITY b \"" + std::string(2000, ' ') + "\">]>";
  const std::string many = "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;";
  EXPECT_THAT(faultOf(entity + test::vtpTriangle(test::vtpPointData(R"(type="Int8" Name="a")", many))),
              HasSubstr("entities make it longer"));
  EXPECT_THAT(faultOf(entity + test::vtpTriangle(test::vtpPointData("type=\"" + many + "\"", ""))),
              HasSubstr("entities make it longer"));
}

TEST(VtpReader, AttributesThatNoTagStatesAreNone)
{
  const std::string given = "<!DOCTYPE x [<!ATTLIST DataArray format CDATA \"" + std::string(100, 'x') + "\">]>\n";
  EXPECT_EQ(faultOf(given + test::vtpTriangle(test::vtpPointData(R"(type="Int8" Name="a")", "1 2 3"))), "no fault");
}

TEST(VtpReader, EmptyPiecesTakeNoMemoryAndSmallOnesAreJoined)
{
  std::string pieces;
  for (int k = 0; k < 20'000; ++k) pieces += "<Piece NumberOfPoints=\"0\"/>";
  EXPECT_EQ(readVtp(test::vtpTriangle("", pieces), "f.vtp").mesh.vertexCount(), 3);
  std::string many = test::vtpTriangle();
  const std::size_t begin = many.find("<Piece");
  const std::string piece = many.substr(begin, many.find("</Piece>") + 8 - begin);
  for (int k = 0; k < 999; ++k) many.insert(begin, piece);
  const Mesh joined = readVtp(many, "f.vtp").mesh;
  EXPECT_EQ(joined.vertexCount(), 3000);
  EXPECT_EQ(joined.faces.size(), 1000);
  EXPECT_THAT(joined.faces[999], ElementsAre(2997, 2998, 2999));
}

TEST(VtpReader, BlocksClaimNoMoreThanCompressionCanHold)
{
  const std::string block =
      test::vtpWord(1) + test::vtpWord(std::uint64_t{1} << 50U) + test::vtpWord(0) + test::vtpWord(4) + "abcd";
  EXPECT_THAT(faultOf(test::withVtpFields(block, {0}, kByZlib)), HasSubstr("claims too large a size"));
}

TEST(VtpReader, DamagedBlocksAreNamedForEachCompressor)
{
  for (const std::string name : {"vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor"}) {
    std::string block = findCompressor(name)->compress("0123456789012345678901234567890123456789");
    const auto file = [&](std::size_t size) {
      return test::withVtpFields(
          test::vtpWord(1) + test::vtpWord(size) + test::vtpWord(0) + test::vtpWord(block.size()) + block, {0},
          "compressor=\"" + name + "\"");
    };
    EXPECT_EQ(faultOf(file(40)), "no fault") << name;
    EXPECT_THAT(faultOf(file(39)), HasSubstr("damaged")) << name;
    EXPECT_THAT(faultOf(file(41)), HasSubstr("damaged")) << name;
    for (char& c : block) c = static_cast<char>(~c);
    EXPECT_THAT(faultOf(file(40)), HasSubstr("damaged")) << name;
  }
  EXPECT_THAT(faultOf(test::withVtpFields("", {0}, "compressor=\"vtkOther\"")),
              HasSubstr("compressor 'vtkOther' is not known"));
}

TEST(VtpReader, AnOffsetOnePastTheEndIsNone)
{
  const std::string data = test::vtpWord(2) + "ab";
  const std::size_t end = data.size() + std::string("</AppendedData></VTKFile>\n").size();
  EXPECT_THAT(faultOf(test::withVtpFields(data, {end})), HasSubstr("would begin where the file has none"));
  EXPECT_THAT(faultOf(test::withVtpFields(data, {end - 1})), HasSubstr("cut short"));
}

TEST(VtpReader, EmptyArraysHaveFewComponents)
{
  const auto empty = [](const std::string& components) {
    return faultOf(test::vtpTriangle("", "<FieldData><DataArray type=\"Int8\" Name=\"a\" NumberOfComponents=\"" +
                                             components + "\" format=\"ascii\"></DataArray></FieldData>"));
  };
  EXPECT_EQ(empty("1"), "no fault");
  EXPECT_EQ(empty("9"), "no fault") << "tensors";
  EXPECT_THAT(empty("10"), HasSubstr("its 0 numbers are not whole tuples of 10"));
  EXPECT_THAT(empty("0"), HasSubstr("not whole tuples of 0"));
}

TEST(VtpReader, SizesThatWrapAreCutShort)
{
  using test::vtpWord;
  const std::uint64_t wrapping = (std::uint64_t{1} << 61U);  // so many words of 8 bytes are none
  EXPECT_THAT(faultOf(test::withVtpFields(vtpWord(wrapping) + vtpWord(8) + vtpWord(0) + vtpWord(4), {0}, kByZlib)),
              HasSubstr("cut short"));
  EXPECT_THAT(faultOf(test::withVtpFields(vtpWord(wrapping - 3) + vtpWord(8) + vtpWord(0), {0}, kByZlib)),
              HasSubstr("cut short"));
  EXPECT_THAT(faultOf(test::withVtpFields(vtpWord(~std::uint64_t{0} - 7) + vtpWord(1), {0})), HasSubstr("cut short"));
  const std::string twoBlocks = vtpWord(2) + vtpWord(8) + vtpWord(0) + vtpWord(~std::uint64_t{0}) + vtpWord(3) + "ab";
  EXPECT_THAT(faultOf(test::withVtpFields(twoBlocks, {0}, kByZlib)), HasSubstr("cut short")) << "their sum is 2";
}

TEST(VtpReader, BitsAreReadAsTextAndPacked)
{
  EXPECT_EQ(faultOfPointData(R"(type="Bit" Name="a" format="ascii")", "1 0 1"), "no fault");
  // One byte, 0b01100000, after its size.
  EXPECT_EQ(faultOfPointData(R"(type="Bit" Name="a" format="binary")", "AQAAAGA="), "no fault");
  EXPECT_THAT(faultOfPointData(R"(type="Bit" Name="a" format="binary")", "AgAAAGBg"), HasSubstr("3 bits"));
  EXPECT_THAT(faultOfPointData(R"(type="Bit" Name="a" format="ascii")", "1 0"), HasSubstr("2 tuples"));
}

TEST(VtpReader, SeesWhatCommentsAndReferencesHide)
{
  const std::string hidden =
      test::vtpPointData(R"(type="Float64" Name="a" NumberOfComponents="99999999" format="ascii")", "1");
  EXPECT_THAT(faultOf(test::vtpTriangle("<!-- it's a quote -->\n" + hidden)),
              HasSubstr("not whole tuples of 99999999"));
  EXPECT_THAT(faultOfPointData(R"(type="Int8" Name="a" format="&#98;inary")", "////////"),
              HasSubstr("its data are cut short"));
  EXPECT_THAT(faultOfPointData(R"(type="Int8" Name="a" format="binary")", "!AAAAAAA"), HasSubstr("no base64 text"));
}

TEST(VtpReader, NamesNumbersThatDoNotFitTheirType)
{
  EXPECT_THAT(faultOfPointData(R"(type="Int8" Name="a" format="ascii")", "1 2 300"), HasSubstr("'300'"));
  EXPECT_THAT(faultOfPointData(R"(type="UInt8" Name="a" format="ascii")", "1 -1 3"), HasSubstr("'-1'"));
}

TEST(VtpReader, NamesElementsThatAreNestedTooDeep)
{
  std::string deep;
  for (int k = 0; k < 500000; ++k) deep += "<a>";
  EXPECT_THAT(faultOf(deep), testing::AllOf(HasSubstr("f.vtp:1: "), HasSubstr("nested too deep")));
}

TEST(VtpReader, NamesStepsOfTime)
{
  EXPECT_THAT(faultOf(replaced(test::vtpTriangle(), "<PolyData>", "<PolyData TimeValues=\"0 1\">")),
              HasSubstr("several steps of time"));
}

TEST(VtpReader, NamesOtherKindsOfFiles)
{
  EXPECT_THAT(faultOf(R"(<VTKFile type="ImageData" version="1.0"><ImageData/></VTKFile>)"),
              HasSubstr("no PolyData file"));
  EXPECT_THAT(faultOf(R"(<VTKFile type="PolyData"></VTKFile>)"), HasSubstr("no PolyData in it"));
  EXPECT_THAT(faultOf(""), HasSubstr("no whole XML file: no element found"));
  EXPECT_THAT(faultOf("<VTKFile type=\"PolyData\">\n<PolyData></PolyDatum>"),
              testing::AllOf(HasSubstr("f.vtp:2: "), HasSubstr("no whole XML file: mismatched tag")));
}

std::string withCells(const std::string& corners, const std::string& ends)
{
  return replaced(replaced(test::vtpTriangle(), ">0 1 2<", ">" + corners + "<"), ">3<", ">" + ends + "<");
}

TEST(VtpReader, NamesThePolygonThatIsNoFace)
{
  EXPECT_THAT(faultOf(withCells("0 1 3", "3")), HasSubstr("f.vtp:4: polygon 0: it refers to point 3, but the points"));
  EXPECT_THAT(faultOf(withCells("0 1 -1", "3")), testing::AllOf(HasSubstr("polygon 0"), HasSubstr("point -1")));
  EXPECT_THAT(faultOf(withCells("0 1", "2")), testing::AllOf(HasSubstr("polygon 0"), HasSubstr("at least 3")));
  EXPECT_THAT(faultOf(withCells("0 1 2.5", "3")), HasSubstr("'2.5'"));
}

TEST(VtpReader, NamesOffsetsThatLeadNowhere)
{
  EXPECT_THAT(faultOf(withCells("0 1 2", "300000")), HasSubstr("the last offset is 300000, and there are 3 corners"));
  EXPECT_THAT(faultOf(withCells("0 1 2", "-3")), HasSubstr("the last offset is -3"));
  EXPECT_THAT(faultOf(replaced(withCells("0 1 2 0 1 2", "99 6"), "NumberOfPolys=\"1\"", "NumberOfPolys=\"2\"")),
              HasSubstr("polygon 0: it goes from corner 0 to before corner 99 of 6"));
  EXPECT_THAT(faultOf(replaced(withCells("0 1 2 0 1 2", "3 -9223372036854775808 6"), "NumberOfPolys=\"1\"",
                               "NumberOfPolys=\"3\"")),
              HasSubstr("polygon 1: it goes from corner 3 to before corner -9223372036854775808 of 6"));
  EXPECT_THAT(faultOf(replaced(withCells("0 1 2 0 1 2", "-9223372036854775807 6"), "NumberOfPolys=\"1\"",
                               "NumberOfPolys=\"2\"")),
              HasSubstr("polygon 0"));
}

TEST(VtpReader, NamesCountsThatTheFileDoesNotHold)
{
  EXPECT_THAT(faultOf(replaced(test::vtpTriangle(), "NumberOfPoints=\"3\"", "NumberOfPoints=\"-3\"")),
              testing::AllOf(HasSubstr("f.vtp:2: "), HasSubstr("NumberOfPoints")));
  EXPECT_THAT(faultOf(replaced(test::vtpTriangle(), "NumberOfPoints=\"3\"", "NumberOfPoints=\"9223372036854775807\"")),
              HasSubstr("it has 3 tuples where 9223372036854775807 must be"));
}

TEST(VtpReader, NamesASurfaceWithoutPolygons)
{
  EXPECT_THAT(faultOf(replaced(test::vtpTriangle(), "NumberOfPolys=\"1\"", "")), HasSubstr("no polygons"));
  const std::string strip =
      replaced(replaced(test::vtpTriangle(), "NumberOfPolys", "NumberOfStrips"), "<Polys>", "<Strips>");
  EXPECT_EQ(faultOf(replaced(strip, "</Polys>", "</Strips>")), "no fault");
  const std::string flat = replaced(replaced(strip, "</Polys>", "</Strips>"), ">0 1 2<", ">0 1 0<");
  EXPECT_THAT(faultOf(flat), HasSubstr("no strip has a triangle"));
  EXPECT_THAT(faultOf(replaced(flat, ">0 1 0<", ">0 1 77<")),
              testing::AllOf(HasSubstr("strip 0"), HasSubstr("point 77")));
}

TEST(VtpReader, TrianglesOfStripsAreFacesOfOneSideAfterThePolygons)
{
  const std::string strips =
      R"(<Strips><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 2 0 1</DataArray>
<DataArray type="UInt8" Name="offsets" format="ascii">3 6</DataArray></Strips>)";
  const std::string file =
      replaced(test::vtpTriangle(strips), "NumberOfPolys=\"1\"", "NumberOfPolys=\"1\" NumberOfStrips=\"2\"");
  const Polygons faces = readVtp(file, "f.vtp").mesh.faces;
  ASSERT_EQ(faces.size(), 3);
  EXPECT_THAT(faces[2], ElementsAre(2, 0, 1));
}

}  // namespace
}  // namespace holdfast
