#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/model.h>
#include <holdfast/mesh/labels.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

#include "support/meshes.h"

namespace holdfast::test {
namespace {

using ::testing::HasSubstr;

Mesh labelledGrid()
{
  Mesh mesh = grid(2, 2);
  for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.labels.vertices.push_back(100000 + v);
  for (Index f = 0; f < mesh.faces.size(); ++f) mesh.labels.faces.push_back(20000 + f);
  return mesh;
}

TEST(Labels, StandBehindThePlacesInTheFile)
{
  EXPECT_EQ(vertexText(labelledGrid(), 3), "vertex 3 (labelled 100003)");
  EXPECT_EQ(faceText(labelledGrid(), 1), "face 1 (labelled 20001)");
}

TEST(Labels, AreNotNamedWhereTheFileHasNone)
{
  const Mesh mesh = grid(2, 2);
  EXPECT_EQ(vertexText(mesh, 3), "vertex 3");
  EXPECT_EQ(faceText(mesh, 1), "face 1");
}

TEST(Labels, AreInErrorsAboutThePlacesOfConstraints)
{
  const Model model = makeModel(labelledGrid(), "grid");
  try {
    static_cast<void>(model.locator().locate(AtFace{1, {0.1, 0.1, 0.1, 0.1, 0.6}}, {}));
    FAIL() << "no face of this mesh has five corners";
  } catch (const InputError& error) {
    EXPECT_THAT(error.reason(), HasSubstr("face 1 (labelled 20001) has"));
  }
}

}  // namespace
}  // namespace holdfast::test
