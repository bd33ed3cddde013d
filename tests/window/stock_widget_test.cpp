// A widget of VTK's own that a program adds to the window works beside those of the tools.

#include <array>

#include <QVTKInteractor.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSphereRepresentation.h>
#include <vtkSphereWidget2.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The bracket without perspective, and a sphere of VTK in the layer of the widgets.
class StockWidget : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setParallelProjection(true);
    ASSERT_TRUE(settle());
    sphere->SetRepresentation(shape);
    sphere->SetInteractor(viewport().interactor());
    sphere->SetDefaultRenderer(&viewport().widgetRenderer());
  }

  // A program does so at `Viewport::closing`.
  void TearDown() override { sphere->SetInteractor(nullptr); }

  void putSphere(Vector3 center, double pixels)
  {
    const double radius = pixels * DisplayTransform(viewport().renderer()).worldPerPixel(center);
    std::array<double, 6> bounds{center.x() - radius, center.x() + radius, center.y() - radius,
                                 center.y() + radius, center.z() - radius, center.z() + radius};
    shape->PlaceWidget(bounds.data());
    sphere->On();
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] Vector3 center() { return Vector3(shape->GetCenter()); }

  void dragBy(const QPointF& from, const QPointF& way)
  {
    test::drag(viewport(), {from, from + way / 2, from + way});
    ASSERT_TRUE(settle());
  }

  vtkNew<vtkSphereWidget2> sphere;
  vtkNew<vtkSphereRepresentation> shape;
};

TEST_F(StockWidget, FollowsTheMouseAndToolsPickWhereItIsNot)
{
  const Index vertex = freeVertex();
  const Vector3 place = editor().positions().row(vertex).transpose();
  const auto before = editor().history().state();
  const Vector3 eye(viewport().renderer().GetActiveCamera()->GetPosition());
  trigger("toolPoint");
  test::pressKey(viewport(), Qt::Key_V);
  putSphere(place, 40);
  test::click(viewport(), seenAt(vertex));
  EXPECT_EQ(editor().history().state(), before) << "the sphere lies before the vertex";

  int pictures = 0;
  QObject::connect(&viewport(), &Viewport::rendered, &viewport(), [&] { ++pictures; });
  const QPointF way(90, -70);
  const QPointF start = shownAt(center());
  dragBy(seenAt(vertex), way);
  const QPointF moved = shownAt(center()) - start;
  EXPECT_NEAR(moved.x(), way.x(), 1);
  EXPECT_NEAR(moved.y(), way.y(), 1);
  EXPECT_GT(pictures, 0);
  EXPECT_EQ(editor().history().state(), before);
  EXPECT_EQ(Vector3(viewport().renderer().GetActiveCamera()->GetPosition()), eye);

  const Vector3 there = center();
  holdVertex(vertex);
  EXPECT_EQ(center(), there);
}

TEST_F(StockWidget, GivesWayToTheGizmoUnlessItsPriorityIsTheHigherOne)
{
  const Index point = *indexOf(list(), "flange east");
  const auto target = [&] {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[point].what).to).place;
  };
  editor().selectConstraints({point});
  ASSERT_TRUE(settle());
  putSphere(target(), 2 * kGizmoPixels);
  const Vector3 sphereAt = center();
  const Vector3 pointAt = target();
  dragBy(onArrow(2), {0, -40});
  EXPECT_GT(target().z(), pointAt.z() + 1);
  EXPECT_EQ(center(), sphereAt);

  window.gizmo().widget().SetPriority(sphere->GetPriority() - 0.1F);
  const auto before = editor().history().state();
  dragBy(onArrow(2), {0, -40});
  EXPECT_EQ(editor().history().state(), before);
  EXPECT_GT((center() - sphereAt).norm(), 1);
}

}  // namespace
}  // namespace holdfast
