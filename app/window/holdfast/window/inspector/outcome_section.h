#pragma once
/// \file
/// The inspector of results: whether constraints hold, how hard they pull.

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/outcome_lookup.h>

namespace holdfast {

/// The outcome of one constraint, or what those of several add up to.
class OutcomeSection : public InspectorSection {
  Q_OBJECT

 public:
  OutcomeSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  void showStatus();
  void showLargest(QLabel* label, std::optional<double> ConstraintOutcome::*number, const std::string& units);

  OutcomeLookup outcomes_;
  QLabel* icon_ = nullptr;
  QLabel* status_ = nullptr;
  QLabel* residual_ = nullptr;
  QLabel* gap_ = nullptr;
  QLabel* multiplier_ = nullptr;
  QLabel* sensitivity_ = nullptr;
  QLabel* age_ = nullptr;
};

}  // namespace holdfast
