#pragma once
/// \file
/// How a click is told from a drag.

#include <optional>

#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

/// A button that goes down and comes up in one place, within `kClickPixels`, clicks. What listens to clicks aborts
/// neither, so that a drag from the same place is the camera's.
class Click {
 public:
  void Press(const DisplayPoint& place) { this->PressedAt = place; }

  /// The cursor is at `place`. Whether that ends what could have become a click.
  bool LeaveAt(const DisplayPoint& place, double pixelRatio);

  /// Whether the button that comes up at `place` clicks.
  [[nodiscard]] bool Release(const DisplayPoint& place, double pixelRatio);

  void Forget() { this->PressedAt.reset(); }

 private:
  std::optional<DisplayPoint> PressedAt;  // while the button is down and the cursor near
};

}  // namespace holdfast
