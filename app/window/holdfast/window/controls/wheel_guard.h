#pragma once
/// Keeps the wheel of the mouse, which scrolls, from editing what it passes on its way.

#include <QObject>

namespace holdfast {

/// An event filter for the application. Boxes of choices, numbers and sliders take the wheel only while they have the
/// keys, which the wheel does not give them; otherwise it goes to what they lie in.
class WheelGuard final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace holdfast
