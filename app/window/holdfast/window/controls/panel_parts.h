#pragma once
/// The parts of panels and dialogs. This header also includes Qt's most used widgets. Functions return widgets without
/// a parent: a layout takes them.

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

/// Names a widget. Screen readers read `spoken`.
template <class Widget>
Widget* named(Widget* widget, const QString& name, const QString& spoken)
{
  widget->setAccessibleName(spoken);
  return named(widget, name);
}

/// Returns lines of plain text that can be selected with the mouse.
[[nodiscard]] QLabel* newText(const QString& name);

/// Returns a tool tip for texts from outside, such as names and paths. Without it, Qt would show a text that looks like
/// HTML as HTML.
[[nodiscard]] QString plainTip(const QString& text);

/// Returns an area without a frame that scrolls `content` if it needs more room.
[[nodiscard]] QScrollArea* newScrollArea(QWidget* content, const QString& spoken);

/// Lays out widgets in a column or a row (`QVBoxLayout`, `QHBoxLayout`), with the same margin at all sides.
template <class Layout>
Layout* newLayout(QWidget* owner, int margin, int spacing, std::initializer_list<QWidget*> widgets = {})
{
  auto* layout = new Layout(owner);
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(spacing);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  return layout;
}

/// Makes a text look less important than other texts, or as important as they are.
void setQuiet(QWidget& text, bool isQuiet);

void fill(QWidget& panel, QWidget* content);

/// Shows rows in two alternating colours, without lines between them.
void setTableLook(QTableView& table);

void showRefusal(QLabel& label, const QString& reason);

/// A panel that follows what it shows while the user sees it. It catches up when it comes into view.
class RefreshedPanel : public QWidget {
 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// Follows what the panel shows. While the panel is hidden, it does nothing that takes long.
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

/// A card is a framed piece of text with an icon, a title and buttons. It shows a conflict or a finding.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  void setIcon(const QIcon& icon);
  void setTitle(const QString& title) { title_->setText(title); }
  void setText(const QString& text);
  /// Adds a button below the text. Two buttons are side by side; every third has a line of its own.
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
