#include <QComboBox>
#include <algorithm>

#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

class TargetSection : public SectionOf<PointConstraint> {
 public:
  explicit TargetSection(Editor& editor) : SectionOf(editor)
  {
    way_ = addChoice(tr("&Goes"), "targetWay", tr("How the target is given"),
                     {tr("to a place"), tr("by a shift from rest")}, [this](int way) { chooseWay(way); });
    place_ = addVector(tr("T&arget"), "targetPlace");
    shift_ = addVector(tr("&Shift"), "targetShift");
    connect(place_, &VectorEdit::entered, this, &TargetSection::setPlace);
    connect(shift_, &VectorEdit::entered, this, &TargetSection::setShift);
  }

 private:
  enum Way { ToPlace, ByShift };

  void refresh() override
  {
    const auto isShift = [this](Index row) { return std::holds_alternative<Move>(what(row).to); };
    const bool areShifts = std::all_of(rows().begin(), rows().end(), isShift);
    const bool arePlaces = std::none_of(rows().begin(), rows().end(), isShift);
    way_->setCurrentIndex(areShifts ? ByShift : arePlaces ? ToPlace : -1);
    place_->setNumbers(commonVectorOf([this](const PointConstraint& point) -> std::optional<Vector3> {
      if (const Target* target = std::get_if<Target>(&point.to)) return target->place;
      const std::optional<Vector3> rest = restPlace(editor(), point.at);
      return rest ? std::optional(placeOf(point, *rest)) : std::nullopt;
    }));
    setFieldVisible(shift_, areShifts);
    if (areShifts)
      shift_->setNumbers(commonVectorOf([](const PointConstraint& point) { return std::get<Move>(point.to).shift; }));
  }

  void chooseWay(int way)
  {
    const QString name = way == ToPlace ? tr("send %1 to a place") : tr("shift %1");
    edit(name.arg(subject()), [&](PointConstraint& point) {
      const std::optional<Vector3> rest = restPlace(editor(), point.at);
      const bool isThere = std::holds_alternative<Target>(point.to) == (way == ToPlace);
      if (!rest || isThere) return false;
      const Vector3 place = placeOf(point, *rest);
      if (way == ToPlace)
        point.to = Target{place};
      else
        point.to = Move{place - *rest};
      return true;
    });
    refresh();
  }

  void setPlace(int axis, double value)
  {
    edit(tr("move %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](PointConstraint& point) {
      const std::optional<Vector3> rest = restPlace(editor(), point.at);
      if (!rest) return false;
      Vector3 place = placeOf(point, *rest);
      place[axis] = value;
      point = goingTo(point, *rest, place);
      return true;
    });
  }

  void setShift(int axis, double value)
  {
    edit(tr("shift %1 by %2 = %3").arg(subject(), axisText(axis), exactText(value)), [&](PointConstraint& point) {
      std::get<Move>(point.to).shift[axis] = value;
      return true;
    });
  }

  QComboBox* way_ = nullptr;
  VectorEdit* place_ = nullptr;
  VectorEdit* shift_ = nullptr;
};

}  // namespace

InspectorSection* newTargetSection(Editor& editor)
{
  return new TargetSection(editor);
}

}  // namespace holdfast
