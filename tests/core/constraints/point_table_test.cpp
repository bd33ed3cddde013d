#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/point_tables.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

using testing::HasSubstr;

Vector3 placeOfRow(const PointTableRow& row)
{
  return std::get<AtNear>(row.point.value().at).place;
}

Vector3 targetOfRow(const PointTableRow& row)
{
  return std::get<Target>(row.point.value().to).place;
}

TEST(PointTable, ReadsAPointListAsTheStrictReaderDoes)
{
  const std::string text =
      "target_x,name,x,y,z,target_y,target_z\n0.1,A,1,2,3,4,5\n7,,1e-300,-0,3,4,0.30000000000000004\n";
  const PointTable table = readPointTable(text, "list.csv");
  const ConstraintList strict = parsePointListCsv(text, "list.csv");
  ASSERT_EQ(table.rows.size(), strict.constraints.size());
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& expected = std::get<PointConstraint>(strict.constraints[k].what);
    EXPECT_EQ(table.rows[k].name, strict.constraints[k].name);
    EXPECT_EQ(table.rows[k].fault, "");
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(hasSameBits(placeOfRow(table.rows[k])[axis], std::get<AtNear>(expected.at).place[axis]));
      EXPECT_TRUE(hasSameBits(targetOfRow(table.rows[k])[axis], std::get<Target>(expected.to).place[axis]));
    }
  }
}

TEST(PointTable, FindsSeparatorDecimalSignAndColumns)
{
  const PointTable german = readPointTable("x;y;z\n1,5;2;-0,25\n", "a.csv");
  EXPECT_EQ(german.format.separator, ';');
  EXPECT_EQ(german.format.decimalSign, ',');
  EXPECT_EQ(placeOfRow(german.rows.at(0)), Vector3(1.5, 2, -0.25));
  EXPECT_EQ(targetOfRow(german.rows.at(0)), Vector3(1.5, 2, -0.25));

  const PointTable bare = readPointTable("1\t2\t3\n4\t5\t6\n", "a.csv");
  EXPECT_FALSE(bare.format.hasHeader);
  ASSERT_EQ(bare.rows.size(), 2u);
  EXPECT_EQ(bare.rows[1].name, "point 2");
  EXPECT_EQ(placeOfRow(bare.rows[1]), Vector3(4, 5, 6));

  const PointTable other = readPointTable("id,east,north,up,e2,n2,u2\nA,1,2,3,4,5,6\n", "a.csv");
  EXPECT_EQ(other.rows.at(0).name, "A");
  EXPECT_EQ(targetOfRow(other.rows[0]), Vector3(4, 5, 6));
}

TEST(PointTable, FaultsLeaveTheOtherRowsAlone)
{
  const PointTable table =
      readPointTable("name,x,y,z\nA,1,2,3\nB,1,two,3\nA,4,5,6\nC,1,,3\nD,1,5,2,3\nE,7,8,9\n", "a.csv");
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[0].fault, "");
  EXPECT_EQ(faultText(table.rows[1]), "column y: \"two\" is not a number; correct it");
  EXPECT_EQ(table.rows[1].line, 3);
  EXPECT_FALSE(table.rows[1].point);
  EXPECT_THAT(table.rows[2].fault, HasSubstr("line 2"));
  EXPECT_TRUE(table.rows[2].point) << "another name makes it usable";
  EXPECT_EQ(faultText(table.rows[3]), "column y: a number is missing; every coordinate is needed");
  EXPECT_THAT(table.rows[4].fault, HasSubstr("5 fields"));
  EXPECT_EQ(placeOfRow(table.rows[5]), Vector3(7, 8, 9));
}

TEST(PointTable, IsReadInTheFormatThatIsChosen)
{
  PointTableFormat format = readPointTable("a,b,c,d\n1,2,3,4\n", "a.csv").format;
  format.columns = {};
  format.columns[1] = 3;
  format.columns[2] = 2;
  format.columns[3] = 1;
  format.scale = 25.4;
  EXPECT_EQ(placeOfRow(readPointTable("a,b,c,d\n1,2,3,4\n", "a.csv", format).rows.at(0)), 25.4 * Vector3(4, 3, 2));
  format.columns = {};
  format.separator = '\t';
  EXPECT_EQ(placeOfRow(readPointTable("x\ty\tz\n1\t2\t3\n", "a.csv", format).rows.at(0)), 25.4 * Vector3(1, 2, 3));
}

TEST(PointTable, WithoutRowsIsRefused)
{
  EXPECT_THROW(static_cast<void>(readPointTable("", "a.csv")), InputError);
  EXPECT_THROW(static_cast<void>(readPointTable("x,y,z\n", "a.csv")), InputError);
  EXPECT_THROW(static_cast<void>(readPointTable("x,y,z\n\"1,2\n", "a.csv")), InputError);
}

}  // namespace
}  // namespace holdfast
