// A gesture that was recorded in the window does the same in another window, and in a program of VTK alone.

#include "interaction/recorded_gesture.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QVTKInteractor.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/constraint_drag.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastRegionWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// Returns the view of the camera in all of them.
test::PlainView seenBracket()
{
  test::PlainView view;
  view.eye = {60, 130, 420};
  view.target = {0, 0, 20};
  return view;
}

/// The window with the bracket, a tool chosen.
class BracketWindow : public test::OpenWindow {
 public:
  void begin(const char* tool)
  {
    SetUp();
    open("bracket.obj");
    look(view);
    trigger(tool);
  }
  void TestBody() override {}

  [[nodiscard]] std::string document() { return constraintsToJson(list()); }
  [[nodiscard]] vtkRenderWindowInteractor& interactor() { return *viewport().interactor(); }

  using OpenWindow::editor;
  using OpenWindow::inWidget;
  using OpenWindow::onArrow;
  using OpenWindow::settle;
  using OpenWindow::shownAt;
  using OpenWindow::trigger;
  using OpenWindow::viewport;

  test::PlainView view = seenBracket();
};

/// The widgets of the tools in a window of VTK alone, and a document that functions of the core edit.
class PlainProgram {
 public:
  PlainProgram(std::shared_ptr<const Model> model, const test::PlainView& view)
      : model_(std::move(model)), surface_(std::make_shared<const VisibleSurface>(*model_)), screen_(view)
  {
    interactor_->SetRenderWindow(screen_.renderer().GetRenderWindow());
    interactor_->SetInteractorStyle(nullptr);
    interactor_->Initialize();
    for (vtkAbstractWidget* widget : std::initializer_list<vtkAbstractWidget*>{points_, gizmo_, brush_}) {
      widget->SetInteractor(interactor_);
      widget->SetDefaultRenderer(&screen_.renderer());
    }
    points_->SetSurface(surface_);
    points_->AddObserver(vtkCommand::PlacePointEvent, this, &PlainProgram::hold);
    gizmo_->AddObserver(vtkCommand::InteractionEvent, this, &PlainProgram::move);
    gizmo_->AddObserver(vtkCommand::EndInteractionEvent, this, &PlainProgram::placeGizmo);
    brush_->SetShape(RegionShape::Brush);
    brush_->SetSurface(surface_);
    brush_->SetRegions(std::make_shared<VertexRegions>(model_->mesh, model_->solverMesh));
    brush_->AddObserver(vtkCommand::StartInteractionEvent, this, &PlainProgram::startStroke);
    brush_->AddObserver(vtkCommand::EndInteractionEvent, this, &PlainProgram::endStroke);
  }

  [[nodiscard]] vtkRenderWindowInteractor& interactor() { return *interactor_; }
  [[nodiscard]] vtkAbstractWidget& points() { return *points_; }
  [[nodiscard]] vtkAbstractWidget& brush() { return *brush_; }
  [[nodiscard]] std::string document() const { return constraintsToJson(list_); }

  void makeFixed()
  {
    list_ = added(list_, {unusedName(list_, "fixed "), true, FixedConstraint{Selection{VertexIds{selected_}}}});
  }

