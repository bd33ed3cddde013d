#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ConstraintList parsed(const std::string& constraints)
{
  return parseConstraintsJson(
      R"({"format": "holdfast-constraints", "version": 1, "constraints": [)" + constraints + "]}", "c.json");
}

template <class T>
T only(const std::string& constraint)
{
  return std::get<T>(parsed(constraint).constraints.at(0).what);
}

template <class T>
T selected(const std::string& selection)
{
  return std::get<T>(only<FixedConstraint>(R"({"type": "fixed", "select": )" + selection + "}").select.what);
}

template <class T>
T located(const std::string& location)
{
  return std::get<T>(only<PointConstraint>(R"({"type": "point", "at": )" + location + R"(, "target": [0,0,0]})").at);
}

TEST(ConstraintFile, ReadsEverySelection)
{
  EXPECT_THAT(selected<VertexIds>(R"({"vertices": [3, 0, 3]})").ids, ElementsAre(3, 0, 3));
  EXPECT_EQ(selected<InBox>(R"({"box": {"min": [-1,-2,-3], "max": [1,2,0.1]}})").min, Vector3(-1, -2, -3));
  EXPECT_EQ(selected<InBox>(R"({"box": {"min": [-1,-2,-3], "max": [1,2,0.1]}})").max, Vector3(1, 2, 0.1));
  EXPECT_EQ(selected<InSphere>(R"({"sphere": {"center": [1,2,3], "radius": 2}})").center, Vector3(1, 2, 3));
  EXPECT_EQ(selected<InSphere>(R"({"sphere": {"center": [1,2,3], "radius": 2}})").radius, 2);
  EXPECT_EQ(selected<InHalfSpace>(R"({"halfspace": {"point": [1,2,3], "normal": [0,0,-2]}})").point, Vector3(1, 2, 3));
  EXPECT_EQ(selected<InHalfSpace>(R"({"halfspace": {"point": [1,2,3], "normal": [0,0,-2]}})").normal,
            Vector3(0, 0, -2));
  EXPECT_EQ(selected<InComponent>(R"({"component": 4})").component, 4);
  const InsideCurve curve =
      selected<InsideCurve>(R"({"curve": {"through": [{"vertex": 3}, {"near": [1,2,3]}, {"vertex": 1}]}})");
  ASSERT_EQ(curve.through.size(), 3U);
  EXPECT_EQ(std::get<AtNear>(curve.through[1]).place, Vector3(1, 2, 3));
  EXPECT_EQ(curve.side, CurveSide::Smaller);
  const std::string three = R"([{"vertex": 3}, {"vertex": 2}, {"vertex": 1}])";
  EXPECT_EQ(selected<InsideCurve>(R"({"curve": {"side": "smaller", "through": )" + three + "}}").side,
            CurveSide::Smaller);
  EXPECT_EQ(selected<InsideCurve>(R"({"curve": {"through": )" + three + R"(, "side": "larger"}})").side,
            CurveSide::Larger);
  EXPECT_EQ(selected<AllOf>(R"({"all": [{"component": 4}, {"vertices": [1]}]})").parts.size(), 2U);
  EXPECT_EQ(selected<AnyOf>(R"({"any": [{"component": 4}]})").parts.size(), 1U);
  const NotIn none = selected<NotIn>(R"({"not": {"component": 4}})");
  EXPECT_EQ(std::get<InComponent>(none.part->what).component, 4);
  const Grown grown = selected<Grown>(R"({"grown": {"select": {"component": 4}, "rings": 3}})");
  EXPECT_EQ(std::get<InComponent>(grown.part->what).component, 4);
  EXPECT_EQ(grown.rings, 3);
}

TEST(ConstraintFile, ReadsEveryLocation)
{
  EXPECT_EQ(located<AtVertex>(R"({"vertex": 12})").vertex, 12);
  const AtEdge edge = located<AtEdge>(R"({"edge": [12, 13], "t": 0.25})");
  EXPECT_THAT((std::array{edge.i, edge.j}), ElementsAre(12, 13));
  EXPECT_EQ(edge.t, 0.25);
  const AtFace face = located<AtFace>(R"({"face": 77, "weights": [0.2, 0.3, 0.5]})");
  EXPECT_EQ(face.face, 77);
  EXPECT_THAT(face.weights, ElementsAre(0.2, 0.3, 0.5));
  EXPECT_EQ(located<AtNear>(R"({"near": [4.1, 0.2, 0.9]})").place, Vector3(4.1, 0.2, 0.9));
}

