#include "holdfast/window/inspector/frame_section.h"

#include <QComboBox>
#include <cmath>

#include <holdfast/base/error.h>
#include <holdfast/geometry/centroid.h>
#include <holdfast/window/model/handle_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// Doubles count up to here one by one.
constexpr double kMostWholeTurns = 9e15;

const FrameMotion& framesOf(const Constraint& constraint)
{
  return std::get<FrameMotion>(std::get<HandleConstraint>(constraint.what).motion);
}

/// What the lines say, in the place of what `vector` has; of several that differ each keeps its own.
void take(const VectorEdit& lines, Vector3& vector)
{
  const VectorEdit::Numbers typed = lines.typed();
  for (Index axis = 0; axis < 3; ++axis) vector[axis] = typed[static_cast<std::size_t>(axis)].value_or(vector[axis]);
}

}  // namespace

FrameSection::FrameSection(Editor& editor, QWidget* parent)
    : InspectorSection(editor, parent),
      from_(addFrame(&FrameMotion::from, tr("&From"), "frameFrom", {tr("its centroid"), tr("a place")})),
      to_(addFrame(&FrameMotion::to, tr("T&o"), "frameTo", {tr("the same place"), tr("a place")})),
      turns_(addNumber(tr("&Whole turns"), "frameTurns"))
{
  explain(turns_, tr("Added to the shortest rotation, about its axis"));
  connect(turns_, &NumberEdit::entered, this, &FrameSection::setTurns);
}

FrameSection::Lines FrameSection::addFrame(Frame FrameMotion::*frame, const QString& title, const QString& name,
                                           const QStringList& origins)
{
  const QString spoken = QString(title).remove('&');
  Lines lines{frame};
  lines.choice = addChoice(title, name + "Choice", tr("%1: where the frame is").arg(spoken), origins);
  lines.origin = addVector(tr("Origin"), name + "Origin", tr("%1: origin").arg(spoken));
  lines.x = addVector(tr("x axis"), name + "X", tr("%1: x axis").arg(spoken));
  lines.y = addVector(tr("y axis"), name + "Y", tr("%1: y axis").arg(spoken));
  explain(lines.x, tr("Of any length"));
  explain(lines.y, tr("Of any length; what it has along x is left out"));
  connect(lines.choice, qOverload<int>(&QComboBox::activated), this,
          [this, lines](int choice) { chooseOrigin(lines, choice); });
  for (VectorEdit* edit : {lines.origin, lines.x, lines.y})
    connect(edit, &VectorEdit::entered, this, &FrameSection::takeFrames);
  return lines;
}

bool FrameSection::fits(const Constraint& constraint) const
{
  const auto* handle = std::get_if<HandleConstraint>(&constraint.what);
  return handle != nullptr && std::holds_alternative<FrameMotion>(handle->motion);
}

void FrameSection::refresh()
{
  turns_->setNumber(common([](const Constraint& c) { return std::optional(static_cast<double>(framesOf(c).turns)); }));
  const bool isOther = isNews();
  for (const Lines& lines : {from_, to_}) {
    const auto chosen =
        common([&](const Constraint& c) { return std::optional<double>((framesOf(c).*lines.frame).origin ? 1 : 0); });
    lines.choice->setCurrentIndex(chosen ? static_cast<int>(*chosen) : -1);
    setFieldVisible(lines.origin, chosen == 1);
    if (isOther) showFrame(lines);
  }
}

void FrameSection::showFrame(const Lines& lines)
{
  const auto show = [&](VectorEdit* edit, const auto& read) {
    edit->setNumbers(
        commonVector([&](const Constraint& c) { return std::optional<Vector3>(read(framesOf(c).*lines.frame)); }));
  };
  show(lines.origin, [](const Frame& frame) { return frame.origin; });
  show(lines.x, [](const Frame& frame) { return frame.x; });
  show(lines.y, [](const Frame& frame) { return frame.y; });
}

void FrameSection::chooseOrigin(const Lines& lines, int choice)
{
  const QString name = choice == 0 ? tr("take the origin of %1 from its vertices") : tr("give %1 an origin");
  changeFrames(name.arg(subject()),
               [&](FrameMotion motion, const Constraint& constraint) -> std::optional<FrameMotion> {
                 Frame& frame = motion.*lines.frame;
                 if (frame.origin.has_value() == (choice == 1)) return std::nullopt;
                 const auto present = [&] {
                   return motion.from.origin ? *motion.from.origin : centroid(settingOf(editor(), constraint).rest);
                 };
                 frame.origin = choice == 1 ? std::optional(present()) : std::nullopt;
                 return motion;
               });
}

void FrameSection::takeFrames()
{
  changeFrames(tr("set the frames of %1").arg(subject()), [this](FrameMotion motion, const Constraint&) {
    for (const Lines& lines : {from_, to_}) {
      Frame& frame = motion.*lines.frame;
      if (frame.origin) take(*lines.origin, *frame.origin);
      take(*lines.x, frame.x);
      take(*lines.y, frame.y);
    }
    return motion;
  });
}

void FrameSection::setTurns(double turns)
{
  changeFrames(tr("turn %1 by %2 whole turns more").arg(subject(), exactText(turns)),
               [&](FrameMotion motion, const Constraint&) {
                 if (turns != std::floor(turns) || std::abs(turns) > kMostWholeTurns)
                   throw InputError({}, exactText(turns).toStdString() + " is no whole number of turns");
                 motion.turns = static_cast<Index>(turns);
                 return motion;
               });
}

void FrameSection::changeFrames(const QString& name, const MotionChange& change)
{
  InspectorSection::change(name, [&](Constraint constraint) -> std::optional<Constraint> {
    const std::optional<FrameMotion> motion = change(framesOf(constraint), constraint);
    if (!motion) return std::nullopt;
    HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
    handle.motion = *motion;
    requireValid(handle);
    return constraint;
  });
}

}  // namespace holdfast
