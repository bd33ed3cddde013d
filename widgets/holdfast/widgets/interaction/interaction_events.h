#pragma once
/// What the widgets of this room share: events beside VTK's, bindings, cursor, clicks, modes of selection.
/// docs/widgets.md lists the events of each widget with their call data, and its bindings, which its event translator
/// can change. Sizes are pixels of a display of ordinary resolution; `PixelRatio`, 1 by default, is the number of
/// pixels of the window for each of them.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <vtkAbstractWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkEvent.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetRepresentation.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

/// Events beside those of `vtkCommand`.
enum InteractionEvents : unsigned long {
  /// Instead of EndInteractionEvent: the gesture was taken back; restore the state before it.
  CancelInteractionEvent = vtkCommand::UserEvent + 18'500,
  /// The right button went down and up in one place. Call data: none; the interactor has the place.
  ContextMenuRequestEvent,
  /// A click is about to begin another ruler: the present one goes. Call data: none.
  NextRulerEvent
};

/// As `vtkSetMacro` sets a member of `object`, for types that VTK cannot print.
template <class Value>
void assign(vtkObject& object, Value& member, Value value)
{
  if (member == value) return;
  member = std::move(value);
  object.Modified();
}

/// A press and a release nearer than this are a click.
inline constexpr double kClickPixels = 4;

/// Whether the interactor's style moves the camera at the moment: nothing follows the cursor then.
[[nodiscard]] inline bool isCameraMoving(vtkRenderWindowInteractor& interactor)
{
  auto* style = vtkInteractorStyle::SafeDownCast(interactor.GetInteractorStyle());
  return style != nullptr && style->GetState() != VTKIS_NONE;
}

/// Whether the press that is being handled is the second one of a double click.
[[nodiscard]] inline bool isSecondPress(vtkRenderWindowInteractor& interactor)
{
  return interactor.GetRepeatCount() > 0;
}

/// The pixel of the event that is being handled.
[[nodiscard]] inline DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return {position[0], position[1]};
}

/// `ComputeInteractionState` of that pixel.
inline int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return representation.ComputeInteractionState(position[0], position[1]);
}

