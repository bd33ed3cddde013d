#include "holdfast/view/interaction/orientation_representation.h"

#include <array>

#include <vtkActor.h>
#include <vtkEllipticalButtonSource.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkTubeFilter.h>

namespace holdfast {
namespace {

// Balls and letters are some twenty pixels wide.
constexpr int kBallSides = 16;
constexpr int kShaftSides = 6;
constexpr int kLetterPoints = 24;

// Of the superclass: the origin, the ends of the shafts, the centers of the balls; along x, -x, y, -y, z, -z.
constexpr int kFirstEnd = 1;
constexpr int kFirstBall = 7;

}  // namespace

vtkStandardNewMacro(OrientationRepresentation);

OrientationRepresentation::OrientationRepresentation()
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

void OrientationRepresentation::PositionHandles()
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

void OrientationRepresentation::HighlightHandle()
{
  const std::pair picked(this->PickedAxis, this->PickedDir);
  if (this->Renderer == nullptr || picked == this->LetteredFor) return;
  this->Superclass::HighlightHandle();
  this->LetteredFor = picked;
}

}  // namespace holdfast
