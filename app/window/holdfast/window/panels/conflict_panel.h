#pragma once
/// \file
/// The panel that explains conflicts: what cannot hold together, by how much, and what would mend it.

#include <QWidget>
#include <string>
#include <vector>

#include <holdfast/window/controls/card.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/model/editor.h>

class QStackedWidget;

namespace holdfast {

/// Cards, one a clash, with repairs that edit the list; below them what merely repeats.
class ConflictPanel : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit ConflictPanel(Editor& editor, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// A conflict of the newest deformation.
  struct Conflict {
    const ConstraintOutcome* outcome = nullptr;
    const ConflictSet* conflictSet = nullptr;
  };
  struct ConflictCard {
    Card* card = nullptr;
    QPushButton* select = nullptr;
    QPushButton* disable = nullptr;
    QPushButton* retarget = nullptr;
    Conflict conflict;
  };

  void makeErrorCard();
  void refresh();
  void refreshError();
  void refreshConflicts(const std::vector<Conflict>& conflicts);
  void refreshRepetitions(const std::vector<Conflict>& repetitions);
  void addCard();
  void fill(ConflictCard& card, const Conflict& conflict);
  void fillRepairs(ConflictCard& card);
  [[nodiscard]] Rows rowsOf(const Conflict& conflict) const;
  void selectSet(std::size_t card);
  void disable(std::size_t card);
  void retarget(std::size_t card);

  Editor& editor_;
  QStackedWidget* pages_ = nullptr;
  QLabel* empty_ = nullptr;
  CardList* list_ = nullptr;
  Card* error_ = nullptr;
  QWidget* conflicts_ = nullptr;
  QVBoxLayout* conflictLayout_ = nullptr;
  std::vector<ConflictCard> cards_;
  QLabel* more_ = nullptr;
  QLabel* repetitionTitle_ = nullptr;
  QLabel* repetitions_ = nullptr;
  std::shared_ptr<const DeformResult> shown_;  // keeps alive what the cards refer to
};

}  // namespace holdfast
