#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/byte_order.h>

namespace holdfast {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A file as some program writes it, against the letter of its format or nearly so.
struct OddFile {
  std::string name;
  std::string extension;
  std::string bytes;
  Index faces = 1;
  std::string remark = {};  ///< part of what is said about it; empty where nothing is
};

std::ostream& operator<<(std::ostream& stream, const OddFile& file)
{
  return stream << file.name;
}

MeshDocument readOdd(const OddFile& file)
{
  if (file.extension == ".obj") return readObj(file.bytes, "odd");
  if (file.extension == ".ply") return readPly(file.bytes, "odd");
  if (file.extension == ".off") return readOff(file.bytes, "odd");
  return readStl(file.bytes, "odd");
}

class OddFiles : public testing::TestWithParam<OddFile> {};

TEST_P(OddFiles, AreReadAndKeptByteForByte)
{
  const MeshDocument document = readOdd(GetParam());
  EXPECT_EQ(document.mesh.faces.size(), GetParam().faces);
  EXPECT_EQ(document.source->withPositions(document.mesh, document.mesh.positions).bytes, GetParam().bytes);
}

TEST_P(OddFiles, AreSaidToBeOddWhereSomethingIsNotRead)
{
  const std::vector<std::string> remarks = readOdd(GetParam()).remarks;
  if (GetParam().remark.empty())
    EXPECT_THAT(remarks, IsEmpty());
  else
    EXPECT_THAT(remarks, testing::ElementsAre(HasSubstr(GetParam().remark)));
}

/// What is written with other positions is read again, with these positions.
TEST_P(OddFiles, AreWrittenWithOtherPositions)
{
  const MeshDocument document = readOdd(GetParam());
  const Positions moved = (document.mesh.positions.array() + 0.5).matrix();
  OddFile again = GetParam();
  again.bytes = document.source->withPositions(document.mesh, moved).bytes;
  EXPECT_EQ(readOdd(again).mesh.positions, moved);
  EXPECT_EQ(readOdd(again).mesh.faces, document.mesh.faces);
}

std::string withAllReplaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string withReturns(const std::string& text)
{
  return withAllReplaced(text, "\n", "\r");
}

const std::string kOddVertices = "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\n";
const std::string kObjQuad = kOddVertices + "f 1 2 3 4\n";

INSTANTIATE_TEST_SUITE_P(
    Obj, OddFiles,
    testing::Values(
        OddFile{"AbsentTexture", ".obj", kOddVertices + "f 1/1 2/2 3/3 4/4\n", 1,
                "4 references to a texture coordinate that the file does not have (the first is '1' in line 5"},
        OddFile{"AbsentNormals", ".obj", kOddVertices + "vn 0 0 1\nf 1//1 2//2 3//2 4//1\n", 1,
                "2 references to a normal that the file does not have (the first is '2' in line 6; there are 1 'vn'"},
        OddFile{"ReferenceZero", ".obj", kOddVertices + "f 1/0 2/0 3/0 4/0\n", 1, "the first is '0' in line 5"},
        OddFile{"NegativeAbsentNormal", ".obj", kOddVertices + "f 1//-1 2//-1 3//-1 4//-1\n", 1, "4 references"},
        OddFile{"CreaseTag", ".obj", kObjQuad + "t crease 2/1/0 0 1 4.5\n", 1,
                "1 statement that OBJ does not have (the first is 't' in line 6)"},
        OddFile{"DollarSign", ".obj", "$ converted 1992\n" + kObjQuad, 1, "'$' in line 1"},
        OddFile{"UnknownWords", ".obj", "!rev 3\n" + kObjQuad + "call a.obj\nshadow 1 2\n", 1, "3 statements"},
        OddFile{"BareNumbers", ".obj", kObjQuad + "1 2 3\n", 1, "'1' in line 6"},
        OddFile{"BlankBehindBackslash", ".obj", kOddVertices + "f 1 2 \\ \n 3 4\n"},
        OddFile{"TabBehindBackslash", ".obj", kOddVertices + "f 1 2 \\\t \r\n 3 4\n"},
        OddFile{"BackslashAtTheEnd", ".obj", kOddVertices + "f 1 2 3 4 \\"},
        OddFile{"FolderAsMaterial", ".obj", kOddVertices + "usemtl lib\\steel\\\nf 1 2 3 4\n"},
        OddFile{"FolderAsLibrary", ".obj", "mtllib C:\\parts\\\n" + kOddVertices + "g a\\\nf 1 2 3 4\n"},
        OddFile{"FolderInAComment", ".obj", "# C:\\parts\\\n" + kOddVertices + "s 1 # \\\nf 1 2 3 4\n"},
        OddFile{"NormalsOfNan", ".obj", "vn 1.#QNAN -1.#IND 1.#INF\n" + kObjQuad},
        OddFile{"PaddedNan", ".obj", "vt 1.#QNAN0 -1.#IND00\nvn nan -nan nan(ind)\nvn 1.#SNAN inf -inf\n" + kObjQuad},
        OddFile{"TinyExponents", ".obj", "vt 0.5 -1.07797e-046\nvt 0 1e-400\n" + kObjQuad},
        OddFile{"TinyCoordinates", ".obj", "v 0 1e-400 0\nv 4 -1.0e-99999999999999999999 0\nv 4 3 0\nf 1 2 3\n"},
        OddFile{"HugeTexture", ".obj", "vt 0 -1e999\n" + kObjQuad},
        OddFile{"FortranExponents", ".obj", "v 0 0 0\nv 4.0D+00 0 0\nv 4d0 3 0\nf 1 2 3\n"},
        OddFile{"TwoCorners", ".obj", kObjQuad + "f 1 2\n", 2, ""},
        OddFile{"OneCorner", ".obj", "f 1\n" + kObjQuad, 2, ""}, OddFile{"NoCorner", ".obj", kObjQuad + "f\n", 2, ""},
        OddFile{"Returns", ".obj", withReturns(kObjQuad)},
        OddFile{"ReturnsWithoutALast", ".obj", withReturns("# one\n" + kOddVertices + "f 1 2\\\n3 4")},
        OddFile{"DoubleReturns", ".obj", withAllReplaced(kObjQuad, "\n", "\r\r\n")},
        OddFile{"MixedLineEnds", ".obj", withReturns(kOddVertices) + "g a\r\ng b\nf 1 2 3 4\r"},
        OddFile{"MarkInTheMiddle", ".obj", "\xEF\xBB\xBF" + kOddVertices + "\xEF\xBB\xBF" + "f 1 2 3 4\n"},
        OddFile{"EndOfFileMark", ".obj", kObjQuad + "\x1A"},
        OddFile{"ZeroBehindTheText", ".obj", kObjQuad + std::string(3, '\0')}),
    testing::PrintToStringParamName());

const std::string kOddPlyVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kOddPlyFace = "element face 1\nproperty list uchar int vertex_indices\n";

std::string plyText(const std::string& body, const std::string& more = "", const std::string& face = kOddPlyFace)
{
  return "ply\nformat ascii 1.0\n" + kOddPlyVertex + more + face + "end_header\n" + body;
}

const std::string kOddTriangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string plyBinary()
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + kOddPlyVertex + kOddPlyFace + "end_header\n";
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) bytes += toBytes(x, std::endian::little);
  bytes += '\3';
  for (const std::int32_t corner : {0, 1, 2}) bytes += toBytes(corner, std::endian::little);
  return bytes;
}

