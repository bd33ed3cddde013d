#include "holdfast/widgets/gizmo/gizmo_drag.h"

#include <cmath>

#include <fmt/format.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

// The digits of a double, and room for zeros around them.
constexpr std::size_t kMostCharacters = 24;

// The sine of the angle to an axis or a plane below which a ray does not say where it meets it: about one degree, and
// motions stay within fifty times the distance of the eye.
constexpr double kLeastSine = 0.02;

// Rings whose plane is seen at a smaller sine are rolled instead: where the ray meets the plane, a pixel would be many
// degrees.
constexpr double kFlatRing = 0.3;

// Closer to the center of a ring the cursor has no direction from it.
constexpr double kNoDirectionPixels = 2;

// Steps are not enlarged more than this for directions that point at the eye.
constexpr double kLeastForeshortening = 0.1;

// A view that shows the gizmo nowhere has no pixels to fit a step to.
constexpr RoundStep kAnyStep{1, 0};
constexpr double kSmallestPixel = 1e-280;
constexpr double kLargestPixel = 1e280;

// Lengths of very many or very few digits are printed in powers of ten.
constexpr int kMostDecimals = 6;
constexpr double kLongest = 1e9;

/// Nothing is never negative.
double plain(double value)
{
  return value == 0 ? 0 : value;
}

RoundStep stepFor(const DisplayTransform& view, const Vector3& place, std::initializer_list<Vector3> directions)
{
  const double pixel = view.worldPerPixel(place);
  if (!(pixel > kSmallestPixel && pixel < kLargestPixel)) return kAnyStep;
  double foreshortening = 1;
  for (const Vector3& direction : directions)
    foreshortening = std::min(foreshortening, direction.cross(view.sightOf(place)).norm());
  return roundStepFrom(kSnapPixels * pixel / std::max(foreshortening, kLeastForeshortening));
}

/// With a direction of unit length.
Ray sightThrough(const DisplayTransform& view, const DisplayPoint& point)
{
  Ray ray = view.rayThrough(point);
  ray.direction.normalize();
  return ray;
}

/// " about (0.6, 0, 0.8)": of an axis that the part's own letter does not name.
std::string axisInWords(const Vector3& axis)
{
  constexpr double kAlong = 1 - 1e-9;
  constexpr double kShown = 5e-4;
  if (axis.cwiseAbs().maxCoeff() > kAlong) return {};
  const auto shown = [](double value) { return std::abs(value) < kShown ? 0 : value; };
  return fmt::format(" about ({:.3g}, {:.3g}, {:.3g})", shown(axis.x()), shown(axis.y()), shown(axis.z()));
}

}  // namespace

bool NumericInput::add(char key)
{
  if (!isBegunBy(key)) return false;
  if (key == '-') {
    text_ = text_.starts_with('-') ? text_.substr(1) : '-' + text_;
    return true;
  }
  const char character = key == ',' ? '.' : key;
  if (text_.size() >= kMostCharacters || (character == '.' && text_.find('.') != std::string::npos)) return false;
  text_ += character;
  return true;
}

double NumericInput::value() const
{
  const ParsedNumber<double> number = parseNumber<double>(text_);
  return number.fault == NumberFault::None ? number.value : 0;
}

double RoundStep::multiple(double count) const
{
  const double whole = count * factor;
  return exponent < 0 ? whole / std::pow(10.0, -exponent) : whole * std::pow(10.0, exponent);
}

RoundStep roundStepFrom(double least)
{
  assert(least >= 1e-300 && least <= 1e300);
  RoundStep step{1, static_cast<int>(std::floor(std::log10(least)))};
  while (step.size() < least) {
    step.exponent += step.factor == 5 ? 1 : 0;
    step.factor = step.factor == 1 ? 2 : step.factor == 2 ? 5 : 1;
  }
  return step;
}

GizmoDrag::GizmoDrag(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view, const DisplayPoint& start,
                     double ringPixels)
    : part_(part), frame_(frame), view_(view), ringPixels_(ringPixels)
{
  assert(part != GizmoPart::None && ringPixels > 0);
  const int axis = axisIndexOf(part);
  if (axis < 0) {
    first_ = view.right();
    second_ = view.up();
    normal_ = -view.direction();
  } else if (kindOf(part) == GizmoPartKind::Arrow) {
    first_ = second_ = normal_ = frame.axes.col(axis);
  } else {
    first_ = frame.axes.col((axis + 1) % 3);
    second_ = frame.axes.col((axis + 2) % 3);
    normal_ = frame.axes.col(axis);
  }
  step_ = stepFor(view, frame.center, {first_, second_});
  const Vector3 sight = view.sightOf(frame.center);
  isFlat_ = kindOf(part) == GizmoPartKind::Ring && std::abs(normal_.dot(sight)) < kFlatRing;
  if (isRotation(part_)) {
    const std::optional<double> degrees = isFlat_ ? std::nullopt : degreesAt(start);
    // A flat ring is held at its place nearest to the eye.
    grabbed_ = degrees ? Vector3(std::cos(*degrees * kDegree) * first_ + std::sin(*degrees * kDegree) * second_)
                       : Vector3((sight.dot(normal_) * normal_ - sight).normalized());
  }
  follow(start);
}

