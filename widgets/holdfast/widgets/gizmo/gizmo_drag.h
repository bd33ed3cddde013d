#pragma once
/// The meaning of the cursor, or of a typed number, while a part of the gizmo is held. It is plain mathematics.

#include <optional>
#include <string>
#include <string_view>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>

namespace holdfast {

/// A number that is typed: digits and one point or comma, in the order of the keys. A comma counts as a point. Minus
/// changes the sign at any time. No locale applies.
class NumericInput {
 public:
  static constexpr std::string_view kKeys = "0123456789.,-";

  /// Tells whether a number can begin with the key.
  [[nodiscard]] static bool isBegunBy(char key) { return kKeys.find(key) != std::string_view::npos; }

  /// Adds a key. Where the number cannot go on with the key, it returns false and nothing changes.
  bool add(char key);
  /// Takes back the last character of `text`.
  void chop()
  {
    if (!text_.empty()) text_.pop_back();
  }
  void clear() { text_.clear(); }

  [[nodiscard]] bool isEmpty() const noexcept { return text_.empty(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// Returns the nearest double; 0 before the first digit.
  [[nodiscard]] double value() const;

 private:
  std::string text_;
};

/// The motion since the drag began. It is a translation, or a rotation about the line along `axis` through the frame's
/// centre.
struct GizmoMotion {
  Vector3 translation = Vector3::Zero();  ///< model units
  Vector3 axis = Vector3::UnitZ();        ///< of unit length
  double degrees = 0;                     ///< angle of the rotation, of any number of turns
  double distance = 0;                    ///< length of the translation; along an arrow it has a sign
};

enum class Snap {
  None,
  On  ///< to multiples of the drag's steps
};

/// A round step: 1, 2 or 5 times a power of ten. Its multiples are the doubles nearest to the decimal numbers that they
/// stand for.
struct RoundStep {
  int factor = 1;
  int exponent = 0;

  [[nodiscard]] double multiple(double count) const;
  [[nodiscard]] double size() const { return multiple(1); }
  /// Returns how many digits after the point a multiple needs.
  [[nodiscard]] int decimals() const { return exponent < 0 ? -exponent : 0; }
};

/// Returns the smallest round step that is no less than `least`, which is from 1e-300 to 1e300.
[[nodiscard]] RoundStep roundStepFrom(double least);

inline constexpr double kSnapDegrees = 15;
inline constexpr double kSnapPixels = 8;

/// The distance of a ring from the centre, in pixels, unless the caller says another.
inline constexpr double kRingPixels = 70;

/// One drag of one part. The motion begins with exactly none. It stays as it is where the cursor determines none: a ray
/// along the arrow, in the plane of the ring, or behind the eye. So the motion is always finite.
///
///     GizmoDrag drag(GizmoPart::ArrowX, frame, DisplayTransform(*renderer), centerOfPixel(x, y));
///     const GizmoMotion motion = drag.to(centerOfPixel(newX, newY), Snap::On);
///     object.setCenter(frame.center + motion.translation);
class GizmoDrag {
 public:
  /// Begins a drag of `part`, which is not `None`, with the cursor at `start`. `ringPixels`, which is positive, is how
  /// far the rings are from the centre on the display.
  GizmoDrag(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view, const DisplayPoint& start,
            double ringPixels = kRingPixels);

  /// Returns the motion with the cursor at `point`, and remembers it. Angles follow the cursor over several turns.
  GizmoMotion to(const DisplayPoint& point, Snap snap);

  /// Returns a motion by exactly `amount`: model units, or degrees for a ring. Squares and the centre move in the
  /// direction of the drag so far, or along their first axis.
  [[nodiscard]] GizmoMotion typed(double amount) const;

  [[nodiscard]] GizmoPart part() const noexcept { return part_; }
  [[nodiscard]] const GizmoFrame& frame() const noexcept { return frame_; }

  /// Returns the step of translations that snap. It is the smallest round length that is seen as `kSnapPixels` in every
  /// direction of the part.
  [[nodiscard]] const RoundStep& step() const noexcept { return step_; }

  /// Returns the unit direction from the centre to where a ring was grabbed. For other parts it is zero.
  [[nodiscard]] const Vector3& grabbed() const noexcept { return grabbed_; }

 private:
  [[nodiscard]] std::optional<double> alongArrow(const Ray& ray) const;
  [[nodiscard]] std::optional<Vector3> onPlane(const Ray& ray) const;
  [[nodiscard]] std::optional<double> degreesAt(const DisplayPoint& point) const;
  [[nodiscard]] std::optional<Eigen::Vector2d> amountAt(const DisplayPoint& point) const;
  [[nodiscard]] GizmoMotion shifted(const Eigen::Vector2d& amounts) const;
  [[nodiscard]] GizmoMotion rotated(double degrees) const;
  void follow(const DisplayPoint& point);

  GizmoPart part_;
  GizmoFrame frame_;
  DisplayTransform view_;
  double ringPixels_;
  Vector3 first_;        // along an arrow; else both span the plane in which the part moves or rotates,
  Vector3 second_;       // for rings counterclockwise from `first_`
  Vector3 normal_;       // of that plane
  bool isFlat_ = false;  // the ring is seen so much from the side that the cursor rolls it
  RoundStep step_;
  Vector3 grabbed_ = Vector3::Zero();

  std::optional<Eigen::Vector2d> start_;              // of the first cursor that said something
  Eigen::Vector2d amount_ = Eigen::Vector2d::Zero();  // so far, without snapping
};

/// Returns the text that follows the number of a motion: "°", " mm", or nothing where `units` is empty.
[[nodiscard]] std::string motionUnit(GizmoPart part, const std::string& units);

/// Returns the motion as a label says it: "12.5 mm" or "30.0°". Lengths have the digits that a step of `step` needs. No
/// number is "-0".
[[nodiscard]] std::string motionText(GizmoPart part, const GizmoMotion& motion, const RoundStep& step,
                                     const std::string& units);

}  // namespace holdfast
