#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include <holdfast/base/error.h>
#include <holdfast/widgets/constraint_words.h>
#include <holdfast/widgets/number_words.h>
#include <holdfast/widgets/region_sections.h>

namespace holdfast {
namespace {

/// In the order of `Handle::motion`; the last two cannot be chosen, because nothing here edits them.
enum Method { NoTurn, AboutAxis, AboutFixed, FromFrameToFrame, VertexByVertex };

int methodOf(const Constraint& constraint)
{
  return static_cast<int>(std::get<Handle>(constraint.what).motion.index());
}

const Turn* turnOf(const Constraint& constraint)
{
  return std::get_if<Turn>(&std::get<Handle>(constraint.what).motion);
}

}  // namespace

HandleSection::HandleSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent), vertices_(editor)
{
  method_ = new QComboBox(this);
  method_->setObjectName("handleMethod");
  method_->setAccessibleName(tr("How the handle turns"));
  method_->addItems(
      {tr("not at all"), tr("by its own frame, about an axis"), tr("about the fixed region as it moves")});
  form().addRow(tr("&Turns"), method_);
  axis_ = addVector(tr("&Axis"), "handleAxis");
  degrees_ = addNumber(tr("&Degrees"), "handleDegrees");
  degrees_->setToolTip(tr("Any number of turns: 720 is twice around"));
  centerChoice_ = new QComboBox(this);
  centerChoice_->setObjectName("handleCenterChoice");
  centerChoice_->setAccessibleName(tr("What the axis goes through"));
  centerChoice_->addItems({tr("its centroid"), tr("a place")});
  form().addRow(tr("T&hrough"), centerChoice_);
  center_ = addVector(tr("&Center"), "handleCenter");
  translation_ = addVector(tr("&Shift"), "handleTranslation");

  connect(method_, qOverload<int>(&QComboBox::activated), this, &HandleSection::chooseMethod);
  connect(centerChoice_, qOverload<int>(&QComboBox::activated), this, &HandleSection::chooseCenter);
  connect(translation_, &VectorEdit::entered, this, &HandleSection::setTranslation);
  connect(degrees_, &NumberEdit::entered, this, [this](double value) {
    changeTurn(tr("turn %1 by %2 degrees").arg(subject(), exactText(value)),
               [=](Turn& turn, const Handle&) { turn.degrees = value; });
  });
  connect(axis_, &VectorEdit::entered, this, [this](int axis, double value) {
    changeTurn(tr("turn %1 about another axis").arg(subject()), [=](Turn& turn, const Handle&) {
      turn.axis[axis] = value;
      if (turn.axis.isZero(0))
        throw InputError({}, "an axis cannot be zero in x, y and z; type the new direction first, then this 0");
    });
  });
  connect(center_, &VectorEdit::entered, this, [this](int axis, double value) {
    changeTurn(tr("turn %1 about another place").arg(subject()),
               [=](Turn& turn, const Handle&) { (*turn.center)[axis] = value; });
  });
}

bool HandleSection::fits(const Constraint& constraint) const
{
  return std::holds_alternative<Handle>(constraint.what);
}

void HandleSection::refresh()
{
  const int method = methodOf(constraint(rows().front()));
  const bool isCommon = common([](const Constraint& c) { return std::optional<double>(methodOf(c)); }).has_value();
  while (method_->count() > FromFrameToFrame) method_->removeItem(FromFrameToFrame);
  if (isCommon && method == FromFrameToFrame) method_->addItem(tr("from frame to frame"));
  if (isCommon && method == VertexByVertex) method_->addItem(tr("as the targets of its vertices say"));
  method_->setCurrentIndex(isCommon ? std::min<int>(method, FromFrameToFrame) : -1);

  const bool areTurns = isCommon && method == AboutAxis;
  setFieldVisible(axis_, areTurns);
  setFieldVisible(degrees_, areTurns);
  setFieldVisible(centerChoice_, areTurns);
  setFieldVisible(center_, areTurns && turnOf(constraint(rows().front()))->center.has_value());
  translation_->setNumbers(
      commonVector([](const Constraint& c) { return std::optional<Vector3>(std::get<Handle>(c.what).translate); }));
  if (!areTurns) return;
  axis_->setNumbers(commonVector([](const Constraint& c) { return std::optional<Vector3>(turnOf(c)->axis); }));
  degrees_->setNumber(common([](const Constraint& c) { return std::optional<double>(turnOf(c)->degrees); }));
  const auto centered = common([](const Constraint& c) { return std::optional<double>(turnOf(c)->center ? 1 : 0); });
  centerChoice_->setCurrentIndex(centered ? static_cast<int>(*centered) : -1);
  center_->setNumbers(commonVector([](const Constraint& c) { return turnOf(c)->center; }));
}

void HandleSection::chooseMethod(int method)
{
  if (method > AboutFixed) return;
  change(tr("turn %1 %2").arg(subject(), method_->itemText(method)),
         [&](Constraint constraint) -> std::optional<Constraint> {
           Handle& handle = std::get<Handle>(constraint.what);
           if (static_cast<int>(handle.motion.index()) == method) return std::nullopt;
           if (method == NoTurn) handle.motion = std::monostate{};
           if (method == AboutAxis) handle.motion = Turn{};
           if (method == AboutFixed) handle.motion = TurnAboutFixed{};
           return constraint;
         });
  refresh();
}

Vector3 HandleSection::centroidOf(const Handle& handle)
{
  const std::vector<Index> vertices = vertices_.of(handle.select).vertices;
  Vector3 sum = Vector3::Zero();
  for (const Index v : vertices) sum += editor().model()->mesh.positions.row(v).transpose();
  return vertices.empty() ? sum : Vector3(sum / static_cast<double>(vertices.size()));
}

void HandleSection::chooseCenter(int choice)
{
  const QString name = choice == 0 ? tr("turn %1 about its centroid") : tr("turn %1 about a place");
  changeTurn(name.arg(subject()), [&](Turn& turn, const Handle& handle) {
    if (turn.center.has_value() == (choice == 1)) return;
    turn.center = choice == 1 ? std::optional(centroidOf(handle)) : std::nullopt;
  });
  refresh();
}

void HandleSection::setTranslation(int axis, double value)
{
  change(tr("move %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](Constraint constraint) {
    std::get<Handle>(constraint.what).translate[axis] = value;
    return constraint;
  });
}

void HandleSection::changeTurn(const QString& name, const std::function<void(Turn&, const Handle&)>& change)
{
  InspectorSection::change(name, [&](Constraint constraint) {
    Handle& handle = std::get<Handle>(constraint.what);
    Turn turn = std::get<Turn>(handle.motion);
    change(turn, handle);
    handle.motion = turn;
    return constraint;
  });
}

}  // namespace holdfast
