#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

#include "core/io/bad_file.h"

namespace holdfast {
namespace {

using test::BadFile;
using testing::ElementsAre;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Mesh meshOf(const std::string& text)
{
  return readObj(text, "mesh.obj").mesh;
}

TEST(ObjReader, NegativeReferencesCountBackFromTheirLine)
{
  const Mesh mesh = meshOf(kTriangle + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -4\n");
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.faces[1], ElementsAre(3, 2, 0));
}

TEST(ObjReader, FacesMayStandBeforeTheirVertices)
{
  EXPECT_THAT(meshOf("f 1/1/1 3/1/1 2\n" + kTriangle + "vt 0\nvn 0 0 1\n").faces[0], ElementsAre(0, 2, 1));
}

TEST(ObjReader, EveryFormOfReferenceNamesItsVertex)
{
  const Mesh mesh = meshOf(kTriangle + "vt 0 0\nvn 0 0 1\nf 1 2/1 3//1\nf 3/1/1 2/ 1//\n");
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.faces[1], ElementsAre(2, 1, 0));
}

TEST(ObjReader, AContinuationJoinsLinesEvenInsideAWord)
{
  const Mesh mesh = meshOf("v 0 0\\\n 0\nv 1 \\\r\n 0 0\nv 0 1 0\nf \\\n1 \\\n2\\\n 3\n");
  EXPECT_EQ(mesh.positions.row(1).transpose(), Vector3(1, 0, 0));
  EXPECT_THAT(mesh.faces[0], ElementsAre(0, 1, 2));
}

TEST(ObjReader, AContinuedStatementThatIsKeptHidesNoVertex)
{
  EXPECT_EQ(meshOf(kTriangle + "g name \\\nv 9 9 9\nf 1 2 3\n").vertexCount(), 3);
}

TEST(ObjReader, ACommentIsNotContinued)
{
  EXPECT_EQ(meshOf("# a \\\n" + kTriangle + "f 1 2 3\n").vertexCount(), 3);
}

TEST(ObjReader, NumbersMayHaveAPlusAndNeedNotBeFinite)
{
  const Mesh mesh = meshOf("v +1 +.5e+1 -0\nv nan inf -inf\nv 0 0 0\nf +1 2 3\n");
  EXPECT_EQ(mesh.positions.row(0).transpose(), Vector3(1, 5, 0));
  EXPECT_TRUE(std::signbit(mesh.positions(0, 2)));
  EXPECT_TRUE(std::isnan(mesh.positions(1, 0)));
  EXPECT_EQ(mesh.positions(1, 2), -std::numeric_limits<double>::infinity());
}

TEST(ObjReader, NamesWhatAnotherFormatWouldLose)
{
  const MeshDocument document =
      readObj("mtllib a\nusemtl b\ng c\ns 1\nv 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nvt 0\nvn 0 0 1\nl 1 2\nf 1 2 3\n", "");
  EXPECT_THAT(document.source->extras(),
              testing::UnorderedElementsAre("texture coordinates", "normals", "vertex colours", "groups", "lines",
                                            "materials", "smoothing groups"));
}

class BadObj : public testing::TestWithParam<BadFile> {};

TEST_P(BadObj, IsRefusedAtItsLine)
{
  test::expectRefused(GetParam(), readObj);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadObj,
    testing::Values(BadFile{"MissingCoordinate", "v 0 0 0\nv 1 0\n", 2, "", "coordinate z is missing"},
                    BadFile{"NoNumber", "v 0 zero 0\n", 1, "", "coordinate y is 'zero', which is not a number"},
                    BadFile{"HalfANumber", "v 0 1.5.2 0\n", 1, "", "'1.5.2', which is not a number"},
                    BadFile{"Hexadecimal", "v 0 0x10 0\n", 1, "", "'0x10', which is not a number"},
                    BadFile{"TwoSigns", "v 0 +-1 0\n", 1, "", "'+-1', which is not a number"},
                    BadFile{"TooLarge", "\n\nv 0 0 1e999\n", 3, "", "'1e999', which no double can hold"},
                    BadFile{"FiveNumbers", "v 0 0 0 1 1\n", 1, "", "the vertex has 5 numbers"},
                    BadFile{"EightNumbers", "v 0 0 0 1 1 1 1 1\n", 1, "", "the vertex has 8 numbers"},
                    BadFile{"GarbageColor", "v 0 0 0 1 x 1\n", 1, "", "'x', which is not a number"},
                    BadFile{"LongNormal", "vn 0 0 1 0\n", 1, "", "'0' is too much here"},
                    BadFile{"GarbageTexture", "vt 0 ?\n", 1, "", "'?', which is not a number"},
                    BadFile{"IndexZero", kTriangle + "f 1 2 0\n", 4, "", "vertex 0 does not exist: OBJ counts from 1"},
                    BadFile{"IndexPastEnd", kTriangle + "f 1 2 3\nf 1 2 4\nf 7 8 9\n", 5, "",
                            "vertex 4 does not exist: the file has 3 'v' lines"},
                    BadFile{"NegativePastBeginning", kTriangle + "f -1 -2 -4\n", 4, "",
                            "vertex -4 does not exist: only 3 stand above"},
                    BadFile{"HugeIndex", kTriangle + "f 1 2 99999999999999999999\n", 4, "", "far beyond any"},
                    BadFile{"IndexNotWhole", kTriangle + "f 1 2 3.0\n", 4, "", "'3.0', which is not a whole number"},
                    BadFile{"NoVertexInReference", kTriangle + "f 1 2 /3\n", 4, "", "a corner without a vertex"},
                    BadFile{"Binary", std::string("\x89PNG\0\n", 6), 1, "", "'\\x89PNG\\x00' is not an OBJ statement"},
                    BadFile{"ErrorBehindContinuation", "v 0 \\\n0 \\\n x\n", 3, "", "coordinate z is 'x'"},
                    BadFile{"ErrorBehindWindowsLines", "# a\r\n\r\nv 0 0\r\n", 3, "", "coordinate z is missing"},
                    BadFile{"NoFaces", kTriangle, 0, "", "the mesh has no faces: "},
                    BadFile{"NoVertices", "# nothing\n", 0, "", "the mesh has no vertices: "}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace holdfast
