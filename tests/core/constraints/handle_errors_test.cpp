#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/words/error.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::hold;
using testing::HasSubstr;

const std::string kIds = R"({"type": "handle", "select": {"vertices": [7, 3, 5]}, )";
const std::string kPart = R"({"type": "handle", "select": {"component": 0}, )";
const std::string kThree = R"("targets": [[0,0,0], [1,0,0], [0,1,0]])";

void expectHandleRefused(const std::string& handle, const std::string& key, const std::string& words)
{
  SCOPED_TRACE(handle);
  try {
    static_cast<void>(parseConstraintsJson(
        R"({"format": "holdfast-constraints", "version": 1, "constraints": [)" + handle + "]}", "c.json"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "c.json");
    EXPECT_EQ(error.location().element, "constraints[0]" + key);
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
}

TEST(HandleErrors, MotionsExcludeOneAnother)
{
  const std::string rotate = R"("rotate": {"axis": [0,0,1], "degrees": 9})";
  const std::string frame = R"("frame": {"to": {}})";
  const std::string turn = R"("turn": "about-fixed")";
  expectHandleRefused(kIds + rotate + ", " + frame + "}", "", R"("rotate", "frame" exclude one another)");
  expectHandleRefused(kIds + rotate + ", " + turn + R"(, "translate": [0,0,1]})", "", R"("rotate", "turn" exclude)");
  expectHandleRefused(kIds + turn + ", " + kThree + "}", "", R"("turn", "targets" exclude one another)");
  expectHandleRefused(kIds + frame + ", " + kThree + "}", "", R"("frame", "targets" exclude one another)");
  expectHandleRefused(kIds + R"("enabled": true})", "", R"("turn", "frame", "targets", "rotations")");
}

TEST(HandleErrors, TurnIsAboutFixedAndHasATranslation)
{
  expectHandleRefused(kPart + R"("turn": "about-fix", "translate": [0,0,1]})", ".turn",
                      R"(unknown way to turn "about-fix"; did you mean "about-fixed"?)");
  expectHandleRefused(kPart + R"("turn": 90, "translate": [0,0,1]})", ".turn", "text in double quotes");
  expectHandleRefused(kPart + R"("turn": "about-fixed"})", ".turn", R"(add "translate")");
}

TEST(HandleErrors, TurnNearIsATurnBesideTurn)
{
  const std::string head = kPart + R"("turn": "about-fixed", "translate": [0,0,1], "turn_near": )";
  expectHandleRefused(head + R"({"degrees": 190}})", ".turn_near", R"("axis" is missing)");
  expectHandleRefused(head + R"({"axis": [0,0,0], "degrees": 190}})", ".turn_near.axis", "cannot be zero");
  expectHandleRefused(head + R"({"axis": [0,0,1], "degrees": 190, "turns": 1}})", ".turn_near.turns", "Known here");
  expectHandleRefused(kPart + R"("translate": [0,0,1], "turn_near": {"axis": [0,0,1], "degrees": 190}})", ".turn_near",
                      R"(add "turn": "about-fixed")");
}

TEST(HandleErrors, FramesHaveTwoAxes)
{
  const std::string head = kPart + R"("frame": )";
  expectHandleRefused(head + R"({"from": {}}})", ".frame", R"("to" is missing)");
  expectHandleRefused(head + R"({"to": {"z": [0,0,1]}}})", ".frame.to.z", R"(Known here: "origin", "x", "y")");
  expectHandleRefused(head + R"({"to": {}, "turn": 1}})", ".frame.turn", R"(did you mean "turns"?)");
  expectHandleRefused(head + R"({"to": {"x": [0,0,0]}}})", ".frame.to.x", "cannot be zero");
  expectHandleRefused(head + R"({"from": {"y": [0,0,0]}, "to": {}}})", ".frame.from.y", "cannot be zero");
  expectHandleRefused(head + R"({"to": {"x": [0,2,0]}}})", ".frame.to.y", R"(parallel to "x")");
  expectHandleRefused(head + R"({"from": {"x": [3,0,0], "y": [-1,1e-9,0]}, "to": {}}})", ".frame.from.y",
                      R"(parallel to "x")");
  expectHandleRefused(head + R"({"to": {"origin": [1,2]}}})", ".frame.to.origin", "[x, y, z]");
}

TEST(HandleErrors, WholeTurnsNeedAnAxis)
{
  const std::string head = kPart + R"("frame": )";
  expectHandleRefused(head + R"({"to": {"origin": [1,2,3]}, "turns": 1}})", ".frame.turns",
                      R"(no axis to turn about; use "rotate")");
  expectHandleRefused(head + R"({"to": {"x": [0,1,0], "y": [-1,0,0]}, "turns": 0.5}})", ".frame.turns",
                      "not an integer");
}

TEST(HandleErrors, TargetsAndRotationsHaveOneEntryForEachListedVertex)
{
  const std::string turn = R"({"axis": [0,0,1], "degrees": 9})";
  const std::string repeated = R"({"type": "handle", "select": {"vertices": [7, 3, 7]}, )";
  expectHandleRefused(kPart + kThree + "}", ".select", R"("targets" has one entry for each vertex of a list)");
  expectHandleRefused(kIds + R"("targets": [[0,0,0], [1,0,0]]})", ".targets", "2 entries for the 3 vertices");
  expectHandleRefused(kIds + R"("targets": []})", ".targets", "empty");
  expectHandleRefused(kIds + R"("targets": [[0,0,0], [1,0], [2,0,0]]})", ".targets[1]", "[x, y, z]");
  expectHandleRefused(repeated + kThree + "}", ".select.vertices[2]", "vertex 7 is in this list already");
  expectHandleRefused(R"({"type": "handle", "select": {"vertices": [7, 3]}, "targets": [[0,0,0], [1,0,0]]})",
                      ".targets", R"(at least 3 vertices say how a handle turns, this one has 2)");
  expectHandleRefused(kPart + R"("translate": [0,0,1], "rotations": [)" + turn + "]}", ".select",
                      R"("rotations" has one entry)");
  expectHandleRefused(kIds + R"("translate": [0,0,1], "rotations": [)" + turn + "]}", ".rotations",
                      "1 entry for the 3 vertices");
  expectHandleRefused(repeated + R"("rotations": [)" + turn + "," + turn + "," + turn + "]}", ".select.vertices[2]",
                      R"("rotations" has one entry for each vertex)");
  expectHandleRefused(kIds + R"("rotations": [{"axis": [0,0,0], "degrees": 1}]})", ".rotations[0].axis",
                      "cannot be zero");
  expectHandleRefused(kIds + R"("rotations": [{"axis": [0,0,1], "degrees": 1, "center": [0,0,0]}]})",
                      ".rotations[0].center", "unknown key");
}

void expectListUnusable(const ConstraintList& list, const std::string& element, const std::string& words)
{
  try {
    static_cast<void>(test::systemOf(test::grid(2, 2), list));
    ADD_FAILURE() << "taken for good";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().element, element);
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
}

/// On a grid of 2 x 2 squares whose corner (0, 0) is fixed.
void expectUnusable(const HandleConstraint& handle, const std::string& key, const std::string& words)
{
  expectListUnusable(test::listOf({hold({0}), {"", true, handle}}), "constraints[1]" + key, words);
}

HandleConstraint aboutFixed(Index vertex, const Vector3& translate)
{
  return {{VertexIds{{vertex}}}, RotationAboutFixed{}, translate, {}};
}

TEST(HandleErrors, AboutFixedNeedsADirectionBeforeAndAfter)
{
  expectListUnusable(test::listOf({{"", true, aboutFixed(8, {0, 0, 1})}}), "constraints[0].turn",
                     R"("P0": nothing is fixed that the handle could turn about; add a constraint of type "fixed")");
  expectUnusable(aboutFixed(0, {0, 0, 1}), ".turn", "lies at that of the fixed vertices at rest");
  expectUnusable(aboutFixed(8, {-2, -2, 0}), ".turn", R"(lies at that of the fixed vertices after "translate")");
  expectUnusable(aboutFixed(8, {-4, -4, 0}), ".turn", R"(say which by "turn_near")");
  HandleConstraint along = aboutFixed(8, {-4, -4, 0});
  along.motion = RotationAboutFixed{AxisAngle{{1, 1, 0}, 180}};
  expectUnusable(along, ".turn", R"(say which by "turn_near")");
}

TEST(HandleErrors, DisabledHandlesNeedNothingFixed)
{
  ConstraintList list = test::listOf({{"", true, aboutFixed(8, {0, 0, 1})}});
  list.constraints[0].isEnabled = false;
  EXPECT_TRUE(test::systemOf(test::grid(2, 2), list).rows.empty());
}

TEST(HandleErrors, PlacesStayWithinTheRangeOfDoubles)
{
  HandleConstraint far{{VertexIds{{1, 4, 8}}}, {}, Vector3(1e308, 0, 0), {}};
  expectUnusable(far, "", "too large for doubles");
  far.motion = VertexTargets{{{1.5e308, 0, 0}, {0, 1.5e308, 0}, {0, 0, 0}}};
  expectUnusable(far, "", "too large for doubles");
}

TEST(HandleErrors, OfListsThatWereNotReadAreFoundToo)
{
  HandleConstraint handle{{VertexIds{{1, 4, 8}}}, {}, Vector3(0, 0, 1), {}};
  handle.motion = VertexTargets{{{0, 0, 0}, {1, 1, 1}}};
  expectUnusable(handle, ".targets", "2 entries for the 3 vertices");
  handle.motion = FrameMotion{{}, {std::nullopt, {0, 0, 0}, {0, 1, 0}}, 0};
  expectUnusable(handle, ".frame.to.x", "cannot be zero");
  handle.motion = std::monostate{};
  handle.rotations.resize(4);
  expectUnusable(handle, ".rotations", "4 entries for the 3 vertices");
  handle.select = {AllOf{}};
  expectUnusable(handle, ".select", R"(select by "vertices")");
}

}  // namespace
}  // namespace holdfast
