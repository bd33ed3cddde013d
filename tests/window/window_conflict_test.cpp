#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

// Pixels to all sides of a ball's middle that are the ball's.
constexpr int kReach = 2;

/// Of all channels the one that differs most, from 0 to 255.
int difference(const QColor& a, const QColor& b)
{
  return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

/// A vertex of the bracket that is held twice: by "P1", and by "P2" after it.
class HeldTwice : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    vertex = freeVertex();
    holdVertex(vertex);
    first = static_cast<Index>(list().constraints.size()) - 1;
    second = first + 1;
    // The arrows stand at the point as long as it is selected, and come first.
    key(Qt::Key_Escape);
    holdVertex(vertex);
    trigger("toolSelect");
    openPanel("Conflicts");
  }

  [[nodiscard]] std::string nameOf(Index row) { return list().constraints[row].name; }
  [[nodiscard]] ConstraintStatus status(Index row) { return editor().deformation()->report.constraints[row].status; }
  [[nodiscard]] QString dockTitle() { return find<QDockWidget>("conflictsDock").windowTitle(); }

  [[nodiscard]] std::vector<ConstraintMark> marksOf(Index row)
  {
    std::vector<ConstraintMark> marks = viewport().marks();
    std::erase_if(marks, [&](const ConstraintMark& mark) { return mark.constraint != row; });
    return marks;
  }

  /// What share of the pixels of the ball at the vertex has the colour of `status`, without the shades of its light.
  [[nodiscard]] double shareDrawnAs(ConstraintStatus status)
  {
    // Rings and arrows stand where something is selected.
    editor().selectConstraints({});
    vtkActorCollection* actors = viewport().renderer().GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) actor->GetProperty()->LightingOff();
    viewport().scheduleRender();
    EXPECT_TRUE(settle());
    const QPoint middle(static_cast<int>(seenAt(vertex).x()), static_cast<int>(seenAt(vertex).y()));
    const QImage ball =
        viewport().grab(QRect(middle - QPoint(kReach, kReach), QSize(2 * kReach + 1, 2 * kReach + 1))).toImage();
    int count = 0;
    for (int y = 0; y < ball.height(); ++y)
      for (int x = 0; x < ball.width(); ++x)
        if (difference(ball.pixelColor(x, y), toQColor(glyphColor(status))) <= 2) ++count;
    return static_cast<double>(count) / (ball.width() * ball.height());
  }

  [[nodiscard]] Card* conflictCard()
  {
    for (Card* card : window.findChildren<Card*>())
      if (card->isVisible() && card->findChild<QPushButton*>("conflictDisable") != nullptr) return card;
    return nullptr;
  }

  [[nodiscard]] QString textOf(const Card& card, const char* label) { return card.findChild<QLabel*>(label)->text(); }

  void expectNoConflict()
  {
    EXPECT_NE(status(second), ConstraintStatus::Conflicting);
    EXPECT_EQ(conflictCard(), nullptr);
    EXPECT_EQ(dockTitle(), "Conflicts");
    EXPECT_EQ(tabOf("Conflicts"), "Conflicts");
    const auto marks = marksOf(second);
    EXPECT_TRUE(std::none_of(marks.begin(), marks.end(),
                             [](const ConstraintMark& mark) { return mark.status == ConstraintStatus::Conflicting; }));
  }

  /// What every part of the window says while "P2" asks for a place 2.5 away.
  void expectConflict()
  {
    EXPECT_EQ(shown(second, Table::Status), "conflicting");
    EXPECT_EQ(shown(first, Table::Status), "met");
    EXPECT_EQ(dockTitle(), "Conflicts (1)");
    EXPECT_EQ(tabOf("Conflicts"), "Conflicts (1)");
    const auto marks = marksOf(second);
    ASSERT_EQ(marks.size(), 1u);
    EXPECT_EQ(marks.front().status, ConstraintStatus::Conflicting);
    EXPECT_EQ(marks.front().target,
              std::get<Target>(std::get<PointConstraint>(list().constraints[second].what).to).place);
    ASSERT_NE(conflictCard(), nullptr);
    EXPECT_TRUE(conflictCard()->isEnabled());
  }

  void typeConflict()
  {
    const double z = std::get<Target>(std::get<PointConstraint>(list().constraints[first].what).to).place.z();
    typeInto(second, Table::Z, std::to_string(z + 2.5).c_str());
    ASSERT_TRUE(settle());
  }

  void pressOnCard(const char* button)
  {
    auto* found = conflictCard()->findChild<QPushButton*>(button);
    ASSERT_NE(found, nullptr);
    ASSERT_TRUE(found->isVisible());
    clickOn(*found);
    ASSERT_TRUE(settle());
  }

  Index vertex = 0;
  Index first = 0;
  Index second = 0;
};

