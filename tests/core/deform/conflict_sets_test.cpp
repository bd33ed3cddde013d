// Which sets of constraints a constraint is said to conflict with: the smallest ones of each kind.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using ConstraintNames = std::vector<std::string>;

/// Vertex 1 stays 1 unit beside vertex 0, as at rest.
Constraint besideTheFirst()
{
  return {"", true, RelativeConstraint{AtVertex{0}, AtVertex{1}, Vector3(-1, 0, 0)}};
}

/// The names of all sets of the last constraint.
std::vector<ConstraintNames> setsOfTheLast(std::vector<Constraint> constraints)
{
  const Report report = test::deformed(test::grid(4, 4), test::listOf(std::move(constraints)), {}).report;
  std::vector<ConstraintNames> sets;
  for (const ConflictSet& set : report.constraints.back().conflictSets) sets.push_back(set.with);
  return sets;
}

TEST(ConflictSets, LeaveOutASetThatNeedsAllOfAnotherAndMore)
{
  // The row of vertex 0 contradicts P0, that of vertex 1 the chain P0 and P1.
  const std::vector<ConstraintNames> sets =
      setsOfTheLast({test::hold({0}), besideTheFirst(), test::handle({0, 1}, {}, Vector3(0, 0, 1))});
  EXPECT_EQ(sets, std::vector<ConstraintNames>{{"P0"}});
}

TEST(ConflictSets, LeaveOutALargerSetOfRepetitionsAsWell)
{
  const std::vector<ConstraintNames> sets =
      setsOfTheLast({test::hold({0}), besideTheFirst(), test::handle({0, 1}, {}, Vector3::Zero())});
  EXPECT_EQ(sets, std::vector<ConstraintNames>{{"P0"}});
}

TEST(ConflictSets, KeepALargerSetOfAnotherKind)
{
  // What it repeats does not explain what it contradicts.
  const std::vector<ConstraintNames> sets =
      setsOfTheLast({test::hold({0}), besideTheFirst(),
                     test::handle({0, 1, 12}, VertexTargets{{Vector3(0, 0, 0), Vector3(1, 0, 1), Vector3(2, 2, 0)}},
                                  Vector3::Zero())});
  EXPECT_EQ(sets, (std::vector<ConstraintNames>{{"P0", "P1"}, {"P0"}}));
}

TEST(ConflictSets, KeepSetsOfWhichNoneIsPartOfAnother)
{
  const std::vector<ConstraintNames> sets =
      setsOfTheLast({test::hold({0}), test::hold({1}), test::handle({0, 1}, {}, Vector3(0, 0, 1))});
  EXPECT_EQ(sets, (std::vector<ConstraintNames>{{"P0"}, {"P1"}}));
}

}  // namespace
}  // namespace holdfast
