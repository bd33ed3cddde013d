#pragma once
/// Keeps a window from being repainted while OpenGL draws in it.

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace holdfast {

/// The pause holds back the repaints of a window. A repaint composes the widgets of the window. That waits for all that
/// OpenGL was ordered to draw, and the window cannot answer meanwhile. Repaints that are requested during the pause
/// follow after it.
class RepaintPause : public QObject {
 public:
  /// Makes a pause for the window of the widget `inside`, which outlives the pause.
  explicit RepaintPause(QWidget& inside) : inside_(inside) {}

  void begin();
  /// Ends the pause, and tells whether a repaint was requested. The repaint follows with the next events.
  bool end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& inside_;
  QPointer<QWidget> window_;  // null when there is no pause
  bool isWaiting_ = false;
};

}  // namespace holdfast
