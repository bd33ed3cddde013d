#pragma once
/// \file
/// The panel that shows what is selected with all digits, and edits it by typing.

#include <QWidget>
#include <vector>

#include <holdfast/window/inspector/inspector_section.h>

class QCheckBox;
class QLabel;
class QLineEdit;
class QStackedWidget;
class QVBoxLayout;

namespace holdfast {

/// The selected constraints of an editor: one in full, of several what they have in common.
class InspectorPanel : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit InspectorPanel(Editor& editor, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void makeHead(QVBoxLayout& layout);
  void addSection(QVBoxLayout& layout, const QString& title, InspectorSection* section);
  void refresh();
  void refreshHead();
  void rename();
  void enable(bool isEnabled);
  void refuse(const QString& reason);

  struct Part {
    QLabel* title = nullptr;
    InspectorSection* section = nullptr;
  };

  Editor& editor_;
  QStackedWidget* pages_ = nullptr;
  QLabel* empty_ = nullptr;
  QLabel* kind_ = nullptr;
  QLineEdit* name_ = nullptr;
  QCheckBox* enabled_ = nullptr;
  QLabel* reason_ = nullptr;
  std::vector<Part> parts_;
};

}  // namespace holdfast
