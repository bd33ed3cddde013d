#pragma once
/// \file
/// The panel of what is wrong or doubtful about the mesh and the constraints, though it can be solved.

#include <QWidget>
#include <vector>

#include <holdfast/window/controls/card.h>
#include <holdfast/window/model/editor.h>

class QStackedWidget;

namespace holdfast {

/// The file's vertices that a finding names, those of its faces if it names faces, ascending; none where it speaks of
/// constraints.
[[nodiscard]] std::vector<Index> verticesOf(const Finding& finding, const Mesh& mesh);

/// Findings, a card each, with a button that shows where they are.
class FindingsPanel : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit FindingsPanel(Editor& editor, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Asks the view to show these vertices of the file.
  void showVertices(std::vector<Index> vertices);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void addCard();
  void fill(std::size_t card);
  void showWhere(std::size_t card);

  Editor& editor_;
  QStackedWidget* pages_ = nullptr;
  QLabel* empty_ = nullptr;
  CardList* list_ = nullptr;
  std::vector<Card*> cards_;
  std::vector<Finding> findings_;  // those on the cards
};

}  // namespace holdfast
