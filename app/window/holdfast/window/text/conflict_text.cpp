#include "holdfast/window/text/conflict_text.h"

#include <QCoreApplication>

#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

struct ConflictText {
  Q_DECLARE_TR_FUNCTIONS(ConflictText)
};

/// Of a set that is empty: the constraint contradicts itself, or its part of the mesh.
QString loneConflict(const ConstraintOutcome& outcome, const QString& length)
{
  return ConflictText::tr("%1 contradicts itself by %2, or asks a part to move that nothing places.")
      .arg(quoted(outcome.name), length);
}

}  // namespace

QString conflictText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet, const std::string& units)
{
  // The unit stays on the line of its number.
  const QString length = lengthText(conflictSet.gap.stableNorm(), units).replace(' ', QChar::Nbsp);
  if (conflictSet.with.empty()) return loneConflict(outcome, length);
  const QString others = quotedList(conflictSet.with);
  const QString own = quoted(outcome.name);
  const bool isOne = conflictSet.with.size() == 1;
  if (outcome.type == "relative")
    return (isOne ? ConflictText::tr("%1 asks for an offset that differs by %2 from what %3 says.")
                  : ConflictText::tr("%1 asks for an offset that differs by %2 from what %3 say."))
        .arg(own, length, others);
  if (outcome.type == "rigid")
    return (isOne ? ConflictText::tr("%1 cannot stay rigid: %3 bends it by %2.")
                  : ConflictText::tr("%1 cannot stay rigid: %3 bend it by %2."))
        .arg(own, length, others);
  if (outcome.type == "point")
    return (isOne ? ConflictText::tr("%1 asks for a place %2 away from where %3 puts it.")
                  : ConflictText::tr("%1 asks for a place %2 away from where %3 put it."))
        .arg(own, length, others);
  return (isOne ? ConflictText::tr("%1 asks for places up to %2 away from where %3 puts them.")
                : ConflictText::tr("%1 asks for places up to %2 away from where %3 put them."))
      .arg(own, length, others);
}

QString gapText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet, const std::string& units)
{
  QString text = ConflictText::tr("Off by %1").arg(roundedText(conflictSet.gap));
  if (!units.empty()) text += ' ' + QString::fromStdString(units);
  if (outcome.rows > 1)
    text += ConflictText::tr(", in %1 of its %2 rows")
                .arg(QString::number(conflictSet.rows), QString::number(outcome.rows));
  return text + '.';
}

QString repetitionText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet)
{
  const QString own = quoted(outcome.name);
  if (conflictSet.with.empty()) return ConflictText::tr("%1 repeats itself").arg(own);
  const QString others = quotedList(conflictSet.with);
  return conflictSet.rows == outcome.rows ? ConflictText::tr("%1 repeats %2").arg(own, others)
                                          : ConflictText::tr("%1 repeats %2 in part").arg(own, others);
}

}  // namespace holdfast
