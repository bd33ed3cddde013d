// The judge is judged: what it passes, and the slightest damage that it must not pass.

#include "support/residual_verifier.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/batch.h"
#include "support/meshes.h"

namespace holdfast::test {
namespace {

class ResidualVerifier : public BatchTest {
 protected:
  /// A deformed sphere, and constraints that hold at vertex 7, edge 8 to 9, a face, and two selections.
  ResidualVerifier() { EXPECT_EQ(runBatch(deform(mesh(), constraints())).exitCode, 0); }

  /// The deformed mesh with a coordinate of one vertex multiplied by `factor`.
  [[nodiscard]] std::filesystem::path damaged(std::size_t vertex, double factor) const
  {
    PlainMesh plain = readPlainMesh(output("out.obj"));
    plain.positions.at(vertex)[2] *= factor;
    std::ostringstream text;
    text << std::setprecision(17);
    for (const PlainPoint& p : plain.positions) text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& face : plain.faces)
      text << "f " << face[0] + 1 << ' ' << face[1] + 1 << ' ' << face[2] + 1 << '\n';
    return out_.file("damaged.obj", text.str());
  }

  /// The vertex furthest down, which is fixed; furthest up, which a handle moves.
  [[nodiscard]] std::size_t extreme(double sign) const
  {
    const PlainMesh plain = readPlainMesh(mesh());
    const auto furthest =
        std::max_element(plain.positions.begin(), plain.positions.end(),
                         [sign](const PlainPoint& a, const PlainPoint& b) { return sign * a[2] < sign * b[2]; });
    return static_cast<std::size_t>(furthest - plain.positions.begin());
  }
};

TEST_F(ResidualVerifier, PassesWhatIsMet)
{
  const auto verdict = meetsConstraints(mesh(), output("out.obj"), constraints());
  EXPECT_TRUE(verdict);
  EXPECT_TRUE(meetsConstraints(mesh(), damaged(0, 1), constraints()));
}

TEST_F(ResidualVerifier, FailsWhenACoordinateChangesInTheTenthDigit)
{
  EXPECT_FALSE(meetsConstraints(mesh(), damaged(extreme(-1), 1 + 1e-10), constraints()));
  EXPECT_FALSE(meetsConstraints(mesh(), damaged(extreme(1), 1 + 1e-10), constraints()));
}

TEST_F(ResidualVerifier, FailsWhenAFixedVertexChangesInTheLastBit)
{
  const auto verdict = meetsConstraints(mesh(), damaged(extreme(-1), 1 + 2.3e-16), constraints());
  EXPECT_FALSE(verdict);
  EXPECT_THAT(verdict.message(), testing::HasSubstr("not copied: \"low\""));
}

TEST_F(ResidualVerifier, FailsWhenACoordinateIsNoNumber)
{
  EXPECT_FALSE(meetsConstraints(mesh(), damaged(extreme(-1), std::nan("")), constraints()));
}

TEST_F(ResidualVerifier, FailsWhenFacesDiffer)
{
  std::ofstream(output("out.obj"), std::ios::app) << "f 1 2 3\n";
  EXPECT_FALSE(meetsConstraints(mesh(), output("out.obj"), constraints()));
}

TEST_F(ResidualVerifier, FailsForTheMeshAtRest)
{
  EXPECT_FALSE(meetsConstraints(mesh(), mesh(), constraints()));
}

/// A constraint of every kind alone, each on a mesh that meets it but for one coordinate.
TEST_F(ResidualVerifier, MeasuresEveryKindOfPoint)
{
  const std::vector<std::pair<std::string, double>> cases{
      {R"({"type": "fixed", "name": "c", "select": {"vertices": [4]}})", 1},
      {R"({"type": "handle", "name": "c", "select": {"vertices": [4]}, "translate": [0, 0, 0]})", 1},
      {R"({"type": "handle", "name": "c", "select": {"vertices": [4]}, "rotate": {"axis": [1, 2, 3], "degrees": 720}})",
       1},
      {R"({"type": "point", "name": "c", "at": {"vertex": 4}, "move": [0, 0, 0]})", 1},
      {R"({"type": "point", "name": "c", "at": {"edge": [4, 5], "t": 0.25}, "move": [0, 0, 0]})", 0.25},
      {R"({"type": "point", "name": "c", "at": {"edge": [5, 4], "t": 0.25}, "move": [0, 0, 0]})", 0.75},
      {R"({"type": "point", "name": "c", "at": {"face": 4, "weights": [0.5, 0.3, 0.2]}, "move": [0, 0, 0]})", 0.3}};
  const PlainMesh rest = readPlainMesh(mesh());
  for (const auto& [constraint, weight] : cases) {
    const auto file = in_.file("one.json", constraintText({constraint}));
    PlainMesh moved = rest;
    EXPECT_EQ(verify(rest, moved, file, {}).largest < 1e-15, true) << constraint;
    const long vertex = constraint.find("face") == std::string::npos ? 4 : rest.faces[4][1];
    moved.positions[vertex][1] += 1e-6;
    const Verification found = verify(rest, moved, file, {});
    EXPECT_NEAR(found.largest, weight * 1e-6, 1e-15) << constraint;
    EXPECT_EQ(found.points, 1) << constraint;
    EXPECT_EQ(found.worst, "c");
  }
}

/// Handles of two vertices beside a fixed one, and where they go.
class VerifierOfHandles : public testing::Test {
 protected:
  [[nodiscard]] Verification verified(const std::string& motion, const PlainPoint& first, const PlainPoint& second)
  {
    const auto file = in_.file(
        "handle.json",
        constraintText({R"({"type": "fixed", "name": "f", "select": {"vertices": [0]}})",
                        R"({"type": "fixed", "name": "g", "select": {"vertices": [0, 1]}})",
                        R"({"type": "handle", "name": "h", "select": {"vertices": [3, 2]}, )" + motion + "}"}));
    PlainMesh moved = rest_;
    moved.positions[3] = first;
    moved.positions[2] = second;
    return verify(rest_, moved, file, {});
  }

