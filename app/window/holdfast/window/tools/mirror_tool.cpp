#include <utility>

#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/plane_widget.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

// A normal that differs by less is the same: VTK brings it to length 1.
constexpr double kSameNormal = 1e-12;

/// Partners are found at rest, so the list is solved when the plane is let go, and not while it moves.
class MirrorTool : public QObject {
 public:
  MirrorTool(Editor& editor, Viewport& viewport, QObject* parent)
      : QObject(parent), editor_(editor), plane_(viewport, this)
  {
    plane_.widget().AddObserver(vtkCommand::StartInteractionEvent, this, &MirrorTool::start);
    plane_.widget().AddObserver(vtkCommand::EndInteractionEvent, this, &MirrorTool::finish);
    for (const auto& signal : {&Editor::opened, &Editor::stateChanged, &Editor::constraintSelectionChanged})
      connect(&editor, signal, this, &MirrorTool::follow);
  }

 private:
  /// The mirror that alone is selected, if there is one.
  [[nodiscard]] const MirrorConstraint* selected() const
  {
    if (!editor_.isOpen() || editor_.selectedConstraints().size() != 1) return nullptr;
    const Constraint& constraint = editor_.list().constraints[editor_.selectedConstraints().front()];
    return constraint.isEnabled ? std::get_if<MirrorConstraint>(&constraint.what) : nullptr;
  }

  void follow()
  {
    if (isMoving_) return;
    const MirrorConstraint* const mirror = selected();
    if (mirror != nullptr) plane_.place(editor_.model()->mesh.positions, mirror->point, mirror->normal);
    plane_.setEnabled(mirror != nullptr);
  }

  void start()
  {
    isMoving_ = true;
    point_ = plane_.point();
    normal_ = plane_.normal();
  }

  void finish()
  {
    isMoving_ = false;
    if (selected() == nullptr) return follow();
    const bool hasTurned = (plane_.normal() - normal_).norm() > kSameNormal;
    if (!hasTurned && plane_.point() == point_) return;
    ConstraintList list = editor_.list();
    const Index row = editor_.selectedConstraints().front();
    auto& mirror = std::get<MirrorConstraint>(list.constraints[row].what);
    mirror.point = plane_.point();
    if (hasTurned) mirror.normal = plane_.normal();
    editor_.edit(tr("move the mirror of %1").arg(subjectOf(editor_, {row})), std::move(list));
  }

  Editor& editor_;
  PlaneWidget plane_;
  bool isMoving_ = false;
  Vector3 point_ = Vector3::Zero();  // of the plane where the gesture began
  Vector3 normal_ = Vector3::UnitX();
};

}  // namespace

QObject* newMirrorTool(Editor& editor, Viewport& viewport, QObject* parent)
{
  return new MirrorTool(editor, viewport, parent);
}

}  // namespace holdfast
