#include "holdfast/window/panels/report_panel.h"

#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/outcome_lookup.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

ReportPanel::ReportPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("reportPanel");
  QWidget* content = new QWidget;
  QVBoxLayout* layout = new QVBoxLayout(content);
  layout->setContentsMargins(10, 10, 10, 10);
  layout->setSpacing(8);
  makeOptions();
  layout->addLayout(options_);
  age_ = new QLabel;
  age_->setObjectName("reportAge");
  age_->setWordWrap(true);
  layout->addWidget(age_);
  report_ = new QFormLayout;
  report_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  report_->setHorizontalSpacing(10);
  report_->setVerticalSpacing(4);
  layout->addLayout(report_);
  copy_ = new QPushButton(tr("&Copy as Text"));
  copy_->setObjectName("reportCopy");
  connect(copy_, &QPushButton::clicked, this, &ReportPanel::copy);
  layout->addWidget(copy_, 0, Qt::AlignLeft);
  layout->addStretch(1);

  QScrollArea* area = new QScrollArea;
  area->setAccessibleName(tr("Solution"));
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  QVBoxLayout* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(area);
  for (const auto signal : {&Editor::opened, &Editor::stateChanged, &Editor::deformed, &Editor::solveStateChanged})
    connect(&editor, signal, this, &ReportPanel::refresh);
  refresh();
}

void ReportPanel::makeOptions()
{
  weights_ = new QComboBox;
  weights_->setObjectName("reportWeights");
  weights_->addItem(tr("Cotangent, guarded"), static_cast<int>(Weights::Cotangent));
  weights_->addItem(tr("Cotangent, as published"), static_cast<int>(Weights::CotangentPaper));
  weights_->addItem(tr("Uniform"), static_cast<int>(Weights::Uniform));
  solver_ = new QComboBox;
  solver_->setObjectName("reportSolver");
  solver_->addItem(tr("Hard: constraints hold exactly"), static_cast<int>(SolverKind::Hard));
  solver_->addItem(tr("Soft: weighted least squares"), static_cast<int>(SolverKind::Soft));
  solver_->addItem(tr("Lagrange multipliers"), static_cast<int>(SolverKind::Lagrange));
  softWeight_ = new NumberEdit;
  softWeight_->setObjectName("reportSoftWeight");
  options_ = new QFormLayout;
  options_->setHorizontalSpacing(10);
  options_->setVerticalSpacing(6);
  options_->addRow(tr("&Weights"), weights_);
  options_->addRow(tr("&Solver"), solver_);
  options_->addRow(tr("Soft w&eight"), softWeight_);
  connect(weights_, qOverload<int>(&QComboBox::activated), this, &ReportPanel::choose);
  connect(solver_, qOverload<int>(&QComboBox::activated), this, &ReportPanel::choose);
  connect(softWeight_, &NumberEdit::entered, this, &ReportPanel::setSoftWeight);
  connect(softWeight_, &NumberEdit::refused, this, &ReportPanel::refuse);
}

void ReportPanel::showEvent(QShowEvent* event)
{
  refresh();
  QWidget::showEvent(event);
}

void ReportPanel::refresh()
{
  refreshOptions();
  if (isVisible()) refreshReport();
}

void ReportPanel::refreshOptions()
{
  const bool isOpen = editor_.isOpen();
  weights_->setEnabled(isOpen);
  solver_->setEnabled(isOpen);
  const DeformOptions options = isOpen ? editor_.state().options : DeformOptions();
  weights_->setCurrentIndex(weights_->findData(static_cast<int>(options.weights)));
  solver_->setCurrentIndex(solver_->findData(static_cast<int>(options.solver.kind)));
  const bool isSoft = isOpen && options.solver.kind == SolverKind::Soft;
  softWeight_->setVisible(isSoft);
  options_->labelForField(softWeight_)->setVisible(isSoft);
  softWeight_->setNumber(options.solver.softWeight);
}

void ReportPanel::refreshReport()
{
  const bool isSolved = editor_.deformation() != nullptr;
  copy_->setVisible(isSolved);
  show(isSolved ? reportLines(editor_.deformation()->report, editor_.deformedState()->list.units) : ReportLines());
  const bool isCurrent = areResultsCurrent(editor_);
  age_->setVisible(!isSolved || !isCurrent);
  age_->setText(!editor_.isOpen() ? tr("No mesh is open.")
                : !isSolved       ? tr("Nothing is solved yet.")
                                  : tr("This is the report of the list before the latest changes."));
  QPalette own = palette();
  if (!isCurrent) own.setColor(QPalette::WindowText, quietColor(own));
  for (QLabel* value : values_) value->setPalette(own);
}

void ReportPanel::show(const ReportLines& lines)
{
  while (report_->rowCount() > static_cast<int>(lines.size())) {
    report_->removeRow(report_->rowCount() - 1);
    values_.pop_back();
  }
  while (values_.size() < lines.size()) {
    QLabel* value = new QLabel;
    value->setWordWrap(true);
    value->setTextFormat(Qt::PlainText);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    report_->addRow(new QLabel, value);
    values_.push_back(value);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    static_cast<QLabel*>(report_->labelForField(values_[k]))->setText(lines[k].title);
    values_[k]->setText(lines[k].value);
    values_[k]->setToolTip(lines[k].exact);
    values_[k]->setObjectName("report" + lines[k].key);
  }
}

void ReportPanel::choose()
{
  DeformOptions options = editor_.state().options;
  options.weights = static_cast<Weights>(weights_->currentData().toInt());
  options.solver.kind = static_cast<SolverKind>(solver_->currentData().toInt());
  if (options == editor_.state().options) return;
  const bool isOtherWeights = options.weights != editor_.state().options.weights;
  editor_.setOptions(isOtherWeights ? tr("choose weights") : tr("choose the solver"), options);
}

void ReportPanel::setSoftWeight(double weight)
{
  DeformOptions options = editor_.state().options;
  if (weight > 0) {
    options.solver.softWeight = weight;
    editor_.setOptions(tr("set the soft weight to %1").arg(exactText(weight)), options);
    return;
  }
  softWeight_->replaceTyped(options.solver.softWeight);
  refuse(tr("A soft weight has to be positive."));
}

void ReportPanel::refuse(const QString& reason)
{
  age_->setText(reason);
  age_->setVisible(true);
}

void ReportPanel::copy()
{
  if (editor_.deformation() == nullptr) return;
  const ReportLines lines = reportLines(editor_.deformation()->report, editor_.deformedState()->list.units);
  QGuiApplication::clipboard()->setText(reportText(lines));
}

}  // namespace holdfast
