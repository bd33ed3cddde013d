#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <map>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/outcome_lookup.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

class OutcomeSection : public InspectorSection {
 public:
  explicit OutcomeSection(Editor& editor) : InspectorSection(editor), outcomes_(editor)
  {
    QWidget* line = new QWidget(this);
    QHBoxLayout* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    icon_ = new QLabel(line);
    status_ = named(new QLabel(line), "outcomeStatus");
    status_->setWordWrap(true);
    layout->addWidget(icon_);
    layout->addWidget(status_, 1);
    addRow(tr("Status"), line);
    residual_ = addText(tr("Residual"), "outcomeResidual");
    gap_ = addText(tr("Gap"), "outcomeGap");
    multiplier_ = addText(tr("Force"), "outcomeForce");
    sensitivity_ = addText(tr("Amplification"), "outcomeAmplification");
    age_ = addText({}, "outcomeAge");
    age_->setText(tr("These values are of the list before the latest changes."));
  }

  bool fits(const Constraint& /*constraint*/) const override { return true; }

 private:
  void refresh() override
  {
    const std::string& units = editor().list().units;
    showStatus();
    showLargest(residual_, &ConstraintOutcome::residual, units);
    showLargest(gap_, &ConstraintOutcome::gap, units);
    showLargest(multiplier_, &ConstraintOutcome::multiplier, {});
    showLargest(sensitivity_, &ConstraintOutcome::sensitivity, {});
    const bool isCurrent = areResultsCurrent(editor());
    setFieldVisible(age_, !isCurrent);
    QPalette own = palette();
    if (!isCurrent) own.setColor(QPalette::WindowText, quietColor(own));
    for (QLabel* label : {status_, residual_, gap_, multiplier_, sensitivity_, age_}) label->setPalette(own);
  }

  void showStatus()
  {
    std::map<std::optional<ConstraintStatus>, int> counts;
    for (const Index row : rows()) ++counts[shownStatus(constraint(row), outcomes_.find(constraint(row).name, row))];
    icon_->setVisible(counts.size() == 1);
    if (counts.size() == 1) {
      const std::optional<ConstraintStatus> status = counts.begin()->first;
      const int side = style()->pixelMetric(QStyle::PM_SmallIconSize);
      icon_->setPixmap(statusIcon(status, lightnessOf(palette())).pixmap(side, side));
      status_->setText(statusText(status));
      status_->setToolTip(statusMeaning(status));
      return;
    }
    QStringList words;
    for (const auto& [status, count] : counts) words << QString::number(count) + ' ' + statusText(status);
    status_->setText(words.join(", "));
    status_->setToolTip({});
  }

  void showLargest(QLabel* label, std::optional<double> ConstraintOutcome::*number, const std::string& units)
  {
    std::optional<double> largest;
    for (const Index row : rows()) {
      const ConstraintOutcome* outcome = outcomes_.find(constraint(row).name, row);
      if (outcome == nullptr || !constraint(row).isEnabled || !(outcome->*number)) continue;
      largest = std::max(largest.value_or(0), *(outcome->*number));
    }
    setFieldVisible(label, largest.has_value());
    if (!largest) return;
    const QString text = lengthText(*largest, units);
    label->setText(rows().size() == 1 ? text : tr("%1 at most").arg(text));
    label->setToolTip(exactText(*largest));
  }

  OutcomeLookup outcomes_;
  QLabel* icon_ = nullptr;
  QLabel* status_ = nullptr;
  QLabel* residual_ = nullptr;
  QLabel* gap_ = nullptr;
  QLabel* multiplier_ = nullptr;
  QLabel* sensitivity_ = nullptr;
  QLabel* age_ = nullptr;
};

}  // namespace

InspectorSection* newOutcomeSection(Editor& editor)
{
  return new OutcomeSection(editor);
}

}  // namespace holdfast
