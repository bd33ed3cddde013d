#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>

#include "support/constraint_lists.h"

namespace holdfast {
namespace {

using test::kPointListHeader;
using testing::HasSubstr;

ConstraintList parsedPointList(const std::string& text)
{
  return parsePointListCsv(text, "p.csv");
}

Vector3 placeOf(const Constraint& constraint)
{
  return std::get<AtNear>(std::get<PointConstraint>(constraint.what).at).place;
}

Vector3 targetOf(const Constraint& constraint)
{
  return std::get<Target>(std::get<PointConstraint>(constraint.what).to).place;
}

void expectPointListRefused(const std::string& text, Index line, const std::string& element, const std::string& words)
{
  SCOPED_TRACE(text);
  try {
    static_cast<void>(parsedPointList(text));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "p.csv");
    EXPECT_EQ(error.location().line, line);
    EXPECT_EQ(error.location().element, element);
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
}

TEST(PointListCsv, ReadsRowsAsNearPointsWithTargets)
{
  const ConstraintList list = parsedPointList(kPointListHeader + "A,1,2.5,-3e-2,4,5,6\nB,0.1,0,0,+7,.5,9.\n");
  ASSERT_EQ(list.constraints.size(), 2U);
  EXPECT_EQ(list.constraints[0].name, "A");
  EXPECT_TRUE(list.constraints[0].isEnabled);
  EXPECT_EQ(placeOf(list.constraints[0]), Vector3(1, 2.5, -0.03));
  EXPECT_EQ(targetOf(list.constraints[0]), Vector3(4, 5, 6));
  EXPECT_EQ(placeOf(list.constraints[1]), Vector3(0.1, 0, 0));
  EXPECT_EQ(targetOf(list.constraints[1]), Vector3(7, 0.5, 9));
}

TEST(PointListCsv, TakesColumnsInAnyOrder)
{
  const ConstraintList list = parsedPointList("target_z, target_y,target_x,z,y,x,name\n6,5,4, 3 ,2,1,A");
  EXPECT_EQ(list.constraints[0].name, "A");
  EXPECT_EQ(placeOf(list.constraints[0]), Vector3(1, 2, 3));
  EXPECT_EQ(targetOf(list.constraints[0]), Vector3(4, 5, 6));
}

TEST(PointListCsv, NamesTheNamelessByTheirPlaceInTheList)
{
  const ConstraintList list = parsedPointList(kPointListHeader + "A,1,2,3,4,5,6\n\n,1,2,3,4,5,6\n");
  EXPECT_EQ(list.constraints[1].name, "point 2");
}

TEST(PointListCsv, UnderstandsLineEndsBlankLinesAndAByteOrderMark)
{
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const ConstraintList list =
        parsedPointList("\xEF\xBB\xBF" + end + kPointListHeader.substr(0, kPointListHeader.size() - 1) + end + "  \t" +
                        end + "A,1,2,3,4,5,6" + end + end + "B,1,2,3,4,5,6" + end + " ");
    ASSERT_EQ(list.constraints.size(), 2U);
    EXPECT_EQ(list.constraints[1].name, "B");
    EXPECT_EQ(targetOf(list.constraints[1]), Vector3(4, 5, 6));
  }
}

TEST(PointListCsv, UnderstandsQuotedFields)
{
  const ConstraintList list = parsedPointList(
      "\"name\",x,y,z,target_x,target_y,target_z\n"
      "\"bolt \"\"A\"\", left\",\"1\",2,3,4,5,\"6\"\n"
      "\"two\r\nlines\",1,2,3,4,5,6\n\"\",1,2,3,4,5,6\n");
  EXPECT_EQ(list.constraints[0].name, "bolt \"A\", left");
  EXPECT_EQ(placeOf(list.constraints[0]), Vector3(1, 2, 3));
  EXPECT_EQ(list.constraints[1].name, "two\r\nlines");
  EXPECT_EQ(list.constraints[2].name, "point 3");
}

TEST(PointListCsv, CountsLinesThroughQuotedFieldsAndBlankLines)
{
  expectPointListRefused(kPointListHeader + "\n\"two\r\nlines\",1,2,3,4,5,6\r\nB,1,2,three,4,5,6\n", 5, "column z",
                         "\"three\"");
}

TEST(PointListCsv, MisusedQuotesAreRefused)
{
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,5,6\n\"B,1,2,3,4,5,6\nC,1,2,3,4,5,6\n", 3, "", "does not end");
  expectPointListRefused(kPointListHeader + "\"A\"x,1,2,3,4,5,6\n", 2, "", "after the closing quote");
  expectPointListRefused(kPointListHeader + "5\" hole,1,2,3,4,5,6\n", 2, "", "write quotes inside it twice");
}

