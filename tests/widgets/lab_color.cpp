#include "widgets/lab_color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace holdfast::test {
namespace {

// White of D65, and the end of the linear part of Lab's cube root.
constexpr double kWhiteX = 0.95047;
constexpr double kWhiteZ = 1.08883;
constexpr double kKnee = 6.0 / 29;

double fromGamma(double channel)
{
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double toGamma(double sum)
{
  const double inside = std::clamp(sum, 0.0, 1.0);
  return inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow(inside, 1 / 2.4) - 0.055;
}

double labRoot(double t)
{
  return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4.0 / 29;
}

}  // namespace

LabColor toLab(const Color& color)
{
  const double red = fromGamma(color.red);
  const double green = fromGamma(color.green);
  const double blue = fromGamma(color.blue);
  const double x = labRoot((0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) / kWhiteX);
  const double y = labRoot(0.2126729 * red + 0.7151522 * green + 0.0721750 * blue);
  const double z = labRoot((0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) / kWhiteZ);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const LabColor& p, const LabColor& q)
{
  return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b);
}

Color seenBy(Vision vision, const Color& color)
{
  if (vision == Vision::Usual) return color;
  using Row = std::array<double, 3>;
  constexpr std::array<Row, 3> kWithoutGreen{
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
  constexpr std::array<Row, 3> kWithoutRed{
      {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
  const auto channel = [&](int k) {
    const Row& row = (vision == Vision::WithoutGreen ? kWithoutGreen : kWithoutRed)[k];
    return toGamma(row[0] * fromGamma(color.red) + row[1] * fromGamma(color.green) + row[2] * fromGamma(color.blue));
  };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace holdfast::test
