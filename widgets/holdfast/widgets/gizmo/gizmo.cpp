#include "holdfast/widgets/gizmo/gizmo.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <holdfast/widgets/gizmo/gizmo_colors.h>

namespace holdfast {
namespace {

using namespace gizmo_layout;

constexpr std::array<const char*, 3> kLetters{"x", "y", "z"};
constexpr double kLetterSize = 0.145;
constexpr double kLetterShade = 0.72;

GizmoPart arrowOf(std::size_t axis)
{
  return static_cast<GizmoPart>(static_cast<std::size_t>(GizmoPart::ArrowX) + axis);
}

/// `place` is that of the letter, in the display. A position of its own would have VTK draw the letter and load it onto
/// the graphics card anew each time that it changes, for which all that is being drawn there is waited for.
void setUpLetter(vtkTextActor& letter, vtkCoordinate& place, std::size_t axis)
{
  letter.SetInput(kLetters.at(axis));
  vtkTextProperty& property = *letter.GetTextProperty();
  const Color color = gizmoColor(arrowOf(axis));
  property.SetFontFamilyToArial();
  property.BoldOn();
  property.SetColor(kLetterShade * color.red, kLetterShade * color.green, kLetterShade * color.blue);
  property.SetJustificationToCentered();
  property.SetVerticalJustificationToCentered();
  place.SetCoordinateSystemToDisplay();
  letter.GetPositionCoordinate()->SetCoordinateSystemToViewport();
  letter.GetPositionCoordinate()->SetReferenceCoordinate(&place);
}

/// Light from above the left shoulder, so that tubes look round.
void addLight(vtkRenderer& layer)
{
  layer.RemoveAllLights();
  layer.AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.35, 0.55, 1);
  layer.AddLight(light);
}

/// Where a part stands: what belongs to no axis faces the view.
GizmoPlacement placementFor(GizmoPart part, const GizmoPlacement& placement, const ViewGeometry& view)
{
  if (axisIndexOf(part) >= 0) return placement;
  GizmoPlacement facing = placement;
  facing.frame.axes << view.right, view.up, -view.direction;
  return facing;
}

}  // namespace

Gizmo::Gizmo()
{
  for (int k = 1; k < kGizmoPartCount; ++k)
    parts_.push_back(std::make_unique<GizmoPartActors>(static_cast<GizmoPart>(k)));
  for (std::size_t axis = 0; axis < letters_.size(); ++axis)
    setUpLetter(*letters_.at(axis), *letterPlaces_.at(axis), axis);
}

Gizmo::~Gizmo() = default;

void Gizmo::addTo(vtkRenderer& layer)
{
  layer_ = &layer;
  vtkNew<vtkCamera> camera;
  layer.SetActiveCamera(camera);
  layer.InteractiveOff();
  addLight(layer);
  for (vtkProp* prop : props()) layer.AddViewProp(prop);
}

void Gizmo::setFrame(const Vector3& center, const Eigen::Matrix3d& axes)
{
  frame_ = {center, axes};
}

void Gizmo::setPixelSize(double radius)
{
  pixels_ = radius;
}

void Gizmo::show(GizmoMotions motions)
{
  isShown_ = true;
  motions_ = motions;
}

void Gizmo::hide()
{
  isShown_ = false;
}

void Gizmo::highlight(GizmoPart part)
{
  highlighted_ = part;
}

void Gizmo::showDrag(GizmoTrace trace)
{
  drag_ = std::move(trace);
}

void Gizmo::endDrag()
{
  drag_.reset();
}

bool Gizmo::isOffered(GizmoPart part) const
{
  return isShown_ && (motions_ == GizmoMotions::MovesAndTurns || !isRotation(part));
}

bool Gizmo::isDrawn(GizmoPart part) const
{
  return isOffered(part) && (!drag_ || drag_->part == part);
}

Color Gizmo::colorOf(GizmoPart part) const
{
  return part == highlighted_ || drag_ ? kHighlightColor : gizmoColor(part);
}

void Gizmo::update(vtkRenderer& scene)
{
  const ViewGeometry view = viewGeometryOf(scene);
  const GizmoPlacement placement = placementOf(view, frame_, pixels_);
  const Vector3 sight = sightOf(view, frame_.center);
  for (const auto& actors : parts_) {
    const GizmoPart part = actors->part();
    const double visibility = drag_ || part == highlighted_ ? 1 : visibilityOf(part, frame_, view);
    actors->show(placementFor(part, placement, view), colorOf(part), isDrawn(part) ? visibility : 0, sight);
  }
  updateLetters(placement, view);
  updateTrace(placement);
  followCamera(scene);
}

void Gizmo::updateLetters(const GizmoPlacement& placement, const ViewGeometry& view)
{
  for (std::size_t axis = 0; axis < letters_.size(); ++axis) {
    vtkTextActor& letter = *letters_.at(axis);
    const GizmoPart arrow = arrowOf(axis);
    const Vector3 end = frame_.center + kLabelAt * placement.scale * frame_.axes.col(static_cast<Index>(axis));
    const std::optional<DisplayPoint> place = toDisplay(view, end);
    const double visibility = visibilityOf(arrow, frame_, view);
    letter.SetVisibility(isDrawn(arrow) && place && placement.scale > 0 && visibility >= kLeastVisible);
    if (place) letterPlaces_.at(axis)->SetValue(place->x(), place->y());
    letter.GetTextProperty()->SetFontSize(std::max(8, static_cast<int>(std::lround(kLetterSize * pixels_))));
  }
}

void Gizmo::updateTrace(const GizmoPlacement& placement)
{
  if (!isShown_ || !drag_ || !(placement.scale > 0)) return trace_.hide();
  const double radius = kindOf(drag_->part) == GizmoPartKind::ViewRing ? 1 : kRingRadius;
  trace_.show(*drag_, radius * placement.scale, pixels_);
}

void Gizmo::followCamera(vtkRenderer& scene)
{
  if (!layer_ || layer_ == &scene) return;
  layer_->SetViewport(scene.GetViewport());
  layer_->GetActiveCamera()->DeepCopy(scene.GetActiveCamera());
  layer_->ResetCameraClippingRange();
}

GizmoPart Gizmo::hitTest(vtkRenderer& scene, double displayX, double displayY) const
{
  if (!isShown_) return GizmoPart::None;
  const ViewGeometry view = viewGeometryOf(scene);
  const GizmoPart part = hitGizmo(view, placementOf(view, frame_, pixels_), {displayX, displayY});
  // What turns comes last of all that can be hit: nothing lies behind it.
  return isOffered(part) ? part : GizmoPart::None;
}

std::vector<vtkProp*> Gizmo::props() const
{
  std::vector<vtkProp*> result;
  for (const auto& actors : parts_) result.push_back(&actors->solid());
  for (vtkProp* prop : trace_.props()) result.push_back(prop);
  for (const auto& actors : parts_) result.push_back(&actors->faded());
  for (const auto& letter : letters_) result.push_back(letter);
  return result;
}

}  // namespace holdfast
