#include <QAction>

#include <vtkCamera.h>

#include <holdfast/window/tools/plane_widget.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class SectionTool : public QObject {
 public:
  SectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent)
      : QObject(parent), editor_(editor), viewport_(viewport), isOn_(isOn), plane_(viewport, this)
  {
    plane_.widget().AddObserver(vtkCommand::InteractionEvent, this, &SectionTool::cut);
    connect(&isOn, &QAction::toggled, this, &SectionTool::follow);
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
    plane_.setEnabled(isCutting);
    if (isCutting) return cut();
    viewport_.setSection(std::nullopt);
  }

  /// Through the middle, across the axis that is nearest to the sight, so that the half before it goes.
  void placeInDocument()
  {
    const Positions& positions = editor_.positions();
    const Vector3 sight(viewport_.renderer().GetActiveCamera()->GetDirectionOfProjection());
    Index axis = 0;
    sight.cwiseAbs().maxCoeff(&axis);
    Vector3 away = Vector3::Unit(axis);
    if (sight[axis] < 0) away = -away;
    plane_.place(positions, (positions.colwise().minCoeff() + positions.colwise().maxCoeff()) / 2, away);
    isPlaced_ = true;
  }

  void cut() { viewport_.setSection(SectionPlane{plane_.point(), plane_.normal()}); }

  Editor& editor_;
  Viewport& viewport_;
  QAction& isOn_;
  PlaneWidget plane_;
  bool isPlaced_ = false;  // in this document
};

}  // namespace

QObject* newSectionTool(Editor& editor, Viewport& viewport, QAction& isOn, QObject* parent)
{
  return new SectionTool(editor, viewport, isOn, parent);
}

}  // namespace holdfast
