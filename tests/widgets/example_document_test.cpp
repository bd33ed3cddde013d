#include <map>

#include <gtest/gtest.h>

#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>
#include <holdfast/widgets/scene/example_document.h>

namespace holdfast {
namespace {

TEST(ExampleDocument, HasSomethingOfEverything)
{
  const ExampleDocument example = exampleDocument();
  std::map<ConstraintStatus, int> marks;
  for (const ConstraintMark& mark : constraintMarks(example.model, example.list, example.deformation))
    ++marks[mark.status];
  EXPECT_GT(marks[ConstraintStatus::Met], 0);
  EXPECT_GT(marks[ConstraintStatus::Redundant], 0);
  EXPECT_GT(marks[ConstraintStatus::Conflicting], 0);
  EXPECT_GT(marks[ConstraintStatus::Disabled], 0);
  EXPECT_TRUE(hasRotation(boundaryRotations(example.deformation)));
}

}  // namespace
}  // namespace holdfast
