#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/point_lists.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"
#include "support/meshes.h"

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
  expectPointListRefused("name,x,y,z,target_x,target_y,targt_z\nA,1,2,3,4,5,6\n", 1, "column target_z",
                         R"(is it the one called "targt_z"?)");
  expectPointListRefused("name,x,y,z,target_x,target_y,target_z,x\nA,1,2,3,4,5,6,7\n", 1, "column x", "more than once");
  expectPointListRefused("name,u,y,z,target_x,target_y,target_z\nA,1,2,3,4,5,6\n", 1, "column x", "missing");
  expectPointListRefused(kPointListHeader, 1, "", "no row");
}

TEST(PointListCsv, RowsHaveTheLengthOfTheHeader)
{
  expectPointListRefused(kPointListHeader + "A,1,2,3,4,5\n", 2, "", "this row has 6 fields, the header has 7");
  expectPointListRefused(kPointListHeader + "A,1,5,2,5,3,5,4,5,5,5,6,5\n", 2, "",
                         "13 fields, the header has 7; decimal signs are points");
}

/// The same table in other ways of writing.
void expectSameList(const std::string& text)
{
  SCOPED_TRACE(text);
  const ConstraintList expected = parsedPointList(kPointListHeader + "A,1,2.5,-0.03,4,5,1200\nB,0,0,0,1,2,3\n");
  EXPECT_TRUE(test::areSame(parsedPointList(text), expected));
}

TEST(PointListCsv, SeparatorsAndDecimalCommasAreFound)
{
  expectSameList("name;x;y;z;target_x;target_y;target_z\nA;1;2,5;-0,03;4;5;1200\nB;0;0;0;1;2;3\n");
  expectSameList("name;x;y;z;target_x;target_y;target_z\nA;1;2.5;-0.03;4;5;1200\nB;0;0;0;1;2;3\n");
  expectSameList("name\tx\ty\tz\ttarget_x\ttarget_y\ttarget_z\nA\t1\t2,5\t-0,03\t4\t5\t1200\nB\t0\t0\t0\t1\t2\t3");
  expectSameList("name x y z target_x target_y target_z\n A  1 2.5 -3e-2\t4 5 1200 \nB 0 0 0 1 2 3\n");
  expectSameList("name x y z target_x target_y target_z\nA 1 2,5 -3e-2 4 5 1,2e3\nB 0 0 0 1 2 3\n");
}

TEST(PointListCsv, DecimalSignsAreNotMixed)
{
  expectPointListRefused("name;x;y;z;target_x;target_y;target_z\nA;1,5;2,5;3;4;5;6\nB;1;2.5;3;4;5;6\n", 3, "column y",
                         "the decimal sign is a comma in this table");
  expectPointListRefused("name;x;y;z;target_x;target_y;target_z\nA;1.5;2.5;3;4;5;6\nB;1;2,5;3;4;5;6\n", 3, "column y",
                         "the decimal sign is a point");
  expectPointListRefused("name;x;y;z;target_x;target_y;target_z\nA;1.234,5;2,5;3;4;5;6\n", 2, "column x",
                         "is not a number");
}

TEST(PointListCsv, ALineThatStatesTheSeparatorIsObeyed)
{
  const std::string rows = "A,1,2.5,-0.03,4,5,1200\nB,0,0,0,1,2,3\n";
  expectSameList("sep=,\n" + kPointListHeader + rows);
  expectSameList("\"sep=,\"\r\n" + kPointListHeader + rows);
  expectSameList("\xEF\xBB\xBFSEP=,\r\n\r\n" + kPointListHeader + rows);
  expectSameList("sep=|\nname|x|y|z|target_x|target_y|target_z\nA|1|2,5|-0,03|4|5|1200\nB|0|0|0|1|2|3\n");
  expectPointListRefused("sep=,\n" + kPointListHeader + "A,1,2,three,4,5,6\n", 3, "column z", "\"three\"");
}

