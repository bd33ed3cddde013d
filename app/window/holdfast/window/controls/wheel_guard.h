#pragma once
/// Keeps the wheel of the mouse, which scrolls, from editing the controls that it passes on its way.

#include <QObject>

namespace holdfast {

/// The guard is an event filter for the application. Boxes of choices, numbers and sliders take the wheel only while
/// they have the keyboard focus, which the wheel does not give them. Otherwise the wheel goes to the widget that they
/// lie in.
class WheelGuard final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace holdfast
