#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "holdfast/widgets/interaction/vtkHoldfastConstraintMarkWidget.h"
#include "interaction/call_data_log.h"
#include "interaction/interaction_fixture.h"
#include "interaction/recorded_gesture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::CallDataLog;
using test::InteractionFixture;
using testing::ElementsAre;
using testing::IsEmpty;

ConstraintMark markAt(const Vector3& place, MarkKind kind, Index constraint)
{
  ConstraintMark mark{place, place};
  mark.kind = kind;
  mark.constraint = constraint;
  return mark;
}

/// A region, a point in one of its vertices, and a point elsewhere.
std::vector<ConstraintMark> threeConstraints()
{
  return {markAt({1, 1, 0}, MarkKind::Selection, 0), markAt({2, 1, 0}, MarkKind::Selection, 0),
          markAt({2, 1, 0}, MarkKind::Vertex, 1), markAt({3, 2, 0}, MarkKind::Face, 2)};
}

struct MarkWidgetFixture : InteractionFixture {
  MarkWidgetFixture() : InteractionFixture(test::grid(4, 3))
  {
    widget->SetMarks(markSet(model(), threeConstraints(), nullptr));
    enable(*widget);
  }

  vtkNew<vtkHoldfastConstraintMarkWidget> widget;
  CallDataLog<Index> highlighted{*widget, vtkCommand::HighlightEvent};
  CallDataLog<ConstraintPick> picked{*widget, vtkCommand::PickEvent};
};

struct MarkWidget : MarkWidgetFixture, testing::Test {};

TEST_F(MarkWidget, TellsWhatTheCursorIsOver)
{
  mouse().moveTo(pixelOf({1, 1, 0}));
  mouse().moveTo(pixelOf({1, 1, 0}) + DisplayPoint(3, 2));
  mouse().moveTo(pixelOf({2, 1, 0}));
  EXPECT_EQ(widget->GetHighlighted(), 1) << "points before regions";
  mouse().moveTo(pixelOf({2.5, 1.5, 0}));
  mouse().moveTo(pixelOf({3, 2, 0}));
  mouse().leave();
  EXPECT_THAT(highlighted.data(), ElementsAre(0, 1, std::nullopt, 2, std::nullopt));
  EXPECT_THAT(picked.data(), IsEmpty());
}

TEST_F(MarkWidget, TellsWhatIsClickedAndWhatIsHeld)
{
  mouse().click(pixelOf({3, 2, 0}));
  mouse().click(pixelOf({1, 1, 0}), {.shift = true});
  mouse().click(pixelOf({2, 1, 0}), {.ctrl = true});
  mouse().click(pixelOf({2.5, 1.5, 0}));
  mouse().click({1, 1}, {.shift = true});
  ASSERT_EQ(picked.data().size(), 5U);
  const auto is = [](Index constraint, bool isAdded) {
    return testing::Optional(testing::AllOf(testing::Field(&ConstraintPick::constraint, constraint),
                                            testing::Field(&ConstraintPick::isAdded, isAdded)));
  };
  EXPECT_THAT(picked.data(), ElementsAre(is(2, false), is(0, true), is(1, true), is(-1, false), is(-1, true)));
}

TEST_F(MarkWidget, ADragIsNoClickAndBelongsToTheCamera)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  interactor().SetInteractorStyle(style);
  const DisplayPoint from = pixelOf({3, 2, 0});
  mouse().moveTo(from);
  mouse().press(from);
  mouse().moveTo(from + DisplayPoint(6, 0));
  mouse().moveTo(from + DisplayPoint(1, 0));
  EXPECT_EQ(widget->GetHighlighted(), -1) << "while the camera moves";
  mouse().release(from);
  EXPECT_THAT(picked.data(), IsEmpty());
  mouse().doubleClick(pixelOf({3, 2, 0}));
  EXPECT_EQ(picked.data().size(), 1U);
}

TEST_F(MarkWidget, ReachesAsFarAsItsPixelsAndTheRatio)
{
  const DisplayPoint beside = pixelOf({3, 2, 0}) + DisplayPoint(12, 0);
  mouse().moveTo(beside);
  EXPECT_EQ(widget->GetHighlighted(), -1);
  widget->SetPixelRatio(2);
  mouse().moveTo(beside);
  EXPECT_EQ(widget->GetHighlighted(), 2);
  widget->GetConstraintMarkRepresentation()->SetReachPixels(4);
  mouse().moveTo(beside);
  EXPECT_EQ(widget->GetHighlighted(), -1);
}

TEST_F(MarkWidget, MarksBehindTheEyeAreNotFound)
{
  renderer().GetActiveCamera()->SetPosition(3, 2, -1);
  renderer().GetActiveCamera()->SetFocalPoint(3, 2, -5);
  mouse().click({200, 150});
  ASSERT_EQ(picked.data().size(), 1U);
  EXPECT_EQ(picked.data()[0]->constraint, -1);
}