TEST(ConstraintFile, ReadsHandlesWithATurnAShiftOrBoth)
{
  const std::string head = R"({"type": "handle", "select": {"component": 0}, )";
  const HandleConstraint both = only<HandleConstraint>(
      head + R"("rotate": {"axis": [0,0,2], "degrees": 450, "center": [1,2,3]}, "translate": [0,0,2]})");
  const AxisRotation turn = std::get<AxisRotation>(both.motion);
  EXPECT_EQ(turn.axis, Vector3(0, 0, 2));
  EXPECT_EQ(turn.degrees, 450);
  EXPECT_EQ(turn.center, Vector3(1, 2, 3));
  EXPECT_EQ(both.translate, Vector3(0, 0, 2));
  const HandleConstraint rotated = only<HandleConstraint>(head + R"("rotate": {"axis": [0,0,1], "degrees": -90}})");
  EXPECT_FALSE(std::get<AxisRotation>(rotated.motion).center.has_value());
  EXPECT_EQ(rotated.translate, Vector3(0, 0, 0));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(only<HandleConstraint>(head + R"("translate": [0,0,2]})").motion));
}

TEST(ConstraintFile, ReadsHandlesThatTurnAboutTheFixedVertices)
{
  const HandleConstraint handle = only<HandleConstraint>(
      R"({"type": "handle", "select": {"component": 0}, "turn": "about-fixed", "translate": [0,0,2]})");
  EXPECT_FALSE(std::get<RotationAboutFixed>(handle.motion).near.has_value());
  EXPECT_EQ(handle.translate, Vector3(0, 0, 2));
  const HandleConstraint round =
      only<HandleConstraint>(R"({"type": "handle", "select": {"component": 0}, "turn": "about-fixed",
                                        "translate": [0,0,2], "turn_near": {"axis": [0,3,0], "degrees": 190}})");
  const std::optional<AxisAngle>& near = std::get<RotationAboutFixed>(round.motion).near;
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(near->axis, Vector3(0, 3, 0));
  EXPECT_EQ(near->degrees, 190);
}

TEST(ConstraintFile, ReadsHandlesThatGoFromFrameToFrame)
{
  const std::string head = R"({"type": "handle", "select": {"component": 0}, "frame": )";
  const auto full =
      std::get<FrameMotion>(only<HandleConstraint>(head + R"({"from": {"origin": [1,2,3], "x": [0,2,0], "y": [0,1,1]},
                              "to": {"origin": [4,5,6], "x": [0,0,1], "y": [3,0,0]}, "turns": -2}})")
                                .motion);
  EXPECT_EQ(full.from.origin, Vector3(1, 2, 3));
  EXPECT_EQ(full.from.x, Vector3(0, 2, 0));
  EXPECT_EQ(full.from.y, Vector3(0, 1, 1));
  EXPECT_EQ(full.to.origin, Vector3(4, 5, 6));
  EXPECT_EQ(full.to.x, Vector3(0, 0, 1));
  EXPECT_EQ(full.to.y, Vector3(3, 0, 0));
  EXPECT_EQ(full.turns, -2);
  const auto brief =
      std::get<FrameMotion>(only<HandleConstraint>(head + R"({"to": {"x": [0,1,0], "y": [-1,0,0]}}})").motion);
  EXPECT_FALSE(brief.from.origin.has_value());
  EXPECT_EQ(brief.from.x, Vector3(1, 0, 0));
  EXPECT_EQ(brief.from.y, Vector3(0, 1, 0));
  EXPECT_FALSE(brief.to.origin.has_value());
  EXPECT_EQ(brief.turns, 0);
}

TEST(ConstraintFile, ReadsTargetsAndRotationsOfSingleVertices)
{
  const HandleConstraint handle = only<HandleConstraint>(R"({"type": "handle", "select": {"vertices": [7, 3, 5]},
    "targets": [[1,2,3], [4,5,6], [7,8,9]],
    "rotations": [{"axis": [0,0,2], "degrees": 720}, {"axis": [1,0,0], "degrees": 0}, {"axis": [0,1,0], "degrees": -9}]})");
  EXPECT_THAT(std::get<VertexTargets>(handle.motion).places,
              ElementsAre(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9)));
  ASSERT_EQ(handle.rotations.size(), 3U);
  EXPECT_EQ(handle.rotations[0].axis, Vector3(0, 0, 2));
  EXPECT_EQ(handle.rotations[0].degrees, 720);
  EXPECT_EQ(handle.rotations[2].degrees, -9);
  EXPECT_EQ(only<HandleConstraint>(R"({"type": "handle", "select": {"vertices": [7]}, "translate": [1,2,3],
    "rotations": [{"axis": [0,0,2], "degrees": 720}]})")
                .rotations.size(),
            1U);
}

