#include "holdfast/widgets/interaction/vtkHoldfastRotationSphereStyle.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <vtkObjectFactory.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/interaction_events.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastRotationSphereStyle);

void vtkHoldfastRotationSphereStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sphere: " << this->Sphere << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void vtkHoldfastRotationSphereStyle::SetSphere(RotationSphere* sphere)
{
  this->Sphere = sphere;
  this->IsPressed = false;
  this->State = VTKIS_NONE;
}

void vtkHoldfastRotationSphereStyle::OnLeftButtonDown()
{
  if (!this->Sphere) return;
  if (isSecondPress(*this->Interactor)) return this->Fit();
  this->IsPressed = true;
  this->Last = cursorOf(*this->Interactor);
}

void vtkHoldfastRotationSphereStyle::OnMouseMove()
{
  if (!this->IsPressed) return;
  const DisplayPoint to = cursorOf(*this->Interactor);
  if (this->State == VTKIS_NONE && (to - this->Last).norm() < kClickPixels * this->PixelRatio) return;
  if (this->State == VTKIS_NONE) this->StartState(VTKIS_ROTATE);
  this->Turn(to - std::exchange(this->Last, to));
}

void vtkHoldfastRotationSphereStyle::OnLeftButtonUp()
{
  if (!std::exchange(this->IsPressed, false)) return;
  if (this->State != VTKIS_NONE) return this->StopState();
  const DisplayPoint place = cursorOf(*this->Interactor) + DisplayPoint(0.5, 0.5);
  if (auto vertex = this->Sphere->pick(place.x(), place.y())) this->InvokeEvent(vtkCommand::PickEvent, &*vertex);
}

void vtkHoldfastRotationSphereStyle::OnKeyPress()
{
  const char* name = this->Interactor->GetKeySym();
  const std::string_view key = name != nullptr ? name : "";
  constexpr double kPixelsOfKey = 20;
  const double step = kPixelsOfKey * this->PixelRatio;
  if (key == "Left") this->Turn({-step, 0});
  if (key == "Right") this->Turn({step, 0});
  if (key == "Up") this->Turn({0, step});
  if (key == "Down") this->Turn({0, -step});
  if (key == "plus" || key == "equal") this->Zoom(1);
  if (key == "minus") this->Zoom(-1);
  if (key == "Home") this->Fit();
}

void vtkHoldfastRotationSphereStyle::Turn(const DisplayPoint& pixels)
{
  if (!this->Sphere) return;
  // A drag across the height of the picture rotates the sphere by this: it about follows the cursor.
  constexpr double kSphereDegreesAcross = 3.2 / kDegree;
  vtkRenderer& renderer = *this->Sphere->renderer();
  const DisplayPoint degrees = kSphereDegreesAcross / std::max(1, renderer.GetSize()[1]) * pixels;
  orbit(*renderer.GetActiveCamera(), Vector3::Zero(), degrees.x(), degrees.y());
  this->CameraMoved();
}

void vtkHoldfastRotationSphereStyle::Zoom(double notches)
{
  if (!this->Sphere) return;
  constexpr double kZoomOfNotch = 1.2;
  zoomSphere(*this->Sphere->renderer()->GetActiveCamera(),
             std::pow(kZoomOfNotch, notches * this->GetMouseWheelMotionFactor()));
  this->CameraMoved();
}

void vtkHoldfastRotationSphereStyle::Fit()
{
  if (!this->Sphere) return;
  this->Sphere->fitCamera();
  this->CameraMoved();
}

void vtkHoldfastRotationSphereStyle::CameraMoved()
{
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Interactor->Render();
}
