#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <algorithm>
#include <string>
#include <vector>

#include <holdfast/deform/messages.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

struct ReportLine {
  QString key;  ///< its name for scripts
  QString title;
  QString value;
  QString exact;  ///< with all digits, where `value` is rounded
};

using ReportLines = std::vector<ReportLine>;

// Limits within this factor of the usual one count as usual.
constexpr double kRounding = 1.000001;

QString secondsText(double seconds)
{
  return QObject::tr("%1 s").arg(roundedText(seconds));
}

QString meshText(const MeshReport& mesh)
{
  return countText(mesh.vertices, "1 vertex", "%1 vertices") + ", " + countText(mesh.faces, "1 face", "%1 faces") +
         ", " + countText(mesh.components, "1 part", "%1 parts");
}

/// "12 met, 2 conflicting"
QString countsText(const Report& report)
{
  QStringList words;
  for (const ConstraintStatus status :
       {ConstraintStatus::Met, ConstraintStatus::Redundant, ConstraintStatus::Conflicting, ConstraintStatus::Missed,
        ConstraintStatus::Independent, ConstraintStatus::Disabled})
    if (const Index count = countOf(report, status); count > 0) words << countText(count) + ' ' + statusText(status);
  return words.isEmpty() ? QObject::tr("none") : words.join(", ");
}

/// The largest limit of a residual, model units. Constraints far from the origin have limits of their own.
double largestLimit(const Report& report)
{
  double largest = kPromisedResidual * report.mesh.bboxDiagonal;
  for (const ConstraintOutcome& outcome : report.constraints) largest = std::max(largest, outcome.limit.value_or(0));
  return largest;
}

/// The promised residuals as shares of the diagonal.
QString promiseText(const Report& report)
{
  const double largest = largestLimit(report) / report.mesh.bboxDiagonal;
  const QString usual = roundedText(kPromisedResidual);
  return largest <= kPromisedResidual * kRounding
             ? usual
             : QObject::tr("%1, and up to %2 where doubles lie farther apart").arg(usual, roundedText(largest));
}

QString residualText(const Report& report, const LengthStyle& style)
{
  if (countOf(report, ConstraintStatus::Missed) == 0) return metText(largestLimit(report), style.units);
  return lengthText(report.solve.maxResidual, style);
}

QString relativeResidualText(const Report& report)
{
  if (countOf(report, ConstraintStatus::Missed) == 0)
    return QObject::tr("met ≤ %1 of the diagonal").arg(promiseText(report));
  return QObject::tr("%1 of the diagonal, promised %2")
      .arg(roundedText(report.solve.maxResidualRelative), promiseText(report));
}

QString accuracyText(double accuracy)
{
  return QObject::tr("%1; doubtful above %2, refused above %3")
      .arg(roundedText(accuracy), roundedText(kDoubtfulAccuracy), roundedText(kUsableAccuracy));
}

QString iterationsText(const RotationIterations& iterations, RotationSource source)
{
  return QObject::tr("iteration %1 moved a vertex by %2 of the %3%4")
      .arg(countText(iterations.count), roundedText(iterations.change), toText(sizeName(source)),
           iterations.isConverged ? QString() : QObject::tr("; more would move it further"));
}

/// "fine", or "doubtful: folded faces, inverted faces"
QString resultText(const ResultVerdict& result)
{
  QStringList kinds;
  for (const std::string& kind : result.warnings) kinds << QString::fromStdString(kind).replace('_', ' ');
  return toText(name(result.status)) + (kinds.isEmpty() ? QString() : ": " + kinds.join(", "));
}

QString rangeText(const RatioVerdict& ratios)
{
  return QObject::tr("%1 to %2 times as large as at rest").arg(roundedText(ratios.least), roundedText(ratios.most));
}

