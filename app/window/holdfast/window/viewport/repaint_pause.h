#pragma once
/// \file
/// A window that is not repainted while something is drawn in it.

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace holdfast {

/// Putting the widgets of a window together waits for all that OpenGL was ordered to draw: done meanwhile, it would
/// hold up whatever comes next. Nothing is lost: what is to be repainted is repainted after the pause.
class RepaintPause : public QObject {
 public:
  /// `inside`: a widget of that window; this is a part of it.
  explicit RepaintPause(QWidget& inside) : inside_(inside) {}

  void begin();
  /// Whether something waits to be repainted, which comes with the events that follow.
  bool end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& inside_;
  QPointer<QWidget> window_;  // null when there is no pause
  bool isWaiting_ = false;
};

}  // namespace holdfast
