#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/mesh_file.h>

#include "support/mesh_examples.h"
#include "support/random.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::MeshExample;
using test::Spelling;

bool hasSameDoubles(const Positions& a, const Positions& b)
{
  return a.rows() == b.rows() && std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0;
}

class MeshRoundTrip : public testing::TestWithParam<MeshExample> {
 protected:
  [[nodiscard]] MeshDocument read(const std::string& bytes) const
  {
    return readMesh(folder_.file("mesh" + GetParam().extension, bytes));
  }

  /// In-plane positions whose doubles are hard to write: every normal stays (0, 0, 1).
  [[nodiscard]] static Positions hardPositions()
  {
    Positions positions = GetParam().rest;
    positions.col(0).array() += GetParam().holdsDoubles ? 0.1 : 0.125;
    positions.col(1) *= GetParam().holdsDoubles ? 1.0 / 3.0 : 0.75;
    positions.col(1).array() += 0.25;
    positions.col(2).setConstant(-0.0);
    if (GetParam().holdsDoubles) {
      positions(0, 1) = std::numeric_limits<double>::denorm_min();
      positions(1, 1) = -5e-310;
      positions(2, 1) = 0.30000000000000004;
    }
    return positions;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_P(MeshRoundTrip, ReadsPositionsAndFaces)
{
  const MeshDocument document = read(GetParam().file());
  EXPECT_EQ(document.mesh.positions, GetParam().rest);
  EXPECT_EQ(document.mesh.faces, GetParam().faces);
}

TEST_P(MeshRoundTrip, SamePositionsGiveTheSameBytes)
{
  const MeshDocument document = read(GetParam().file());
  const Serialized same = serializeMesh(document, document.mesh.positions, GetParam().extension);
  EXPECT_EQ(same.bytes, GetParam().file());
  EXPECT_THAT(same.notes, testing::IsEmpty());
}

TEST_P(MeshRoundTrip, OtherPositionsChangeNothingElse)
{
  const MeshDocument document = read(GetParam().file());
  const Serialized other = serializeMesh(document, hardPositions(), GetParam().extension);
  EXPECT_EQ(other.bytes, GetParam().bytes(hardPositions(), Spelling::AsWritten));
}

TEST_P(MeshRoundTrip, DoublesSurviveToTheLastBit)
{
  const MeshDocument document = read(GetParam().file());
  const MeshDocument again = read(serializeMesh(document, hardPositions(), GetParam().extension).bytes);
  EXPECT_TRUE(hasSameDoubles(again.mesh.positions, hardPositions()));
  EXPECT_EQ(again.mesh.faces, GetParam().faces);
}

TEST_P(MeshRoundTrip, AnyPositionsSurviveToTheLastBit)
{
  test::Random random(4711);
  const MeshDocument document = read(GetParam().file());
  for (int trial = 0; trial < 20; ++trial) {
    Positions positions = GetParam().rest;
    for (double& x : positions.reshaped()) {
      x = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.integer(-60, 60)));
      if (!GetParam().holdsDoubles) x = static_cast<double>(static_cast<float>(x));
    }
    const Serialized written = serializeMesh(document, positions, GetParam().extension);
    const MeshDocument again = read(written.bytes);
    ASSERT_TRUE(hasSameDoubles(again.mesh.positions, positions));
    ASSERT_EQ(again.mesh.faces, GetParam().faces);
    ASSERT_EQ(serializeMesh(again, positions, GetParam().extension).bytes, written.bytes);
  }
}

using TextMeshRoundTrip = MeshRoundTrip;

TEST_P(TextMeshRoundTrip, OneMovedVertexKeepsTheTokensOfTheOthers)
{
  const MeshDocument document = read(GetParam().file());
  Positions positions = GetParam().rest;
  positions(4, 0) = 2.5;
  const std::string written = serializeMesh(document, positions, GetParam().extension).bytes;
  std::string expected = GetParam().bytes(positions, Spelling::AsRead);
  for (auto at = expected.find("+2.5000"); at != std::string::npos; at = expected.find("+2.5000"))
    expected.replace(at, 7, "2.5");
  for (auto at = expected.find(" float x"); at != std::string::npos; at = expected.find(" float x"))
    for (const char* word : {" float x", " float y", " float z"}) expected.replace(expected.find(word), 6, " double");
  EXPECT_EQ(written, expected);
}

std::vector<MeshExample> textExamples()
{
  std::vector<MeshExample> examples;
  for (const MeshExample& example : test::meshExamples())
    if (example.isText) examples.push_back(example);
  return examples;
}

INSTANTIATE_TEST_SUITE_P(Formats, TextMeshRoundTrip, testing::ValuesIn(textExamples()),
                         testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Formats, MeshRoundTrip, testing::ValuesIn(test::meshExamples()),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace holdfast
