#include "holdfast/window/window/status_line.h"

#include <QEvent>
#include <algorithm>

#include <holdfast/deform/outcomes.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kIndent = 6;

QString shareText(double share)
{
  return share == 0 ? QString("0") : QString::number(share, 'e', 1);
}

QString milliseconds(double seconds)
{
  const double value = 1000 * seconds;
  return value < 10 ? QString::number(value, 'f', 1) : QString::number(value, 'f', 0);
}

}  // namespace

StatusLine::StatusLine(Editor& editor, QWidget* parent)
    : QStatusBar(parent),
      editor_(editor),
      left_(named(new QLabel(this), "statusHint")),
      step_(named(new QLabel(this), "statusStage")),
      cancel_(named(new QPushButton(tr("Stop"), this), "statusStop")),
      result_(named(new QLabel(this), "statusResult")),
      numbers_(named(new QLabel(this), "statusNumbers")),
      selection_(named(new QLabel(this), "statusSelection"))
{
  setObjectName("statusLine");
  left_->setMinimumWidth(1);
  left_->setIndent(kIndent);
  left_->installEventFilter(this);
  cancel_->setToolTip(tr("Stop solving; the picture stays as it is (Esc)"));
  cancel_->setFlat(true);
  addWidget(left_, 1);
  addPermanentWidget(step_);
  addPermanentWidget(cancel_);
  addPermanentWidget(result_);
  addPermanentWidget(numbers_);
  addPermanentWidget(selection_);
  connect(cancel_, &QPushButton::clicked, &editor_, &Editor::cancelSolving);
  connect(&editor_, &Editor::opened, this, &StatusLine::clearDocumentMessage);
  connect(&editor_, &Editor::opened, this, &StatusLine::showNumbers);
  for (const auto& signal : {&Editor::deformed, &Editor::examined})
    connect(&editor_, signal, this, &StatusLine::showNumbers);
  for (const auto& signal : {&Editor::opened, &Editor::deformed, &Editor::examined})
    connect(&editor_, signal, this, &StatusLine::showResult);
  for (const auto& signal : {&Editor::deformed, &Editor::vertexSelectionChanged, &Editor::decimalsChanged})
    connect(&editor_, signal, this, &StatusLine::measureSelection);
  connect(&editor_, &Editor::solveStateChanged, this, &StatusLine::showStep);
  connect(&editor_, &Editor::stepChanged, this, &StatusLine::showStep);
  showNumbers();
  showResult();
  showStep();
}

void StatusLine::showHint()
{
  left_->setText(left_->fontMetrics().elidedText(hint_, Qt::ElideRight, left_->width() - 2 * kIndent));
  left_->setToolTip(hint_);
}

/// What is said of the document that is coming stays.
void StatusLine::clearDocumentMessage()
{
  if (currentMessage() == documentMessage_) clearMessage();
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == left_ && event->type() == QEvent::Resize) showHint();
  return QStatusBar::eventFilter(watched, event);
}

void StatusLine::showStep()
{
  const bool isSolving = editor_.solveState() == SolveState::Solving && !editor_.history().isInGesture();
  step_->setText(isSolving && !editor_.step().isEmpty() ? editor_.step() + "…" : QString());
  step_->setVisible(isSolving);
  cancel_->setVisible(isSolving);
}