TEST(PointListCsv, HeaderNamesEachColumnOnce)
{
  expectPointListRefused("", 1, "", "no header");
  expectPointListRefused("\n\n", 1, "", "no header");
  expectPointListRefused("name,x,y,z,target_x,target_y\nA,1,2,3,4,5\n", 1, "column target_z", "missing");
  expectPointListRefused("name,x,y,z,target_x,target_y,target-z\n", 1, "",
                         R"(unknown column "target-z"; did you mean "target_z"?)");
  expectPointListRefused("name,x,y,z,target_x,target_y,target_z,x\n", 1, "column x", "more than once");
  expectPointListRefused("A,1,2,3,4,5,6\n", 1, "", "The first line is the header");
  expectPointListRefused(kPointListHeader, 1, "", "no row");
}

TEST(PointListCsv, RowsHaveTheLengthOfTheHeader)
{
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,5\n", 2, "", "this row has 6 fields, the header has 7");
  expectPointListRefused(kPointListHeader + "A,1,5,2,5,3,5,4,5,5,5,6,5\n", 2, "",
                         "13 fields, the header has 7; decimal signs are points");
}

TEST(PointListCsv, OtherSeparatorsAreNamed)
{
  expectPointListRefused("name;x;y;z;target_x;target_y;target_z\nA;1,5;2;3;4;5;6\n", 1, "", "separated by semicolons");
  expectPointListRefused("\"name\";\"x\"\n", 1, "", "separated by semicolons");
  expectPointListRefused("name\tx\ty\tz\ttarget_x\ttarget_y\ttarget_z\n", 1, "", "separated by tabs");
}

TEST(PointListCsv, NumbersAreFiniteAndWhole)
{
  expectPointListRefused(kPointListHeader + "A,,2,3,4,5,6\n", 2, "column x", "a number is missing");
  expectPointListRefused(kPointListHeader + "A,1,\"2,5\",3,4,5,6\n", 2, "column y", "the decimal sign is a point");
  expectPointListRefused(kPointListHeader + "A,1,2,3 mm,4,5,6\n", 2, "column z", "\"3 mm\" is not a number");
  expectPointListRefused(kPointListHeader + "A,1,2,3,nan,5,6\n", 2, "column target_x", "not a number");
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,inf,6\n", 2, "column target_y", "not a number");
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,5,1e999\n", 2, "column target_z", "does not fit");
  expectPointListRefused(kPointListHeader + "A,+-1,2,3,4,5,6\n", 2, "column x", "not a number");
  expectPointListRefused(kPointListHeader + "A,0x10,2,3,4,5,6\n", 2, "column x", "not a number");
}

TEST(PointListCsv, NamesAreUnique)
{
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,5,6\nB,1,2,3,4,5,6\nA,1,2,3,4,5,6\n", 4, "column name",
                         "\"A\" is the name of the point in line 2 already");
  expectPointListRefused(kPointListHeader + "point 2,1,2,3,4,5,6\n,1,2,3,4,5,6\n", 3, "column name", "\"point 2\"");
}

}  // namespace
}  // namespace holdfast
