#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/document/point_lists.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

using test::kPointListHeader;
using testing::HasSubstr;
using testing::StartsWith;

Model gridModel()
{
  return makeModel(test::grid(4, 4), "mesh");
}

void expectPasteRefused(const std::string& text, const std::string& words)
{
  try {
    static_cast<void>(fromClipboardText(text));
    ADD_FAILURE() << "was read: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

TEST(PointListText, SaysWherePointsLieAndWhereTheyGo)
{
  ConstraintList list =
      test::listOf({test::moveTo(AtVertex{6}, {0.1, -2, 1e300}), test::hold({0}),
                    test::moveBy(AtEdge{0, 1, 0.25}, {0, 0.5, 1}), test::moveBy(AtNear{{2, 2, 3}}, {0, 0, 1})});
  list.constraints[2].name = "bolt \"2\", left";
  EXPECT_EQ(toClipboardText(list, {3, 0, 2}, gridModel()), kPointListHeader + "P0,1,1,0,0.1,-2,1e+300\n" +
                                                               "\"bolt \"\"2\"\", left\",0.75,0,0,0.75,0.5,1\n" +
                                                               "P3,2,2,3,2,2,1\n");
}

TEST(PointListText, PointsComeBackBitForBit)
{
  test::Random random(9);
  std::vector<Constraint> constraints;
  for (int k = 0; k < 100; ++k)
    constraints.push_back(test::moveTo(AtNear{test::randomVector(random, 1e3)}, test::randomVector(random, 1e-3)));
  ConstraintList list = test::listOf(constraints);
  list.constraints[0].name = " two\nlines ";
  std::vector<Index> all;
  for (Index k = 0; k < 100; ++k) all.push_back(k);
  EXPECT_TRUE(test::areSame(fromClipboardText(toClipboardText(list, all, gridModel())), list));
}

TEST(PointListText, OtherConstraintsAreAConstraintFileAndComeBack)
{
  test::Random random(4);
  const ConstraintList list = test::randomConstraintList(random, 30);
  std::vector<Index> all;
  for (Index k = 0; k < 30; ++k) all.push_back(k);
  const std::string text = toClipboardText(list, all, gridModel());
  EXPECT_THAT(text, StartsWith("{"));
  EXPECT_TRUE(test::areSame(fromClipboardText("\n  " + text), list));
  const std::vector<Index> some{3, 5, 17};
  EXPECT_TRUE(test::areSame(fromClipboardText(constraintsToJson(extracted(list, some))), extracted(list, some)));
}

TEST(PointListText, TakesTheCellsOfASpreadsheet)
{
  const std::string header = "name\tx\ty\tz\ttarget_x\ttarget_y\ttarget_z\r\n";
  const ConstraintList list =
      fromClipboardText(header + "bolt 2, left\t1\t2\t3\t4\t5\t6\r\n3\" pipe\t1\t2\t3\t4\t5\t6\r\n" +
                        "\"a\ttab, \"\"quoted\"\"\"\t1\t2\t3\t4\t5\t6\r\n\t1\t2\t3\t4\t5\t6\r\n");
  ASSERT_EQ(list.constraints.size(), 4U);
  EXPECT_EQ(list.constraints[0].name, "bolt 2, left");
  EXPECT_EQ(list.constraints[1].name, "3\" pipe");
  EXPECT_EQ(list.constraints[2].name, "a\ttab, \"quoted\"");
  EXPECT_EQ(list.constraints[3].name, "point 4");
  EXPECT_EQ(std::get<AtNear>(std::get<PointConstraint>(list.constraints[1].what).at).place, Vector3(1, 2, 3));
  const ConstraintList german = fromClipboardText(header + "A\t1,5\t2\t3\t4\t5\t6\r\n");
  EXPECT_EQ(std::get<AtNear>(std::get<PointConstraint>(german.constraints[0].what).at).place, Vector3(1.5, 2, 3));
  expectPasteRefused(header + "A\t1.5\t2\t3\t4\t5\t6\r\nB\t1,5\t2\t3\t4\t5\t6\r\n", "the decimal sign is a point");
}

TEST(PointListText, OtherTextIsRefused)
{
  expectPasteRefused("", "there is no text to paste");
  expectPasteRefused(" \n\t", "there is no text to paste");
  expectPasteRefused("https://example.org", "clipboard");
  expectPasteRefused("{", "not valid JSON");
  expectPasteRefused(kPointListHeader, "there is no row");
}

TEST(PointListText, PointsThatTheMeshDoesNotHaveAreRefused)
{
  const ConstraintList list = test::listOf({test::moveTo(AtVertex{1000}, {0, 0, 0})});
  EXPECT_THROW(static_cast<void>(toClipboardText(list, {0}, gridModel())), InputError);
}

}  // namespace
}  // namespace holdfast
