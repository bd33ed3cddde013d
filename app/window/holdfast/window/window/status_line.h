#pragma once
/// The line below the picture. It says what the mouse does, what is selected, and how accurate the solution is.

#include <QLabel>
#include <QPushButton>
#include <QStatusBar>

#include <holdfast/window/model/editor.h>

namespace holdfast {

class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(Editor& editor, QWidget* parent = nullptr);

  void setHint(const QString& hint)
  {
    hint_ = hint;
    showHint();
  }

  /// Shows a message for some time, at most until the next message or until another document is opened. It covers the
  /// hint meanwhile.
  void showDocumentMessage(const QString& message, int milliseconds)
  {
    documentMessage_ = message;
    showMessage(message, milliseconds);
  }

  /// Returns a size without a width, so that no text makes the window wider.
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, QStatusBar::minimumSizeHint().height()}; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showHint();
  void clearDocumentMessage();
  void showNumbers();
  void showResult();
  void measureSelection();
  void showStep();

  Editor& editor_;
  QString hint_;
  QString documentMessage_;  // the latest, shown or not
  QLabel* left_;
  QLabel* step_;
  QPushButton* cancel_;
  QLabel* result_;  // where it is doubtful
  QLabel* numbers_;
  QLabel* selection_;      // in place of the numbers while vertices are selected
  BackgroundJob measure_;  // of the selection
  bool isMeasureDue_ = false;
};

}  // namespace holdfast
