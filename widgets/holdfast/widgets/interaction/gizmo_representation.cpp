#include "holdfast/widgets/interaction/gizmo_representation.h"

#include <algorithm>
#include <cmath>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <holdfast/widgets/camera/view_geometry.h>

namespace holdfast {
namespace {

// Pixels of a display of ordinary resolution.
constexpr int kLabelFontSize = 14;
// Up and to the right of the cursor, clear of what is dragged.
constexpr double kLabelOffset[] = {18, 16};

/// Above `renderer`, and not below any other: of two in one layer the one that was added last is drawn last.
int topLayer(vtkRenderer& renderer)
{
  int layer = renderer.GetLayer() + 1;
  vtkRendererCollection& others = *renderer.GetRenderWindow()->GetRenderers();
  for (int k = 0; k < others.GetNumberOfItems(); ++k)
    layer = std::max(layer, static_cast<vtkRenderer*>(others.GetItemAsObject(k))->GetLayer());
  return layer;
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

}  // namespace

vtkStandardNewMacro(GizmoRepresentation);

GizmoRepresentation::GizmoRepresentation()
{
  setUpLabel(*this->LabelActor);
  this->Drawing.addTo(*this->Layer);
  this->Layer->AddViewProp(this->LabelActor);
  this->Layer->AddObserver(vtkCommand::StartEvent, this, &GizmoRepresentation::BuildRepresentation);
}

GizmoRepresentation::~GizmoRepresentation()
{
  this->GizmoRepresentation::SetRenderer(nullptr);
}

void GizmoRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->GetFrame().center.transpose() << '\n';
  os << indent << "Turns: " << (this->Motions == GizmoMotions::MovesAndTurns) << '\n';
  os << indent << "AlignToView: " << this->AlignToView << '\n';
  os << indent << "PixelSize: " << this->PixelSize << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
  os << indent << "Units: " << this->Units << '\n';
  os << indent << "Part: " << static_cast<int>(this->GetPart()) << '\n';
  os << indent << "LabelVisibility: " << this->LabelVisibility << '\n';
  os << indent << "Label: " << this->Label << '\n';
}

void GizmoRepresentation::SetFrame(const Vector3& center, const Eigen::Matrix3d& axes)
{
  if (this->IsDragging()) return;
  this->Drawing.setFrame(center, axes);
  this->Modified();
}

void GizmoRepresentation::SetMotions(GizmoMotions motions)
{
  if (this->IsDragging() || this->Motions == motions) return;
  this->Motions = motions;
  if (!this->Offers(this->GetPart())) this->SetPart(GizmoPart::None);
  this->Modified();
}

bool GizmoRepresentation::Offers(GizmoPart part) const
{
  return part != GizmoPart::None && (this->Motions == GizmoMotions::MovesAndTurns || !isRotation(part));
}

void GizmoRepresentation::SetUnits(const std::string& units)
{
  if (this->Units == units) return;
  this->Units = units;
  this->Modified();
}

void GizmoRepresentation::SetPart(GizmoPart part)
{
  if (this->GetPart() == part) return;
  this->Drawing.highlight(part);
  this->Modified();
}

GizmoDrag GizmoRepresentation::NewDrag(const DisplayPoint& cursor)
{
  this->ApplySettings();
  return {this->GetPart(), this->GetFrame(), viewGeometryOf(*this->Renderer), cursor, this->Drawing.ringPixels()};
}

void GizmoRepresentation::ShowDrag(const GizmoTrace& trace, const std::string& label, const DisplayPoint& cursor)
{
  this->Drawing.setFrame(trace.from.center + trace.motion.translation, trace.from.axes);
  this->Drawing.showDrag(trace);
  this->Label = label;
  this->LabelPosition = cursor;
  this->Modified();
}

void GizmoRepresentation::EndDrag()
{
  this->Drawing.endDrag();
  this->Label.clear();
  this->Modified();
}

void GizmoRepresentation::SetVisibility(vtkTypeBool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  if (!isVisible && !this->IsDragging()) this->SetPart(GizmoPart::None);
}

void GizmoRepresentation::SetRenderer(vtkRenderer* renderer)
{
  if (vtkRenderWindow* old = this->Layer->GetRenderWindow()) old->RemoveRenderer(this->Layer);
  this->Superclass::SetRenderer(renderer);
  vtkRenderWindow* window = renderer != nullptr ? renderer->GetRenderWindow() : nullptr;
  if (window == nullptr) return;
  this->Layer->SetLayer(topLayer(*renderer));
  window->SetNumberOfLayers(std::max(window->GetNumberOfLayers(), this->Layer->GetLayer() + 1));
  window->AddRenderer(this->Layer);
}

/// Hands what the setters say to the gizmo; the axes of the view are those of the camera as it stands now.
void GizmoRepresentation::ApplySettings()
{
  this->Drawing.setPixelSize(this->PixelSize * this->PixelRatio);
  if (this->Visibility)
    this->Drawing.show(this->Motions);
  else
    this->Drawing.hide();
  if (!this->AlignToView || this->IsDragging()) return;
  const ViewGeometry view = viewGeometryOf(*this->Renderer);
  Eigen::Matrix3d axes;
  axes << view.right, view.up, -view.direction;
  this->Drawing.setFrame(this->GetFrame().center, axes);
}

void GizmoRepresentation::BuildRepresentation()
{
  if (!this->Renderer) return;
  this->ApplySettings();
  this->Drawing.update(*this->Renderer);
  this->PlaceLabel();
}

int GizmoRepresentation::ComputeInteractionState(int x, int y, int /*modify*/)
{
  GizmoPart part = GizmoPart::None;
  if (this->Renderer && this->Renderer->IsInViewport(x, y)) {
    this->ApplySettings();
    part = this->Drawing.hitTest(*this->Renderer, x + 0.5, y + 0.5);
  }
  this->InteractionState = static_cast<int>(part);
  return this->InteractionState;
}

/// At the cursor, and wholly inside the viewport.
void GizmoRepresentation::PlaceLabel()
{
  vtkTextActor& actor = *this->LabelActor;
  actor.SetVisibility(this->Visibility && this->LabelVisibility && !this->Label.empty());
  if (!actor.GetVisibility()) return;
  actor.SetInput(this->Label.c_str());
  vtkTextProperty& property = *actor.GetTextProperty();
  property.SetFontSize(static_cast<int>(std::lround(kLabelFontSize * this->PixelRatio)));
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

}  // namespace holdfast
