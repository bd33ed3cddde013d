#pragma once
/// A window that is not repainted while OpenGL draws in it.

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace holdfast {

/// Composing the widgets of a window waits for all that OpenGL was ordered to draw, and the window cannot answer
/// meanwhile. Repaints requested during the pause follow after it.
class RepaintPause : public QObject {
 public:
  /// `inside`: a widget of that window; it stays alive as long as this.
  explicit RepaintPause(QWidget& inside) : inside_(inside) {}

  void begin();
  /// Whether a repaint was requested; it follows with the next events.
  bool end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& inside_;
  QPointer<QWidget> window_;  // null when there is no pause
  bool isWaiting_ = false;
};

}  // namespace holdfast
