#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

#include "core/io/bad_file.h"

namespace holdfast {
namespace {

using test::BadFile;
using test::kTriangleVertices;
using testing::ElementsAre;

TEST(OffReader, CountsMayStandOnTheFirstLineWithoutEdges)
{
  const Mesh mesh = readOff("OFF 3 1\n" + kTriangleVertices + "3 2 1 0", "mesh.off").mesh;
  EXPECT_EQ(mesh.positions.row(1).transpose(), Vector3(1, 0, 0));
  EXPECT_THAT(mesh.faces[0], ElementsAre(2, 1, 0));
}

TEST(OffReader, CommentsAndBlankLinesStandAnywhere)
{
  const Mesh mesh =
      readOff("# first\nOFF # second\n\n3 1 0 # third\n0 0 0#\n# fourth\n1 0 0\n\n0 1 0\n3 0 1 2 # fifth\n#", "").mesh;
  EXPECT_EQ(mesh.vertexCount(), 3);
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
}

TEST(OffReader, NamesWhatAnotherFormatWouldLose)
{
  const MeshDocument document =
      readOff("STCNOFF 3 1 0\n0 0 0 0 0 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 0 0\n0 1 0 0 0 1 1 1 1 0 0\n3 0 1 2 9\n", "");
  EXPECT_THAT(document.source->extras(),
              ElementsAre("normals", "vertex colours", "texture coordinates", "face colours"));
}

class BadOff : public testing::TestWithParam<BadFile> {};

TEST_P(BadOff, IsRefusedAtItsLine)
{
  test::expectRefused(GetParam(), readOff);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadOff,
    testing::Values(
        BadFile{"OtherFormat", "ply\n", 1, "", "the file begins with 'ply'"},
        BadFile{"OnlyComments", "# a\n", 1, "", "the file begins with ''"},
        BadFile{"FourDimensional", "4OFF\n3 1 0\n", 1, "", "not three-dimensional"},
        BadFile{"Binary", "OFF BINARY\n", 1, "", "binary OFF is not read"},
        BadFile{"NoCounts", "OFF\n\n", 2, "", "the file ends before the counts"},
        BadFile{"OneCount", "OFF\n3\n", 2, "", "the count of faces is missing"},
        BadFile{"FourCounts", "OFF\n3 1 0 0\n", 2, "", "'0' is too much here"},
        BadFile{"CountsNotWhole", "OFF\n3 1.5 0\n", 2, "", "'1.5', which is not a whole number"},
        BadFile{"NoVertices", "OFF\n0 1 0\n3 0 1 2\n", 2, "", "the mesh has no vertices: "},
        BadFile{"NegativeVertices", "OFF\n-3 1 0\n", 2, "", "the mesh has no vertices: "},
        BadFile{"NoFaces", "OFF\n3 0 0\n" + kTriangleVertices, 2, "", "the mesh has no faces: "},
        BadFile{"MoreVerticesThanBytes", "OFF\n9000000000000000000 1 0\n" + kTriangleVertices + "3 0 1 2\n", 2, "",
                "the header promises 9000000000000000000 vertices, but only 27 bytes follow"},
        BadFile{"MoreFacesThanBytes", "OFF\n3 1000 0\n" + kTriangleVertices + "3 0 1 2\n", 2, "",
                "the header promises 1000 faces"},
        BadFile{"TruncatedVertices", "OFF\n4 1 0\n0.00 0.00 0.00\n1.00 0.00 0.00\n", 4, "",
                "the file ends after 2 of 4 vertices"},
        BadFile{"TruncatedFaces", "OFF\n3 3 0\n0.00 0.00 0.00\n1 0 0\n0 1 0\n3 0 1 2\n", 6, "",
                "the file ends after 1 of 3 faces"},
        BadFile{"MissingCoordinate", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 4, "", "coordinate z is missing"},
        BadFile{"Garbage", "OFF\n3 1 0\n0 0 0\n1 l 0\n0 1 0\n3 0 1 2\n", 4, "", "coordinate y is 'l'"},
        BadFile{"TooLarge", "OFF\n3 1 0\n0 0 1e999\n1 1 0\n0 1 0\n3 0 1 2\n", 3, "", "no double can hold"},
        BadFile{"ColorsOfSome", "OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n3 0 1 2\n", 4, "",
                "vertex 1 has 0 numbers more than the header's first word calls for, the vertices before it have 3: "},
        BadFile{"ColorsBeforeNormals", "NCOFF\n3 1 0\n0 0 0 1 1 1 1 0 0 1 7\n", 3, "",
                "vertex 0 has 11 numbers, and by the header's first word it needs 9 or 10: "},
        BadFile{"NegativeCorners", "OFF\n3 1 0\n" + kTriangleVertices + "-2 0 1\n", 6, "", "face 0 has -2 corners: "},
        BadFile{"MoreEdgesThanCounted", "OFF\n3 1 1\n" + kTriangleVertices + "3 0 1 2\n2 0 1\n2 1 2\n", 8, "",
                "more text behind the last of the 1 faces"},
        BadFile{"ColorsMissing", "COFF\n3 1 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n3 0 1 2\n", 4, "",
                "vertex 1 has 3 numbers, and by the header's first word it needs 6 or 7: "},
        BadFile{"CornerMissing", "OFF\n3 1 0\n" + kTriangleVertices + "4 0 1 2\n", 6, "",
                "a corner of the face is missing"},
        BadFile{"IndexPastEnd", "OFF\n3 1 0\n" + kTriangleVertices + "3 0 1 3\n", 6, "",
                "vertex 3 of face 0 does not exist"},
        BadFile{"NegativeIndex", "OFF\n3 1 0\n" + kTriangleVertices + "3 0 1 -1\n", 6, "",
                "vertex -1 of face 0 does not exist"},
        BadFile{"OddColor", "OFF\n3 1 0\n" + kTriangleVertices + "3 0 1 2 1 1\n", 6, "",
                "2 numbers stand behind the corners"},
        BadFile{"TrailingLine", "OFF\n3 1 0\n" + kTriangleVertices + "3 0 1 2\n\n3 0 1 2\n", 8, "",
                "more text behind the last of the 1 faces"}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace holdfast