TEST(PointListCsv, TitlesMayHaveCapitalsBlanksAndUnits)
{
  const std::string rows = "\nA,1,2.5,-0.03,4,5,1200\nB,0,0,0,1,2,3\n";
  expectSameList("Name,X,Y,Z,Target_X,Target_Y,Target_Z" + rows);
  expectSameList("NAME,X,Y,Z,TARGET X,Target-Y,targetZ" + rows);
  expectSameList("Point,x,y,z,tx,ty,tz" + rows);
  for (const char* const header :
       {"name,x [mm],y [mm],z [mm],target_x [mm],target_y [mm],target_z [mm]",
        "name,x (mm),y (mm),z (mm),target_x (mm),target_y (mm),target_z (mm)",
        "name,X/mm,Y/mm,Z/mm,target_x/mm,target_y/mm,target_z/mm", "name,x mm,y in mm,z,target_x,target_y,target_z",
        "name,x\u00A0[mm],y,z,target_x,target_y,target_z",
        "name,x,y,z,target_x,target_y,target_z\n,mm,mm,mm,mm,mm,mm"}) {
    SCOPED_TRACE(header);
    ConstraintList list = parsedPointList(header + rows);
    EXPECT_EQ(list.units, "mm");
    list.units = "";
    EXPECT_TRUE(test::areSame(list, parsedPointList(kPointListHeader + rows.substr(1))));
  }
}

TEST(PointListCsv, ColumnsInDifferentUnitsAreRefused)
{
  expectPointListRefused("name,x [m],y [m],z [m],target_x [mm],target_y [mm],target_z [mm]\nA,1,2,3,4,5,6\n", 1,
                         "column target_x", "this column is in mm, and x is in m");
}

TEST(PointListCsv, OtherColumnsAreKept)
{
  const ConstraintList list = parsedPointList(
      "id,name,x,y,z,target_x,target_y,target_z,note,note,\n7,A,1,2,3,4,5,6,\"ok, fine\",twice,\n8,B,1,2,3,4,5,6,,,\n");
  EXPECT_EQ(list.constraints[0].extra,
            (std::vector<ExtraText>{{"id", "7"}, {"note", "ok, fine"}, {"note (column 10)", "twice"}}));
  EXPECT_EQ(list.constraints[1].extra, (std::vector<ExtraText>{{"id", "8"}}));
  EXPECT_TRUE(test::areSame(parseConstraintsJson(constraintsToJson(list), "c.json"), list));
  const Model model = makeModel(test::grid(4, 4), "mesh");
  EXPECT_TRUE(test::areSame(fromClipboardText(toClipboardText(list, {0, 1}, model)), list));
}

TEST(PointListCsv, EmptyRowsAndEmptyFieldsAtTheEndMeanNothing)
{
  expectSameList(kPointListHeader + "A,1,2.5,-0.03,4,5,1200\n,,,,,,\nB,0,0,0,1,2,3\n,,,,,,\n , ,,,,,\n");
  expectSameList("name;x;y;z;target_x;target_y;target_z;;\n;;\nA;1;2,5;-0,03;4;5;1200;;\nB;0;0;0;1;2;3\n;;;;;;;;\n");
  expectSameList(kPointListHeader + ",,,,,,\nA,1,2.5,-0.03,4,5,1200,,,\nB,0,0,0,1,2,3, ,\n");
}

TEST(PointListCsv, BlanksThatDoNotBreakMeanNothing)
{
  expectSameList(kPointListHeader + "A,1,\u00A02.5,-0.03,4\u00A0,\u202F5,1200\nB,0,0,0,1,2,3\n");
  expectSameList(kPointListHeader + "A,1,2.5,-0.03,4,5,1\u00A0200\nB,0,0,0,1,2,3\n");
  expectSameList(kPointListHeader + "A,1,2.5,\u22120.03,4,5,1\u202F200\nB,0,0,0,1,2,3\n\u00A0,,,,,,\u00A0\n");
  expectPointListRefused(kPointListHeader + "A,1\u00A02,2,3,4,5,6\n", 2, "column x", "is not a number");
}

TEST(PointListCsv, CommentsMayStandBeforeTheTable)
{
  const std::string rows = "A,1,2.5,-0.03,4,5,1200\nB,0,0,0,1,2,3\n";
  expectSameList("# measured 12 to 14 h, 3 parts\n#\n" + kPointListHeader + rows);
  expectSameList("// " + kPointListHeader + rows);
  expectSameList("#name x y z target_x target_y target_z\nA 1 2.5 -0.03 4 5 1200\nB 0 0 0 1 2 3\n");
  EXPECT_EQ(parsedPointList("#1,1,2,3,4,5,6\n").constraints[0].name, "#1");
  EXPECT_EQ(parsedPointList(kPointListHeader + "#1,1,2,3,4,5,6\n").constraints[0].name, "#1");
  expectPointListRefused("# one\n# two\n" + kPointListHeader + "A,1,2,three,4,5,6\n", 4, "column z", "\"three\"");
}

