#include "holdfast/widgets/interaction/constraint_mark_widget.h"

#include <algorithm>
#include <utility>

#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include <holdfast/widgets/interaction/cursor.h>
#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {

vtkStandardNewMacro(ConstraintMarkWidget);

template <void (ConstraintMarkWidget::*Action)()>
void ConstraintMarkWidget::Call(vtkAbstractWidget* widget)
{
  (static_cast<ConstraintMarkWidget*>(widget)->*Action)();
}

ConstraintMarkWidget::ConstraintMarkWidget()
{
  using Widget = ConstraintMarkWidget;
  vtkWidgetCallbackMapper& mapper = *this->CallbackMapper;
  mapper.SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &Call<&Widget::Hover>);
  mapper.SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, &Call<&Widget::Leave>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &Call<&Widget::Press>);
  mapper.SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                           &Call<&Widget::Release>);
}

void ConstraintMarkWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Highlighted: ";
  if (this->Highlighted)
    os << *this->Highlighted << '\n';
  else
    os << "(none)\n";
}

void ConstraintMarkWidget::SetRepresentation(ConstraintMarkRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
}

void ConstraintMarkWidget::CreateDefaultRepresentation()
{
  if (this->WidgetRep == nullptr) this->WidgetRep = ConstraintMarkRepresentation::New();
}

ConstraintMarkRepresentation* ConstraintMarkWidget::GetConstraintMarkRepresentation()
{
  return static_cast<ConstraintMarkRepresentation*>(this->GetRepresentation());
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

void ConstraintMarkWidget::Leave()
{
  this->Highlight(std::nullopt);
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
