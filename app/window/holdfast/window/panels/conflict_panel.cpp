#include <algorithm>
#include <string>
#include <vector>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/report.h>
#include <holdfast/document/constraint_drag.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// “P3” asks for a place 0.42 mm away from where “P1” and “P2” put it.
QString conflictText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet, const LengthStyle& style)
{
  // The unit stays on the line of its number.
  const QString length = lengthText(conflictSet.gap.stableNorm(), style).replace(' ', QChar::Nbsp);
  const auto said = [&](const QString& byOne, const QString& bySeveral) {
    return (conflictSet.with.size() == 1 ? byOne : bySeveral)
        .arg(quoted(outcome.name), length, quotedList(conflictSet.with));
  };
  if (conflictSet.with.empty())
    return QObject::tr("%1 contradicts itself by %2, or asks a part to move that nothing places.")
        .arg(quoted(outcome.name), length);
  if (outcome.type == RelativeConstraint::kType)
    return said(QObject::tr("%1 asks for an offset that differs by %2 from what %3 says."),
                QObject::tr("%1 asks for an offset that differs by %2 from what %3 say."));
  if (outcome.type == RigidConstraint::kType)
    return said(QObject::tr("%1 cannot stay rigid: %3 bends it by %2."),
                QObject::tr("%1 cannot stay rigid: %3 bend it by %2."));
  if (outcome.type == PointConstraint::kType)
    return said(QObject::tr("%1 asks for a place %2 away from where %3 puts it."),
                QObject::tr("%1 asks for a place %2 away from where %3 put it."));
  return said(QObject::tr("%1 asks for places up to %2 away from where %3 puts them."),
              QObject::tr("%1 asks for places up to %2 away from where %3 put them."));
}

/// How many of the rows, and which way they are off.
QString gapText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet, const LengthStyle& style)
{
  QString text = QObject::tr("Off by %1").arg(placeText(conflictSet.gap, style));
  if (!style.units.empty()) text += ' ' + QString::fromStdString(style.units);
  if (outcome.rows > 1)
    text += QObject::tr(", in %1 of its %2 rows").arg(QString::number(conflictSet.rows), QString::number(outcome.rows));
  text += '.';
  if (conflictSet.isMetByFoundRotations) text += ' ' + QObject::tr("Rotations that are found would meet it.");
  return text;
}

/// “P4” repeats “P1”; a rigid region alone repeats none.
QString repetitionText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet)
{
  const QString own = quoted(outcome.name);
  if (conflictSet.with.empty())
    return (conflictSet.rows == outcome.rows ? QObject::tr("%1 holds as it is: nothing moves it")
                                             : QObject::tr("%1 repeats itself in part"))
        .arg(own);
  const QString others = quotedList(conflictSet.with);
  return conflictSet.rows == outcome.rows ? QObject::tr("%1 repeats %2").arg(own, others)
                                          : QObject::tr("%1 repeats %2 in part").arg(own, others);
}

// The table has all of them.
constexpr std::size_t kMostConflicts = 100;
constexpr std::size_t kMostRepetitions = 200;
constexpr int kLettersOnButtons = 16;

class ConflictPanel final : public RefreshedPanel {
 public:
  explicit ConflictPanel(Editor& editor) : editor_(editor)
  {
    setObjectName("conflictPanel");
    CardList* list = named(new CardList, "conflictList", tr("Conflicts"));
    error_ = named(new Card, "conflictError");
    error_->setTitle(tr("The constraints cannot be solved as they are."));
    conflicts_ = new QWidget;
    conflictLayout_ = newLayout<QVBoxLayout>(conflicts_, 0, 8);
    more_ = newText("conflictMore");
    repetitionTitle_ = newText("repetitionTitle");
    repetitionTitle_->setText(tr("Redundant, in agreement"));
    repetitions_ = newText("repetitions");
    for (QWidget* widget : std::initializer_list<QWidget*>{error_, conflicts_, more_, repetitionTitle_, repetitions_})
      list->add(widget);
    pages_ = new HintedContent(list, "conflictEmpty");
    holdfast::fill(*this, pages_);

    for (const auto signal : {&Editor::opened, &Editor::stateChanged, &Editor::deformed, &Editor::solveStateChanged,
                              &Editor::decimalsChanged})
      connect(&editor, signal, this, &ConflictPanel::refresh);
    refresh();
  }

 private:
  struct Conflict {
    const ConstraintOutcome* outcome = nullptr;
    const ConflictSet* conflictSet = nullptr;
  };
  struct ConflictCard {
    Card* card = nullptr;
    QPushButton* select = nullptr;
    QPushButton* disable = nullptr;
    QPushButton* retarget = nullptr;
    QPushButton* prefer = nullptr;
    QPushButton* average = nullptr;
    Conflict conflict;
  };

