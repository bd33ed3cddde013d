#include "holdfast/widgets/interaction/constraint_mark_widget.h"

#include <algorithm>
#include <utility>

#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {
namespace {

// Users aim at single points, not at one vertex of a region in the same place.
constexpr double kRegionHandicapPixels = 2;

}  // namespace

vtkStandardNewMacro(ConstraintMarkRepresentation);

void ConstraintMarkRepresentation::SetMarks(std::shared_ptr<const MarkSet> marks)
{
  this->Marks = std::move(marks);
  this->Modified();
}

bool ConstraintMarkRepresentation::HasMarksOf(Index constraint) const
{
  return this->Marks && std::any_of(this->Marks->marks.begin(), this->Marks->marks.end(),
                                    [&](const ConstraintMark& mark) { return mark.constraint == constraint; });
}

std::optional<Index> ConstraintMarkRepresentation::FindConstraint(double displayX, double displayY) const
{
  if (this->Renderer == nullptr || !this->Marks) return std::nullopt;
  const DisplayTransform toDisplay(*this->Renderer);
  const DisplayPoint cursor = centerOfPixel(displayX, displayY);
  double nearest = this->ReachPixels * this->PixelRatio;
  std::optional<Index> found;
  for (const ConstraintMark& mark : this->Marks->marks) {
    if (this->Section && !isKept(*this->Section, mark.place)) continue;
    const DisplayTransform::Shown shown = toDisplay.show(mark.place);
    if (shown.depth <= 0) continue;
    const double handicap = isSinglePoint(mark.kind) ? 0 : kRegionHandicapPixels * this->PixelRatio;
    const double distance = (shown.point - cursor).norm() + handicap;
    if (distance >= nearest) continue;
    nearest = distance;
    found = mark.constraint;
  }
  return found;
}

vtkStandardNewMacro(ConstraintMarkWidget);

ConstraintMarkWidget::ConstraintMarkWidget()
{
  using Widget = ConstraintMarkWidget;
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &call<&Widget::Hover>);
  mapper.SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, &call<&Widget::Leave>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &call<&Widget::Press>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                           &call<&Widget::Release>);
}

void ConstraintMarkWidget::SetEnabled(int enabling)
{
  if (enabling == 0 && this->Enabled != 0) this->Leave();
  this->LeftClick.Forget();
  this->Superclass::SetEnabled(enabling);
}

void ConstraintMarkWidget::SetMarks(std::shared_ptr<const MarkSet> marks)
{
  this->GetConstraintMarkRepresentation()->SetMarks(std::move(marks));
  if (this->Highlighted && !this->GetConstraintMarkRepresentation()->HasMarksOf(*this->Highlighted)) this->Leave();
}

std::optional<Index> ConstraintMarkWidget::ConstraintAtCursor()
{
  if (!isCursorIn(*this->CurrentRenderer, *this->Interactor)) return std::nullopt;
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  return this->GetConstraintMarkRepresentation()->FindConstraint(cursor.x(), cursor.y());
}

void ConstraintMarkWidget::Highlight(std::optional<Index> constraint)
{
  if (this->Highlighted == constraint) return;
  this->Highlighted = constraint;
  if (this->ManagesCursor != 0) this->RequestCursorShape(constraint ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
  this->InvokeEvent(vtkCommand::HighlightEvent, constraint ? &*constraint : nullptr);
}

void ConstraintMarkWidget::Hover()
{
  this->LeftClick.LeaveAt(cursorOf(*this->Interactor), this->PixelRatio());
  this->Highlight(isCameraMoving(*this->Interactor) ? std::nullopt : this->ConstraintAtCursor());
}

void ConstraintMarkWidget::Press()
{
  this->LeftClick.Forget();
  if (isSecondPress(*this->Interactor) || !isCursorIn(*this->CurrentRenderer, *this->Interactor)) return;
  this->LeftClick.Press(cursorOf(*this->Interactor));
}

void ConstraintMarkWidget::Release()
{
  if (!this->LeftClick.Release(cursorOf(*this->Interactor), this->PixelRatio())) return;
  ConstraintPick pick{this->ConstraintAtCursor(),
                      this->Interactor->GetShiftKey() != 0 || this->Interactor->GetControlKey() != 0};
  this->InvokeEvent(vtkCommand::PickEvent, &pick);
}

}  // namespace holdfast
