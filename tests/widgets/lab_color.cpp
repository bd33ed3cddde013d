#include "widgets/lab_color.h"

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

}  // namespace holdfast::test
