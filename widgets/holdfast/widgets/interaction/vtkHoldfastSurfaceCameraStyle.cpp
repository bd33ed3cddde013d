#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCamera.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/picking/surface_picker.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceCameraStyle);

vtkHoldfastSurfaceCameraStyle::vtkHoldfastSurfaceCameraStyle()
{
  vtkWidgetEventTranslator& translator = *this->EventTranslator;
  // The first that fits counts: the one with a modifier comes first.
  translator.SetTranslation(vtkCommand::RightButtonPressEvent, vtkEvent::ShiftModifier, 0, 0, nullptr,
                            vtkWidgetEvent::Translate);
  translator.SetTranslation(vtkCommand::RightButtonPressEvent, vtkWidgetEvent::Rotate);
  translator.SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Rotate);
  translator.SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::Translate);
}

void vtkHoldfastSurfaceCameraStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
  os << indent << "EventTranslator: " << this->EventTranslator.Get() << '\n';
}

Vector3 vtkHoldfastSurfaceCameraStyle::PlaceUnder(const DisplayPoint& cursor)
{
  vtkRenderer& renderer = *this->CurrentRenderer;
  if (this->Surface)
    if (const auto pick = SurfacePicker(this->Surface).pick(renderer, cursor.x(), cursor.y(), PickKind::Face, 0))
      return pick->place;
  return atDepthOf(renderer, Vector3(renderer.GetActiveCamera()->GetFocalPoint()), cursor);
}

void vtkHoldfastSurfaceCameraStyle::ButtonDown(unsigned long event)
{
  if (this->PressEvent != 0) return;
  this->FindPokedRenderer(this->Interactor->GetEventPosition()[0], this->Interactor->GetEventPosition()[1]);
  if (this->CurrentRenderer == nullptr) return;
  this->PressEvent = event;
  this->Motion = this->EventTranslator->GetTranslation(event, vtkEvent::GetModifier(this->Interactor), 0, 0, nullptr);
  this->Last = cursorOf(*this->Interactor);
}

void vtkHoldfastSurfaceCameraStyle::ButtonUp(unsigned long pressEvent)
{
  if (this->PressEvent != pressEvent) return;
  this->PressEvent = 0;
  if (this->State != VTKIS_NONE) return this->StopState();
  if (pressEvent == vtkCommand::RightButtonPressEvent) this->InvokeEvent(ContextMenuRequestEvent);
}

void vtkHoldfastSurfaceCameraStyle::Cancel()
{
  this->PressEvent = 0;
  if (this->State != VTKIS_NONE) this->StopState();
}

void vtkHoldfastSurfaceCameraStyle::OnMouseMove()
{
  if (this->PressEvent == 0) return;
  const DisplayPoint to = cursorOf(*this->Interactor);
  if (this->State == VTKIS_NONE) {
    const bool isMotion = this->Motion == vtkWidgetEvent::Rotate || this->Motion == vtkWidgetEvent::Translate;
    if (!isMotion || (to - this->Last).norm() < kClickPixels * this->PixelRatio) return;
    this->Pivot = this->PlaceUnder(this->Last);
    this->StartState(this->Motion == vtkWidgetEvent::Translate ? VTKIS_PAN : VTKIS_ROTATE);
  }
  const DisplayPoint from = std::exchange(this->Last, to);
  if (this->State == VTKIS_PAN) {
    pan(*this->CurrentRenderer, this->Pivot, from, to);
  } else {
    // A drag across the height of the picture rotates by this.
    constexpr double kDegreesAcross = 220;
    const DisplayPoint degrees = kDegreesAcross / std::max(1, this->CurrentRenderer->GetSize()[1]) * (to - from);
    orbit(*this->CurrentRenderer->GetActiveCamera(), this->Pivot, degrees.x(), degrees.y());
  }
  this->CameraMoved();
}

void vtkHoldfastSurfaceCameraStyle::Zoom(double notches)
{
  constexpr double kWheelZoom = 1.2;
  const DisplayPoint cursor = cursorOf(*this->Interactor);
  this->FindPokedRenderer(static_cast<int>(cursor.x()), static_cast<int>(cursor.y()));
  if (this->CurrentRenderer == nullptr) return;
  zoom(*this->CurrentRenderer, this->PlaceUnder(cursor),
       std::pow(kWheelZoom, notches * this->GetMouseWheelMotionFactor()));
  this->CameraMoved();
}

void vtkHoldfastSurfaceCameraStyle::CameraMoved()
{
  if (this->AutoAdjustCameraClippingRange) this->CurrentRenderer->ResetCameraClippingRange();
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Interactor->Render();
}
