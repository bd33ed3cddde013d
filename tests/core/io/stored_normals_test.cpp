#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(StoredNormals, OnlyThoseOfFacesWithAMovedVertexChange)
{
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nvn 0.0 0.0 1.0\nvn 0.0 0.0 1.0\nvn 0.0 0.0 1.0\n"
      "f 1//1 2//1 3//1\nf 4//2 5//2 6//2\n";
  const MeshDocument document = readObj(text, "");
  Positions positions = document.mesh.positions;
  positions.row(1) = Vector3(0, 0, 1);
  const Serialized written = document.source->withPositions(document.mesh, positions);
  EXPECT_EQ(written.bytes,
            "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nvn -1 0 0\nvn 0.0 0.0 1.0\nvn 0.0 0.0 1.0\n"
            "f 1//1 2//1 3//1\nf 4//2 5//2 6//2\n");
  EXPECT_THAT(written.notes, ElementsAre("1 normal recomputed"));
}

TEST(StoredNormals, ASharedNormalIsWeightedByArea)
{
  // A triangle of area 1/2 in z = 0 and one of area 3/2 in x = 0, with one normal for both.
  const MeshDocument document =
      readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 3\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n", "");
  const Positions positions = document.mesh.positions.rowwise() + Eigen::RowVector3d(1, 0, 0);
  const std::string written = document.source->withPositions(document.mesh, positions).bytes;
  std::istringstream line(written.substr(written.find("vn")));
  std::string keyword;
  Vector3 normal;
  line >> keyword >> normal.x() >> normal.y() >> normal.z();
  EXPECT_EQ(keyword, "vn");
  EXPECT_TRUE(normal.isApprox(Vector3(3, 0, 1).normalized(), 1e-15));
}

TEST(StoredNormals, WithoutAreaTheOldNormalStaysAndANoteSaysSo)
{
  const MeshDocument document = readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1.00\nf 1//1 2//1 3//1\n", "");
  Positions positions = document.mesh.positions;
  positions.row(2) = Vector3(2, 0, 0);
  const Serialized written = document.source->withPositions(document.mesh, positions);
  EXPECT_THAT(written.bytes, HasSubstr("vn 0 0 1.00\n"));
  EXPECT_THAT(written.notes, ElementsAre(HasSubstr("1 normal kept from before")));
}

TEST(StoredNormals, OfAVertexFollowEveryFaceAroundIt)
{
  const MeshDocument document = readOff(
      "NOFF 5 2\n0 0 0 0 0 1.0\n1 0 0 0 0 1.0\n0 1 0 0 0 1.0\n1 1 0 0 0 1.0\n7 7 7 0 0 1.0\n3 0 1 2\n3 1 3 2\n", "");
  Positions positions = document.mesh.positions;
  positions.row(0) = Vector3(1, 1, 1);
  positions.row(4) = Vector3(8, 8, 8);
  const Serialized written = document.source->withPositions(document.mesh, positions);
  const MeshDocument again = readOff(written.bytes, "");
  EXPECT_THAT(written.notes, ElementsAre("3 normals recomputed"));
  EXPECT_THAT(written.bytes, HasSubstr("1 1 0 0 0 1.0\n"));  // its only face did not move
  EXPECT_THAT(written.bytes, HasSubstr("8 8 8 0 0 1.0\n"));  // it has no face
}

TEST(StoredNormals, OfAWholeTypeInPlyStayAndANoteSaysSo)
{
  const MeshDocument document = readPly(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property char nx\nproperty char ny\nproperty char nz\nelement face 1\nproperty list uchar int vertex_index\n"
      "end_header\n0 0 0 0 0 127\n1 0 0 0 0 127\n0 1 0 0 0 127\n3 0 1 2\n",
      "");
  const Serialized written =
      document.source->withPositions(document.mesh, (document.mesh.positions.array() + 1).matrix());
  EXPECT_THAT(written.bytes, HasSubstr("1 1 1 0 0 127\n2 1 1 0 0 127\n1 2 1 0 0 127\n"));
  EXPECT_THAT(written.notes, ElementsAre(HasSubstr("normals kept from before: nx, ny, nz are of a whole type")));
}

TEST(StoredNormals, InPlyKeepTheirOwnPrecision)
{
  const MeshDocument document = readPly(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty double nz\nelement face 1\n"
      "property list uchar int vertex_index\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
      "");
  Positions positions = document.mesh.positions;
  positions(1, 2) = 1;
  positions(2, 2) = 1;
  const Serialized written = document.source->withPositions(document.mesh, positions);
  EXPECT_THAT(written.bytes, HasSubstr("1 0 1 -0.57735026 -0.57735026 0.57735026918962"));
  EXPECT_THAT(written.notes, ElementsAre("3 normals recomputed", "coordinates promoted to double"));
}

}  // namespace
}  // namespace holdfast
