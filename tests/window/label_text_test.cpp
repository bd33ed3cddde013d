#include <gtest/gtest.h>

#include <holdfast/window/text/constraint_text.h>

#include "support/meshes.h"

namespace holdfast::test {
namespace {

TEST(LabelText, IsWhatTheFileCallsAVertexOrAFace)
{
  Mesh mesh = grid(1, 1);
  mesh.labels = {{10, 20, 30, 40}, std::vector<Index>(mesh.faces.size(), 7)};
  EXPECT_EQ(labelText(mesh, AtVertex{2}), " (labelled 30)");
  EXPECT_EQ(labelText(mesh, AtFace{0, {1, 0, 0}}), " (labelled 7)");
  EXPECT_EQ(labelText(mesh, AtEdge{0, 1, 0.5}), "");
}

TEST(LabelText, IsEmptyWhereTheFileHasNoLabels)
{
  const Mesh mesh = grid(1, 1);
  EXPECT_EQ(labelText(mesh, AtVertex{2}), "");
  EXPECT_EQ(labelText(mesh, AtFace{0, {1, 0, 0}}), "");
}

}  // namespace
}  // namespace holdfast::test
