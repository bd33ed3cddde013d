#include <QAction>
#include <array>

#include <vtkCamera.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkProperty.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/interaction/vtkHoldfastSectionPlaneRepresentation.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/window/tools/tools.h>

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

class SectionTool : public QObject {
 public:
  SectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent)
      : QObject(parent), editor_(editor), viewport_(viewport), isOn_(isOn)
  {
    widget_->SetInteractor(viewport.interactor());
    widget_->SetDefaultRenderer(&viewport.widgetRenderer());
    widget_->KeyPressActivationOff();
    widget_->SetRepresentation(plane_);
    widget_->SetPriority(kPriority);
    // They move the camera.
    widget_->GetEventTranslator()->RemoveTranslation(vtkCommand::MiddleButtonPressEvent);
    widget_->GetEventTranslator()->RemoveTranslation(vtkCommand::RightButtonPressEvent);
    widget_->AddObserver(vtkCommand::InteractionEvent, this, &SectionTool::cut);
    plane_->SetPlaceFactor(1.1);
    plane_->OutlineTranslationOff();
    plane_->ScaleEnabledOff();
    setLook(*plane_);
    connect(&isOn, &QAction::toggled, this, &SectionTool::follow);
    connect(&viewport, &Viewport::surfaceChanged, this, [this] { plane_->SetSurface(viewport_.surface()); });
    connect(&viewport, &Viewport::closing, this, [this] { widget_->SetInteractor(nullptr); });
    connect(&editor, &Editor::opened, this, [this] {
      isPlaced_ = false;
      follow();
    });
  }

 private:
  void follow()
  {
    const bool isCutting = isOn_.isChecked() && editor_.isOpen();
    if (isCutting && !isPlaced_) placeInDocument();
    widget_->SetEnabled(isCutting ? 1 : 0);
    if (isCutting) return cut();
    viewport_.setSection(std::nullopt);
  }

  /// Through the middle, across the axis that is nearest to the sight, so that the half before it goes.
  void placeInDocument()
  {
    const Positions& positions = editor_.positions();
    const Vector3 low = positions.colwise().minCoeff();
    const Vector3 high = positions.colwise().maxCoeff();
    std::array<double, 6> bounds{low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
    plane_->PlaceWidget(bounds.data());
    const Vector3 sight(viewport_.renderer().GetActiveCamera()->GetDirectionOfProjection());
    Index axis = 0;
    sight.cwiseAbs().maxCoeff(&axis);
    Vector3 away = Vector3::Unit(axis);
    if (sight[axis] < 0) away = -away;
    Vector3 middle = (low + high) / 2;
    plane_->SetOrigin(middle.data());
    plane_->SetNormal(away.data());
    isPlaced_ = true;
  }

  void cut() { viewport_.setSection(SectionPlane{Vector3(plane_->GetOrigin()), Vector3(plane_->GetNormal())}); }

  Editor& editor_;
  Viewport& viewport_;
  QAction& isOn_;
  vtkNew<vtkHoldfastSectionPlaneRepresentation> plane_;
  vtkNew<vtkImplicitPlaneWidget2> widget_;
  bool isPlaced_ = false;  // in this document
};

}  // namespace

QObject* newSectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent)
{
  return new SectionTool(editor, viewport, isOn, parent);
}

}  // namespace holdfast
