#include "pad.h"

#include <cmath>
#include <numbers>

#include "revolved.h"

namespace holdfast::generate {
namespace {

using std::numbers::pi;

double perimeter(const Pad& pad)
{
  return 4 * (pad.halfX + pad.halfY - 2 * pad.radius) + 2 * pi * pad.radius;
}

// From the middle of the right side to the middle of the far side, by length along the outline.
Vector2 onFirstQuarter(const Pad& pad, double length)
{
  const double up = pad.halfY - pad.radius, arc = pad.radius * pi / 2;
  if (length < up) return {pad.halfX, length};
  if (length > up + arc) return {pad.halfX - pad.radius - (length - up - arc), pad.halfY};
  const double angle = (length - up) / pad.radius;
  return {pad.halfX - pad.radius + pad.radius * std::cos(angle), up + pad.radius * std::sin(angle)};
}

// Relative to the centre, anticlockwise, at a share t in [0, 1) of the perimeter.
Vector3 onOutline(const Pad& pad, double t)
{
  const double quarter = perimeter(pad) / 4;
  const double quarters = 4 * t;
  const Index turns = static_cast<Index>(quarters);
  const double share = quarters - static_cast<double>(turns);
  const Vector2 place = onFirstQuarter(pad, quarter * (turns % 2 == 0 ? share : 1 - share));
  const double signX = turns == 0 || turns == 3 ? 1 : -1, signY = turns < 2 ? 1 : -1;
  return {signX * place.x(), signY * place.y(), 0};
}

}  // namespace

Ring addPad(Shell& shell, const std::string& group, const Pad& pad)
{
  constexpr double kEdge = 1.6;
  const Index count = 4 * std::lround(perimeter(pad) / (4 * kEdge));
  const Index rows = std::lround(pad.height / (kRowHeight * kEdge));
  const auto place = [&](Index row, double t) -> Vector3 {
    const double share = static_cast<double>(row) / static_cast<double>(rows);
    return pad.centre + onOutline(pad, t) + share * pad.height * Vector3::UnitZ();
  };
  const Shell::BandEnds side = shell.addBand(group, {rows, count, place});
  shell.addPatch(group, planeChart(pad.centre + pad.height * Vector3::UnitZ(), Vector3::UnitZ()), {side.last});
  return side.first;
}

}  // namespace holdfast::generate
