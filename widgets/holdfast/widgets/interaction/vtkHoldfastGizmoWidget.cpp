#include "holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h"

#include <algorithm>
#include <cctype>

using namespace holdfast;

namespace {

// Before the widgets that pick on the surface.
constexpr float kGizmoPriority = 0.6F;

constexpr char kEscapeKey = 27;

// Of each button, those by which it goes down first.
constexpr std::array<std::array<unsigned long, 3>, 3> kButtonEvents{
    {{vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonDoubleClickEvent, vtkCommand::LeftButtonReleaseEvent},
     {vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonDoubleClickEvent,
      vtkCommand::MiddleButtonReleaseEvent},
     {vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonDoubleClickEvent,
      vtkCommand::RightButtonReleaseEvent}}};

/// 0, 1 and 2 for "x", "y" and "z", small or large; others are beyond.
int axisOfKey(char key)
{
  return std::tolower(static_cast<unsigned char>(key)) - 'x';
}

bool isAxisKey(char key)
{
  return axisOfKey(key) >= 0 && axisOfKey(key) < 3;
}

bool isShortcut(vtkRenderWindowInteractor& interactor)
{
  return interactor.GetControlKey() != 0 || interactor.GetAltKey() != 0;
}

}  // namespace

vtkStandardNewMacro(vtkHoldfastGizmoWidget);