/// Whose first byte of the body is a line feed.
std::string plyBinaryWithReturns()
{
  return withReturns("ply\nformat binary_big_endian 1.0\nelement first 1\nproperty uchar a\n" + kOddPlyVertex +
                     kOddPlyFace + "end_header\n") +
         '\n' + std::string(36, '\0') + '\3' + std::string(12, '\0');
}

INSTANTIATE_TEST_SUITE_P(
    Ply, OddFiles,
    testing::Values(
        OddFile{"PlyRowsOverTwoLines", ".ply",
                plyText("0 0 0 \n0 0 1 \n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n",
                        "property float nx\nproperty float ny\nproperty float nz\n")},
        OddFile{"PlyValuesOnLinesOfTheirOwn", ".ply", plyText("0\n0\n0\n1\n0\n0\n0\n1\n0\n3 0 1 2\n")},
        OddFile{"PlyListsOverLines", ".ply", plyText("0 0 0\n1 0 0\n0 1 0\n3\n0 1\n2\n")},
        OddFile{"PlyRowsOverLinesWithColours", ".ply",
                plyText("0 0 0\n\n200 1 2\n1 0 0\n200 1 2\n0 1 0\n200 1 2\n3 0 1 2\n",
                        "property uchar red\nproperty uchar green\nproperty uchar blue\n")},
        OddFile{"PlyLineEndBehindABinary", ".ply", plyBinary() + "\n", 1, "1 byte behind the last element"},
        OddFile{"PlyZerosBehindABinary", ".ply", plyBinary() + std::string(16, '\0'), 1, "16 bytes behind"},
        OddFile{"PlyTextBehindABinary", ".ply", plyBinary() + "made by a scanner", 1, "17 bytes behind"},
        OddFile{"PlyTextBehindAText", ".ply", plyText(kOddTriangle + "end of file\n"), 1,
                "text follows the last element, from line 14 on"},
        OddFile{"PlyMarkBeforeTheBody", ".ply", plyText("\xEF\xBB\xBF" + kOddTriangle)},
        OddFile{"PlyMarksBeforeHeaderAndBody", ".ply", "\xEF\xBB\xBF" + plyText("\xEF\xBB\xBF" + kOddTriangle)},
        OddFile{"PlyReturns", ".ply", withReturns(plyText(kOddTriangle))},
        OddFile{"PlyBinaryWithReturns", ".ply", plyBinaryWithReturns()},
        OddFile{"PlyHeaderWithReturnsBodyWithout", ".ply", withReturns(plyText("")) + kOddTriangle},
        OddFile{"PlyEndOfFileMark", ".ply", plyText(kOddTriangle + "\x1A")},
        OddFile{"PlyNanAndTinyColours", ".ply",
                plyText("0 0 0 1.#QNAN\n1 0 0 1e-400\n0 1 0 1e999\n3 0 1 2\n", "property float quality\n")},
        OddFile{"PlyFaceOfNoCorner", ".ply",
                plyText(kOddTriangle + "0\n", "", "element face 2\nproperty list uchar int vertex_indices\n"), 2, ""},
        OddFile{"PlyFacesOfOneAndTwoCorners", ".ply",
                plyText("0 0 0\n1 0 0\n0 1 0\n1 2\n3 0 1 2\n2 0 1\n", "",
                        "element face 3\nproperty list uchar int vertex_indices\n"),
                3, ""},
        OddFile{"PlyShortStrips", ".ply",
                plyText("0 0 0\n1 0 0\n0 1 0\n8 0 1 2 -1 0 1 -1 2\n", "",
                        "element tristrips 1\nproperty list int int vertex_indices\n"),
                1, "2 strips of fewer than three corners"}),
    testing::PrintToStringParamName());