/// The parameter of the point on the arrow's line that is closest to the ray.
std::optional<double> GizmoDrag::alongArrow(const Ray& ray) const
{
  const Vector3 away = frame_.center - ray.origin;
  const double cosine = first_.dot(ray.direction);
  const double sineSquared = first_.cross(ray.direction).squaredNorm();
  if (!(sineSquared > kLeastSine * kLeastSine)) return std::nullopt;
  const double along = (cosine * ray.direction.dot(away) - first_.dot(away)) / sineSquared;
  const double onRay = ray.direction.dot(away) + along * cosine;
  if (!view_.isParallel() && !(onRay > 0)) return std::nullopt;
  return along;
}

/// From the center to where the ray meets the plane.
std::optional<Vector3> GizmoDrag::onPlane(const Ray& ray) const
{
  const Vector3 away = frame_.center - ray.origin;
  const double sine = normal_.dot(ray.direction);
  if (!(std::abs(sine) > kLeastSine)) return std::nullopt;
  const double onRay = normal_.dot(away) / sine;
  if (!view_.isParallel() && !(onRay > 0)) return std::nullopt;
  return Vector3(onRay * ray.direction - away);
}

std::optional<double> GizmoDrag::degreesAt(const DisplayPoint& point) const
{
  const std::optional<DisplayPoint> center = toDisplay(view_, frame_.center);
  if (!center || !point.allFinite()) return std::nullopt;
  const DisplayPoint arm = point - *center;
  if (isFlat_) {
    // The side that faces the eye goes with the cursor, like a wheel.
    const Vector3 tangent = normal_.cross(grabbed_);
    return arm.dot(DisplayPoint(tangent.dot(view_.right()), tangent.dot(view_.up())).normalized()) / ringPixels_ /
           kDegree;
  }
  if (!(arm.norm() > kNoDirectionPixels)) return std::nullopt;
  if (part_ == GizmoPart::ViewRing) return std::atan2(arm.y(), arm.x()) / kDegree;
  const std::optional<Vector3> place = onPlane(sightThrough(view_, point));
  if (!place || !place->allFinite()) return std::nullopt;
  return std::atan2(place->dot(second_), place->dot(first_)) / kDegree;
}

/// Along both directions; of a rotation the degrees, and 0.
std::optional<Eigen::Vector2d> GizmoDrag::amountAt(const DisplayPoint& point) const
{
  std::optional<Eigen::Vector2d> amount;
  if (isRotation(part_)) {
    if (const auto degrees = degreesAt(point)) amount.emplace(*degrees, 0);
  } else if (kindOf(part_) == GizmoPartKind::Arrow) {
    if (const auto along = alongArrow(sightThrough(view_, point))) amount.emplace(*along, 0);
  } else if (const auto place = onPlane(sightThrough(view_, point))) {
    amount.emplace(place->dot(first_), place->dot(second_));
  }
  return amount && amount->allFinite() ? amount : std::nullopt;
}

void GizmoDrag::follow(const DisplayPoint& point)
{
  const std::optional<Eigen::Vector2d> amount = amountAt(point);
  if (!amount) return;
  if (!start_) start_ = amount;
  const double before = amount_.x();
  amount_ = *amount - *start_;
  if (isRotation(part_) && !isFlat_) amount_.x() += 360 * std::round((before - amount_.x()) / 360);
}

GizmoMotion GizmoDrag::shifted(const Eigen::Vector2d& amounts) const
{
  const bool isArrow = kindOf(part_) == GizmoPartKind::Arrow;
  if (isArrow) return {amounts.x() * first_, normal_, 0, amounts.x()};
  return {amounts.x() * first_ + amounts.y() * second_, normal_, 0, amounts.norm()};
}

GizmoMotion GizmoDrag::rotated(double degrees) const
{
  return {Vector3::Zero(), normal_, degrees, 0};
}

GizmoMotion GizmoDrag::to(const DisplayPoint& point, Snap snap)
{
  follow(point);
  if (isRotation(part_))
    return rotated(snap == Snap::On ? plain(kSnapDegrees * std::round(amount_.x() / kSnapDegrees)) : amount_.x());
  if (snap == Snap::None) return shifted(amount_);
  const auto snapped = [this](double amount) { return plain(step_.multiple(std::round(amount / step_.size()))); };
  return shifted({snapped(amount_.x()), snapped(amount_.y())});
}

GizmoMotion GizmoDrag::typed(double amount) const
{
  if (isRotation(part_)) return rotated(amount);
  if (kindOf(part_) == GizmoPartKind::Arrow || amount_.isZero(0)) return shifted({amount, 0});
  GizmoMotion motion = shifted(amount * amount_.normalized());
  motion.distance = std::abs(amount);
  return motion;
}

std::string motionUnit(GizmoPart part, const std::string& units)
{
  if (isRotation(part)) return "°";
  return units.empty() ? "" : " " + units;
}

std::string motionText(GizmoPart part, const GizmoMotion& motion, const RoundStep& step, const std::string& units)
{
  const auto withoutSignOfNothing = [](const std::string& text) {
    return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1) : text;
  };
  if (isRotation(part))
    return withoutSignOfNothing(fmt::format("{:.1f}", motion.degrees)) + motionUnit(part, units) +
           axisInWords(motion.axis);
  const bool isPlain = step.decimals() <= kMostDecimals && std::abs(motion.distance) < kLongest;
  const std::string number =
      isPlain ? fmt::format("{:.{}f}", motion.distance, step.decimals()) : fmt::format("{:.4g}", motion.distance);
  return withoutSignOfNothing(number) + motionUnit(part, units);
}

}  // namespace holdfast
