#include "holdfast/window/tools/plane_widget.h"

#include <array>

#include <vtkProperty.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>

namespace holdfast {
namespace {

// The plane comes after the gizmo and before the tools, because its handles are small.
constexpr float kPriority = 0.55F;

/// In one colour, without shading.
void setColor(vtkProperty& property, const Color& color)
{
  property.SetColor(color.red, color.green, color.blue);
  property.SetAmbient(1);
  property.SetDiffuse(0);
  property.SetSpecular(0);
}

/// Gives the plane the colour of selected things, and the gizmo's yellow where the cursor would take it.
void setLook(vtkImplicitPlaneRepresentation& plane)
{
  plane.DrawOutlineOff();
  // A filled plane would tint the colours of all that is seen through it.
  plane.DrawPlaneOff();
  plane.SetEdgeColor(kAccentColor.red, kAccentColor.green, kAccentColor.blue);
  setColor(*plane.GetNormalProperty(), kAccentColor);
  setColor(*plane.GetSelectedNormalProperty(), kHighlightColor);
}

}  // namespace

PlaneWidget::PlaneWidget(Viewport& viewport, QObject* parent) : QObject(parent)
{
  widget_->SetInteractor(viewport.interactor());
  widget_->SetDefaultRenderer(&viewport.widgetRenderer());
  widget_->KeyPressActivationOff();
  widget_->SetRepresentation(plane_);
  widget_->SetPriority(kPriority);
  // They move the camera.
  widget_->GetEventTranslator()->RemoveTranslation(vtkCommand::MiddleButtonPressEvent);
  widget_->GetEventTranslator()->RemoveTranslation(vtkCommand::RightButtonPressEvent);
  plane_->SetPlaceFactor(1.1);
  plane_->OutlineTranslationOff();
  plane_->ScaleEnabledOff();
  setLook(*plane_);
  connect(&viewport, &Viewport::surfaceChanged, this, [this, &viewport] { plane_->SetSurface(viewport.surface()); });
  connect(&viewport, &Viewport::closing, this, [this] { widget_->SetInteractor(nullptr); });
}

void PlaneWidget::place(const Positions& positions, const Vector3& point, const Vector3& normal)
{
  const Vector3 low = positions.colwise().minCoeff();
  const Vector3 high = positions.colwise().maxCoeff();
  std::array<double, 6> bounds{low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
  plane_->PlaceWidget(bounds.data());
  const Vector3 across = normal.stableNormalized();
  const Vector3 middle = (low + high) / 2;
  Vector3 nearest = middle - across.dot(middle - point) * across;
  Vector3 direction = across;
  plane_->SetOrigin(nearest.data());
  plane_->SetNormal(direction.data());
}

}  // namespace holdfast