const std::string kOddOffBody = "0 0 0\n4 0 0\n4 3 0\n0 3 0\n4 0 1 2 3\n";

INSTANTIATE_TEST_SUITE_P(
    Off, OddFiles,
    testing::Values(OddFile{"OffGlued", ".off", "OFF4 1 0\n" + kOddOffBody},
                    OddFile{"OffLowerCase", ".off", "off\n4 1 0\n" + kOddOffBody},
                    OddFile{"OffWithoutAKeyword", ".off", "4 1 0\n" + kOddOffBody},
                    OddFile{"OffGluedColours", ".off",
                            "coff4 1 0\n0 0 0 1 0 0\n4 0 0 1 0 0\n4 3 0 1 0 0\n0 3 0 1 0 0 1\n4 0 1 2 3\n"},
                    OddFile{"OffColoursUnannounced", ".off",
                            "OFF\n4 1 0\n0 0 0 .5 .5 1\n4 0 0 .5 .5 1\n4 3 0 .5 .5 1\n0 3 0 .5 .5 1\n4 0 1 2 3\n"},
                    OddFile{
                        "OffColoursWithOpacity", ".off",
                        "OFF\n4 1 0\n0 0 0 9 9 9 255\n4 0 0 9 9 9 255\n4 3 0 9 9 9 255\n0 3 0 9 9 9 255\n4 0 1 2 3\n"},
                    OddFile{"OffNormalsThenColoursUnannounced", ".off",
                            "NOFF\n3 1 0\n0 0 0 0 0 1 9 9 9\n4 0 0 0 0 1 9 9 9\n4 3 0 0 0 1 9 9 9\n3 0 1 2\n"},
                    OddFile{"OffEdgesAsFaces", ".off", "OFF\n4 2 0\n" + kOddOffBody + "2 0 1\n", 2, ""},
                    OddFile{"OffEdgesBehindFaces", ".off", "OFF\n4 1 2\n" + kOddOffBody + "2 0 1\n2 1 2\n"},
                    OddFile{"OffPointAsFace", ".off", "OFF\n4 2 0\n" + kOddOffBody + "1 3\n", 2, ""},
                    OddFile{"OffTextBehind", ".off", "OFF\n4 1 0\n" + kOddOffBody + "end\n", 1,
                            "text follows the last face, from line 8"},
                    OddFile{"OffReturns", ".off", withReturns("OFF\n# a\n4 1 0\n" + kOddOffBody)}),
    testing::PrintToStringParamName());

