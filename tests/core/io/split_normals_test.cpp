#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Vector3 kUpwards(0, 0, 1);
const Vector3 kAside(1, 0, 0);

/// The normal of each corner of each face of an OBJ file, looked up without the code under test.
std::vector<std::vector<Vector3>> cornerNormals(const std::string& text)
{
  std::vector<Vector3> normals;
  std::vector<std::vector<long>> references;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "vn") {
      Vector3 normal;
      words >> normal.x() >> normal.y() >> normal.z();
      normals.push_back(normal);
    } else if (word == "f") {
      references.emplace_back();
      for (std::string corner; words >> corner;) {
        const long number = std::stol(corner.substr(corner.rfind('/') + 1));
        references.back().push_back(number < 0 ? static_cast<long>(normals.size()) + number : number - 1);
      }
    }
  }
  std::vector<std::vector<Vector3>> result;
  for (const std::vector<long>& face : references) {
    result.emplace_back();
    for (const long n : face) result.back().push_back(normals.at(static_cast<std::size_t>(n)));
  }
  return result;
}

/// Two unit squares in z = 0 side by side, five units apart.
const std::string kTwoSquares = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n";

/// With the second square upright, so that its normal is (1, 0, 0).
std::string withTheSecondUpright(const std::string& text, std::vector<std::string>* notes = nullptr)
{
  const MeshDocument document = readObj(text, "");
  Positions positions = document.mesh.positions;
  for (Index v = 4; v < 8; ++v) positions.row(v) = Vector3(5, positions(v, 1), 5 - positions(v, 0));
  const Serialized written = document.source->withPositions(document.mesh, positions);
  if (notes != nullptr) *notes = written.notes;
  return written.bytes;
}

TEST(SplitNormals, CornersThatRestKeepTheOneThatTheyShare)
{
  std::vector<std::string> notes;
  const std::string written =
      withTheSecondUpright(kTwoSquares + "vn 0 0 1.0\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1 8//1\n", &notes);
  EXPECT_THAT(written, HasSubstr("vn 0 0 1.0\nvn 1 0 0\nf 1//1 2//1 3//1 4//1\nf 5//2 6//2 7//2 8//2\n"));
  EXPECT_THAT(notes, ElementsAre("1 normal added, because corners that moved shared one with others"));
}

TEST(SplitNormals, ReferencesThatCountBackGoOnNamingTheSame)
{
  const std::string written =
      withTheSecondUpright(kTwoSquares + "vn 0 1 0\nvn 0 0 1\nf 5//-1 6//-1 7//-1 8//-1\nf 1//-1 2//-1 3//-1 4//-2\n");
  const auto normals = cornerNormals(written);
  EXPECT_THAT(normals[0], testing::Each(kAside));
  EXPECT_THAT(normals[1], ElementsAre(kUpwards, kUpwards, kUpwards, Vector3(0, 1, 0)));
}

TEST(SplitNormals, LinesBetweenObjectsCountOnAfterwards)
{
  // Each object has its own normals, and no face refers to a line below it.
  const std::string written = withTheSecondUpright(
      kTwoSquares + "o a\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1 8//1\no b\nvn 0 1 0\nf 1//2 3//2 4//2\n");
  EXPECT_THAT(written, HasSubstr("o a\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1 4//1\nf 5//2 6//2 7//2 8//2\n"));
  EXPECT_THAT(written, HasSubstr("o b\nvn 0 1 0\nf 1//3 3//3 4//3\n"));
}

TEST(SplitNormals, ANormalBelowItsFacesIsFollowedByTheOthers)
{
  const auto normals = cornerNormals(kTwoSquares + "vn 0 0 1\nf 1//1 2//1 3//1\n");
  EXPECT_THAT(normals[0], testing::Each(kUpwards));
  const std::string written =
      withTheSecondUpright("f 5//1 6//1 7//1 8//1\nf 1//1 2//1 3//1 4//1\n" + kTwoSquares + "vn 0 0 1");
  EXPECT_TRUE(written.starts_with("f 5//2 6//2 7//2 8//2\nf 1//1 2//1 3//1 4//1\n"));
  EXPECT_TRUE(written.ends_with("vn 0 0 1\nvn 1 0 0"));
}