  void refresh() override
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
    if (!conflicts.empty() || !repetitions.empty() || !error_->isHidden()) return pages_->showContent();
    pages_->showHint(!editor_.isOpen()                             ? tr("No mesh is open.")
                     : shown_ == nullptr                           ? tr("Nothing is solved yet.")
                     : editor_.solveState() == SolveState::Solving ? tr("No conflicts before the latest edit.")
                                                                   : tr("No conflicts."));
  }

  void refreshError()
  {
    const bool isUnusable = editor_.solveState() == SolveState::Unusable;
    error_->setVisible(isUnusable);
    if (!isUnusable) return;
    error_->setIcon(statusIcon(ConstraintStatus::Conflicting, palette()));
    error_->setText(editor_.error());
  }

  void refreshConflicts(const std::vector<Conflict>& conflicts)
  {
    const std::size_t count = std::min(conflicts.size(), kMostConflicts);
    while (cards_.size() < count) addCard();
    namesOnButtons_.clear();
    for (std::size_t k = 0; k < count; ++k) namesOnButtons_.push_back(conflicts[k].conflictSet->disable);
    for (std::size_t k = 0; k < cards_.size(); ++k) {
      cards_[k].card->setVisible(k < count);
      if (k < count) fill(cards_[k], conflicts[k]);
    }
    more_->setVisible(conflicts.size() > count);
    more_->setText(tr("The table has %1 more.").arg(countText(static_cast<Index>(conflicts.size() - count))));
  }

  void refreshRepetitions(const std::vector<Conflict>& repetitions)
  {
    repetitionTitle_->setVisible(!repetitions.empty());
    repetitions_->setVisible(!repetitions.empty());
    QStringList lines;
    for (std::size_t k = 0; k < std::min(repetitions.size(), kMostRepetitions); ++k)
      lines << repetitionText(*repetitions[k].outcome, *repetitions[k].conflictSet);
    if (repetitions.size() > kMostRepetitions)
      lines << tr("The table has %1 more.").arg(countText(static_cast<Index>(repetitions.size() - kMostRepetitions)));
    repetitions_->setText(lines.join('\n'));
    setQuiet(*repetitions_, true);
  }

  void addCard()
  {
    const std::size_t k = cards_.size();
    ConflictCard card;
    card.card = named(new Card, QString("conflict%1").arg(k));
    card.select = card.card->addButton(tr("Select the set"), "conflictSelect");
    card.disable = card.card->addButton({}, "conflictDisable");
    card.retarget = card.card->addButton({}, "conflictRetarget");
    card.prefer = card.card->addButton(tr("Prefer this one"), "conflictPrefer");
    card.average = card.card->addButton(tr("Use the average"), "conflictAverage");
    connect(card.prefer, &QPushButton::clicked, this, [this, k] { prefer(k); });
    connect(card.average, &QPushButton::clicked, this, [this, k] { average(k); });
    connect(card.select, &QPushButton::clicked, this, [this, k] { selectSet(k); });
    connect(card.disable, &QPushButton::clicked, this, [this, k] { disable(k); });
    connect(card.retarget, &QPushButton::clicked, this, [this, k] { retarget(k); });
    conflictLayout_->addWidget(card.card);
    cards_.push_back(card);
  }

  void fill(ConflictCard& card, const Conflict& conflict)
  {
    card.conflict = conflict;
    const LengthStyle style = editor_.lengthStyle();
    card.card->setIcon(statusIcon(ConstraintStatus::Conflicting, palette()));
    card.card->setTitle(conflictText(*conflict.outcome, *conflict.conflictSet, style));
    card.card->setText(gapText(*conflict.outcome, *conflict.conflictSet, style));
    card.card->setToolTip(exactText(conflict.conflictSet->gap));
    fillRepairs(card);
  }

  void fillRepairs(ConflictCard& card)
  {
    const auto& [outcome, conflictSet] = card.conflict;
    // Repairs belong to the list that was solved, and wait while another one is on screen.
    const bool isCurrent = editor_.isCurrent();
    card.card->setEnabled(isCurrent);
    card.disable->setText(tr("Disable %1").arg(quotedEnds(conflictSet->disable, namesOnButtons_, kLettersOnButtons)));
    card.disable->setToolTip(plainTip(
        tr("Disabling %1 ends most conflicts at the price of the fewest rows").arg(quoted(conflictSet->disable))));
    card.prefer->setVisible(!conflictSet->with.empty());
    card.prefer->setToolTip(plainTip(tr("Moves %1 up, before %2, so that it holds and they give way")
                                         .arg(quoted(outcome->name), quotedList(conflictSet->with))));
    const std::optional<SharedPlace> shared = isCurrent ? sharedPlaceOf(card) : std::nullopt;
    card.average->setVisible(shared.has_value());
    if (shared) {
      card.average->setText(tr("Use the average %1").arg(placeText(shared->mean, editor_.lengthStyle())));
      card.average->setToolTip(plainTip(
          tr("Gives %1 the target %2").arg(quotedList(namesOf(shared->constraints)), exactText(shared->mean))));
    }
    const std::optional<Vector3>& target = conflictSet->consistentTarget;
    card.retarget->setVisible(target.has_value());
    if (!target) return;
    card.retarget->setText(tr("Use the target %1").arg(placeText(*target, editor_.lengthStyle())));
    card.retarget->setToolTip(plainTip(
        tr("Gives %1 the target %2, which agrees with the others").arg(quoted(outcome->name), exactText(*target))));
  }

  /// What is shown is the solution of the list. Points that are all at one place are one set, whichever two of them
  /// the report names: with an average of two, the third would be at odds.
  [[nodiscard]] std::optional<SharedPlace> sharedPlaceOf(const ConflictCard& card) const
  {
    return sharedPlace(shown_->details->system, namedBy(card));
  }

  /// What is at odds at one place is one set.
  [[nodiscard]] Rows setOf(const ConflictCard& card) const
  {
    Rows rows = namedBy(card);
    const std::optional<SharedPlace> shared = editor_.isCurrent() ? sharedPlaceOf(card) : std::nullopt;
    for (const ConflictCard& other : cards_) {
      if (!shared || other.card->isHidden()) break;
      const Rows named = namedBy(other);
      if (std::ranges::includes(shared->constraints, named)) rows.insert(rows.end(), named.begin(), named.end());
    }
    return sortedOnce(std::move(rows));
  }

  [[nodiscard]] std::vector<std::string> namesOf(const Rows& rows) const
  {
    std::vector<std::string> names;
    for (const Index row : rows) names.push_back(editor_.list().constraints[row].name);
    return names;
  }

  /// Ascending, as far as they are in the list still.
  [[nodiscard]] Rows namedBy(const ConflictCard& card) const
  {
    std::vector<std::string> names = card.conflict.conflictSet->with;
    names.push_back(card.conflict.outcome->name);
    Rows rows;
    for (const std::string& name : names)
      if (const std::optional<Index> row = indexOf(editor_.list(), name)) rows.push_back(*row);
    std::ranges::sort(rows);
    return rows;
  }

  void selectSet(std::size_t card) { editor_.selectConstraints(setOf(cards_[card])); }

  void prefer(std::size_t card)
  {
    if (const std::optional<Index> row = indexOf(editor_.list(), cards_[card].conflict.outcome->name))
      moveConstraints(editor_, {*row}, setOf(cards_[card]).front());
  }

  void average(std::size_t card)
  {
    const std::optional<SharedPlace> shared = sharedPlaceOf(cards_[card]);
    if (!shared) return;
    changeConstraints(editor_, tr("give %1 their average target").arg(subjectOf(editor_, shared->constraints)),
                      shared->constraints,
                      [&](const Constraint& constraint) { return withTarget(constraint, shared->mean, editor_); });
  }

  void disable(std::size_t card)
  {
    if (const std::optional<Index> row = indexOf(editor_.list(), cards_[card].conflict.conflictSet->disable))
      switchConstraints(editor_, {*row}, Enabling::Disabled);
  }

  void retarget(std::size_t card)
  {
    const auto& [outcome, conflictSet] = cards_[card].conflict;
    const std::optional<Index> row = indexOf(editor_.list(), outcome->name);
    if (!row || !conflictSet->consistentTarget) return;
    const Vector3 target = *conflictSet->consistentTarget;
    changeConstraints(editor_, tr("give %1 the consistent target").arg(subjectOf(editor_, {*row})), {*row},
                      [&](const Constraint& constraint) { return withTarget(constraint, target, editor_); });
  }

  Editor& editor_;
  HintedContent* pages_ = nullptr;
  Card* error_ = nullptr;
  QWidget* conflicts_ = nullptr;
  QVBoxLayout* conflictLayout_ = nullptr;
  std::vector<ConflictCard> cards_;
  std::vector<std::string> namesOnButtons_;  // of all cards
  QLabel* more_ = nullptr;
  QLabel* repetitionTitle_ = nullptr;
  QLabel* repetitions_ = nullptr;
  std::shared_ptr<const DeformResult> shown_;  // keeps alive what the cards refer to
};

}  // namespace

QWidget* newConflictPanel(Editor& editor)
{
  return new ConflictPanel(editor);
}

}  // namespace holdfast
