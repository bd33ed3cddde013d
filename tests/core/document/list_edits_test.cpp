#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Names = std::vector<std::string>;

Constraint point(const std::string& name, Index vertex = 0)
{
  return {name, true, PointConstraint{AtVertex{vertex}, Move{}}};
}

ConstraintList pointsNamed(const Names& names)
{
  ConstraintList list{"mm", {}};
  for (const std::string& name : names) list.constraints.push_back(point(name, std::ssize(list.constraints)));
  return list;
}

Names namesOf(const ConstraintList& list)
{
  Names names;
  for (const Constraint& constraint : list.constraints) names.push_back(constraint.name);
  return names;
}

/// The vertices of the points, which tell who is who after names have changed.
std::vector<Index> verticesOf(const ConstraintList& list)
{
  std::vector<Index> vertices;
  for (const Constraint& constraint : list.constraints)
    vertices.push_back(std::get<AtVertex>(std::get<PointConstraint>(constraint.what).at).vertex);
  return vertices;
}

template <class Edit>
void expectEditRefused(Edit edit, const std::string& words)
{
  try {
    static_cast<void>(edit());
    ADD_FAILURE() << "was done";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

TEST(ListEdits, FindByName)
{
  const ConstraintList list = pointsNamed({"a", "b"});
  EXPECT_EQ(indexOf(list, "b"), 1);
  EXPECT_EQ(indexOf(list, "B"), std::nullopt);
}

TEST(ListEdits, FreshNamesFillTheFirstGap)
{
  EXPECT_EQ(unusedName({}, "P"), "P1");
  EXPECT_EQ(unusedName(pointsNamed({"P1", "P3", "P", "Q2"}), "P"), "P2");
  EXPECT_EQ(unusedName(pointsNamed({"P2", "P1"}), "P"), "P3");
}

TEST(ListEdits, AddAtTheEnd)
{
  EXPECT_THAT(namesOf(added(pointsNamed({"a", "b"}), point("c"))), ElementsAre("a", "b", "c"));
}

TEST(ListEdits, NamesThatAreTakenOrEmptyAreRefused)
{
  const ConstraintList list = pointsNamed({"a", "b"});
  expectEditRefused([&] { return added(list, point("b")); }, "\"b\" is the name of constraint 2 in the list already");
  expectEditRefused([&] { return added(list, point("")); }, "the name is empty");
  expectEditRefused([&] { return renamed(list, 0, "b"); }, "choose another");
  expectEditRefused([&] { return renamed(list, 0, ""); }, "the name is empty");
}

TEST(ListEdits, RenameChangesNothingElse)
{
  const ConstraintList list = renamed(pointsNamed({"a", "b"}), 1, "c");
  EXPECT_THAT(namesOf(list), ElementsAre("a", "c"));
  EXPECT_THAT(verticesOf(list), ElementsAre(0, 1));
  EXPECT_THAT(namesOf(renamed(list, 1, "c")), ElementsAre("a", "c")) << "to its own name";
}

TEST(ListEdits, RemoveAndExtractDivideTheList)
{
  const ConstraintList list = pointsNamed({"a", "b", "c", "d"});
  EXPECT_THAT(namesOf(removed(list, {3, 1, 3})), ElementsAre("a", "c"));
  EXPECT_THAT(namesOf(extracted(list, {3, 1, 3})), ElementsAre("b", "d"));
  EXPECT_THAT(namesOf(removed(list, {})), ElementsAre("a", "b", "c", "d"));
  EXPECT_EQ(removed(list, {0, 1, 2, 3}).units, "mm");
  EXPECT_EQ(extracted(list, {}).units, "mm");
}

TEST(ListEdits, MovePutsTheChosenSideBySideInTheirOrder)
{
  const ConstraintList list = pointsNamed({"a", "b", "c", "d", "e"});
  EXPECT_THAT(namesOf(moved(list, {3, 1}, 0)), ElementsAre("b", "d", "a", "c", "e"));
  EXPECT_THAT(namesOf(moved(list, {3, 1}, 5)), ElementsAre("a", "c", "e", "b", "d"));
  EXPECT_THAT(namesOf(moved(list, {3, 1}, 2)), ElementsAre("a", "b", "d", "c", "e"));
  EXPECT_THAT(namesOf(moved(list, {0}, 2)), ElementsAre("b", "a", "c", "d", "e"));
}

TEST(ListEdits, MoveToWhereItIsChangesNothing)
{
  const ConstraintList list = pointsNamed({"a", "b", "c"});
  for (const Index before : {1, 2}) EXPECT_TRUE(test::areSame(moved(list, {1}, before), list));
  EXPECT_TRUE(test::areSame(moved(list, {}, 1), list));
  EXPECT_TRUE(test::areSame(moved(list, {0, 1, 2}, 1), list));
}

TEST(ListEdits, EnableAndDisableTheChosenAlone)
{
  const ConstraintList list = withEnabled(pointsNamed({"a", "b", "c"}), {0, 2}, Enabling::Disabled);
  EXPECT_FALSE(list.constraints[0].isEnabled);
  EXPECT_TRUE(list.constraints[1].isEnabled);
  EXPECT_FALSE(list.constraints[2].isEnabled);
  EXPECT_TRUE(withEnabled(list, {0}, Enabling::Enabled).constraints[0].isEnabled);
}

TEST(ListEdits, PasteMakesNamesUniqueAndKeepsTheOrder)
{
  const ConstraintList list =
      pasted(pointsNamed({"P1", "P3", "base", "7"}), pointsNamed({"P1", "base", "P3", "new", "P2", "7"}));
  EXPECT_THAT(namesOf(list), ElementsAre("P1", "P3", "base", "7", "P2", "base 2", "P4", "new", "P5", "7 2"));
}

TEST(ListEdits, PasteTwiceCountsOn)
{
  const ConstraintList one = pointsNamed({"base"});
  EXPECT_THAT(namesOf(pasted(pasted(one, one), one)), ElementsAre("base", "base 2", "base 3"));
}

TEST(ListEdits, PasteKeepsTheUnitsOfTheList)
{
  EXPECT_EQ(pasted({"inch", {}}, pointsNamed({"a"})).units, "inch");
  EXPECT_EQ(pasted({}, pointsNamed({"a"})).units, "mm");
}

TEST(ListEdits, PasteOfManyAlikeTakesNoQuadraticTime)
{
  ConstraintList many;
  constexpr Index kCount = 20000;
  for (Index k = 1; k <= kCount; ++k) many.constraints.push_back(point("P" + std::to_string(k), k));
  const ConstraintList list = pasted(many, many);
  EXPECT_EQ(list.constraints.back().name, "P" + std::to_string(2 * kCount));
}

}  // namespace
}  // namespace holdfast