TEST_F(MarkWidget, FindsARegionByItsFaces)
{
  std::vector<ConstraintMark> square;
  for (const Index vertex : {6, 7, 11, 12}) {
    square.push_back(markAt(model().mesh.positions.row(vertex), MarkKind::Selection, 4));
    square.back().unknown = vertex;
  }
  widget->SetMarks(markSet(model(), square, nullptr));
  mouse().moveTo(pixelOf({1.5, 1.5, 0}));
  EXPECT_EQ(widget->GetHighlighted(), -1) << "it knows no faces";
  widget->SetSurface(surface());
  mouse().moveTo(pixelOf({1.4, 1.5, 0}));
  EXPECT_EQ(widget->GetHighlighted(), 4);
  mouse().moveTo(pixelOf({2.5, 1.5, 0}));
  EXPECT_EQ(widget->GetHighlighted(), -1) << "beside it";
  mouse().click(pixelOf({1.5, 1.4, 0}));
  ASSERT_EQ(picked.data().size(), 1U);
  EXPECT_EQ(picked.data()[0]->constraint, 4);
}

TEST_F(MarkWidget, ForgetsWhatHasNoMarksAnyMore)
{
  mouse().moveTo(pixelOf({3, 2, 0}));
  auto marks = threeConstraints();
  marks.back().place.x() = 3.2;
  widget->SetMarks(markSet(model(), marks, nullptr));
  EXPECT_EQ(widget->GetHighlighted(), 2) << "a mark that moves is not lost";
  marks.pop_back();
  widget->SetMarks(markSet(model(), marks, nullptr));
  EXPECT_EQ(widget->GetHighlighted(), -1);
  EXPECT_THAT(highlighted.data(), ElementsAre(2, std::nullopt));
}

TEST_F(MarkWidget, DisabledItTellsNothing)
{
  mouse().moveTo(pixelOf({3, 2, 0}));
  mouse().press(pixelOf({3, 2, 0}));
  widget->SetEnabled(0);
  EXPECT_THAT(highlighted.data(), ElementsAre(2, std::nullopt));
  mouse().release(pixelOf({3, 2, 0}));
  mouse().click(pixelOf({3, 2, 0}));
  EXPECT_THAT(picked.data(), IsEmpty());
}

TEST_F(MarkWidget, ActsInItsRendererAlone)
{
  renderer().SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0, 1, 1);
  other->SetActiveCamera(renderer().GetActiveCamera());
  window().AddRenderer(other);
  const DisplayPoint inside = pixelOf({2, 1, 0});
  mouse().click(inside + DisplayPoint(200, 0));
  EXPECT_THAT(picked.data(), IsEmpty()) << "not even beside all marks";
  mouse().click(inside);
  EXPECT_EQ(picked.data().size(), 1U);
}

TEST_F(MarkWidget, BindingsAndPrioritiesCanBeChanged)
{
  vtkNew<vtkHoldfastConstraintMarkWidget> above;
  above->SetPriority(0.6F);
  enable(*above);
  const CallDataLog<ConstraintPick> first(*above, vtkCommand::PickEvent);
  mouse().click(pixelOf({3, 2, 0}));
  EXPECT_EQ(first.data().size() + picked.data().size(), 2U) << "clicks are left to all";
  widget->GetEventTranslator()->SetTranslation(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::NoEvent);
  widget->GetEventTranslator()->SetTranslation(vtkCommand::MiddleButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  widget->SetPriority(0.4F);
  mouse().click(pixelOf({3, 2, 0}));
  EXPECT_EQ(picked.data().size(), 1U);
  mouse().press(pixelOf({3, 2, 0}));
  mouse().middleRelease(pixelOf({3, 2, 0}));
  EXPECT_EQ(picked.data().size(), 2U);
}

TEST_F(MarkWidget, FindsNothingThatASectionCutsAway)
{
  const SectionPlane section{{2.5, 0, 0}, {1, 0, 0}};
  widget->GetConstraintMarkRepresentation()->SetSection(&section);
  mouse().click(pixelOf({2, 1, 0}));
  mouse().click(pixelOf({3, 2, 0}));
  ASSERT_EQ(picked.data().size(), 2U);
  EXPECT_EQ(picked.data()[0]->constraint, -1);
  EXPECT_EQ(picked.data()[1]->constraint, 2);
}

TEST_F(MarkWidget, AReplayedGestureDoesTheSame)
{
  const std::string events = test::recorded(interactor(), [&] {
    mouse().click(pixelOf({2, 1, 0}), {.shift = true});
    mouse().moveTo(pixelOf({1, 1, 0}));
  });
  MarkWidgetFixture again;
  test::replay(events, again.interactor());
  EXPECT_EQ(again.highlighted.data(), highlighted.data());
  ASSERT_EQ(again.picked.data().size(), 1U);
  EXPECT_EQ(again.picked.data()[0]->constraint, 1);
  EXPECT_TRUE(again.picked.data()[0]->isAdded);
}

}  // namespace
}  // namespace holdfast
