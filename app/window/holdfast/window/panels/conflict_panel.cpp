#include "holdfast/window/panels/conflict_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/labels.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/outcome_lookup.h>
#include <holdfast/window/model/rest_places.h>
#include <holdfast/window/text/conflict_text.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// Nobody reads more; the table has them all.
constexpr std::size_t kMostConflicts = 100;
constexpr std::size_t kMostRepetitions = 200;
constexpr int kLettersOnButtons = 16;

/// A name in few letters, for buttons.
QString inFewLetters(const std::string& name)
{
  const QString all = QString::fromStdString(name);
  return all.size() <= kLettersOnButtons ? quoted(name) : quoted(all.left(kLettersOnButtons - 1).toStdString() + "…");
}

/// The constraint with the target or offset that agrees with the others.
std::optional<Constraint> agreeing(Constraint constraint, const Vector3& target, const Editor& editor)
{
  if (PointConstraint* point = std::get_if<PointConstraint>(&constraint.what)) {
    const std::optional<Vector3> rest = RestPlaces(editor).of(point->at);
    if (!rest) return std::nullopt;
    *point = goingTo(*point, *rest, target);
    return constraint;
  }
  RelativeConstraint* relative = std::get_if<RelativeConstraint>(&constraint.what);
  if (relative == nullptr) return std::nullopt;
  relative->offset = target;
  return constraint;
}

}  // namespace

ConflictPanel::ConflictPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("conflictPanel");
  list_ = new CardList;
  list_->setAccessibleName(tr("Conflicts"));
  makeErrorCard();
  conflicts_ = new QWidget;
  conflictLayout_ = new QVBoxLayout(conflicts_);
  conflictLayout_->setContentsMargins(0, 0, 0, 0);
  conflictLayout_->setSpacing(8);
  list_->add(conflicts_);
  more_ = newText("conflictMore");
  list_->add(more_);
  repetitionTitle_ = newText("repetitionTitle");
  list_->add(repetitionTitle_);
  repetitions_ = newText("repetitions");
  list_->add(repetitions_);

  empty_ = newHint("conflictEmpty");
  pages_ = new QStackedWidget;
  pages_->addWidget(empty_);
  pages_->addWidget(list_);
  QVBoxLayout* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);

  for (const auto signal : {&Editor::opened, &Editor::stateChanged, &Editor::deformed, &Editor::solveStateChanged})
    connect(&editor, signal, this, &ConflictPanel::refresh);
  refresh();
}

void ConflictPanel::makeErrorCard()
{
  error_ = new Card;
  error_->setObjectName("conflictError");
  error_->setTitle(tr("The constraints cannot be solved as they are."));
  list_->add(error_);
}

void ConflictPanel::showEvent(QShowEvent* event)
{
  refresh();
  QWidget::showEvent(event);
}

void ConflictPanel::refresh()
{
  if (!isVisible()) return;
  shown_ = editor_.deformation();
  std::vector<Conflict> conflicts;
  std::vector<Conflict> repetitions;
  if (shown_ != nullptr)
    for (const ConstraintOutcome& outcome : shown_->report.constraints)
      for (const ConflictSet& conflictSet : outcome.conflictSets)
        (conflictSet.isConflict ? conflicts : repetitions).push_back({&outcome, &conflictSet});
  refreshError();
  refreshConflicts(conflicts);
  refreshRepetitions(repetitions);
  const bool isAny = !conflicts.empty() || !repetitions.empty() || !error_->isHidden();
  pages_->setCurrentIndex(isAny ? 1 : 0);
  empty_->setText(!editor_.isOpen()                             ? tr("No mesh is open.")
                  : shown_ == nullptr                           ? tr("Nothing is solved yet.")
                  : editor_.solveState() == SolveState::Solving ? tr("Nothing contradicted before the latest changes.")
                                                                : tr("Nothing contradicts."));
}

void ConflictPanel::refreshError()
{
  const bool isUnusable = editor_.solveState() == SolveState::Unusable;
  error_->setVisible(isUnusable);
  if (!isUnusable) return;
  error_->setIcon(statusIcon(ConstraintStatus::Conflicting, lightnessOf(palette())));
  error_->setText(editor_.error());
}

void ConflictPanel::refreshConflicts(const std::vector<Conflict>& conflicts)
{
  const std::size_t count = std::min(conflicts.size(), kMostConflicts);
  while (cards_.size() < count) addCard();
  for (std::size_t k = 0; k < cards_.size(); ++k) {
    cards_[k].card->setVisible(k < count);
    if (k < count) fill(cards_[k], conflicts[k]);
  }
  more_->setVisible(conflicts.size() > count);
  more_->setText(tr("%n more conflicts are in the table.", nullptr, static_cast<int>(conflicts.size() - count)));
}

