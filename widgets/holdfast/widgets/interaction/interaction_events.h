#pragma once
/// The widgets of this folder share events beside VTK's, bindings, cursor, clicks and modes of selection. The header of
/// each widget lists its bindings and the events that it invokes, with their call data. The event translator of a
/// widget can change its bindings. Sizes are pixels of a display of ordinary resolution. `PixelRatio`, 1 by default, is
/// the number of window pixels for each of them.

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

#include <holdfast/numbers/types.h>
#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

/// Events beside those of `vtkCommand`.
enum InteractionEvents : unsigned long {
  /// Comes instead of EndInteractionEvent where the gesture was taken back. An observer then restores the state before
  /// the gesture.
  CancelInteractionEvent = vtkCommand::UserEvent + 18'500,
  /// The right button went down and up in one place. The event has no call data; the interactor knows the place.
  ContextMenuRequestEvent,
  /// A click is about to begin another ruler, and the present one is removed. The event has no call data.
  NextRulerEvent
};

/// Sets a member of `object` as `vtkSetMacro` does, for types that VTK cannot print. `object` is modified only where
/// the value changes.
template <class Value>
void assign(vtkObject& object, Value& member, Value value)
{
  if (member == value) return;
  member = std::move(value);
  object.Modified();
}

/// A press and a release that are nearer to each other than this are a click.
inline constexpr double kClickPixels = 4;

/// Tells whether the interactor's style moves the camera at the moment. Nothing follows the cursor then.
[[nodiscard]] inline bool isCameraMoving(vtkRenderWindowInteractor& interactor)
{
  auto* style = vtkInteractorStyle::SafeDownCast(interactor.GetInteractorStyle());
  return style != nullptr && style->GetState() != VTKIS_NONE;
}

/// Tells whether the press that is being handled is the second one of a double click.
[[nodiscard]] inline bool isSecondPress(vtkRenderWindowInteractor& interactor)
{
  return interactor.GetRepeatCount() > 0;
}

/// Returns the pixel of the event that is being handled.
[[nodiscard]] inline DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return {position[0], position[1]};
}

/// Calls `ComputeInteractionState` for the pixel of the event that is being handled, and returns its result.
inline int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return representation.ComputeInteractionState(position[0], position[1]);
}

/// Returns points of a circle at equal distances, counterclockwise.
[[nodiscard]] inline std::vector<DisplayPoint> circle(const DisplayPoint& center, double radius, int corners)
{
  std::vector<DisplayPoint> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(center + radius * DisplayPoint(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// Recognises a click: a press and a release within `kClickPixels`. Widgets abort neither event, so that a drag from
/// the same place moves the camera.
class Click {
 public:
  void Press(const DisplayPoint& place) { this->PressedAt = place; }

  /// Call it when the cursor is at `place`. It tells whether that ends a possible click.
  bool LeaveAt(const DisplayPoint& place, double pixelRatio)
  {
    if (!this->PressedAt || (place - *this->PressedAt).norm() < kClickPixels * pixelRatio) return false;
    this->PressedAt.reset();
    return true;
  }

  /// Call it when the button comes up at `place`. It tells whether that was a click.
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

/// A widget whose representation is of one class. Disabling it stops a gesture that is under way.
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
  /// Makes a representation if there is none. It does not use SetRepresentation, which would disable the widget and
  /// enable it again: enabling asks for a representation.
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
  /// Stops what is under way. The widget is enabled, and about to be disabled.
  virtual void Stop() {}
  [[nodiscard]] Representation& Drawn() { return *static_cast<Representation*>(this->GetRepresentation()); }

  /// Makes a widget event call a member function without arguments. A function that returns true has used the VTK
  /// event, which is then aborted.
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
  /// Tells whether the cursor is in the renderer's part of the window.
  [[nodiscard]] bool IsCursorInside() const
  {
    const int* cursor = this->Interactor->GetEventPosition();
    return this->CurrentRenderer->IsInViewport(cursor[0], cursor[1]) != 0;
  }
  void ShowCursor(int shape)
  {
    if (this->ManagesCursor != 0) this->RequestCursorShape(shape);
  }

  /// Aborts the event that is being handled: no observer of lower priority gets it.
  void Use() { this->EventCallbackCommand->SetAbortFlag(1); }

  /// Begins a click where the cursor is inside the renderer's part of the window. The second press of a double click
  /// begins none.
  void PressClick()
  {
    this->LeftClick.Forget();
    if (!isSecondPress(*this->Interactor) && this->IsCursorInside()) this->LeftClick.Press(this->Cursor());
  }

  Click LeftClick;
};

/// A representation that consists of props. It draws those that are visible, in their order.
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

/// Returns the mode for the keys of the event that is being handled. Ctrl removes; Shift without Ctrl adds; without
/// both keys the mode replaces.
[[nodiscard]] inline SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor)
{
  if (interactor.GetControlKey() != 0) return SelectionMode::Remove;
  return interactor.GetShiftKey() != 0 ? SelectionMode::Add : SelectionMode::Replace;
}

/// Joins a selection with the vertices that a gesture has reached. Arguments and result are ascending and have each id
/// once. O(sum of both).
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