TEST(SplitNormals, EverythingElseStaysInItsPlace)
{
  const std::string written =
      withTheSecondUpright("# plate\r\n" + kTwoSquares +
                           "vt 0 0\nvn 0 0 1 # up\r\ng a\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf 5/1/1 \\\n 6/1/1 7/1/1 8/1/1\n");
  EXPECT_THAT(written, HasSubstr("vt 0 0\nvn 0 0 1 # up\r\nvn 1 0 0\r\ng a\nf 1/1/1 2/1/1 3/1/1 4/1/1\n"
                                 "f 5/1/2 \\\n 6/1/2 7/1/2 8/1/2\n"));
}

TEST(SplitNormals, LinesEndAsThoseOfTheFile)
{
  std::string text = kTwoSquares + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1 8//1\n";
  std::ranges::replace(text, '\n', '\r');
  EXPECT_THAT(withTheSecondUpright(text), HasSubstr("\rvn 0 0 1\rvn 1 0 0\rf 1//1 2//1"));
}

TEST(SplitNormals, WhereAllCornersMoveTheLineIsReplaced)
{
  const std::string written =
      withTheSecondUpright(kTwoSquares + "vn 0 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 5//2 6//2 8//2\n");
  EXPECT_THAT(written, HasSubstr("vn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 5//2 6//2 8//2\n"));
}

/// Quads along x, all with one normal; those beyond x = 2 go uphill.
TEST(SplitNormals, ABentStripIsSmoothAndRestsWhereItWasHeld)
{
  std::string text;
  for (int x = 0; x <= 4; ++x) text += fmt::format("v {} 0 0\nv {} 1 0\n", x, x);
  text += "vn 0 0 1\n";
  for (int k = 1; k < 9; k += 2) text += fmt::format("f {}//1 {}//1 {}//1 {}//1\n", k, k + 2, k + 3, k + 1);
  const MeshDocument document = readObj(text, "");
  Positions positions = document.mesh.positions;
  for (Index v = 6; v < 10; ++v) positions(v, 2) = positions(v, 0) - 2;
  const auto normals = cornerNormals(document.source->withPositions(document.mesh, positions).bytes);
  const Vector3 uphill = Vector3(-1, 0, 1).normalized();
  EXPECT_THAT(normals[0], testing::Each(kUpwards));
  EXPECT_THAT(normals[1], testing::Each(kUpwards));
  for (const Vector3& normal : normals[3]) EXPECT_TRUE(normal.isApprox(uphill, 1e-15));
  // The quad that leaves the flat part begins between both.
  EXPECT_TRUE(normals[2][0].isApprox((Vector3(-1, 0, 1) + kUpwards).normalized(), 1e-15));
  EXPECT_TRUE(normals[2][1].isApprox(uphill, 1e-15));
}

TEST(SplitNormals, WhatMovesInItsPlaneSharesOnAndAddsNoLine)
{
  const std::string text = kTwoSquares + "vn 0 0 1.0\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1 8//1\n";
  const MeshDocument document = readObj(text, "");
  Positions positions = document.mesh.positions;
  positions.bottomRows(4).col(0).array() += 1;
  const Serialized written = document.source->withPositions(document.mesh, positions);
  EXPECT_THAT(written.bytes, HasSubstr("vn 0 0 1.0\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 7//1 8//1\n"));
  EXPECT_THAT(written.notes, testing::IsEmpty());
}

TEST(SplitNormals, AFaceWithoutAreaKeepsTheSharedOne)
{
  const MeshDocument document = readObj(kTwoSquares + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 8//1\n", "");
  Positions positions = document.mesh.positions;
  positions.row(7) = Vector3(7, 0, 0);
  const Serialized written = document.source->withPositions(document.mesh, positions);
  EXPECT_THAT(written.bytes, HasSubstr("vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 5//1 6//1 8//1\n"));
  EXPECT_THAT(written.notes, ElementsAre(HasSubstr("1 normal kept from before")));
}

TEST(SplitNormals, WhatIsWrittenIsReadAgain)
{
  const std::string written =
      withTheSecondUpright(kTwoSquares + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 5//-1 6//-1 7//-1 8//-1\n");
  const MeshDocument again = readObj(written, "");
  EXPECT_THAT(again.remarks, testing::IsEmpty());
  EXPECT_EQ(again.source->withPositions(again.mesh, again.mesh.positions).bytes, written);
}

}  // namespace
}  // namespace holdfast