  /// The places are right, and others are not.
  void expectPlaces(const std::string& motion, const PlainPoint& first, const PlainPoint& second)
  {
    SCOPED_TRACE(motion);
    EXPECT_LT(verified(motion, first, second).largest, 1e-14);
    const Verification exchanged = verified(motion, second, first);
    EXPECT_GT(exchanged.largest, 1);
    EXPECT_EQ(exchanged.worst, "h");
    EXPECT_NEAR(verified(motion, first, {second[0], second[1] + 1e-6, second[2]}).largest, 1e-6, 1e-14);
  }

  // The centroids of what is fixed and of the handle are (0, 0, 0) and (4, 0, 0).
  PlainMesh rest_{{{-1, 0, 0}, {1, 0, 0}, {5, -1, 0}, {3, 1, 0}}, {{0, 1, 2}, {1, 2, 3}}};
  TemporaryFolder in_;
};

TEST_F(VerifierOfHandles, KnowsTheTurnAboutWhatIsFixed)
{
  // A quarter turn about z; then out of it.
  expectPlaces(R"("turn": "about-fixed", "translate": [-4, 4, 0])", {-1, 3, 0}, {1, 5, 0});
  expectPlaces(R"("turn": "about-fixed", "translate": [4, 0, 0])", {7, 1, 0}, {9, -1, 0});
}

TEST_F(VerifierOfHandles, KnowsFrames)
{
  expectPlaces(R"("frame": {"to": {"x": [0, 2, 0], "y": [-1, 5, 0]}})", {3, -1, 0}, {5, 1, 0});
  expectPlaces(R"("frame": {"to": {"x": [0, 2, 0], "y": [-1, 5, 0]}, "turns": 2}, "translate": [0, 0, 1])", {3, -1, 1},
               {5, 1, 1});
  expectPlaces(
      R"("frame": {"from": {"origin": [3, 1, 1], "x": [0, 0, 1], "y": [1, 0, 0]}, "to": {"origin": [0, 0, 7]}})",
      {-1, 0, 7}, {-1, 2, 5});
}

TEST_F(VerifierOfHandles, KnowsTargetsInTheOrderOfTheIdsAndBitForBit)
{
  const std::string targets = R"("targets": [[0.1, 7, 8], [9, 0.2, 4]])";
  expectPlaces(targets, {0.1, 7, 8}, {9, 0.2, 4});
  EXPECT_TRUE(verified(targets, {0.1, 7, 8}, {9, 0.2, 4}).inexact.empty());
  EXPECT_EQ(verified(targets, {std::nextafter(0.1, 1), 7, 8}, {9, 0.2, 4}).inexact, std::set<std::string>{"h"});
  expectPlaces(R"("targets": [[0.1, 7, 8], [9, 0.2, 4]], "translate": [0.2, 0, -1])", {0.1 + 0.2, 7, 7}, {9.2, 0.2, 3});
}

TEST_F(VerifierOfHandles, DoesNotPassOverKeysThatItDoesNotKnow)
{
  EXPECT_THROW(static_cast<void>(verified(R"("stretch": 2)", {3, 1, 0}, {5, -1, 0})), std::runtime_error);
}

/// What holdfast-batch writes for each, and that it is not what the others ask for.
TEST_F(ResidualVerifier, TellsTheMotionsOfHandlesApart)
{
  const std::string low =
      R"({"type": "fixed", "name": "low", "select": {"halfspace": {"point": [0, 0, -0.8], "normal": [0, 0, -1]}}})";
  const std::string high = R"({"type": "handle", "name": "high", "select": {"vertices": [0, 5, 11, 40]}, )";
  std::vector<std::string> files;
  for (const char* const motion :
       {R"("translate": [0.3, 0.2, 0.4])", R"("translate": [0.3, 0.2, 0.4], "turn": "about-fixed")",
        R"("translate": [0.3, 0.2, 0.4], "rotate": {"axis": [1, 2, 3], "degrees": 400})",
        R"("frame": {"from": {"x": [1, 1, 0]}, "to": {"origin": [1, 1, 1], "y": [0.5, -3, 1]}, "turns": -1})",
        R"("targets": [[1, 0, 2], [0, 1.1, 2], [-1, 0, 2.3], [0.2, -1, 2]])",
        R"("translate": [0.3, 0.2, 0.4], "scale": [1, 0.5, 2])",
        R"("frame": {"from": {"x": [1, 1, 0]}, "to": {"y": [0.5, -3, 1]}}, "scale": [3, 1, 1])"})
    files.push_back(
        in_.file(std::to_string(files.size()) + ".json", constraintText({low, high + motion + "}"})).string());
  for (const std::string& file : files) {
    ASSERT_EQ(runBatch(deform(mesh(), file)).exitCode, 0) << file;
    for (const std::string& other : files)
      EXPECT_EQ(meetsConstraints(mesh(), output("out.obj"), other), file == other) << file << ", " << other;
  }
}

TEST_F(ResidualVerifier, MeasuresHowFarPartnersAreFromBeingImages)
{
  const PlainMesh rest = readPlainMesh(mesh());
  const auto file = in_.file(
      "mirror.json",
      constraintText({R"({"type": "mirror", "name": "c", "plane": {"point": [0, 0, 0], "normal": [0, 0, 2]}})"}));
  EXPECT_LT(verify(rest, rest, file, {}).largest, 1e-15);
  EXPECT_EQ(verify(rest, rest, file, {}).points, static_cast<long>(rest.positions.size()));
  PlainMesh moved = rest;
  moved.positions[4][1] += 1e-3;
  EXPECT_NEAR(verify(rest, moved, file, {}).largest, 1e-3, 1e-15);
  const auto listed = in_.file("listed.json", constraintText({R"({"type": "mirror", "name": "c", "pairs": [[4, 4]],
                                                                  "plane": {"point": [0, 0, 0], "normal": [0, 0, 2]}})"}));
  EXPECT_NEAR(verify(rest, moved, listed, {}).largest, 2 * std::abs(moved.positions[4][2]), 1e-15);
}

TEST_F(ResidualVerifier, MeasuresDistancesThatAreToBeKept)
{
  const PlainMesh rest = readPlainMesh(mesh());
  PlainMesh moved = rest;
  moved.positions[4][1] += 1e-3;
  const auto length = [](const PlainMesh& at) {
    const PlainPoint& p = at.positions[4];
    const PlainPoint& q = at.positions[5];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for (const char* constraint : {R"({"type": "rigid", "name": "c", "select": {"vertices": [4, 5]}})",
                                 R"({"type": "relative", "name": "c", "from": {"vertex": 4}, "to": {"vertex": 5}})"}) {
    const auto file = in_.file("one.json", constraintText({constraint}));
    EXPECT_EQ(verify(rest, rest, file, {}).largest, 0) << constraint;
    const Verification found = verify(rest, moved, file, {});
    EXPECT_NEAR(found.largest, std::abs(length(moved) - length(rest)), 1e-15) << constraint;
    EXPECT_GT(found.largest, 1e-6) << constraint;
    EXPECT_EQ(found.points, 1) << constraint;
  }
}

}  // namespace
}  // namespace holdfast::test
