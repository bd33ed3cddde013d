#include <QComboBox>

#include <holdfast/window/inspector/region_sections.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// In the order of `HandleConstraint::motion`.
enum Method { NoTurn, AboutAxis, AboutFixed, FromFrameToFrame, VertexByVertex };

int methodOf(const Constraint& constraint)
{
  return static_cast<int>(std::get<HandleConstraint>(constraint.what).motion.index());
}

const AxisRotation* turnOf(const Constraint& constraint)
{
  return std::get_if<AxisRotation>(&std::get<HandleConstraint>(constraint.what).motion);
}

}  // namespace

HandleSection::HandleSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent), vertices_(editor)
{
  method_ =
      addChoice(tr("&Turns"), "handleMethod", tr("How the handle turns"),
                {tr("not at all"), tr("by its own frame, about an axis"), tr("about the fixed region as it moves"),
                 tr("from frame to frame"), tr("as the targets of its vertices say")});
  axis_ = addVector(tr("&Axis"), "handleAxis");
  degrees_ = addNumber(tr("&Degrees"), "handleDegrees");
  explain(degrees_, tr("Any number of turns: 720 is twice around"));
  centerChoice_ = addChoice(tr("T&hrough"), "handleCenterChoice", tr("What the axis goes through"),
                            {tr("its centroid"), tr("a place")});
  center_ = addVector(tr("&Center"), "handleCenter");
  translation_ = addVector(tr("&Shift"), "handleTranslation");

  connect(method_, qOverload<int>(&QComboBox::activated), this, &HandleSection::chooseMethod);
  connect(centerChoice_, qOverload<int>(&QComboBox::activated), this, &HandleSection::chooseCenter);
  connect(translation_, &VectorEdit::entered, this, &HandleSection::setTranslation);
  connect(degrees_, &NumberEdit::entered, this, [this](double value) {
    changeRotation(tr("turn %1 by %2 degrees").arg(subject(), exactText(value)),
                   [=](AxisRotation& turn, const HandleConstraint&) { turn.degrees = value; });
  });
  connect(axis_, &VectorEdit::entered, this, [this](int axis, double value) {
    changeRotation(tr("turn %1 about another axis").arg(subject()), [=](AxisRotation& turn, const HandleConstraint&) {
      turn.axis[axis] = value;
      requireAxis(turn.axis);
    });
  });
  connect(center_, &VectorEdit::entered, this, [this](int axis, double value) {
    changeRotation(tr("turn %1 about another place").arg(subject()),
                   [=](AxisRotation& turn, const HandleConstraint&) { (*turn.center)[axis] = value; });
  });
}

bool HandleSection::fits(const Constraint& constraint) const
{
  return std::holds_alternative<HandleConstraint>(constraint.what);
}

void HandleSection::refresh()
{
  const int method = methodOf(constraint(rows().front()));
  const bool isCommon = common([](const Constraint& c) { return std::optional<double>(methodOf(c)); }).has_value();
  method_->setCurrentIndex(isCommon ? method : -1);

  const bool areRotations = isCommon && method == AboutAxis;
  setFieldVisible(axis_, areRotations);
  setFieldVisible(degrees_, areRotations);
  setFieldVisible(centerChoice_, areRotations);
  setFieldVisible(center_, areRotations && turnOf(constraint(rows().front()))->center.has_value());
  translation_->setNumbers(commonVector(
      [](const Constraint& c) { return std::optional<Vector3>(std::get<HandleConstraint>(c.what).translate); }));
  if (!areRotations) return;
  axis_->setNumbers(commonVector([](const Constraint& c) { return std::optional<Vector3>(turnOf(c)->axis); }));
  degrees_->setNumber(common([](const Constraint& c) { return std::optional<double>(turnOf(c)->degrees); }));
  const auto centered = common([](const Constraint& c) { return std::optional<double>(turnOf(c)->center ? 1 : 0); });
  centerChoice_->setCurrentIndex(centered ? static_cast<int>(*centered) : -1);
  center_->setNumbers(commonVector([](const Constraint& c) { return turnOf(c)->center; }));
}

void HandleSection::chooseMethod(int method)
{
  change(tr("turn %1 %2").arg(subject(), method_->itemText(method)),
         [&](Constraint constraint) -> std::optional<Constraint> {
           if (methodOf(constraint) == method) return std::nullopt;
           if (method == FromFrameToFrame) return restated(editor(), constraint, byFrames);
           if (method == VertexByVertex) return restated(editor(), constraint, byTargets);
           HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
           if (method == NoTurn) handle.motion = std::monostate{};
           if (method == AboutAxis) handle.motion = AxisRotation{};
           if (method == AboutFixed) handle.motion = RotationAboutFixed{};
           return constraint;
         });
  refresh();
}

Vector3 HandleSection::centroidOf(const HandleConstraint& handle)
{
  const std::vector<Index> vertices = vertices_.of(handle.select).vertices;
  Vector3 sum = Vector3::Zero();
  for (const Index v : vertices) sum += editor().model()->mesh.positions.row(v).transpose();
  return vertices.empty() ? sum : Vector3(sum / static_cast<double>(vertices.size()));
}

void HandleSection::chooseCenter(int choice)
{
  const QString name = choice == 0 ? tr("turn %1 about its centroid") : tr("turn %1 about a place");
  changeRotation(name.arg(subject()), [&](AxisRotation& turn, const HandleConstraint& handle) {
    if (turn.center.has_value() == (choice == 1)) return;
    turn.center = choice == 1 ? std::optional(centroidOf(handle)) : std::nullopt;
  });
  refresh();
}

void HandleSection::setTranslation(int axis, double value)
{
  change(tr("move %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](Constraint constraint) {
    std::get<HandleConstraint>(constraint.what).translate[axis] = value;
    return constraint;
  });
}

void HandleSection::changeRotation(const QString& name,
                                   const std::function<void(AxisRotation&, const HandleConstraint&)>& change)
{
  InspectorSection::change(name, [&](Constraint constraint) {
    HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
    AxisRotation turn = std::get<AxisRotation>(handle.motion);
    change(turn, handle);
    handle.motion = turn;
    return constraint;
  });
}

}  // namespace holdfast
