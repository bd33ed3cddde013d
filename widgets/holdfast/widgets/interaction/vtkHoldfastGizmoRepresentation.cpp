#include "holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkRendererCollection.h>
#include <vtkTextProperty.h>

using namespace holdfast;

namespace {

using namespace gizmo_layout;

constexpr std::array<const char*, 3> kLetters{"x", "y", "z"};
constexpr double kLetterSize = 0.145;
constexpr double kLetterShade = 0.72;

// Pixels of a display of ordinary resolution.
constexpr int kLabelFontSize = 14;
// Up and to the right of the cursor, clear of what is dragged.
constexpr double kLabelOffset[] = {18, 16};

GizmoPart arrowOf(int axis)
{
  return static_cast<GizmoPart>(static_cast<int>(GizmoPart::ArrowX) + axis);
}

/// Above `renderer`, and not below any other: of two in one layer the one that was added last is drawn last.
int topLayer(vtkRenderer& renderer)
{
  int layer = renderer.GetLayer() + 1;
  vtkRendererCollection& others = *renderer.GetRenderWindow()->GetRenderers();
  for (int k = 0; k < others.GetNumberOfItems(); ++k)
    layer = std::max(layer, static_cast<vtkRenderer*>(others.GetItemAsObject(k))->GetLayer());
  return layer;
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

/// `place` is that of the letter, in the display. VTK would draw the letter and load it onto the graphics card again
/// each time that a position of its own changes, and wait for all drawing there.
void setUpLetter(vtkTextActor& letter, vtkCoordinate& place, int axis)
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

/// Dark on a white plate, so that it is read on any scene.
void setUpLabel(vtkTextActor& label)
{
  label.VisibilityOff();
  vtkTextProperty& property = *label.GetTextProperty();
  property.SetFontFamilyToArial();
  property.BoldOn();
  property.SetColor(0.13, 0.15, 0.19);
  property.SetBackgroundColor(1, 1, 1);
  property.SetBackgroundOpacity(0.82);
}

Eigen::Matrix3d axesOf(const DisplayTransform& view)
{
  Eigen::Matrix3d axes;
  axes << view.right(), view.up(), -view.direction();
  return axes;
}

}  // namespace

vtkStandardNewMacro(vtkHoldfastGizmoRepresentation);

vtkHoldfastGizmoRepresentation::vtkHoldfastGizmoRepresentation()
{
  for (int k = 1; k < kGizmoPartCount; ++k)
    this->Parts.push_back(std::make_unique<GizmoPartActors>(static_cast<GizmoPart>(k)));
  for (int axis = 0; axis < 3; ++axis) setUpLetter(*this->Letters.at(axis), *this->LetterPlaces.at(axis), axis);
  setUpLabel(*this->LabelActor);
  this->Layer->SetActiveCamera(vtkNew<vtkCamera>());
  this->Layer->InteractiveOff();
  addLight(*this->Layer);
  // In this order they are drawn.
  for (const auto& part : this->Parts) this->Layer->AddViewProp(&part->solid());
  for (vtkProp* const prop : this->Trace.props()) this->Layer->AddViewProp(prop);
  for (const auto& part : this->Parts) this->Layer->AddViewProp(&part->faded());
  for (const auto& letter : this->Letters) this->Layer->AddViewProp(letter);
  this->Layer->AddViewProp(this->LabelActor);
  this->Layer->AddObserver(vtkCommand::StartEvent, this, &vtkHoldfastGizmoRepresentation::BuildRepresentation);
}

void vtkHoldfastGizmoRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Frame.center.transpose() << '\n';
  os << indent << "Motions: " << static_cast<int>(this->Motions) << '\n';
  os << indent << "AlignToView: " << this->AlignToView << '\n';
  os << indent << "PixelSize: " << this->PixelSize << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
  os << indent << "Units: " << this->Units << '\n';
  os << indent << "Part: " << static_cast<int>(this->Part) << '\n';
  os << indent << "LabelVisibility: " << this->LabelVisibility << '\n';
  os << indent << "Label: " << this->Label << '\n';
}

void vtkHoldfastGizmoRepresentation::SetFrame(const Vector3& center, const Eigen::Matrix3d& axes)
{
  if (this->IsDragging()) return;
  this->Frame = {center, axes};
  this->Modified();
}

void vtkHoldfastGizmoRepresentation::SetMotions(GizmoMotions motions)
{
  if (this->IsDragging() || this->Motions == motions) return;
  this->Motions = motions;
  if (!this->Offers(this->Part)) this->SetPart(GizmoPart::None);
  this->Modified();
}

bool vtkHoldfastGizmoRepresentation::Offers(GizmoPart part) const
{
  switch (this->Motions) {
    case GizmoMotions::Moves:
      return part != GizmoPart::None && !isRotation(part);
    case GizmoMotions::MovesAndTurns:
      return part != GizmoPart::None;
    case GizmoMotions::MovesAlongZ:
      return part == GizmoPart::ArrowZ;
    case GizmoMotions::MovesAcrossZ:
      return part == GizmoPart::ArrowX || part == GizmoPart::ArrowY || part == GizmoPart::SquareZ;
  }
  return false;
}

GizmoDrag vtkHoldfastGizmoRepresentation::NewDrag(const DisplayPoint& cursor)
{
  const DisplayTransform view(*this->Renderer);
  this->AlignAxes(view);
  return {this->Part, this->Frame, view, cursor, kRingRadius * this->Radius()};
}

void vtkHoldfastGizmoRepresentation::ShowDrag(const GizmoTrace& trace, const std::string& label,
                                              const DisplayPoint& cursor)
{
  this->Frame = {trace.from.center + trace.motion.translation, trace.from.axes};
  this->Drag = trace;
  this->Label = label;
  this->LabelPosition = cursor;
  this->Modified();
}