void ConflictPanel::addCard()
{
  const std::size_t k = cards_.size();
  ConflictCard card;
  card.card = new Card;
  card.card->setObjectName(QStringLiteral("conflict%1").arg(k));
  card.select = card.card->addButton(tr("Select the Set"), "conflictSelect");
  card.disable = card.card->addButton({}, "conflictDisable");
  card.retarget = card.card->addButton({}, "conflictRetarget");
  connect(card.select, &QPushButton::clicked, this, [this, k] { selectSet(k); });
  connect(card.disable, &QPushButton::clicked, this, [this, k] { disable(k); });
  connect(card.retarget, &QPushButton::clicked, this, [this, k] { retarget(k); });
  conflictLayout_->addWidget(card.card);
  cards_.push_back(card);
}

void ConflictPanel::fill(ConflictCard& card, const Conflict& conflict)
{
  card.conflict = conflict;
  const std::string& units = editor_.list().units;
  card.card->setIcon(statusIcon(ConstraintStatus::Conflicting, lightnessOf(palette())));
  card.card->setTitle(conflictText(*conflict.outcome, *conflict.conflictSet, units));
  card.card->setText(gapText(*conflict.outcome, *conflict.conflictSet, units));
  card.card->setToolTip(exactText(conflict.conflictSet->gap));
  fillRepairs(card);
}

void ConflictPanel::fillRepairs(ConflictCard& card)
{
  const auto& [outcome, conflictSet] = card.conflict;
  // Repairs are of the list that was solved: while another one is on screen they wait.
  const bool isCurrent = areResultsCurrent(editor_);
  card.card->setEnabled(isCurrent);
  card.disable->setText(tr("Disable %1").arg(inFewLetters(conflictSet->disable)));
  card.disable->setToolTip(
      tr("Disabling %1 ends most conflicts at the price of the fewest rows").arg(quoted(conflictSet->disable)));
  const std::optional<Vector3>& target = conflictSet->consistentTarget;
  card.retarget->setVisible(target.has_value());
  if (!target) return;
  card.retarget->setText(tr("Use the Target %1").arg(roundedText(*target)));
  card.retarget->setToolTip(
      tr("Gives %1 the target %2, which agrees with the others").arg(quoted(outcome->name), exactText(*target)));
}

void ConflictPanel::refreshRepetitions(const std::vector<Conflict>& repetitions)
{
  repetitionTitle_->setVisible(!repetitions.empty());
  repetitions_->setVisible(!repetitions.empty());
  repetitionTitle_->setText(tr("Repeated, in agreement"));
  QStringList lines;
  for (std::size_t k = 0; k < std::min(repetitions.size(), kMostRepetitions); ++k)
    lines << repetitionText(*repetitions[k].outcome, *repetitions[k].conflictSet);
  if (repetitions.size() > kMostRepetitions)
    lines << tr("%n more are in the table.", nullptr, static_cast<int>(repetitions.size() - kMostRepetitions));
  repetitions_->setText(lines.join('\n'));
  QPalette own = palette();
  own.setColor(QPalette::WindowText, quietColor(own));
  repetitions_->setPalette(own);
}

Rows ConflictPanel::rowsOf(const Conflict& conflict) const
{
  Rows rows;
  const auto add = [&](const std::string& name) {
    if (const std::optional<Index> row = indexOf(editor_.list(), name)) rows.push_back(*row);
  };
  for (const std::string& name : conflict.conflictSet->with) add(name);
  add(conflict.outcome->name);
  std::sort(rows.begin(), rows.end());
  return rows;
}

void ConflictPanel::selectSet(std::size_t card)
{
  editor_.selectConstraints(rowsOf(cards_[card].conflict));
}

void ConflictPanel::disable(std::size_t card)
{
  if (const std::optional<Index> row = indexOf(editor_.list(), cards_[card].conflict.conflictSet->disable))
    disableConstraints(editor_, {*row});
}

void ConflictPanel::retarget(std::size_t card)
{
  const auto& [outcome, conflictSet] = cards_[card].conflict;
  const std::optional<Index> row = indexOf(editor_.list(), outcome->name);
  if (!row || !conflictSet->consistentTarget) return;
  const Vector3 target = *conflictSet->consistentTarget;
  changeConstraints(editor_, tr("give %1 the consistent target").arg(subjectOf(editor_, {*row})), {*row},
                    [&](const Constraint& constraint) { return agreeing(constraint, target, editor_); });
}

}  // namespace holdfast