TEST(PointListCsv, TablesWithoutTitlesAreReadWhereTheirColumnsAreClear)
{
  expectSameList("A,1,2.5,-0.03,4,5,1200\nB,0,0,0,1,2,3\n");
  const ConstraintList pairs = parsedPointList("0 0 0.5 0 0 1.25\n 4 3 2.5   4 3 9\n");
  EXPECT_EQ(placeOf(pairs.constraints[1]), Vector3(4, 3, 2.5));
  EXPECT_EQ(targetOf(pairs.constraints[1]), Vector3(4, 3, 9));
  EXPECT_EQ(pairs.constraints[1].name, "point 2");
  const ConstraintList places = parsedPointList("0 0 0.5\n4 3 2.5\n");
  EXPECT_EQ(targetOf(places.constraints[1]), Vector3(4, 3, 2.5)) << "a cloud of points goes where it was measured";
  const ConstraintList numbered = parsedPointList("17 0 0 0.5\n4 4 3 2.5\n");
  EXPECT_EQ(numbered.constraints[1].name, "4");
  EXPECT_EQ(placeOf(numbered.constraints[1]), Vector3(4, 3, 2.5));
  expectPointListRefused("1 2 3 4 5\n", 1, "", "the table has no titles and 5 columns");
  expectPointListRefused("0.5 2 3 4 5 6 7\n", 1, "", "the table has no titles and 7 columns");
}

TEST(PointListCsv, NormalsAndColorsOfAPointCloudAreNoTargets)
{
  const ConstraintList normals = parsedPointList("0 0 0.5 0 0.6 0.8\n4 3 2.5 1 0 0\n");
  EXPECT_EQ(targetOf(normals.constraints[0]), Vector3(0, 0, 0.5));
  EXPECT_EQ(normals.constraints[0].extra[1].text, "0.6");
  EXPECT_EQ(targetOf(parsedPointList("0.1 0 0.5 255 128 0\n4 3 2.5 1 0 0\n").constraints[0]), Vector3(0.1, 0, 0.5));
  EXPECT_EQ(targetOf(parsedPointList("1 0 0 0 0.6 0.8\n").constraints[0]), Vector3(0, 0.6, 0.8)) << "of a unit sphere";
  EXPECT_EQ(targetOf(parsedPointList("1 2 3 4 5 6\n").constraints[0]), Vector3(4, 5, 6)) << "whole numbers";
}

TEST(PointListCsv, BadRowsAreSkippedWhereThatIsAskedForAndNamed)
{
  const std::string text =
      kPointListHeader + "A,1,2,3,4,5,6\nB,1,2,NaN,4,5,6\n,1,2,3,4,5\nA,1,2,3,4,5,7\nC,1,2,3,4,5,6,7\nD,1,2,3,4,5,6\n";
  const PointList points = parsePointList(text, "p.csv", BadRows::Skip);
  ASSERT_EQ(points.list.constraints.size(), 2U);
  EXPECT_EQ(points.list.constraints[1].name, "D");
  ASSERT_EQ(points.skippedRows.size(), 4U);
  EXPECT_EQ(points.skippedRows[0].line, 3);
  EXPECT_EQ(points.skippedRows[0].name, "B");
  EXPECT_EQ(points.skippedRows[0].fault, "column z: \"NaN\" is not a number; correct it");
  EXPECT_EQ(points.skippedRows[1].name, "point 3");
  EXPECT_THAT(points.skippedRows[1].fault, HasSubstr("6 fields, the header has 7"));
  EXPECT_THAT(points.skippedRows[2].fault, HasSubstr("in line 2 already"));
  EXPECT_EQ(points.skippedRows[3].line, 6);
  EXPECT_TRUE(parsePointList(kPointListHeader + "A,1,2,3,4,5,6\n", "p.csv", BadRows::Skip).skippedRows.empty());
  EXPECT_THROW(static_cast<void>(parsePointList(kPointListHeader + "A,1,2,3,4,5,x\n", "p.csv", BadRows::Skip)),
               InputError);
  EXPECT_THROW(static_cast<void>(parsePointList("name,x,y\nA,1,2\n", "p.csv", BadRows::Skip)), InputError);
}

TEST(PointListCsv, OtherEncodingsAreNamed)
{
  expectPointListRefused(std::string("\xFF\xFEn\0a\0", 6), 1, "", "UTF-16");
  expectPointListRefused("name,x,y,z,target_x,target_y,target_z\nB\xF6lt,1,2,3,4,5,6\n", 2, "", "UTF-8");
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
