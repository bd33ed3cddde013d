#pragma once
/// What panels and dialogs are put together from. Widgets are returned without a parent: a layout takes them.

#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTableView>
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

/// The reason why an edit was refused, in the colour of conflicts.
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

}  // namespace holdfast