TEST(ConstraintFile, ReadsPointsThatGoToAPlaceOrByAShift)
{
  const std::string head = R"({"type": "point", "at": {"vertex": 1}, )";
  EXPECT_EQ(std::get<Target>(only<PointConstraint>(head + R"("target": [1,2,3]})").to).place, Vector3(1, 2, 3));
  EXPECT_EQ(std::get<Move>(only<PointConstraint>(head + R"("move": [1,2,3]})").to).shift, Vector3(1, 2, 3));
}

TEST(ConstraintFile, ReadsRelativesWithAndWithoutAnOffset)
{
  const std::string head = R"({"type": "relative", "from": {"vertex": 3}, "to": {"near": [0,1,0]})";
  EXPECT_FALSE(only<RelativeConstraint>(head + "}").offset.has_value());
  EXPECT_EQ(only<RelativeConstraint>(head + R"(, "offset": [1,2,3]})").offset, Vector3(1, 2, 3));
}

TEST(ConstraintFile, KeepsTheOrderAndNamesTheNamelessByTypeAndPlace)
{
  const ConstraintList list = parsed(R"({"type": "fixed", "select": {"component": 0}},
                                        {"type": "rigid", "name": "hole", "select": {"component": 0}, "enabled": false},
                                        {"type": "point", "at": {"vertex": 1}, "move": [0,0,1], "enabled": true})");
  ASSERT_EQ(list.constraints.size(), 3U);
  EXPECT_EQ(list.constraints[0].name, "fixed 1");
  EXPECT_EQ(list.constraints[1].name, "hole");
  EXPECT_EQ(list.constraints[2].name, "point 3");
  EXPECT_TRUE(list.constraints[0].isEnabled);
  EXPECT_FALSE(list.constraints[1].isEnabled);
  EXPECT_TRUE(list.constraints[2].isEnabled);
}

TEST(ConstraintFile, ReadsUnitsAndAnEmptyListAndAByteOrderMark)
{
  const ConstraintList list = parseConstraintsJson(
      "\xEF\xBB\xBF{\"constraints\": [], \"units\": \"mm\", \"version\": 1, \"format\": \"holdfast-constraints\"}\r\n",
      "c.json");
  EXPECT_EQ(list.units, "mm");
  EXPECT_TRUE(list.constraints.empty());
}

TEST(ConstraintFile, KeepsAllDigitsOfNumbersAndIds)
{
  EXPECT_EQ(
      located<AtNear>(R"({"near": [0.1000000000000000055511151231257827, 1e-300, 12345678901234567890123]})").place,
      Vector3(0.1, 1e-300, 12345678901234567890123.0));
  EXPECT_EQ(located<AtVertex>(R"({"vertex": 9223372036854775807})").vertex, std::numeric_limits<Index>::max());
}

TEST(ConstraintFile, TakesWeightsWhoseSumIsOneUpToRounding)
{
  EXPECT_EQ(located<AtFace>(R"({"face": 0, "weights": [0.3333333333333333, 0.3333333333333333, 0.3333333333333333]})")
                .weights.size(),
            3U);
  EXPECT_THROW(static_cast<void>(located<AtFace>(R"({"face": 0, "weights": [0.25, 0.25, 0.500000000002]})")),
               InputError);
}

std::string nestedNot(int depth)
{
  std::string selection = R"({"component": 0})";
  for (int level = 1; level < depth; ++level) selection = R"({"not": )" + selection + "}";
  return selection;
}

TEST(ConstraintFile, TakesSelectionsNestedToTheLimitAndNoDeeper)
{
  EXPECT_NO_THROW(static_cast<void>(selected<NotIn>(nestedNot(kMaximumSelectionDepth))));
  EXPECT_THROW(static_cast<void>(selected<NotIn>(nestedNot(kMaximumSelectionDepth + 1))), InputError);
  std::string all = R"({"box": {"min": [0,0,0], "max": [1,1,1]}})";
  for (int level = 1; level < kMaximumSelectionDepth; ++level) all = R"({"all": [)" + all + "]}";
  EXPECT_NO_THROW(static_cast<void>(selected<AllOf>(all)));
}

TEST(ConstraintFile, WrittenListReadsBackTheSame)
{
  test::Random random(201);
  for (int i = 0; i < 300; ++i) {
    const ConstraintList list = test::randomConstraintList(random, static_cast<int>(random.integer(0, 12)));
    const std::string text = constraintsToJson(list);
    EXPECT_TRUE(test::areSame(list, parseConstraintsJson(text, "c.json"))) << text;
  }
}