/// Points of a circle at equal distances, counterclockwise.
[[nodiscard]] inline std::vector<DisplayPoint> circle(const DisplayPoint& center, double radius, int corners)
{
  std::vector<DisplayPoint> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(center + radius * DisplayPoint(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// A click is a press and a release within `kClickPixels`. Widgets abort neither event, so that a drag from the same
/// place moves the camera.
class Click {
 public:
  void Press(const DisplayPoint& place) { this->PressedAt = place; }

  /// The cursor is at `place`: whether that ends a possible click.
  bool LeaveAt(const DisplayPoint& place, double pixelRatio)
  {
    if (!this->PressedAt || (place - *this->PressedAt).norm() < kClickPixels * pixelRatio) return false;
    this->PressedAt.reset();
    return true;
  }

  /// Whether the button that comes up at `place` clicks.
  [[nodiscard]] bool Release(const DisplayPoint& place, double pixelRatio)
  {
    this->LeaveAt(place, pixelRatio);
    return std::exchange(this->PressedAt, std::nullopt).has_value();
  }

  void Forget() { this->PressedAt.reset(); }

 private:
  std::optional<DisplayPoint> PressedAt;  // while the button is down and the cursor near
};

template <class Result, class Widget>
Widget classOf(Result (Widget::*action)());

/// A widget whose representation is of one class. Disabling it stops what is under way.
template <class Representation, class Base = vtkAbstractWidget>
class WidgetOf : public Base {
 public:
  void SetRepresentation(Representation* representation)
  {
    this->SetWidgetRepresentation(representation);
    if (representation != nullptr) this->Inform(*representation);
  }
  void SetEnabled(int enabling) override
  {
    if (enabling == 0 && this->Enabled != 0) this->Stop();
    this->LeftClick.Forget();
    this->Base::SetEnabled(enabling);
  }
  /// Not by SetRepresentation, which would disable the widget and enable it again: that asks for a representation.
  void CreateDefaultRepresentation() override
  {
    if (this->WidgetRep != nullptr) return;
    Representation* const representation = Representation::New();
    this->WidgetRep = representation;
    this->Inform(*representation);
  }

 protected:
  /// Tells a new representation what the widget knows.
  virtual void Inform(Representation& /*representation*/) {}
  /// The widget is enabled, and about to be disabled.
  virtual void Stop() {}
  [[nodiscard]] Representation& Drawn() { return *static_cast<Representation*>(this->GetRepresentation()); }

  /// The widget event calls a member function without arguments. One that returns true has used the VTK event.
  template <auto Action>
  void Bind(unsigned long event, unsigned long widgetEvent)
  {
    this->CallbackMapper->SetCallbackMethod(event, widgetEvent, this, &Call<Action>);
  }
  template <auto Action>
  void BindKey(const char* keySym, unsigned long widgetEvent)
  {
    this->CallbackMapper->SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, keySym, widgetEvent,
                                            this, &Call<Action>);
  }
  template <auto Action>
  static void Call(vtkAbstractWidget* widget)
  {
    auto* const self = static_cast<decltype(classOf(Action))*>(widget);
    if constexpr (std::is_void_v<decltype((self->*Action)())>)
      (self->*Action)();
    else if ((self->*Action)())
      self->Use();
  }

  [[nodiscard]] DisplayPoint Cursor() const { return cursorOf(*this->Interactor); }
  /// Whether it is in the renderer's part of the window.
  [[nodiscard]] bool IsCursorInside() const
  {
    const int* cursor = this->Interactor->GetEventPosition();
    return this->CurrentRenderer->IsInViewport(cursor[0], cursor[1]) != 0;
  }
  void ShowCursor(int shape)
  {
    if (this->ManagesCursor != 0) this->RequestCursorShape(shape);
  }

  /// Nothing of lower priority gets the event that is handled.
  void Use() { this->EventCallbackCommand->SetAbortFlag(1); }

  /// Begins a click, but not by the second press of a double click.
  void PressClick()
  {
    this->LeftClick.Forget();
    if (!isSecondPress(*this->Interactor) && this->IsCursorInside()) this->LeftClick.Press(this->Cursor());
  }

  Click LeftClick;
};

/// A representation that consists of props. They are drawn in their order, where they are visible.
template <class Base>
class DrawnByProps : public Base {
 public:
  void GetActors(vtkPropCollection* actors) override
  {
    for (vtkProp* const prop : this->Props) prop->GetActors(actors);
  }
  void GetActors2D(vtkPropCollection* actors) override
  {
    for (vtkProp* const prop : this->Props) prop->GetActors2D(actors);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    for (vtkProp* const prop : this->Props) prop->ReleaseGraphicsResources(window);
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    return this->Draw(viewport, &vtkProp::RenderOpaqueGeometry);
  }
  int RenderOverlay(vtkViewport* viewport) override { return this->Draw(viewport, &vtkProp::RenderOverlay); }

 protected:
  std::vector<vtkProp*> Props;

 private:
  int Draw(vtkViewport* viewport, int (vtkProp::*render)(vtkViewport*))
  {
    this->BuildRepresentation();
    int drawn = 0;
    for (vtkProp* const prop : this->Props)
      if (prop->GetVisibility() != 0) drawn += (prop->*render)(viewport);
    return drawn;
  }
};

enum class SelectionMode { Replace, Add, Remove };

/// By the keys of the event that is handled: Shift adds, Ctrl removes.
[[nodiscard]] inline SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor)
{
  if (interactor.GetControlKey() != 0) return SelectionMode::Remove;
  return interactor.GetShiftKey() != 0 ? SelectionMode::Add : SelectionMode::Replace;
}

/// Arguments and result are ascending, each id once. O(sum of both).
[[nodiscard]] inline std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached,
                                               SelectionMode mode)
{
  std::vector<Index> result;
  if (mode == SelectionMode::Replace) return reached;
  if (mode == SelectionMode::Add) std::ranges::set_union(selected, reached, std::back_inserter(result));
  if (mode == SelectionMode::Remove) std::ranges::set_difference(selected, reached, std::back_inserter(result));
  return result;
}

}  // namespace holdfast
