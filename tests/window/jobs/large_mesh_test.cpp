// Job 6: meshes of 173,000 and 438,000 vertices, from the file to a moved handle.

#include "window/large_mesh.h"

#include <gtest/gtest.h>

#include <holdfast/io/mesh_file.h>

#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

class LargeMeshJob : public test::JobWindow, public ::testing::WithParamInterface<Index> {
 protected:
  void openMesh()
  {
    MeshDocument document;
    document.mesh = test::bumpyEllipsoid(GetParam());
    static_cast<void>(writeMesh(path("scan.ply"), document, document.mesh.positions));
    openFile(path("scan.ply"));
    ASSERT_EQ(editor().model()->mesh.vertexCount(), 6 * GetParam() * GetParam() + 2);
  }

  /// What a band of the screen shows, from its top to its bottom.
  [[nodiscard]] std::vector<QPointF> band(double from, double to)
  {
    const double high = viewport().height();
    return {{20, from * high}, {viewport().width() - 20.0, to * high}};
  }
};

TEST_P(LargeMeshJob, RegionsAreMadeAndMovedExactly)
{
  openMesh();
  key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  key(Qt::Key_I);
  EXPECT_EQ(static_cast<Index>(editor().selectedVertices().size()), editor().model()->mesh.vertexCount());
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(editor().selectedVertices().empty());

  const double top = seenAt(Vector3(0, 0, 90)).y() / viewport().height();
  const double bottom = seenAt(Vector3(0, 0, -90)).y() / viewport().height();
  const Index fixed = constrainBy(Qt::Key_M, band(bottom - 0.04, 0.999), Qt::Key_F);
  dragWith(Qt::Key_M, band(0.001, top + 0.04));
  ASSERT_TRUE(test::waitUntil([this] { return !editor().selectedVertices().empty(); }));
  const std::size_t drawn = editor().selectedVertices().size();
  key(Qt::Key_Plus);
  EXPECT_GT(editor().selectedVertices().size(), drawn) << "grown by a ring";
  key(Qt::Key_H);
  ASSERT_TRUE(settle(std::chrono::minutes(3)));
  ASSERT_EQ(list().constraints.size(), 2u);
  ASSERT_GT(verticesOf(fixed).size(), 100u);
  ASSERT_GT(verticesOf(1).size(), drawn);

  viewport().setFocus();
  keys("x12.5");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle(std::chrono::minutes(3)));
  for (const Index v : verticesOf(fixed)) ASSERT_EQ(nowOf(v), restOf(v)) << v;
  for (const Index v : verticesOf(1)) ASSERT_EQ(nowOf(v), Vector3(restOf(v) + Vector3(12.5, 0, 0))) << v;
  expectAllMet();
  EXPECT_LT(editor().deformation()->report.solve.accuracy, 1e-9);
  expectPicture();
}

INSTANTIATE_TEST_SUITE_P(, LargeMeshJob, ::testing::Values(170, 270),
                         [](const auto& size) { return size.param == 170 ? "Of173Thousand" : "Of438Thousand"; });

}  // namespace
}  // namespace holdfast
