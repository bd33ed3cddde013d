#include <QComboBox>
#include <algorithm>

#include <holdfast/window/inspector/point_section.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

TargetSection::TargetSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent), places_(editor)
{
  way_ =
      addChoice(tr("&Goes"), "targetWay", tr("How the target is said"), {tr("to a place"), tr("by a shift from rest")});
  place_ = addVector(tr("T&arget"), "targetPlace");
  shift_ = addVector(tr("&Shift"), "targetShift");
  connect(way_, qOverload<int>(&QComboBox::activated), this, &TargetSection::chooseWay);
  connect(place_, &VectorEdit::entered, this, &TargetSection::setPlace);
  connect(shift_, &VectorEdit::entered, this, &TargetSection::setShift);
}

bool TargetSection::fits(const Constraint& constraint) const
{
  return std::holds_alternative<PointConstraint>(constraint.what);
}

void TargetSection::refresh()
{
  const auto isShift = [this](Index row) {
    return std::holds_alternative<Move>(std::get<PointConstraint>(constraint(row).what).to);
  };
  const bool areShifts = std::all_of(rows().begin(), rows().end(), isShift);
  const bool arePlaces = std::none_of(rows().begin(), rows().end(), isShift);
  way_->setCurrentIndex(areShifts ? ByShift : arePlaces ? ToPlace : -1);
  place_->setNumbers(commonVector([this](const Constraint& constraint) -> std::optional<Vector3> {
    const PointConstraint& point = std::get<PointConstraint>(constraint.what);
    if (const Target* target = std::get_if<Target>(&point.to)) return target->place;
    const std::optional<Vector3> rest = places_.of(point.at);
    return rest ? std::optional(placeOf(point, *rest)) : std::nullopt;
  }));
  setFieldVisible(shift_, areShifts);
  if (areShifts)
    shift_->setNumbers(commonVector([](const Constraint& constraint) -> std::optional<Vector3> {
      return std::get<Move>(std::get<PointConstraint>(constraint.what).to).shift;
    }));
}

void TargetSection::chooseWay(int way)
{
  const QString name = way == ToPlace ? tr("send %1 to a place") : tr("shift %1");
  change(name.arg(subject()), [&](Constraint constraint) -> std::optional<Constraint> {
    PointConstraint& point = std::get<PointConstraint>(constraint.what);
    const std::optional<Vector3> rest = places_.of(point.at);
    const bool isThere = std::holds_alternative<Target>(point.to) == (way == ToPlace);
    if (!rest || isThere) return std::nullopt;
    const Vector3 place = placeOf(point, *rest);
    if (way == ToPlace)
      point.to = Target{place};
    else
      point.to = Move{place - *rest};
    return constraint;
  });
  refresh();
}

void TargetSection::setPlace(int axis, double value)
{
  change(tr("move %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)),
         [&](Constraint constraint) -> std::optional<Constraint> {
           PointConstraint& point = std::get<PointConstraint>(constraint.what);
           const std::optional<Vector3> rest = places_.of(point.at);
           if (!rest) return std::nullopt;
           Vector3 place = placeOf(point, *rest);
           place[axis] = value;
           point = goingTo(point, *rest, place);
           return constraint;
         });
}

void TargetSection::setShift(int axis, double value)
{
  change(tr("shift %1 by %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](Constraint constraint) {
    std::get<Move>(std::get<PointConstraint>(constraint.what).to).shift[axis] = value;
    return constraint;
  });
}

}  // namespace holdfast