vtkHoldfastGizmoWidget::vtkHoldfastGizmoWidget()
{
  this->Priority = kGizmoPriority;
  this->Bind<&vtkHoldfastGizmoWidget::Hover>(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  this->Bind<&vtkHoldfastGizmoWidget::Leave>(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave);
  this->Bind<&vtkHoldfastGizmoWidget::Press>(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  this->Bind<&vtkHoldfastGizmoWidget::Press>(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::Select);
  this->Bind<&vtkHoldfastGizmoWidget::Release>(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  const auto bindKey = [this](int modifier, char key, unsigned long widgetEvent, void (*action)(vtkAbstractWidget*)) {
    this->CallbackMapper->SetCallbackMethod(vtkCommand::KeyPressEvent, modifier, key, 0, nullptr, widgetEvent, this,
                                            action);
  };
  for (const char key : {'x', 'y', 'z', 'X', 'Y', 'Z'}) {
    bindKey(vtkEvent::NoModifier, key, vtkWidgetEvent::Translate, Call<&vtkHoldfastGizmoWidget::ChooseArrow>);
    bindKey(vtkEvent::ShiftModifier, key, vtkWidgetEvent::Rotate, Call<&vtkHoldfastGizmoWidget::ChooseRing>);
  }
  for (const char key : NumericInput::kKeys)
    bindKey(vtkEvent::AnyModifier, key, vtkWidgetEvent::ModifyEvent, Call<&vtkHoldfastGizmoWidget::Type>);
  this->BindKey<&vtkHoldfastGizmoWidget::Correct>("BackSpace", vtkWidgetEvent::Delete);
  for (const char* const keySym : {"Return", "KP_Enter"})
    this->BindKey<&vtkHoldfastGizmoWidget::Complete>(keySym, vtkWidgetEvent::Completed);
  this->BindKey<&vtkHoldfastGizmoWidget::Reset>("Escape", vtkWidgetEvent::Reset);

  // Gets the events of all buttons, also those that other widgets abort.
  this->ButtonObserver->SetClientData(this);
  this->ButtonObserver->SetCallback(&vtkHoldfastGizmoWidget::NoteButton);
  this->ButtonObserver->PassiveObserverOn();
}

void vtkHoldfastGizmoWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << this->IsDragging() << '\n';
  os << indent << "Held: " << this->Held << '\n';
  os << indent << "Chosen: " << this->Chosen << '\n';
  os << indent << "Typed: " << this->Typed.text() << '\n';
}

void vtkHoldfastGizmoWidget::SetEnabled(int isEnabled)
{
  if (this->Enabled == (isEnabled != 0 ? 1 : 0)) return;
  if (this->Enabled != 0) {
    this->Cancel();
    this->SetPart(GizmoPart::None);
    this->Interactor->RemoveObserver(this->ButtonObserver);
    this->WidgetRep->SetRenderer(nullptr);
  }
  this->WidgetOf::SetEnabled(isEnabled);
  if (this->Enabled == 0) return;
  this->ButtonsDown = 0;
  for (const auto& events : kButtonEvents)
    for (const unsigned long event : events) this->Interactor->AddObserver(event, this->ButtonObserver);
}

void vtkHoldfastGizmoWidget::NoteButton(vtkObject* /*interactor*/, unsigned long event, void* self, void* /*callData*/)
{
  unsigned& down = static_cast<vtkHoldfastGizmoWidget*>(self)->ButtonsDown;
  for (std::size_t k = 0; k < kButtonEvents.size(); ++k)
    if (event == kButtonEvents[k].back())
      down &= ~(1U << k);
    else if (std::ranges::count(kButtonEvents[k], event) > 0)
      down |= 1U << k;
}

void vtkHoldfastGizmoWidget::Highlight(GizmoPart part)
{
  if (part == this->GetPart()) return;
  this->Drawn().SetPart(part);
  this->ShowCursor(part == GizmoPart::None ? VTK_CURSOR_DEFAULT : VTK_CURSOR_HAND);
  this->InvokeEvent(vtkCommand::HighlightEvent, &part);
  this->Render();
}

void vtkHoldfastGizmoWidget::SetPart(GizmoPart part)
{
  if (this->Drag || this->Enabled == 0) return;
  if (part != GizmoPart::None && !this->Drawn().Offers(part)) return;
  this->Chosen = part != GizmoPart::None;
  this->Highlight(part);
}

bool vtkHoldfastGizmoWidget::WantsKey(char key)
{
  if (this->Enabled == 0) return false;
  if (!this->Typed.isEmpty()) return true;
  const bool isActive = this->GetPart() != GizmoPart::None;
  if (key == kEscapeKey) return this->Drag || (this->Chosen && isActive);
  if (NumericInput::isBegunBy(key)) return isActive;
  return isAxisKey(key) && !this->Drag && this->WidgetRep->GetVisibility() != 0;
}

bool vtkHoldfastGizmoWidget::Hover()
{
  if (this->Held) {
    if (this->Typed.isEmpty()) this->FollowCursor();
    return true;
  }
  if (this->ButtonsDown != 0) return false;
  if (this->Drag) return true;
  const GizmoPart part = this->PartUnderCursor();
  if (part == GizmoPart::None && this->Chosen) return false;
  this->Chosen = this->Chosen && part == this->GetPart();
  const bool wasActive = this->GetPart() != GizmoPart::None;
  this->Highlight(part);
  return wasActive && part != GizmoPart::None;
}

void vtkHoldfastGizmoWidget::Leave()
{
  if (!this->Drag && !this->Chosen) this->Highlight(GizmoPart::None);
}

bool vtkHoldfastGizmoWidget::Press()
{
  if (this->Drag) {
    this->Keep();
    return true;
  }
  const GizmoPart part = this->PartUnderCursor();
  if (part == GizmoPart::None) return false;
  this->Chosen = false;
  this->Highlight(part);
  this->Held = true;
  this->Grab();
  return true;
}

bool vtkHoldfastGizmoWidget::Release()
{
  if (!this->Held) return false;
  if (this->Typed.isEmpty()) this->FollowCursor();
  this->Keep();
  return true;
}

bool vtkHoldfastGizmoWidget::Choose(GizmoPart ofX)
{
  const char key = this->Interactor->GetKeyCode();
  if (!isAxisKey(key) || !this->WantsKey(key)) return false;
  this->SetPart(static_cast<GizmoPart>(static_cast<int>(ofX) + axisOfKey(key)));
  return true;
}

bool vtkHoldfastGizmoWidget::Type()
{
  const char key = this->Interactor->GetKeyCode();
  if (isShortcut(*this->Interactor) || !this->WantsKey(key)) return false;
  if (this->Typed.add(key)) this->FollowTyped();
  return true;
}

bool vtkHoldfastGizmoWidget::Correct()
{
  if (this->Typed.isEmpty()) return false;
  this->Typed.chop();
  if (!this->Typed.isEmpty())
    this->FollowTyped();
  else if (this->Held)
    this->FollowCursor();
  else
    this->Cancel();
  return true;
}

bool vtkHoldfastGizmoWidget::Complete()
{
  if (this->Typed.isEmpty()) return false;
  this->Keep();
  return true;
}

bool vtkHoldfastGizmoWidget::Reset()
{
  if (!this->WantsKey(kEscapeKey)) return false;
  this->Cancel();
  if (this->Chosen) this->SetPart(GizmoPart::None);
  return true;
}

/// The characters of the keys that are used; styles and programs act on them.
void vtkHoldfastGizmoWidget::OnChar()
{
  const bool isWanted = !isShortcut(*this->Interactor) && this->WantsKey(this->Interactor->GetKeyCode());
  if (isWanted)
    this->KeyPressCallbackCommand->SetAbortFlag(1);
  else
    this->Superclass::OnChar();
}

void vtkHoldfastGizmoWidget::Grab()
{
  // An observer may have hidden or disabled the gizmo.
  if (this->Enabled == 0 || this->GetPart() == GizmoPart::None) return this->EndDrag();
  this->Drag = this->Drawn().NewDrag(this->PixelCenter());
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
}

void vtkHoldfastGizmoWidget::FollowCursor()
{
  if (!this->Drag) return;
  const Snap snap = this->Interactor->GetControlKey() != 0 ? Snap::On : Snap::None;
  const GizmoMotion motion = this->Drag->to(this->PixelCenter(), snap);
  // Without snapping a pixel is about a tenth of a step.
  const RoundStep& step = this->Drag->step();
  const RoundStep digits = snap == Snap::On ? step : RoundStep{1, step.exponent - 1};
  this->MoveTo(motion, motionText(this->Drag->part(), motion, digits, this->Drawn().GetUnits()));
}

void vtkHoldfastGizmoWidget::FollowTyped()
{
  if (!this->Drag) this->Grab();
  if (!this->Drag) return;
  this->MoveTo(this->Drag->typed(this->Typed.value()),
               this->Typed.text() + "_" + motionUnit(this->Drag->part(), this->Drawn().GetUnits()));
}

void vtkHoldfastGizmoWidget::MoveTo(GizmoMotion motion, const std::string& label)
{
  this->Drawn().ShowDrag({this->Drag->part(), this->Drag->frame(), this->Drag->grabbed(), motion}, label,
                         this->PixelCenter());
  this->InvokeEvent(vtkCommand::InteractionEvent, &motion);
  this->Render();
}

void vtkHoldfastGizmoWidget::EndDrag()
{
  this->Drag.reset();
  this->Held = false;
  this->Typed.clear();
  this->Drawn().EndDrag();
}

void vtkHoldfastGizmoWidget::Keep()
{
  if (!this->Drag) return;
  this->EndDrag();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  this->Render();
}

void vtkHoldfastGizmoWidget::Cancel()
{
  if (!this->Drag) return;
  const GizmoFrame frame = this->Drag->frame();
  this->EndDrag();
  this->Drawn().SetFrame(frame.center, frame.axes);
  this->InvokeEvent(CancelInteractionEvent);
  this->Render();
}