/// On a thread of its own, for its time is that of the mesh. What changes meanwhile is measured after it.
void StatusLine::measureSelection()
{
  showNumbers();
  if (editor_.selectedVertices().empty()) return;
  isMeasureDue_ = measure_.isRunning();
  if (isMeasureDue_) return;
  measure_.start([this, model = editor_.model(), surface = editor_.surface(), vertices = editor_.selectedVertices(),
                  style = editor_.lengthStyle()](Progress&) -> BackgroundJob::Finish {
    const RegionSize size = sizeOfRegion(vertices, model->triangulation.triangles, surface->positions());
    return [this, size, style, count = static_cast<Index>(vertices.size())] {
      const Vector3 extent = size.box.sizes();
      const QString unit = style.units.empty() ? QString() : ' ' + QString::fromStdString(style.units);
      const QString square = unit.isEmpty() ? unit : unit + QStringLiteral("²");
      selection_->setText(QStringList{
          countText(count, "1 vertex", "%1 vertices"), countText(size.triangles, "1 triangle", "%1 triangles"),
          tr("area %1").arg(roundedText(size.area) + square),
          QStringList{numberText(extent.x(), style), numberText(extent.y(), style), numberText(extent.z(), style)}.join(
              QStringLiteral(" × ")) +
              unit}
                              .join("  ·  "));
      selection_->setToolTip(tr("Selected, from %1 to %2%3. Triangles and area: those with all corners selected.")
                                 .arg(placeText(size.box.min(), style), placeText(size.box.max(), style), unit));
      showNumbers();
      if (isMeasureDue_) measureSelection();
    };
  });
}

/// Says nothing of a result that is fine.
void StatusLine::showResult()
{
  if (!editor_.isResultKnown()) return;
  const auto& report = editor_.report();
  result_->setVisible(report != nullptr && report->result.status == ResultStatus::Doubtful);
  if (!result_->isVisibleTo(this)) return;
  const auto count = static_cast<Index>(report->result.warnings.size());
  QPalette own = palette();
  own.setColor(QPalette::WindowText, statusColor(ConstraintStatus::Missed, own));
  result_->setPalette(own);
  result_->setText(countText(count, "Doubtful result: 1 finding", "Doubtful result: %1 findings"));
  QStringList messages;
  for (const Finding& finding : report->mesh.findings)
    if (std::ranges::find(report->result.warnings, finding.kind) != report->result.warnings.end())
      messages << QString::fromStdString(finding.message);
  result_->setToolTip(plainTip(messages.join("\n\n")));
}

void StatusLine::showNumbers()
{
  const bool isSelection = editor_.isOpen() && !editor_.selectedVertices().empty();
  selection_->setVisible(isSelection);
  numbers_->setVisible(editor_.isOpen() && !isSelection);
  if (!editor_.isOpen()) return;
  QStringList parts{countText(editor_.model()->mesh.vertexCount(), "1 vertex", "%1 vertices")};
  QString times;
  if (const auto& deformation = editor_.deformation()) {
    const SolveReport& solve = deformation->report.solve;
    const bool isAllMet = countOf(deformation->report, ConstraintStatus::Missed) == 0;
    times = tr("Time: %1 ms set-up, %2 ms decomposition, %3 ms solution. ")
                .arg(milliseconds(solve.seconds.setup), milliseconds(solve.seconds.factorization),
                     milliseconds(solve.seconds.solution)) +
            tr("Largest residual: %1. ").arg(shareText(solve.maxResidualRelative));
    parts << countText(solve.unknowns, "1 unknown", "%1 unknowns")
          << tr("%1 ms").arg(milliseconds(solve.seconds.setup + solve.seconds.factorization + solve.seconds.solution))
          << (solve.status == SolveStatus::Failed ? tr("not solved")
              : isAllMet                          ? tr("residuals met")
                                                  : tr("residual %1").arg(shareText(solve.maxResidualRelative)));
    if (solve.status != SolveStatus::Failed) parts << tr("accuracy %1").arg(shareText(solve.accuracy));
  }
  numbers_->setText(parts.join("  ·  "));
  numbers_->setToolTip(
      times +
      tr("Residual: the largest of all constraints except those in "
         "conflict, as a share of the bounding box's diagonal. The solver “hard” promises at most 1e-12 or, for a "
         "constraint whose coordinates are so large that doubles lie farther apart, 8 epsilon of the largest "
         "coordinate. "
         "Accuracy: the estimated relative error of the solution. Above 1e-9 it is a finding; above "
         "1e-6 "
         "the solution is refused."));
}

}  // namespace holdfast