 private:
  void hold(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
  {
    const auto& pick = *static_cast<const SurfacePick*>(callData);
    list_ = added(list_, {unusedName(list_, "P"), true, PointConstraint{pick.location, Target{pick.place}}});
    placeGizmo();
  }

  /// The gizmo, for the last constraint.
  void placeGizmo()
  {
    const std::vector<Index> last{static_cast<Index>(list_.constraints.size()) - 1};
    drag_ = std::make_unique<ConstraintDrag>(*model_, list_, last, "list");
    gizmo_->GetGizmoRepresentation()->SetMotions(GizmoMotions::Moves);
    gizmo_->GetGizmoRepresentation()->SetFrame(drag_->center(), Eigen::Matrix3d::Identity());
    pivot_ = drag_->center();
    gizmo_->On();
  }

  void move(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
  {
    const auto& motion = *static_cast<const GizmoMotion*>(callData);
    list_ = drag_->movedBy({motion.axis, motion.degrees, pivot_, motion.translation});
  }

  void startStroke() { before_ = selected_; }

  void endStroke(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
  {
    const auto& [reached, mode] = *static_cast<const RegionCallData*>(callData);
    selected_ = joined(before_, reached, mode);
  }

  std::shared_ptr<const Model> model_;
  std::shared_ptr<const VisibleSurface> surface_;
  test::PlainScreen screen_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<vtkHoldfastSurfacePointWidget> points_;
  vtkNew<vtkHoldfastGizmoWidget> gizmo_;
  vtkNew<vtkHoldfastRegionWidget> brush_;
  ConstraintList list_;
  std::unique_ptr<ConstraintDrag> drag_;
  Vector3 pivot_ = Vector3::Zero();
  std::vector<Index> before_;
  std::vector<Index> selected_;
};

/// The window in which gestures are recorded, and the others that repeat them.
class RecordedInWindow : public ::testing::Test {
 protected:
  /// A point picked in a face, dragged by the gizmo's arrows, and moved by a length that is typed.
  void holdAndDrag(const QPointF& way)
  {
    test::pressKey(first.viewport(), Qt::Key_F);
    test::click(first.viewport(), first.inWidget(first.view.shown({30, 0, 40}).head<2>()));
    ASSERT_TRUE(first.settle());
    for (const int axis : {1, 0}) {
      const QPointF from = first.onArrow(axis);
      test::drag(first.viewport(), {from, from + way / 2, from + way});
      ASSERT_TRUE(first.settle());
    }
    test::moveMouse(first.viewport(), first.onArrow(0));
    test::type(first.viewport(), "-2.5");
    test::pressKey(first.viewport(), Qt::Key_Return);
    ASSERT_TRUE(first.settle());
  }

  [[nodiscard]] PlainProgram plainProgram() { return {first.editor().model(), first.view}; }

  BracketWindow first;
};

TEST_F(RecordedInWindow, HoldsAndMovesThePointToTheSamePlacesBitForBit)
{
  first.begin("toolPoint");
  ASSERT_EQ(first.editor().positions(), first.editor().model()->mesh.positions);
  const std::string before = first.document();
  const std::string events = test::recorded(first.interactor(), [&] { holdAndDrag({20, -45}); });
  const std::string document = first.document();
  ASSERT_EQ(first.editor().list().constraints.size(), 1u);
  ASSERT_EQ(first.editor().history().undoName(), "move P1");

  BracketWindow second;
  second.begin("toolPoint");
  ASSERT_EQ(second.viewport().size(), first.viewport().size());
  test::replay(events, second.interactor());
  EXPECT_EQ(second.document(), document);

  PlainProgram plain = plainProgram();
  plain.points().On();
  test::replay(events, plain.interactor());
  EXPECT_EQ(plain.document(), document);
}

TEST_F(RecordedInWindow, ComparisonMustFailForAnotherGesture)
{
  first.begin("toolPoint");
  holdAndDrag({20, -45});
  const std::string document = first.document();
  while (first.editor().history().canUndo()) first.trigger("undo");
  first.editor().selectConstraints({});
  ASSERT_TRUE(first.settle());
  const std::string events = test::recorded(first.interactor(), [&] { holdAndDrag({20, -46}); });
  EXPECT_NE(first.document(), document);
  PlainProgram plain = plainProgram();
  plain.points().On();
  test::replay(events, plain.interactor());
  EXPECT_EQ(plain.document(), first.document());
}

TEST_F(RecordedInWindow, FixesTheSameVertices)
{
  first.begin("toolBrush");
  const std::string events = test::recorded(first.interactor(), [&] {
    const QPointF from = first.shownAt({30, 0, 40});
    test::drag(first.viewport(), {from, from + QPointF(30, 10), from + QPointF(50, -20)});
    test::drag(first.viewport(), {from + QPointF(30, 0), from + QPointF(30, 30)}, Qt::LeftButton, Qt::ControlModifier);
    ASSERT_TRUE(first.settle());
  });
  ASSERT_GT(first.editor().selectedVertices().size(), 10u);
  first.trigger("makeFixed");

  BracketWindow second;
  second.begin("toolBrush");
  test::replay(events, second.interactor());
  second.trigger("makeFixed");
  EXPECT_EQ(second.document(), first.document());

  PlainProgram plain = plainProgram();
  plain.brush().On();
  test::replay(events, plain.interactor());
  plain.makeFixed();
  EXPECT_EQ(plain.document(), first.document());
}

}  // namespace
}  // namespace holdfast