ReportLines reportLines(const Report& report, const ResultVerdict& result, const LengthStyle& style)
{
  const SolveReport& solve = report.solve;
  ReportLines lines;
  const auto say = [&](const QString& key, const QString& title, const QString& value) {
    lines.push_back({key, title, value, {}});
  };
  const auto round = [&](const QString& key, const QString& title, const QString& value, double exact) {
    lines.push_back({key, title, value, exactText(exact)});
  };
  say("Status", QObject::tr("Status"), toText(name(solve.status)));
  say("Meaning", QObject::tr("Meaning"), QString::fromStdString(solve.message));
  say("Constraints", QObject::tr("Constraints"), countsText(report));
  say("Mesh", QObject::tr("Mesh"), meshText(report.mesh));
  say("Weights", QObject::tr("Weights"), toText(name(solve.weights)));
  say("Solver", QObject::tr("Solver"), toText(name(solve.options.kind)));
  if (solve.status == SolveStatus::Failed || solve.status == SolveStatus::NotRun) return lines;
  round("Residual", QObject::tr("Largest residual"), residualText(report, style), solve.maxResidual);
  round("RelativeResidual", QObject::tr("Relative residual"), relativeResidualText(report), solve.maxResidualRelative);
  say("Method", QObject::tr("Method"), QString::fromStdString(solve.method));
  say("Unknowns", QObject::tr("Unknowns"), countText(solve.unknowns));
  say("Factor", QObject::tr("Factor"), QObject::tr("%1 non-zeros").arg(countText(solve.factorNonzeros)));
  say("Refinement", QObject::tr("Refinement"), countText(solve.refinementSteps, "1 step", "%1 steps"));
  round("Accuracy", QObject::tr("Accuracy"), accuracyText(solve.accuracy), solve.accuracy);
  if (solve.rotationAccuracy)
    round("RotationAccuracy", QObject::tr("Rotations"), accuracyText(*solve.rotationAccuracy), *solve.rotationAccuracy);
  if (solve.iterations)
    round("RotationIterations", QObject::tr("Rotations found"), iterationsText(*solve.iterations, solve.rotations),
          solve.iterations->change);
  say("Result", QObject::tr("Result"), resultText(result));
  say("Lengths", QObject::tr("Lengths of edges"), rangeText(result.edges));
  say("Areas", QObject::tr("Areas of faces"), rangeText(result.areas));
  say("Volumes", QObject::tr("Enclosed volumes"), rangeText(result.volumes));
  round("Setup", QObject::tr("Set-up"), secondsText(solve.seconds.setup), solve.seconds.setup);
  round("Decomposition", QObject::tr("Decomposition"), secondsText(solve.seconds.factorization),
        solve.seconds.factorization);
  round("Solution", QObject::tr("Solution"), secondsText(solve.seconds.solution), solve.seconds.solution);
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

class ReportPanel final : public RefreshedPanel {
 public:
  explicit ReportPanel(Editor& editor) : editor_(editor)
  {
    setObjectName("reportPanel");
    QWidget* content = new QWidget;
    auto* layout = newLayout<QVBoxLayout>(content, 10, 8);
    makeOptions();
    layout->addLayout(options_);
    age_ = newText("reportAge");
    layout->addWidget(age_);
    report_ = new QFormLayout;
    report_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    report_->setHorizontalSpacing(10);
    report_->setVerticalSpacing(4);
    layout->addLayout(report_);
    copy_ = named(new QPushButton(tr("Copy as te&xt")), "reportCopy");
    connect(copy_, &QPushButton::clicked, this, &ReportPanel::copy);
    layout->addWidget(copy_, 0, Qt::AlignLeft);
    layout->addStretch(1);
    fill(*this, newScrollArea(content, tr("Solution")));
    for (const auto signal : {&Editor::opened, &Editor::stateChanged, &Editor::deformed, &Editor::examined,
                              &Editor::solveStateChanged, &Editor::decimalsChanged})
      connect(&editor, signal, this, &ReportPanel::refresh);
    refresh();
  }

 private:
  void makeOptions()
  {
    weights_ = named(new QComboBox, "reportWeights");
    weights_->addItem(tr("Cotangent, guarded"), static_cast<int>(Weights::Cotangent));
    weights_->addItem(tr("Cotangent, as published"), static_cast<int>(Weights::CotangentPaper));
    weights_->addItem(tr("Uniform"), static_cast<int>(Weights::Uniform));
    solver_ = named(new QComboBox, "reportSolver");
    solver_->addItem(tr("Hard: constraints hold exactly"), static_cast<int>(SolverKind::Hard));
    solver_->addItem(tr("Soft: weighted least squares"), static_cast<int>(SolverKind::Soft));
    solver_->addItem(tr("Lagrange multipliers"), static_cast<int>(SolverKind::Lagrange));
    softWeight_ = named(new NumberEdit, "reportSoftWeight");
    rotations_ = named(new QComboBox, "reportRotations");
    rotations_->addItem(tr("Given by constraints"), static_cast<int>(RotationSource::Given));
    rotations_->addItem(tr("Found: edges keep their length"), static_cast<int>(RotationSource::Found));
    rotations_->addItem(tr("Found: smooth at single points"), static_cast<int>(RotationSource::FoundSmooth));
    rotationChange_ = named(new NumberEdit, "reportRotationChange");
    rotationChange_->setToolTip(
        tr("Rotations are found when an iteration moves no vertex by more than this share of "
           "the diagonal"));
    weld_ = named(new NumberEdit, "reportWeld");
    weld_->setToolTip(tr(
        "Vertices that are no farther apart than this length are one for the solver; 0 joins those at one place. The "
        "file keeps its vertices."));
    options_ = new QFormLayout;
    options_->setHorizontalSpacing(10);
    options_->setVerticalSpacing(6);
    options_->addRow(tr("&Weights"), weights_);
    options_->addRow(tr("S&olver"), solver_);
    options_->addRow(tr("Soft wei&ght"), softWeight_);
    options_->addRow(tr("&Rotations"), rotations_);
    options_->addRow(tr("&Last change"), rotationChange_);
    options_->addRow(tr("Weld wi&thin"), weld_);
    connect(weights_, qOverload<int>(&QComboBox::activated), this, &ReportPanel::choose);
    connect(solver_, qOverload<int>(&QComboBox::activated), this, &ReportPanel::choose);
    connect(rotations_, qOverload<int>(&QComboBox::activated), this, &ReportPanel::choose);
    connect(softWeight_, &NumberEdit::entered, this, &ReportPanel::setSoftWeight);
    connect(softWeight_, &NumberEdit::refused, this, &ReportPanel::refuse);
    connect(softWeight_, &NumberEdit::righted, this, &ReportPanel::refreshReport);
    connect(rotationChange_, &NumberEdit::entered, this, &ReportPanel::setRotationChange);
    connect(rotationChange_, &NumberEdit::refused, this, &ReportPanel::refuse);
    connect(rotationChange_, &NumberEdit::righted, this, &ReportPanel::refreshReport);
    connect(weld_, &NumberEdit::entered, this, &ReportPanel::setWeld);
    connect(weld_, &NumberEdit::refused, this, &ReportPanel::refuse);
    connect(weld_, &NumberEdit::righted, this, &ReportPanel::refreshReport);
  }

  void refresh() override
  {
    refreshOptions();
    if (isVisible()) refreshReport();
  }

  void refreshOptions()
  {
    const bool isOpen = editor_.isOpen();
    weights_->setEnabled(isOpen);
    solver_->setEnabled(isOpen);
    rotations_->setEnabled(isOpen);
    const DeformOptions options = isOpen ? editor_.state().options : DeformOptions();
    weights_->setCurrentIndex(weights_->findData(static_cast<int>(options.weights)));
    solver_->setCurrentIndex(solver_->findData(static_cast<int>(options.solver.kind)));
    rotations_->setCurrentIndex(rotations_->findData(static_cast<int>(options.rotations.source)));
    refreshNumber(*softWeight_, options.solver.softWeight, isOpen && options.solver.kind == SolverKind::Soft);
    refreshNumber(*rotationChange_, options.rotations.change,
                  isOpen && options.rotations.source != RotationSource::Given);
    weld_->setEnabled(isOpen);
    weld_->setNumber(options.weldTolerance);
  }

  /// Shows the number and its label only where it has an effect.
  void refreshNumber(NumberEdit& line, double number, bool isUsed)
  {
    line.setVisible(isUsed);
    options_->labelForField(&line)->setVisible(isUsed);
    line.setNumber(number);
  }

  void refreshReport()
  {
    const bool isSolved = editor_.deformation() != nullptr;
    copy_->setVisible(isSolved);
    if (isSolved && editor_.isResultKnown()) result_ = editor_.report()->result;
    show(isSolved ? shownLines() : ReportLines());
    const bool isCurrent = editor_.isCurrent();
    age_->setVisible(!isSolved || !isCurrent);
    age_->setText(!editor_.isOpen() ? tr("No mesh is open.")
                  : !isSolved       ? tr("Nothing is solved yet.")
                                    : tr("From before the latest edit."));
    for (QLabel* value : values_) setQuiet(*value, !isCurrent);
  }

  void show(const ReportLines& lines)
  {
    while (report_->rowCount() > static_cast<int>(lines.size())) {
      report_->removeRow(report_->rowCount() - 1);
      values_.pop_back();
    }
    while (values_.size() < lines.size()) {
      values_.push_back(newText({}));
      values_.back()->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
      report_->addRow(new QLabel, values_.back());
    }
    for (std::size_t k = 0; k < lines.size(); ++k) {
      static_cast<QLabel*>(report_->labelForField(values_[k]))->setText(lines[k].title);
      values_[k]->setText(lines[k].value);
      values_[k]->setToolTip(lines[k].exact);
      values_[k]->setObjectName("report" + lines[k].key);
    }
  }

  void choose()
  {
    DeformOptions options = editor_.state().options;
    options.weights = static_cast<Weights>(weights_->currentData().toInt());
    options.solver.kind = static_cast<SolverKind>(solver_->currentData().toInt());
    options.rotations.source = static_cast<RotationSource>(rotations_->currentData().toInt());
    const DeformOptions& before = editor_.state().options;
    if (options == before) return;
    editor_.setOptions(options.weights != before.weights       ? tr("choose weights")
                       : options.rotations != before.rotations ? tr("choose where rotations come from")
                                                               : tr("choose the solver"),
                       options);
  }

  void setSoftWeight(double weight)
  {
    DeformOptions options = editor_.state().options;
    if (weight > 0) {
      options.solver.softWeight = weight;
      editor_.setOptions(tr("set the soft weight to %1").arg(exactText(weight)), options);
      return;
    }
    softWeight_->replaceTyped(options.solver.softWeight);
    refuse(tr("A soft weight must be positive."));
  }

  void setRotationChange(double change)
  {
    DeformOptions options = editor_.state().options;
    if (change > 0) {
      options.rotations.change = change;
      editor_.setOptions(tr("set the last change of rotations to %1").arg(exactText(change)), options);
      return;
    }
    rotationChange_->replaceTyped(options.rotations.change);
    refuse(tr("A last change must be positive: a share of the diagonal."));
  }

  /// The line shows it once the mesh is welded.
  void setWeld(double tolerance)
  {
    const double before = editor_.state().options.weldTolerance;
    weld_->replaceTyped(before);
    if (tolerance < 0) return refuse(tr("A distance within which vertices are welded must be 0 or more."));
    if (tolerance != before) editor_.weldWithin(tolerance);
  }

  void refuse(const QString& reason)
  {
    age_->setText(reason);
    age_->setVisible(true);
  }

  void copy()
  {
    if (editor_.deformation() == nullptr) return;
    QGuiApplication::clipboard()->setText(reportText(shownLines()));
  }

  [[nodiscard]] ReportLines shownLines() const
  {
    return reportLines(*editor_.report(), result_, {editor_.deformedState()->list.units, editor_.decimals()});
  }

  Editor& editor_;
  QFormLayout* options_ = nullptr;
  QComboBox* weights_ = nullptr;
  QComboBox* solver_ = nullptr;
  QComboBox* rotations_ = nullptr;
  NumberEdit* softWeight_ = nullptr;
  NumberEdit* rotationChange_ = nullptr;
  NumberEdit* weld_ = nullptr;
  QLabel* age_ = nullptr;
  QFormLayout* report_ = nullptr;
  std::vector<QLabel*> values_;
  QPushButton* copy_ = nullptr;
  ResultVerdict result_;  // the last that is known: texts do not flicker in a drag
};

}  // namespace

QWidget* newReportPanel(Editor& editor)
{
  return new ReportPanel(editor);
}

}  // namespace holdfast
