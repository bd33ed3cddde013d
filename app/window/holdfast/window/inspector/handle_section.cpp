#include <QComboBox>

#include <holdfast/geometry/centroid.h>
#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// In the order of `HandleConstraint::motion`.
enum Method { NoTurn, AboutAxis, AboutFixed, FromFrameToFrame, VertexByVertex };

/// Frames have a section of their own.
class HandleSection : public SectionOf<HandleConstraint> {
 public:
  explicit HandleSection(Editor& editor) : SectionOf(editor)
  {
    method_ =
        addChoice(tr("&Turns"), "handleMethod", tr("How the handle turns"),
                  {tr("not at all"), tr("by its own frame, about an axis"), tr("about the fixed region as it moves"),
                   tr("from frame to frame"), tr("as the targets of its vertices say")},
                  [this](int method) { chooseMethod(method); });
    axis_ = addVector(tr("&Axis"), "handleAxis");
    degrees_ = addNumber(tr("&Degrees"), "handleDegrees");
    explain(degrees_, tr("Any number of turns: 720 is twice around"));
    centerChoice_ = addChoice(tr("T&hrough"), "handleCenterChoice", tr("What the axis goes through"),
                              {tr("its centroid"), tr("a place")}, [this](int choice) { chooseCenter(choice); });
    center_ = addVector(tr("&Center"), "handleCenter");
    translation_ = addVector(tr("&Shift"), "handleTranslation");

    connect(degrees_, &NumberEdit::entered, this, [this](double value) {
      changeRotation(tr("turn %1 by %2 degrees").arg(subject(), exactText(value)),
                     [=](AxisRotation& turn) { turn.degrees = value; });
    });
    connect(axis_, &VectorEdit::entered, this, [this](int axis, double value) {
      changeRotation(tr("turn %1 about another axis").arg(subject()), [=](AxisRotation& turn) {
        turn.axis[axis] = value;
        requireAxis(turn.axis);
      });
    });
    connect(center_, &VectorEdit::entered, this, [this](int axis, double value) {
      changeRotation(tr("turn %1 about another place").arg(subject()),
                     [=](AxisRotation& turn) { (*turn.center)[axis] = value; });
    });
    connect(translation_, &VectorEdit::entered, this, [this](int axis, double value) {
      edit(tr("move %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](HandleConstraint& handle) {
        handle.translate[axis] = value;
        return true;
      });
    });
  }

 private:
  void refresh() override
  {
    const auto method =
        commonOf([](const HandleConstraint& handle) { return static_cast<double>(handle.motion.index()); });
    method_->setCurrentIndex(method ? static_cast<int>(*method) : -1);
    const bool areRotations = method == AboutAxis;
    setFieldVisible(axis_, areRotations);
    setFieldVisible(degrees_, areRotations);
    setFieldVisible(centerChoice_, areRotations);
    setFieldVisible(center_, areRotations && turnOf(what()).center.has_value());
    translation_->setNumbers(commonVectorOf([](const HandleConstraint& handle) { return handle.translate; }));
    if (!areRotations) return;
    axis_->setNumbers(commonVectorOf([](const HandleConstraint& handle) { return turnOf(handle).axis; }));
    degrees_->setNumber(commonOf([](const HandleConstraint& handle) { return turnOf(handle).degrees; }));
    const auto centered = commonOf([](const HandleConstraint& handle) { return turnOf(handle).center ? 1 : 0; });
    centerChoice_->setCurrentIndex(centered ? static_cast<int>(*centered) : -1);
    center_->setNumbers(commonVectorOf([](const HandleConstraint& handle) { return turnOf(handle).center; }));
  }

  static const AxisRotation& turnOf(const HandleConstraint& handle) { return std::get<AxisRotation>(handle.motion); }

  void chooseMethod(int method)
  {
    change(tr("turn %1 %2").arg(subject(), method_->itemText(method)),
           [&](Constraint constraint) -> std::optional<Constraint> {
             HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
             if (static_cast<int>(handle.motion.index()) == method) return std::nullopt;
             if (method == FromFrameToFrame) return restated(editor(), constraint, byFrames);
             if (method == VertexByVertex) return restated(editor(), constraint, byTargets);
             if (method == NoTurn) handle.motion = std::monostate{};
             if (method == AboutAxis) handle.motion = AxisRotation{};
             if (method == AboutFixed) handle.motion = RotationAboutFixed{};
             return constraint;
           });
    refresh();
  }

  void chooseCenter(int choice)
  {
    const QString name = choice == 0 ? tr("turn %1 about its centroid") : tr("turn %1 about a place");
    edit(name.arg(subject()), [&](HandleConstraint& handle) {
      AxisRotation& turn = std::get<AxisRotation>(handle.motion);
      if (turn.center.has_value() == (choice == 1)) return false;
      turn.center = choice == 1 ? std::optional(centroidOf(handle)) : std::nullopt;
      return true;
    });
    refresh();
  }

  Vector3 centroidOf(const HandleConstraint& handle)
  {
    const std::vector<Index> vertices = findVertices(editor(), handle.select).vertices;
    if (vertices.empty()) return Vector3::Zero();
    return centroid(editor().model()->mesh.positions(vertices, Eigen::all));
  }

  /// Changes the turn of all handles, each of which has one.
  void changeRotation(const QString& name, const std::function<void(AxisRotation&)>& change)
  {
    edit(name, [&](HandleConstraint& handle) {
      change(std::get<AxisRotation>(handle.motion));
      return true;
    });
  }

  QComboBox* method_ = nullptr;
  VectorEdit* axis_ = nullptr;
  NumberEdit* degrees_ = nullptr;
  QComboBox* centerChoice_ = nullptr;
  VectorEdit* center_ = nullptr;
  VectorEdit* translation_ = nullptr;
};

}  // namespace

InspectorSection* newHandleSection(Editor& editor)
{
  return new HandleSection(editor);
}

}  // namespace holdfast
