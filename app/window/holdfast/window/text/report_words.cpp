#include "holdfast/window/text/report_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include <holdfast/deform/accuracy.h>
#include <holdfast/window/text/constraint_words.h>
#include <holdfast/window/text/number_words.h>

namespace holdfast {
namespace {

// Of a limit that is the usual one.
constexpr double kRounding = 1.000001;

struct ReportWords {
  Q_DECLARE_TR_FUNCTIONS(ReportWords)
};

QString text(std::string_view view)
{
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

QString secondsText(double seconds)
{
  return ReportWords::tr("%1 s").arg(roundedText(seconds));
}

QString meshText(const MeshReport& mesh)
{
  const QString parts =
      mesh.components == 1 ? ReportWords::tr("1 part") : ReportWords::tr("%1 parts").arg(countText(mesh.components));
  return ReportWords::tr("%1 vertices, %2 faces, %3").arg(countText(mesh.vertices), countText(mesh.faces), parts);
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
  return words.isEmpty() ? ReportWords::tr("none") : words.join(", ");
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
             : ReportWords::tr("%1, and up to %2 where doubles lie farther apart").arg(usual, roundedText(largest));
}

QString accuracyText(double accuracy)
{
  return ReportWords::tr("%1; doubtful above %2, refused above %3")
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
  say("Status", ReportWords::tr("Status"), text(name(solve.status)));
  say("Meaning", ReportWords::tr("Meaning"), QString::fromStdString(solve.message));
  say("Constraints", ReportWords::tr("Constraints"), countsText(report.constraints));
  say("Mesh", ReportWords::tr("Mesh"), meshText(report.mesh));
  say("Weights", ReportWords::tr("Weights"), text(name(solve.weights)));
  say("Solver", ReportWords::tr("Solver"), text(name(solve.options.kind)));
  if (solve.status == SolveStatus::Failed || solve.status == SolveStatus::NotRun) return lines;
  round("Residual", ReportWords::tr("Largest residual"), lengthText(solve.maxResidual, units), solve.maxResidual);
  round("RelativeResidual", ReportWords::tr("Relative residual"),
        ReportWords::tr("%1 of the diagonal, promised %2")
            .arg(roundedText(solve.maxResidualRelative), promiseText(report)),
        solve.maxResidualRelative);
  say("Method", ReportWords::tr("Method"), QString::fromStdString(solve.method));
  say("Unknowns", ReportWords::tr("Unknowns"), countText(solve.unknowns));
  say("Factor", ReportWords::tr("Factor"), ReportWords::tr("%1 non-zeros").arg(countText(solve.factorNonzeros)));
  say("Refinement", ReportWords::tr("Refinement"),
      solve.refinementSteps == 1 ? ReportWords::tr("1 step") : ReportWords::tr("%1 steps").arg(solve.refinementSteps));
  round("Accuracy", ReportWords::tr("Accuracy"), accuracyText(solve.accuracy), solve.accuracy);
  if (solve.rotationAccuracy)
    round("RotationAccuracy", ReportWords::tr("Rotations"), accuracyText(*solve.rotationAccuracy),
          *solve.rotationAccuracy);
  round("Setup", ReportWords::tr("Set-up"), secondsText(solve.seconds.setup), solve.seconds.setup);
  round("Decomposition", ReportWords::tr("Decomposition"), secondsText(solve.seconds.decomposition),
        solve.seconds.decomposition);
  round("Solution", ReportWords::tr("Solution"), secondsText(solve.seconds.solution), solve.seconds.solution);
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
