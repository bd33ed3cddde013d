#include "holdfast/window/text/conflict_words.h"

#include <QCoreApplication>

#include <holdfast/window/text/constraint_words.h>
#include <holdfast/window/text/number_words.h>

namespace holdfast {
namespace {

struct ConflictWords {
  Q_DECLARE_TR_FUNCTIONS(ConflictWords)
};

/// Of a set that is empty: the constraint contradicts itself, or its part of the mesh.
QString loneConflict(const ConstraintOutcome& outcome, const QString& length)
{
  return ConflictWords::tr("%1 contradicts itself by %2, or asks a part to move that nothing places.")
      .arg(quoted(outcome.name), length);
}

}  // namespace

QString conflictText(const ConstraintOutcome& outcome, const Clash& clash, const std::string& units)
{
  // The unit stays on the line of its number.
  const QString length = lengthText(clash.gap.stableNorm(), units).replace(' ', QChar::Nbsp);
  if (clash.with.empty()) return loneConflict(outcome, length);
  const QString others = quotedList(clash.with);
  const QString own = quoted(outcome.name);
  const bool isOne = clash.with.size() == 1;
  if (outcome.type == "relative")
    return (isOne ? ConflictWords::tr("%1 asks for an offset that differs by %2 from what %3 says.")
                  : ConflictWords::tr("%1 asks for an offset that differs by %2 from what %3 say."))
        .arg(own, length, others);
  if (outcome.type == "rigid")
    return (isOne ? ConflictWords::tr("%1 cannot stay rigid: %3 bends it by %2.")
                  : ConflictWords::tr("%1 cannot stay rigid: %3 bend it by %2."))
        .arg(own, length, others);
  if (outcome.type == "point")
    return (isOne ? ConflictWords::tr("%1 asks for a place %2 away from where %3 puts it.")
                  : ConflictWords::tr("%1 asks for a place %2 away from where %3 put it."))
        .arg(own, length, others);
  return (isOne ? ConflictWords::tr("%1 asks for places up to %2 away from where %3 puts them.")
                : ConflictWords::tr("%1 asks for places up to %2 away from where %3 put them."))
      .arg(own, length, others);
}

QString gapText(const ConstraintOutcome& outcome, const Clash& clash, const std::string& units)
{
  QString text = ConflictWords::tr("Off by %1").arg(roundedText(clash.gap));
  if (!units.empty()) text += ' ' + QString::fromStdString(units);
  if (outcome.rows > 1)
    text += ConflictWords::tr(", in %1 of its %2 rows").arg(QString::number(clash.rows), QString::number(outcome.rows));
  return text + '.';
}

QString repetitionText(const ConstraintOutcome& outcome, const Clash& clash)
{
  const QString own = quoted(outcome.name);
  if (clash.with.empty()) return ConflictWords::tr("%1 repeats itself").arg(own);
  const QString others = quotedList(clash.with);
  return clash.rows == outcome.rows ? ConflictWords::tr("%1 repeats %2").arg(own, others)
                                    : ConflictWords::tr("%1 repeats %2 in part").arg(own, others);
}

}  // namespace holdfast
