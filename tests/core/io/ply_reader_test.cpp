#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

#include "core/io/bad_file.h"

namespace holdfast {
namespace {

using test::BadFile;
using test::kTriangleVertices;
using testing::ElementsAre;

const std::string kVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";

/// A text file with the header lines `elements`, which end on line 2 + their number.
std::string text(const std::string& elements, const std::string& body)
{
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

std::string bytes(std::initializer_list<int> values)
{
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

const std::string kBinaryHeader = "ply\nformat binary_big_endian 1.0\n" + kVertex + kFace + "end_header\n";
const std::string kBinaryVertices(36, '\0');
const std::size_t kBody = kBinaryHeader.size();

std::string at(std::size_t offset)
{
  return "byte " + std::to_string(kBody + offset);
}

TEST(PlyReader, TextCoordinatesAreDoublesWhateverTheHeaderSays)
{
  const Mesh mesh = readPly(text(kVertex + kFace, "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "").mesh;
  EXPECT_EQ(mesh.positions(0, 0), 0.1);
}

TEST(PlyReader, BothNamesOfTheListAreKnown)
{
  for (const char* name : {"vertex_indices", "vertex_index"}) {
    const std::string face = std::string("element face 1\nproperty list uint8 uint32 ") + name + "\n";
    EXPECT_THAT(readPly(text(kVertex + face, kTriangleVertices + "3 2 1 0\n"), "").mesh.faces[0], ElementsAre(2, 1, 0));
  }
}

TEST(PlyReader, BigEndianIntegersAreRead)
{
  const std::string face = bytes({3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2});
  EXPECT_THAT(readPly(kBinaryHeader + kBinaryVertices + face, "").mesh.faces[0], ElementsAre(0, 1, 2));
}

TEST(PlyReader, AnElementOfNothingTakesNoTime)
{
  const std::string elements = kVertex + "element nothing 9000000000000000000\n" + kFace;
  EXPECT_EQ(readPly(text(elements, kTriangleVertices + "3 0 1 2\n"), "").mesh.faces.size(), 1);
}

TEST(PlyReader, NamesWhatAnotherFormatWouldLose)
{
  const std::string elements = kVertex + "property float nx\nproperty uchar red\n" + kFace +
                               "property int tag\nelement edge 1\nproperty int vertex1\n";
  const MeshDocument document = readPly(text(elements, "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n3 0 1 2 7\n1\n"), "");
  EXPECT_THAT(document.source->extras(),
              ElementsAre("vertex properties nx, red", "face properties tag", "element edge"));
}

/// A text file of one triangle's vertices with the rows of strips `rows`.
std::string strips(const std::string& rows, Index count = 1, const std::string& more = "")
{
  return text(
      kVertex + more + "element tristrips " + std::to_string(count) + "\nproperty list int int vertex_indices\n",
      kTriangleVertices + rows);
}

TEST(PlyReader, EverySecondTriangleOfAStripIsTurnedRoundAndThoseThatNameAVertexTwiceAreNoFaces)
{
  const Mesh mesh = readPly(strips("8 0 1 2 2 0 0 1 2\n"), "").mesh;
  // Of the six triangles 012, 212, 220, 020, 001 and 210 the first alone and the last, turned round, have an area.
  ASSERT_EQ(mesh.faces.size(), 2);
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.faces[1], ElementsAre(1, 0, 2));
}

TEST(PlyReader, AStripEndsWithItsRowAndAtMinusOne)
{
  const Mesh mesh = readPly(strips("3 0 1 2\n8 2 1 0 -1 -1 1 0 2\n0\n", 3), "").mesh;
  ASSERT_EQ(mesh.faces.size(), 3);
  EXPECT_THAT(mesh.faces[1], ElementsAre(2, 1, 0));
  EXPECT_THAT(mesh.faces[2], ElementsAre(1, 0, 2));
}

TEST(PlyReader, FacesComeBeforeStrips)
{
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const MeshDocument both = readPly(strips("3 2 1 0\n3 0 1 2\n", 1, faces), "");
  ASSERT_EQ(both.mesh.faces.size(), 1);
  EXPECT_THAT(both.mesh.faces[0], ElementsAre(2, 1, 0));
  EXPECT_THAT(both.source->extras(), ElementsAre("element tristrips"));
  const std::string noFaces = "element face 0\nproperty list uchar int vertex_indices\n";
  const MeshDocument one = readPly(strips("3 0 1 2\n", 1, noFaces), "");
  EXPECT_EQ(one.mesh.faces.size(), 1);
  EXPECT_THAT(one.source->extras(), ElementsAre("element face"));
}

class BadPly : public testing::TestWithParam<BadFile> {};

TEST_P(BadPly, IsRefusedAtItsPlace)
{
  test::expectRefused(GetParam(), readPly);
}

INSTANTIATE_TEST_SUITE_P(
    Headers, BadPly,
    testing::Values(
        BadFile{"OtherFormat", "OFF\n", 1, "", "begins with 'OFF', not with 'ply'"},
        BadFile{"NoEnd", "ply\nformat ascii 1.0\n", 2, "", "no end_header"},
        BadFile{"NoFormat", "ply\n" + kVertex + kFace + "end_header\n", 8, "", "no format line"},
        BadFile{"TwoFormats", "ply\nformat ascii 1.0\nformat ascii 1.0\n", 3, "", "names a format twice"},
        BadFile{"UnknownFormat", "ply\nformat binary 1.0\n", 2, "", "'binary' is not a PLY format"},
        BadFile{"UnknownVersion", "ply\nformat ascii 2.0\n", 2, "", "version '2.0' of PLY is not known"},
        BadFile{"UnknownWord", "ply\nformat ascii 1.0\nremark a\n", 3, "", "'remark' is not a word of a PLY header"},
        BadFile{"UnknownType", "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n", 4, "",
                "'half' is not a PLY type"},
        BadFile{"CountNotWhole", "ply\nformat ascii 1.0\nelement vertex 3.5\n", 3, "", "'3.5', which is not a whole"},
        BadFile{"NegativeCount", "ply\nformat ascii 1.0\nelement vertex -3\n", 3, "", "the count -3 is negative"},
        BadFile{"ElementTwice", "ply\nformat ascii 1.0\nelement a 1\nelement a 1\n", 4, "", "'a' is there twice"},
        BadFile{"PropertyTwice", "ply\nformat ascii 1.0\nelement a 1\nproperty int b\nproperty int b\n", 5, "",
                "'b' is there twice"},
        BadFile{"PropertyFirst", "ply\nformat ascii 1.0\nproperty int b\n", 3, "", "before the first element"},
        BadFile{"FloatListCount", "ply\nformat ascii 1.0\nelement a 1\nproperty list float int b\n", 4, "",
                "count of a list must have a whole type"},
        BadFile{"NoName", "ply\nformat ascii 1.0\nelement a 1\nproperty float\n", 4, "", "name of the property"},
        BadFile{"NoVertexElement", text(kFace, "3 0 1 2\n"), 0, "", "no element 'vertex'"},
        BadFile{"NoFaceElement", text(kVertex, kTriangleVertices), 0, "", "no element 'face'"},
        BadFile{"NoZ", text("element vertex 3\nproperty float x\nproperty float y\n" + kFace, ""), 3, "",
                "no number 'z'"},
        BadFile{"ListAsX",
                text("element vertex 3\nproperty list uchar float x\nproperty float y\nproperty float z\n" + kFace, ""),
                3, "", "no number 'x'"},
        BadFile{"NoList", text(kVertex + "element face 1\nproperty int a\n", ""), 7, "", "needs the property 'list"},
        BadFile{"FloatList", text(kVertex + "element face 1\nproperty list uchar float vertex_indices\n", ""), 7, "",
                "needs the property 'list"},
        BadFile{"NoVertices",
                text("element vertex 0\nproperty float x\nproperty float y\nproperty float z\n" + kFace, ""), 3, "",
                "the mesh has no vertices: "},
        BadFile{"NoFaces",
                text(kVertex + "element face 0\nproperty list uchar int vertex_indices\n", kTriangleVertices), 7, "",
                "the mesh has no faces: "}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Texts, BadPly,
    testing::Values(
        BadFile{"MoreRowsThanBytes",
                text("element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n" + kFace,
                     kTriangleVertices + "3 0 1 2\n"),
                10, "", "promises 4000000000 rows of element 'vertex'"},
        BadFile{"Truncated", text(kVertex + kFace, "0.00 0.00 0.00\n1.00 0.00 0.00\n"), 11, "",
                "ends after 2 of 3 rows of element 'vertex'"},
        BadFile{"TruncatedFaces", text(kVertex + kFace, kTriangleVertices), 12, "",
                "ends after 0 of 1 rows of element 'face'"},
        BadFile{"MissingCoordinate", text(kVertex + kFace, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), 11, "", "z is missing"},
        BadFile{"MissingInARowOfTwoLines", text(kVertex + kFace, "0\n0 0\n1 0\n0 1 0\n3 0 1 2\n"), 12, "",
                "z is missing"},
        BadFile{"ExtraInARowOfTwoLines", text(kVertex + kFace, "0 0\n0 5\n1 0 0\n0 1 0\n3 0 1 2\n"), 10, "",
                "z is missing"},
        BadFile{"ExtraNumber", text(kVertex + kFace, "0 0 0\n1 0 0 5\n0 1 0\n3 0 1 2\n"), 11, "", "'5' is too much"},
        BadFile{"Garbage", text(kVertex + kFace, "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"), 11, "", "z is 'zero'"},
        BadFile{"TooLarge", text(kVertex + kFace, "0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n"), 11, "", "no double can hold"},
        BadFile{"CornerMissing", text(kVertex + kFace, kTriangleVertices + "4 0 1 2\n"), 13, "",
                "corner of the face is missing"},
        BadFile{"IndexPastEnd", text(kVertex + kFace, kTriangleVertices + "3 0 1 3\n"), 13, "",
                "vertex 3 of face 0 does not exist"},
        BadFile{"NegativeIndex", text(kVertex + kFace, kTriangleVertices + "3 0 -1 2\n"), 13, "",
                "vertex -1 of face 0"},
        BadFile{"TrailingLine", text(kVertex + kFace, kTriangleVertices + "3 0 1 2\n\n3 0 1 2\n"), 15, "",
                "more text behind the last element"}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Strips, BadPly,
    testing::Values(BadFile{"StripPastEnd", strips("7 0 1 2 -1 0 1 3\n"), 13, "", "vertex 3 of strip 1 does not exist"},
                    BadFile{"StripBelowMinusOne", strips("3 0 1 -2\n"), 13, "", "vertex -2 of strip 0"},
                    BadFile{"StripsOfNothing", strips("1 -1\n"), 7, "", "the mesh has no faces: "},
                    BadFile{"StripsWithoutArea", strips("3 0 1 1\n"), 7, "", "the mesh has no faces: "},
                    BadFile{"NoStrips", strips("", 0), 7, "", "the mesh has no faces: "},
                    BadFile{"StripCornerMissing", strips("4 0 1 2\n"), 13, "", "corner of a strip is missing"}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Binaries, BadPly,
    testing::Values(
        BadFile{"TruncatedVertices", kBinaryHeader + std::string(35, '\0'), 0, at(0),
                "promises 3 rows of element 'vertex', of 12 bytes at least, but only 35 bytes follow"},
        BadFile{"NoFaceBytes", kBinaryHeader + kBinaryVertices, 0, at(32), "promises 1 rows of element 'face'"},
        BadFile{"TruncatedFace", kBinaryHeader + kBinaryVertices + bytes({4, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0}), 0,
                at(49), "the file ends inside this value"},
        BadFile{"IndexPastEndBinary", kBinaryHeader + kBinaryVertices + bytes({3, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2}),
                0, at(41), "vertex 3 of face 0 does not exist"},
        BadFile{"NegativeIndexBinary",
                kBinaryHeader + kBinaryVertices + bytes({3, 0, 0, 0, 0, 0, 0, 0, 1, 255, 255, 255, 255}), 0, at(45),
                "vertex -1 of face 0 does not exist"}),
    testing::PrintToStringParamName());

TEST(PlyReader, AHugeListIsRefusedWithoutMemoryForIt)
{
  const std::string header = "ply\nformat binary_little_endian 1.0\n" + kVertex +
                             "element face 1\nproperty list uint float other\nproperty list uchar int vertex_index\n"
                             "end_header\n";
  const std::string body = kBinaryVertices + bytes({255, 255, 255, 255}) + std::string(20, '\0');
  test::expectRefused({"", header + body, 0, "byte " + std::to_string(header.size() + 36),
                       "4294967295 values are to follow, but only 20 bytes do"},
                      readPly);
}

}  // namespace
}  // namespace holdfast
