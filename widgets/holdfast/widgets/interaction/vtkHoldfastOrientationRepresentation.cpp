#include "holdfast/widgets/interaction/vtkHoldfastOrientationRepresentation.h"

#include <array>

#include <vtkActor.h>
#include <vtkCameraInterpolator.h>
#include <vtkEllipticalButtonSource.h>
#include <vtkMath.h>
#include <vtkPoints.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkTubeFilter.h>

#include <holdfast/numbers/types.h>

using namespace holdfast;

namespace {

// The cosine: both balls of an axis are then in the same pixels.
constexpr double kFacing = 1e-4;

// Balls and letters are some twenty pixels wide.
constexpr int kBallSides = 16;
constexpr int kShaftSides = 6;
constexpr int kLetterPoints = 24;

// Points of the superclass: the origin, the ends of the shafts, the centers of the balls; along x, -x, y, -y, z, -z.
constexpr int kFirstEnd = 1;
constexpr int kFirstBall = 7;

}  // namespace

vtkStandardNewMacro(vtkHoldfastOrientationRepresentation);

vtkHoldfastOrientationRepresentation::vtkHoldfastOrientationRepresentation()
{
  this->ShaftGlyphs->SetNumberOfSides(kShaftSides);
  this->Shafts->SetUserTransform(this->Transform);
  for (int axis = 0; axis < 3; ++axis) {
    for (int direction = 0; direction < 2; ++direction) {
      this->HandleSources[axis][direction]->SetCenter(0, 0, 0);
      this->HandleSources[axis][direction]->SetCircumferentialResolution(kBallSides);
      this->AxisVectorTextProperties[axis][direction]->SetFontSize(kLetterPoints);
    }
  }
  this->PositionHandles();
}

void vtkHoldfastOrientationRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkHoldfastOrientationRepresentation::PositionHandles()
{
  const auto placeOf = [this](int point) {
    std::array<double, 3> place{};
    this->Points->GetPoint(point, place.data());
    this->Transform->TransformPoint(place.data(), place.data());
    return place;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int direction = 0; direction < 2; ++direction)
      this->Handles[axis][direction]->SetPosition(placeOf(kFirstBall + 2 * axis + direction).data());
    const std::array<double, 3> end = placeOf(kFirstEnd + 2 * axis);
    this->Up[axis] = end[1];
    this->Back[axis] = -end[2];
  }
  vtkMath::Normalize(this->Up);
  vtkMath::Normalize(this->Back);
}

void vtkHoldfastOrientationRepresentation::HighlightHandle()
{
  const std::pair picked(this->PickedAxis, this->PickedDir);
  if (this->Renderer == nullptr || picked == this->LetteredFor) return;
  this->Superclass::HighlightHandle();
  this->LetteredFor = picked;
}

void vtkHoldfastOrientationRepresentation::EndWidgetInteraction(double place[2])
{
  // True if the ball under the cursor is the nearest to the viewer, with that of the other direction right behind it.
  bool isFacing = false;
  if (this->PickedAxis >= 0) {
    const Vector3 axis = (this->PickedDir == 0 ? 1 : -1) * Vector3::Unit(this->PickedAxis);
    isFacing = this->GetTransform()->TransformVector(axis.data())[2] > 1 - kFacing;
  }
  this->LastPickedAx = isFacing ? this->PickedAxis : -1;
  this->LastPickedDir = isFacing ? this->PickedDir : -1;
  this->Superclass::EndWidgetInteraction(place);
}
