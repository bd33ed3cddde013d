#include <QStyle>
#include <map>

#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

class OutcomeSection : public InspectorSection {
 public:
  explicit OutcomeSection(Editor& editor) : InspectorSection(editor, tr("Outcome"))
  {
    auto* line = new QWidget(this);
    icon_ = new QLabel;
    status_ = named(new QLabel, "outcomeStatus");
    status_->setWordWrap(true);
    newLayout<QHBoxLayout>(line, 0, 6, {icon_, status_})->setStretch(1, 1);
    addRow(tr("Status"), line);
    addRefresh([this] { showStatus(); });
    addResidual(addLargest(tr("Residual"), "outcomeResidual", &ConstraintOutcome::residual, Unit::Length));
    addBound(addLargest(tr("Off target"), "outcomeOffTarget", &ConstraintOutcome::offTarget, Unit::Length));
    addLargest(tr("Gap"), "outcomeGap", &ConstraintOutcome::gap, Unit::Length);
    addLargest(tr("Force"), "outcomeForce", &ConstraintOutcome::multiplier, Unit::None);
    addLargest(tr("Amplification"), "outcomeAmplification", &ConstraintOutcome::sensitivity, Unit::None);
    QLabel* age = addText({}, "outcomeAge");
    age->setText(tr("From before the latest edit."));
    addRefresh([this, age] {
      setFieldVisible(age, !this->editor().isCurrent());
      setQuiet(*age, true);
    });
  }

  bool fits(const Constraint& /*constraint*/) const override { return true; }

 private:
  enum class Unit { None, Length };

  QLabel* addLargest(const QString& title, const QString& name, std::optional<double> ConstraintOutcome::*number,
                     Unit unit)
  {
    QLabel* label = addText(title, name);
    addRefresh([=, this] {
      std::optional<double> largest;
      for (const Index row : rows()) {
        const ConstraintOutcome* outcome = editor().outcome(constraint(row).name, row);
        if (outcome == nullptr || !constraint(row).isEnabled || !(outcome->*number)) continue;
        largest = std::max(largest.value_or(0), *(outcome->*number));
      }
      setFieldVisible(label, largest.has_value());
      if (!largest) return;
      const QString text = unit == Unit::Length ? lengthText(*largest, editor().lengthStyle()) : roundedText(*largest);
      label->setText(rows().size() == 1 ? text : tr("%1 at most").arg(text));
      label->setToolTip(exactText(*largest));
      setQuiet(*label, !editor().isCurrent());
    });
    return label;
  }

  /// Where all residuals are within their limits their digits are rounding: the tool tip has them.
  void addResidual(QLabel* label)
  {
    addRefresh([=, this] {
      double limit = 0;
      for (const Index row : rows()) {
        const ConstraintOutcome* outcome = editor().outcome(constraint(row).name, row);
        if (outcome == nullptr || !constraint(row).isEnabled || !outcome->residual) continue;
        if (!isWithinLimit(*outcome)) return;
        limit = std::max(limit, *outcome->limit);
      }
      if (limit > 0) label->setText(metText(limit, editor().list().units));
    });
  }

  void addBound(QLabel* label)
  {
    addRefresh([=, this] {
      if (rows().size() != 1) return;
      const ConstraintOutcome* outcome = editor().outcome(constraint(rows().front()).name, rows().front());
      if (outcome == nullptr || !outcome->isAtBound) return;
      label->setText(*outcome->isAtBound ? tr("%1, at its bound").arg(label->text())
                                         : tr("%1, within its tolerance").arg(label->text()));
    });
  }

  void showStatus()
  {
    std::map<std::optional<ConstraintStatus>, int> counts;
    for (const Index row : rows()) ++counts[editor().status(constraint(row), row)];
    setQuiet(*status_, !editor().isCurrent());
    icon_->setVisible(counts.size() == 1);
    if (counts.size() == 1) {
      const std::optional<ConstraintStatus> status = counts.begin()->first;
      const int side = style()->pixelMetric(QStyle::PM_SmallIconSize);
      icon_->setPixmap(statusIcon(status, palette()).pixmap(side, side));
      status_->setText(statusText(status));
      status_->setToolTip(statusMeaning(status));
      return;
    }
    QStringList words;
    for (const auto& [status, count] : counts) words << QString::number(count) + ' ' + statusText(status);
    status_->setText(words.join(", "));
    status_->setToolTip({});
  }

  QLabel* icon_ = nullptr;
  QLabel* status_ = nullptr;
};

}  // namespace

Sections newOutcomeSections(Editor& editor)
{
  return {new OutcomeSection(editor)};
}

}  // namespace holdfast
