#pragma once
/// What panels and dialogs are put together from, Qt's most used widgets included. Widgets are returned without a
/// parent: a layout takes them.

#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <initializer_list>

namespace holdfast {

template <class Object>
Object* named(Object* object, const QString& name)
{
  object->setObjectName(name);
  return object;
}

/// `spoken`: for screen readers.
template <class Widget>
Widget* named(Widget* widget, const QString& name, const QString& spoken)
{
  widget->setAccessibleName(spoken);
  return named(widget, name);
}

/// Lines of plain text that can be selected with the mouse.
[[nodiscard]] QLabel* newText(const QString& name);

/// A tool tip with texts from outside, such as names and paths. Qt would show what looks like HTML as such.
[[nodiscard]] QString plainTip(const QString& text);

/// `content` without a frame, scrolled if it needs more room.
[[nodiscard]] QScrollArea* newScrollArea(QWidget* content, const QString& spoken);

/// A column or a row of widgets (`QVBoxLayout`, `QHBoxLayout`) with the same margin at all sides.
template <class Layout>
Layout* newLayout(QWidget* owner, int margin, int spacing, std::initializer_list<QWidget*> widgets = {})
{
  auto* layout = new Layout(owner);
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(spacing);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  return layout;
}

/// Less important than other texts, or as they are.
void setQuiet(QWidget& text, bool isQuiet);

void fill(QWidget& panel, QWidget* content);

/// Rows without lines between them, in two alternating colours.
void setTableLook(QTableView& table);

void showRefusal(QLabel& label, const QString& reason);

/// A panel that follows what it shows while it is seen, and catches up when it comes into view.
class RefreshedPanel : public QWidget {
 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// Does nothing that takes long while the panel is hidden.
  virtual void refresh() = 0;
};

class HintedContent : public QStackedWidget {
 public:
  HintedContent(QWidget* content, const QString& hintName);

  void showHint(const QString& hint);
  void showContent() { setCurrentIndex(1); }

 private:
  QLabel* hint_;
};

/// A framed piece of text with an icon, a title and buttons: a conflict, or a finding.
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

class CardList : public QScrollArea {
  Q_OBJECT

 public:
  explicit CardList(QWidget* parent = nullptr);

  void add(QWidget* card) { layout_->insertWidget(layout_->count() - 1, card); }

 private:
  QVBoxLayout* layout_;
};

}  // namespace holdfast