TEST(ConstraintFile, ComparisonOfListsSeesOneBit)
{
  test::Random random(202);
  ConstraintList list = test::randomConstraintList(random, 3);
  list.constraints.push_back({"last", true, PointConstraint{AtVertex{1}, Target{Vector3(1, 2, 0.0)}}});
  ConstraintList other = list;
  std::get<Target>(std::get<PointConstraint>(other.constraints.back().what).to).place.z() = -0.0;
  EXPECT_FALSE(test::areSame(list, other));
  EXPECT_TRUE(test::areSame(list, list));
}

TEST(ConstraintFile, WritesNumbersInTheirShortestForm)
{
  const ConstraintList list{"", {{"P", true, PointConstraint{AtVertex{1}, Target{Vector3(0.1, -2, 1e100)}}}}};
  EXPECT_THAT(constraintsToJson(list), HasSubstr(R"("target": [0.1, -2, 1e+100])"));
}

void expectNotWritable(const ConstraintList& list, const std::string& reason)
{
  try {
    static_cast<void>(constraintsToJson(list));
    FAIL() << "written, although " << reason;
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(reason));
  }
}

TEST(ConstraintFile, RefusesToWriteWhatItCouldNotRead)
{
  const Constraint point{"P", true, PointConstraint{AtVertex{1}, Target{Vector3(0, 0, 0)}}};
  expectNotWritable({"", {point, point}}, "names are unique");
  const double infinite = std::numeric_limits<double>::infinity();
  expectNotWritable({"", {{"P", true, PointConstraint{AtVertex{1}, Target{Vector3(0, infinite, 0)}}}}},
                    "constraints[0].target[1]");
  expectNotWritable({"", {{"", true, FixedConstraint{{InComponent{0}}}}}}, "empty");
  expectNotWritable({"", {{"\xFF", true, FixedConstraint{{InComponent{0}}}}}}, "UTF-8");
  expectNotWritable({"", {{"A", true, FixedConstraint{{VertexIds{{}}}}}}}, "constraints[0].select.vertices");
}

/// A folder of this test's own, gone when the test ends.
class ConstraintFileOnDisk : public testing::Test {
 protected:
  void SetUp() override
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / ("holdfast_" + std::string(test->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  void expectUnreadable(const std::filesystem::path& path, const std::string& reason) const
  {
    try {
      static_cast<void>(readConstraints(path));
      FAIL() << path << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, path.string());
      EXPECT_THAT(error.reason(), HasSubstr(reason));
    }
  }

  std::filesystem::path folder_;
};

TEST_F(ConstraintFileOnDisk, IsJsonOrCsvByItsExtensionInAnyCase)
{
  const std::string csv = "name,x,y,z,target_x,target_y,target_z\nA,1,2,3,4,5,6\n";
  test::Random random(203);
  const ConstraintList list = test::randomConstraintList(random, 5);
  EXPECT_EQ(readConstraints(write("points.CSV", csv)).constraints.size(), 1U);
  for (const char* const name : {"constraints.txt", "constraints.xyz", "constraints.json"})
    EXPECT_TRUE(test::areSame(readConstraints(write(name, constraintsToJson(list))), list)) << name;
}

TEST_F(ConstraintFileOnDisk, TablesOfTextAndCloudsOfPointsArePointLists)
{
  const std::string table = "name x y z target_x target_y target_z\nA 1 2 3 4 5 6\n";
  for (const char* const name : {"points.txt", "points.asc", "points.xyz", "points.tsv", "points.XYZ"})
    EXPECT_EQ(readConstraints(write(name, table)).constraints.at(0).name, "A") << name;
  EXPECT_EQ(readConstraints(write("cloud.xyz", "1 2 3\n4 5 6\n")).constraints.size(), 2U);
}

TEST_F(ConstraintFileOnDisk, MissingFileDirectoryAndEmptyFileAreSaidPlainly)
{
  expectUnreadable(folder_ / "nowhere.json", "no such file");
  expectUnreadable(folder_ / "nowhere" / "c.csv", "no such file");
  expectUnreadable(folder_, "directory");
  expectUnreadable(write("empty.json", ""), "empty");
  expectUnreadable(write("blank.json", " \n\n"), "empty");
}

TEST_F(ConstraintFileOnDisk, OtherEncodingsAreSaidPlainly)
{
  expectUnreadable(write("latin1.json", "{\n\"name\": \"M\xFCnster\"}"), "not UTF-8 text (byte 0xFC)");
  expectUnreadable(write("utf16.json", std::string("\xFF\xFE{\0\n\0", 6)), "not UTF-8");
  expectUnreadable(write("surrogate.csv", "name\n\xED\xA0\x80"), "not UTF-8");
  expectUnreadable(write("overlong.csv", "name\n\xC0\xAF"), "not UTF-8");
  expectUnreadable(write("cut.csv", "name\n\xE2\x82"), "not UTF-8");
}

}  // namespace
}  // namespace holdfast