const std::string kOddFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string kOddSolid = "solid a\n" + kOddFacet + "endsolid a\n";

/// A header that counts `counted` facets, and two facets with `attribute` and as many bytes behind it as `payload` has.
std::string stlBinary(std::uint32_t counted, std::uint16_t attribute = 0, const std::string& payload = "")
{
  std::string bytes(80, ' ');
  bytes += toBytes(counted, std::endian::little);
  for (int f = 0; f < 2; ++f) {
    for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
      bytes += toBytes(x, std::endian::little);
    bytes += toBytes(attribute, std::endian::little) + payload;
  }
  return bytes;
}

INSTANTIATE_TEST_SUITE_P(
    Stl, OddFiles,
    testing::Values(
        OddFile{"StlEndSolid", ".stl", "solid a\n" + kOddFacet + "end solid a\n"},
        OddFile{"StlEndSolidGlued", ".stl", "solid AssimpScene\n" + kOddFacet + "endsolidAssimpScene\n"},
        OddFile{"StlSolidGlued", ".stl", "solidPart1\n" + kOddFacet + "END SOLIDPart1\n"},
        OddFile{"StlEndLoop", ".stl",
                withAllReplaced(withAllReplaced(kOddSolid, "endloop", "end loop"), "endfacet", "end facet")},
        OddFile{"StlSolidTwice", ".stl", "solid a\n" + kOddSolid + "endsolid a\n"},
        OddFile{"StlColourLines", ".stl", "solid a\ncolor 0.5 0.5 0.5\n" + kOddFacet + "endsolid a\n", 1,
                "1 line that STL does not have (the first begins with 'color', line 2)"},
        OddFile{"StlNormalsOfNan", ".stl", withAllReplaced(kOddSolid, "0 0 1", "-1.#IND 1.#QNAN 0")},
        OddFile{"StlNormalsOfNanInWords", ".stl", withAllReplaced(kOddSolid, "0 0 1", "-nan(ind) nan inf")},
        OddFile{"StlReturns", ".stl", withReturns(kOddSolid)},
        OddFile{"StlZeroBehindTheText", ".stl", kOddSolid + std::string(1, '\0')},
        OddFile{"StlCountOfZero", ".stl", stlBinary(0), 2, "counts 0 facets, and the file has as many bytes as 2 take"},
        OddFile{"StlCountNeverFilledIn", ".stl", stlBinary(0xFFFFFFFFU), 2, "counts 4294967295 facets"},
        OddFile{"StlCountTooSmall", ".stl", stlBinary(1), 2, "counts 1 facets, and the file has as many bytes as 2"},
        OddFile{"StlOneByteTooMany", ".stl", stlBinary(2) + "\n", 2, "1 byte behind the last of the 2 facets"},
        OddFile{"StlCountOfZeroAndALineEnd", ".stl", stlBinary(0) + "\r\n", 2, "counts 0 facets"},
        OddFile{"StlNoteBehindTheFacets", ".stl", stlBinary(2) + "made by a scanner", 2, "17 bytes behind"},
        OddFile{"StlPayloads", ".stl", stlBinary(2, 4, "abcd"), 2, ""},
        OddFile{"StlLongPayloads", ".stl", stlBinary(2, 50, std::string(50, 'x')), 2, ""},
        OddFile{"StlAttributesWithoutPayloads", ".stl", stlBinary(2, 0x801F), 2, ""}),
    testing::PrintToStringParamName());

TEST(OddFileContents, APolygonWithABrokenBackslashKeepsAllItsCorners)
{
  EXPECT_EQ(readObj(kOddVertices + "f 1 2 \\ \n 3 4\n", "").mesh.faces[0].size(), 4U);
}

TEST(OddFileContents, CoordinatesTooSmallForADoubleAreZeroWithTheirSign)
{
  const Mesh mesh = readObj("v 0 1e-400 -1e-400\nv 0.0000001e-320 0 1\nv 0 1 0\nf 1 2 3\n", "").mesh;
  EXPECT_EQ(mesh.positions.row(0).transpose(), Vector3::Zero());
  EXPECT_TRUE(std::signbit(mesh.positions(0, 2)));
  EXPECT_FALSE(std::signbit(mesh.positions(0, 1)));
}

TEST(OddFileContents, UnannouncedColoursAreNamedWhereAnotherFormatWouldLoseThem)
{
  EXPECT_THAT(readOff("OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n", "").source->extras(),
              testing::ElementsAre("vertex colours"));
}

}  // namespace
}  // namespace holdfast
