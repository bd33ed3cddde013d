#include "holdfast/widgets/interaction/vtkHoldfastConstraintMarkWidget.h"

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastConstraintMarkWidget);

vtkHoldfastConstraintMarkWidget::vtkHoldfastConstraintMarkWidget()
{
  this->Bind<&vtkHoldfastConstraintMarkWidget::Hover>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&vtkHoldfastConstraintMarkWidget::Leave>(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave);
  this->Bind<&vtkHoldfastConstraintMarkWidget::PressClick>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&vtkHoldfastConstraintMarkWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
}

void vtkHoldfastConstraintMarkWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Highlighted: " << this->Highlighted << '\n';
}

void vtkHoldfastConstraintMarkWidget::SetMarks(std::shared_ptr<const MarkSet> marks)
{
  this->Drawn().SetMarks(std::move(marks));
  if (this->Highlighted >= 0 && !this->Drawn().HasMarksOf(this->Highlighted)) this->Leave();
}

Index vtkHoldfastConstraintMarkWidget::ConstraintAtCursor()
{
  if (!this->IsCursorInside()) return -1;
  return this->Drawn().FindConstraint(this->Cursor().x(), this->Cursor().y());
}

void vtkHoldfastConstraintMarkWidget::Highlight(Index constraint)
{
  if (this->Highlighted == constraint) return;
  this->Highlighted = constraint;
  this->ShowCursor(constraint >= 0 ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
  this->InvokeEvent(vtkCommand::HighlightEvent, constraint >= 0 ? &constraint : nullptr);
}

void vtkHoldfastConstraintMarkWidget::Hover()
{
  this->LeftClick.LeaveAt(this->Cursor(), this->Drawn().GetPixelRatio());
  this->Highlight(isCameraMoving(*this->Interactor) ? -1 : this->ConstraintAtCursor());
}

void vtkHoldfastConstraintMarkWidget::Release()
{
  if (!this->LeftClick.Release(this->Cursor(), this->Drawn().GetPixelRatio())) return;
  ConstraintPick pick{this->ConstraintAtCursor(),
                      this->Interactor->GetShiftKey() != 0 || this->Interactor->GetControlKey() != 0};
  this->InvokeEvent(vtkCommand::PickEvent, &pick);
}
