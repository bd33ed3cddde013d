#include "holdfast/window/text/report_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include <holdfast/deform/accuracy.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// Of a limit that is the usual one.
constexpr double kRounding = 1.000001;

struct ReportText {
  Q_DECLARE_TR_FUNCTIONS(ReportText)
};

QString text(std::string_view view)
{
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

QString secondsText(double seconds)
{
  return ReportText::tr("%1 s").arg(roundedText(seconds));
}

QString meshText(const MeshReport& mesh)
{
  const QString parts =
      mesh.components == 1 ? ReportText::tr("1 part") : ReportText::tr("%1 parts").arg(countText(mesh.components));
  return ReportText::tr("%1 vertices, %2 faces, %3").arg(countText(mesh.vertices), countText(mesh.faces), parts);
}

/// "12 met, 2 conflicting"
QString countsText(const std::vector<ConstraintOutcome>& outcomes)
{
  QStringList words;
  for (const ConstraintStatus status :
       {ConstraintStatus::Met, ConstraintStatus::Redundant, ConstraintStatus::Conflicting, ConstraintStatus::Missed,
        ConstraintStatus::Independent, ConstraintStatus::Disabled}) {
    const auto count = std::count_if(outcomes.begin(), outcomes.end(),
                                     [&](const ConstraintOutcome& outcome) { return outcome.status == status; });
    if (count > 0) words << countText(count) + ' ' + statusText(status);
  }
  return words.isEmpty() ? ReportText::tr("none") : words.join(", ");
}

/// What is promised of the constraints, as shares of the diagonal: those far from the origin have limits of their own.
QString promiseText(const Report& report)
{
  double largest = kPromisedResidual;
  for (const ConstraintOutcome& outcome : report.constraints)
    largest = std::max(largest, outcome.limit.value_or(0) / report.mesh.bboxDiagonal);
  const QString usual = roundedText(kPromisedResidual);
  return largest <= kPromisedResidual * kRounding
             ? usual
             : ReportText::tr("%1, and up to %2 where doubles lie farther apart").arg(usual, roundedText(largest));
}

QString accuracyText(double accuracy)
{
  return ReportText::tr("%1; doubtful above %2, refused above %3")
      .arg(roundedText(accuracy), roundedText(kDoubtfulAccuracy), roundedText(kUsableAccuracy));
}

}  // namespace

ReportLines reportLines(const Report& report, const std::string& units)
{
  const SolveReport& solve = report.solve;
  ReportLines lines;
  const auto say = [&](const QString& key, const QString& title, const QString& value) {
    lines.push_back({key, title, value, {}});
  };
  const auto round = [&](const QString& key, const QString& title, const QString& value, double exact) {
    lines.push_back({key, title, value, exactText(exact)});
  };
  say("Status", ReportText::tr("Status"), text(name(solve.status)));
  say("Meaning", ReportText::tr("Meaning"), QString::fromStdString(solve.message));
  say("Constraints", ReportText::tr("Constraints"), countsText(report.constraints));
  say("Mesh", ReportText::tr("Mesh"), meshText(report.mesh));
  say("Weights", ReportText::tr("Weights"), text(name(solve.weights)));
  say("Solver", ReportText::tr("Solver"), text(name(solve.options.kind)));
  if (solve.status == SolveStatus::Failed || solve.status == SolveStatus::NotRun) return lines;
  round("Residual", ReportText::tr("Largest residual"), lengthText(solve.maxResidual, units), solve.maxResidual);
  round("RelativeResidual", ReportText::tr("Relative residual"),
        ReportText::tr("%1 of the diagonal, promised %2")
            .arg(roundedText(solve.maxResidualRelative), promiseText(report)),
        solve.maxResidualRelative);
  say("Method", ReportText::tr("Method"), QString::fromStdString(solve.method));
  say("Unknowns", ReportText::tr("Unknowns"), countText(solve.unknowns));
  say("Factor", ReportText::tr("Factor"), ReportText::tr("%1 non-zeros").arg(countText(solve.factorNonzeros)));
  say("Refinement", ReportText::tr("Refinement"),
      solve.refinementSteps == 1 ? ReportText::tr("1 step") : ReportText::tr("%1 steps").arg(solve.refinementSteps));
  round("Accuracy", ReportText::tr("Accuracy"), accuracyText(solve.accuracy), solve.accuracy);
  if (solve.rotationAccuracy)
    round("RotationAccuracy", ReportText::tr("Rotations"), accuracyText(*solve.rotationAccuracy),
          *solve.rotationAccuracy);
  round("Setup", ReportText::tr("Set-up"), secondsText(solve.seconds.setup), solve.seconds.setup);
  round("Decomposition", ReportText::tr("Decomposition"), secondsText(solve.seconds.factorization),
        solve.seconds.factorization);
  round("Solution", ReportText::tr("Solution"), secondsText(solve.seconds.solution), solve.seconds.solution);
  return lines;
}

QString reportText(const ReportLines& lines)
{
  int widest = 0;
  for (const ReportLine& line : lines) widest = std::max(widest, static_cast<int>(line.title.size()));
  QString text;
  for (const ReportLine& line : lines) text += line.title.leftJustified(widest + 2) + line.value + '\n';
  return text;
}

}  // namespace holdfast
