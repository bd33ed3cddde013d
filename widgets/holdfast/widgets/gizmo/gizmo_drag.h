#pragma once
/// The meaning of the cursor, or of a typed number, while a part of the gizmo is held. Plain mathematics.

#include <optional>
#include <string>
#include <string_view>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>

namespace holdfast {

/// Digits and one point or comma, in the order of the keys. Minus changes the sign at any time. No locale applies.
class NumericInput {
 public:
  static constexpr std::string_view kKeys = "0123456789.,-";

  /// Whether a number can begin with the key.
  [[nodiscard]] static bool isBegunBy(char key) { return kKeys.find(key) != std::string_view::npos; }

  /// False, and nothing changes, where the number cannot go on with the key.
  bool add(char key);
  /// Takes back the last key's digit, point or sign.
  void chop()
  {
    if (!text_.empty()) text_.pop_back();
  }
  void clear() { text_.clear(); }

  [[nodiscard]] bool isEmpty() const noexcept { return text_.empty(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// The nearest double; 0 before the first digit.
  [[nodiscard]] double value() const;

 private:
  std::string text_;
};

/// Since the drag began: a rotation about the line along `axis` through the frame's center, or a translation.
struct GizmoMotion {
  Vector3 translation = Vector3::Zero();  ///< model units
  Vector3 axis = Vector3::UnitZ();        ///< of unit length
  double degrees = 0;                     ///< of any number of turns
  double distance = 0;                    ///< of the translation: signed along an arrow, else its length
};

enum class Snap {
  None,
  On  ///< to multiples of the drag's steps
};

/// 1, 2 or 5 times a power of ten. Multiples of it are the doubles nearest to the decimal numbers that they are.
struct RoundStep {
  int factor = 1;
  int exponent = 0;

  [[nodiscard]] double multiple(double count) const;
  [[nodiscard]] double size() const { return multiple(1); }
  /// Digits after the point that a multiple needs.
  [[nodiscard]] int decimals() const { return exponent < 0 ? -exponent : 0; }
};

/// The smallest round step that is no less than `least`, from 1e-300 to 1e300.
[[nodiscard]] RoundStep roundStepFrom(double least);

inline constexpr double kSnapDegrees = 15;
inline constexpr double kSnapPixels = 8;

/// How far a ring is from the center, in pixels, unless something else is said.
inline constexpr double kRingPixels = 70;

/// One drag of one part. The motion begins with exactly none, and stays where the cursor determines none (a ray along
/// the arrow, in the plane of the ring, behind the eye): it is always finite.
class GizmoDrag {
 public:
  /// `part` is not `None`. `ringPixels`: how far the rings are from the center on the display.
  GizmoDrag(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view, const DisplayPoint& start,
            double ringPixels = kRingPixels);

  /// The motion with the cursor at `point`; remembers it. Angles follow the cursor over several turns.
  GizmoMotion to(const DisplayPoint& point, Snap snap);

  /// Exactly so far (model units) or so much (degrees): squares and the center in the direction of the drag so far, or
  /// along their first axis.
  [[nodiscard]] GizmoMotion typed(double amount) const;

  [[nodiscard]] GizmoPart part() const noexcept { return part_; }
  [[nodiscard]] const GizmoFrame& frame() const noexcept { return frame_; }

  /// Translations snap to the smallest round length that is seen as `kSnapPixels` in every direction of the part.
  [[nodiscard]] const RoundStep& step() const noexcept { return step_; }

  /// For a ring the unit direction from the center to where it was grabbed, else zero.
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

/// The text behind the number of a motion: "°", " mm", or nothing where `units` is empty.
[[nodiscard]] std::string motionUnit(GizmoPart part, const std::string& units);

/// "12.5 mm" or "30.0°", as a label says it: lengths with the digits that a step of `step` needs; nothing is "-0".
[[nodiscard]] std::string motionText(GizmoPart part, const GizmoMotion& motion, const RoundStep& step,
                                     const std::string& units);

}  // namespace holdfast
