#pragma once
/// A framed piece of text with buttons below it: what panels of conflicts and findings are made of.

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace holdfast {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  void setIcon(const QIcon& icon);
  void setTitle(const QString& title) { title_->setText(title); }
  void setText(const QString& text);
  /// Below the text, two side by side; every third has a line of its own.
  QPushButton* addButton(const QString& text, const QString& name);

 private:
  QLabel* icon_;
  QLabel* title_;
  QLabel* text_;
  QGridLayout* buttons_;
};

/// Cards below one another, scrolled where they need more room.
class CardList : public QScrollArea {
  Q_OBJECT

 public:
  explicit CardList(QWidget* parent = nullptr);

  void add(QWidget* card) { layout_->insertWidget(layout_->count() - 1, card); }

 private:
  QVBoxLayout* layout_;
};

}  // namespace holdfast