void vtkHoldfastGizmoRepresentation::EndDrag()
{
  this->Drag.reset();
  this->Label.clear();
  this->Modified();
}

void vtkHoldfastGizmoRepresentation::SetVisibility(vtkTypeBool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  if (!isVisible && !this->IsDragging()) this->SetPart(GizmoPart::None);
}

void vtkHoldfastGizmoRepresentation::SetRenderer(vtkRenderer* renderer)
{
  if (vtkRenderWindow* old = this->Layer->GetRenderWindow()) old->RemoveRenderer(this->Layer);
  this->Superclass::SetRenderer(renderer);
  vtkRenderWindow* window = renderer != nullptr ? renderer->GetRenderWindow() : nullptr;
  if (window == nullptr) return;
  this->Layer->SetLayer(topLayer(*renderer));
  window->SetNumberOfLayers(std::max(window->GetNumberOfLayers(), this->Layer->GetLayer() + 1));
  window->AddRenderer(this->Layer);
}

void vtkHoldfastGizmoRepresentation::AlignAxes(const DisplayTransform& view)
{
  if (this->AlignToView && !this->IsDragging()) this->Frame.axes = axesOf(view);
}

void vtkHoldfastGizmoRepresentation::BuildRepresentation()
{
  if (!this->Renderer) return;
  const DisplayTransform view(*this->Renderer);
  this->AlignAxes(view);
  const GizmoPlacement placement = placementOf(view, this->Frame, this->Radius());
  this->PlaceParts(view, placement);
  this->PlaceLetters(view, placement);
  if (this->Visibility && this->Drag && placement.scale > 0) {
    const double radius = kindOf(this->Drag->part) == GizmoPartKind::ViewRing ? 1 : kRingRadius;
    this->Trace.show(*this->Drag, radius * placement.scale, this->Radius());
  } else {
    this->Trace.hide();
  }
  this->Layer->SetViewport(this->Renderer->GetViewport());
  this->Layer->GetActiveCamera()->DeepCopy(this->Renderer->GetActiveCamera());
  this->Layer->ResetCameraClippingRange();
  this->PlaceLabel();
}

void vtkHoldfastGizmoRepresentation::PlaceParts(const DisplayTransform& view, const GizmoPlacement& placement)
{
  // Parts without an axis face the view.
  GizmoPlacement facing = placement;
  facing.frame.axes = axesOf(view);
  const Vector3 sight = view.sightOf(this->Frame.center);
  for (const auto& actors : this->Parts) {
    const GizmoPart part = actors->part();
    const bool isHighlighted = this->Drag || part == this->Part;
    const double visibility = isHighlighted ? 1 : visibilityOf(part, this->Frame, view);
    actors->show(axisIndexOf(part) >= 0 ? placement : facing, isHighlighted ? kHighlightColor : gizmoColor(part),
                 this->IsDrawn(part) ? visibility : 0, sight);
  }
}

void vtkHoldfastGizmoRepresentation::PlaceLetters(const DisplayTransform& view, const GizmoPlacement& placement)
{
  for (int axis = 0; axis < 3; ++axis) {
    vtkTextActor& letter = *this->Letters.at(axis);
    const GizmoPart arrow = arrowOf(axis);
    const Vector3 end = this->Frame.center + kLabelAt * placement.scale * this->Frame.axes.col(axis);
    const std::optional<DisplayPoint> place = toDisplay(view, end);
    const bool isSeen = visibilityOf(arrow, this->Frame, view) >= kLeastVisible;
    letter.SetVisibility(this->IsDrawn(arrow) && place && placement.scale > 0 && isSeen);
    if (place) this->LetterPlaces.at(axis)->SetValue(place->x(), place->y());
    letter.GetTextProperty()->SetFontSize(std::max(8, static_cast<int>(std::lround(kLetterSize * this->Radius()))));
  }
}

/// At the cursor, and wholly inside the viewport.
void vtkHoldfastGizmoRepresentation::PlaceLabel()
{
  vtkTextActor& actor = *this->LabelActor;
  actor.SetVisibility(this->Visibility && this->LabelVisibility && !this->Label.empty());
  if (!actor.GetVisibility()) return;
  actor.SetInput(this->Label.c_str());
  actor.GetTextProperty()->SetFontSize(static_cast<int>(std::lround(kLabelFontSize * this->PixelRatio)));
  Eigen::Matrix2d box;  // of x and of y, from the actor's position: least above most
  actor.GetBoundingBox(this->Layer, box.data());
  int place[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double least = this->Layer->GetOrigin()[axis] - box(0, axis);
    const double most = this->Layer->GetOrigin()[axis] + this->Layer->GetSize()[axis] - 1 - box(1, axis);
    const double wanted = this->LabelPosition[axis] + kLabelOffset[axis] * this->PixelRatio - box(0, axis);
    place[axis] = static_cast<int>(std::max(least, std::min(wanted, most)));
  }
  actor.SetDisplayPosition(place[0], place[1]);
}

int vtkHoldfastGizmoRepresentation::ComputeInteractionState(int x, int y, int /*modify*/)
{
  GizmoPart part = GizmoPart::None;
  if (this->Visibility && this->Renderer && this->Renderer->IsInViewport(x, y)) {
    const DisplayTransform view(*this->Renderer);
    this->AlignAxes(view);
    part = hitGizmo(view, placementOf(view, this->Frame, this->Radius()), centerOfPixel(x, y));
    // Rings come last of all that can be hit: nothing lies behind them.
    if (!this->Offers(part)) part = GizmoPart::None;
  }
  this->InteractionState = static_cast<int>(part);
  return this->InteractionState;
}
