#include <QComboBox>
#include <cmath>

#include <holdfast/base/error.h>
#include <holdfast/geometry/centroid.h>
#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// Doubles represent all whole numbers up to here.
constexpr double kMostWholeTurns = 9e15;

const FrameMotion& framesOf(const Constraint& constraint)
{
  return std::get<FrameMotion>(std::get<HandleConstraint>(constraint.what).motion);
}

/// Puts the numbers of the lines into `vector`; an empty line leaves its number as it is.
void take(const VectorEdit& lines, Vector3& vector)
{
  const VectorEdit::Numbers typed = lines.typed();
  for (Index axis = 0; axis < 3; ++axis) vector[axis] = typed[static_cast<std::size_t>(axis)].value_or(vector[axis]);
}

/// Numbers of the frames stay in the lines until they make frames.
class FrameSection : public InspectorSection {
 public:
  explicit FrameSection(Editor& editor)
      : InspectorSection(editor),
        from_(addFrame(&FrameMotion::from, tr("&From"), "frameFrom", {tr("its centroid"), tr("a place")})),
        to_(addFrame(&FrameMotion::to, tr("T&o"), "frameTo", {tr("the same place"), tr("a place")})),
        turns_(addNumber(tr("&Whole turns"), "frameTurns"))
  {
    explain(turns_, tr("Added to the shortest rotation, about its axis"));
    connect(turns_, &NumberEdit::entered, this, &FrameSection::setTurns);
  }

  bool fits(const Constraint& constraint) const override
  {
    const auto* handle = std::get_if<HandleConstraint>(&constraint.what);
    return handle != nullptr && std::holds_alternative<FrameMotion>(handle->motion);
  }

 private:
  /// One frame in lines.
  struct Lines {
    Frame FrameMotion::*frame;
    QComboBox* choice = nullptr;
    VectorEdit* origin = nullptr;
    VectorEdit* x = nullptr;
    VectorEdit* y = nullptr;
  };

  Lines addFrame(Frame FrameMotion::*frame, const QString& title, const QString& name, const QStringList& origins)
  {
    const QString spoken = QString(title).remove('&');
    Lines lines{frame};
    lines.choice = addChoice(title, name + "Choice", tr("%1: where the frame is").arg(spoken), origins,
                             [this, frame](int choice) { chooseOrigin(frame, choice); });
    lines.origin = addVector(tr("Origin"), name + "Origin", tr("%1: origin").arg(spoken));
    lines.x = addVector(tr("x axis"), name + "X", tr("%1: x axis").arg(spoken));
    lines.y = addVector(tr("y axis"), name + "Y", tr("%1: y axis").arg(spoken));
    explain(lines.x, tr("Of any length"));
    explain(lines.y, tr("Of any length; its part along x is ignored"));
    for (VectorEdit* edit : {lines.origin, lines.x, lines.y})
      connect(edit, &VectorEdit::entered, this, &FrameSection::takeFrames);
    return lines;
  }

  void refresh() override
  {
    turns_->setNumber(
        common([](const Constraint& c) { return std::optional(static_cast<double>(framesOf(c).turns)); }));
    const bool isOther = isNews();
    for (const Lines& lines : {from_, to_}) {
      const auto chosen =
          common([&](const Constraint& c) { return std::optional<double>((framesOf(c).*lines.frame).origin ? 1 : 0); });
      lines.choice->setCurrentIndex(chosen ? static_cast<int>(*chosen) : -1);
      setFieldVisible(lines.origin, chosen == 1);
      if (isOther) showFrame(lines);
    }
  }

  void showFrame(const Lines& lines)
  {
    const auto show = [&](VectorEdit* edit, auto Frame::*vector) {
      edit->setNumbers(
          commonVector([&](const Constraint& c) { return std::optional<Vector3>(framesOf(c).*lines.frame.*vector); }));
    };
    show(lines.origin, &Frame::origin);
    show(lines.x, &Frame::x);
    show(lines.y, &Frame::y);
  }

  void chooseOrigin(Frame FrameMotion::*place, int choice)
  {
    const QString name = choice == 0 ? tr("take the origin of %1 from its vertices") : tr("give %1 an origin");
    changeFrames(name.arg(subject()), [&](FrameMotion& motion, const Constraint& constraint) {
      Frame& frame = motion.*place;
      if (frame.origin.has_value() == (choice == 1)) return false;
      if (choice == 0)
        frame.origin.reset();
      else
        frame.origin = motion.from.origin ? *motion.from.origin : centroid(settingOf(editor(), constraint).rest);
      return true;
    });
  }

  void takeFrames()
  {
    changeFrames(tr("set the frames of %1").arg(subject()), [this](FrameMotion& motion, const Constraint&) {
      for (const Lines& lines : {from_, to_}) {
        Frame& frame = motion.*lines.frame;
        if (frame.origin) take(*lines.origin, *frame.origin);
        take(*lines.x, frame.x);
        take(*lines.y, frame.y);
      }
      return true;
    });
  }

  void setTurns(double turns)
  {
    changeFrames(tr("turn %1 by %2 whole turns more").arg(subject(), exactText(turns)),
                 [&](FrameMotion& motion, const Constraint&) {
                   if (turns != std::floor(turns) || std::abs(turns) > kMostWholeTurns)
                     throw InputError({}, exactText(turns).toStdString() + " is no whole number of turns");
                   motion.turns = static_cast<Index>(turns);
                   return true;
                 });
  }

  /// `edit` changes the motion of a handle, or returns false to leave it as it is.
  void changeFrames(const QString& name, const std::function<bool(FrameMotion&, const Constraint&)>& edit)
  {
    change(name, [&](Constraint constraint) -> std::optional<Constraint> {
      HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
      if (!edit(std::get<FrameMotion>(handle.motion), constraint)) return std::nullopt;
      requireValid(handle);
      return constraint;
    });
  }

  Lines from_;
  Lines to_;
  NumberEdit* turns_ = nullptr;
};

}  // namespace

InspectorSection* newFrameSection(Editor& editor)
{
  return new FrameSection(editor);
}

}  // namespace holdfast