TEST_F(HeldTwice, RepeatsWhereItAgrees)
{
  EXPECT_EQ(shown(second, Table::Status), "redundant");
  expectNoConflict();
}

TEST_F(HeldTwice, ConflictsWhereAnotherTargetIsTyped)
{
  typeConflict();
  expectConflict();
  const double gap = (editor().deformation()->report.constraints[second].conflictSets.front().gap).norm();
  EXPECT_NEAR(gap, 2.5, 1e-5);
}

TEST_F(HeldTwice, ConflictsWhereItIsDraggedAway)
{
  editor().selectConstraints({second});
  ASSERT_TRUE(settle());
  const vtkHoldfastGizmoRepresentation& gizmo = window.gizmo().gizmo();
  ASSERT_TRUE(window.gizmo().widget().GetEnabled());
  const Vector3 center = gizmo.GetFrame().center;
  const QPointF step = seenAt(Vector3(center + Vector3::UnitZ())) - seenAt(center);
  // On the shaft of the arrow that points up.
  const QPointF from = seenAt(center) + 0.5 * kGizmoPixels / std::hypot(step.x(), step.y()) * step;
  test::drag(viewport(), {from, from + QPointF(0, -20), from + QPointF(0, -50)});
  ASSERT_TRUE(settle());
  expectConflict();
}

TEST_F(HeldTwice, TheCardSaysWithWhatAndByHowMuch)
{
  typeConflict();
  ASSERT_NE(conflictCard(), nullptr);
  const QString title = textOf(*conflictCard(), "cardTitle");
  const QString expected = QString("“%1” asks for a place 2.5\u00a0mm away from where “%2” puts it.")
                               .arg(nameOf(second).c_str(), nameOf(first).c_str());
  EXPECT_EQ(title, expected) << title.toStdString();
  const QString text = textOf(*conflictCard(), "cardText");
  EXPECT_TRUE(text.startsWith("Off by (")) << text.toStdString();
  EXPECT_TRUE(text.contains("2.5) mm")) << text.toStdString();
}

TEST_F(HeldTwice, TheBallTakesTheColourOfTheStatus)
{
  // Edges of the mesh may cross it.
  EXPECT_GT(shareDrawnAs(ConstraintStatus::Redundant), 0.6);
  EXPECT_EQ(shareDrawnAs(ConstraintStatus::Conflicting), 0);
  typeConflict();
  EXPECT_GT(shareDrawnAs(ConstraintStatus::Conflicting), 0.6);
  EXPECT_EQ(shareDrawnAs(ConstraintStatus::Redundant), 0);
}

TEST_F(HeldTwice, TheConsistentTargetResolvesItAndUndoBringsItBack)
{
  typeConflict();
  pressOnCard("conflictRetarget");
  EXPECT_EQ(status(second), ConstraintStatus::Redundant);
  expectNoConflict();
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  expectConflict();
}

TEST_F(HeldTwice, DisablingResolvesItAndUndoBringsItBack)
{
  typeConflict();
  pressOnCard("conflictDisable");
  EXPECT_EQ(status(second), ConstraintStatus::Disabled);
  EXPECT_EQ(shown(second, Table::Status), "disabled");
  expectNoConflict();
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  expectConflict();
}

TEST_F(HeldTwice, ASelectedSetIsSelectedEverywhere)
{
  typeConflict();
  pressOnCard("conflictSelect");
  EXPECT_EQ(editor().selectedConstraints(), (std::vector<Index>{first, second}));
  EXPECT_EQ(table().selectionModel()->selectedRows().size(), 2);
}

}  // namespace
}  // namespace holdfast
