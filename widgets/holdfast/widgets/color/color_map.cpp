#include "holdfast/widgets/color/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <vtkMath.h>

namespace holdfast {
namespace {

/// CIE L*a*b* under D65: equal distances look about equally large.
struct LabColor {
  double lightness = 0;  ///< 0 black, 100 white
  double a = 0;
  double b = 0;
};

// Points of smooth curves through Lab space at equal distances along each, so that equal steps of a value look equal;
// all of them, and the straight lines between them, can be shown in sRGB.
constexpr LabColor kBlueGreenYellow[] = {{30, 22, -46}, {41, 6, -41},  {50, -8, -31}, {57, -22, -18}, {63, -29, -1},
                                         {70, -31, 18}, {76, -29, 37}, {83, -19, 52}, {90, -6, 66}};

constexpr LabColor kBlueGreyYellow[] = {{22, 6, -33}, {35, 4, -26}, {46, 3, -15}, {55, 1, -3}, {63, 0, 10},
                                        {70, -2, 23}, {77, -3, 37}, {84, -4, 50}, {90, -5, 64}};

constexpr LabColor kBlueWhiteOrange[] = {{36, 12, -50}, {52, 3, -42}, {68, -1, -30}, {83, -1, -15}, {96, 0, 0},
                                         {87, 8, 19},   {76, 18, 35}, {62, 29, 48},  {44, 42, 52}};

// Ends well below the grey of what has no value.
constexpr LabColor kGrey[] = {{8, 0, 0}, {64, 0, 0}};

constexpr LabColor kBlueWhiteRed[] = {{37, 16, -53}, {51, 7, -43}, {66, 1, -29}, {83, -1, -15}, {96, 0, 0},
                                      {84, 15, 12},  {71, 30, 22}, {57, 44, 30}, {43, 55, 36}};

constexpr LabColor kBlackRedYellow[] = {{10, 10, 4},  {19, 26, 17}, {28, 39, 32}, {39, 50, 46}, {54, 48, 57},
                                        {67, 34, 64}, {78, 17, 68}, {88, 1, 62},  {94, -6, 46}};

// In the order of `ColorMap`.
constexpr std::array<std::span<const LabColor>, 6> kMaps{kBlueGreenYellow, kBlueGreyYellow, kBlueWhiteOrange, kGrey,
                                                         kBlueWhiteRed,    kBlackRedYellow};

// Finer than the 256 levels of a channel anywhere along the map. A prime above `kMostBands`: no two bands meet where
// two colours of the table do.
constexpr int kTableColors = 1021;

// The ends of the scale are so far inside the table: what is beyond them may have a colour of its own. With this share,
// no two bands meet between two colours of the table.
constexpr double kFromEnds = 0.3 / kTableColors;

/// From the beginning of the scale to its end, and on; values without a logarithm are as far below as the end is above.
double freeShareOf(const ColorScale& scale, double value)
{
  if (scale.scaling == Scaling::Linear) return (value - scale.low) / (scale.high - scale.low);
  return value > 0 ? std::log(value / scale.low) / std::log(scale.high / scale.low) : -1;
}

/// The share of the map at a share of the scale.
double mapShareAt(const ColorScale& scale, double share)
{
  if (!scale.isSigned || scale.scaling != Scaling::Linear || !isTwoSided(scale.map)) return share;
  return 0.5 + 0.5 * std::lerp(scale.low, scale.high, share) / std::max(std::abs(scale.low), std::abs(scale.high));
}

}  // namespace

Color mixed(const Color& from, const Color& to, double share)
{
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

Color mapColor(double share, ColorMap map)
{
  if (std::isnan(share)) return kNoValueColor;
  const std::span<const LabColor> points = kMaps[static_cast<std::size_t>(map)];
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const auto leg = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double t = place - static_cast<double>(leg);
  const LabColor& p = points[leg];
  const LabColor& q = points[leg + 1];
  Color color;
  vtkMath::LabToRGB(std::lerp(p.lightness, q.lightness, t), std::lerp(p.a, q.a, t), std::lerp(p.b, q.b, t), &color.red,
                    &color.green, &color.blue);
  return color;
}

double shareOf(const ColorScale& scale, double value)
{
  if (std::isnan(value)) return value;
  const double inside = std::clamp(value, scale.low, scale.high);
  if (scale.scaling == Scaling::Linear) return (inside - scale.low) / (scale.high - scale.low);
  return std::log(inside / scale.low) / std::log(scale.high / scale.low);
}

Color colorAt(const ColorScale& scale, double share)
{
  if (scale.bands < 2 || std::isnan(share)) return mapColor(mapShareAt(scale, share), scale.map);
  const double band = std::clamp(std::floor(share * scale.bands), 0.0, scale.bands - 1.0);
  return mapColor(mapShareAt(scale, band / (scale.bands - 1)), scale.map);
}

Color colorOf(const ColorScale& scale, double value)
{
  if (scale.outside == Outside::Marked && value < scale.low) return kBelowColor;
  if (scale.outside == Outside::Marked && value > scale.high) return kBeyondColor;
  return colorAt(scale, shareOf(scale, value));
}

double tablePlace(const ColorScale& scale, double value)
{
  if (std::isnan(value)) return value;
  const double share = scale.outside == Outside::Marked ? freeShareOf(scale, value) : shareOf(scale, value);
  return kFromEnds + (1 - 2 * kFromEnds) * share;
}

vtkSmartPointer<vtkLookupTable> toLookupTable(const ColorScale& scale)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kTableColors);
  table->SetTableRange(0, 1);
  for (int k = 0; k < kTableColors; ++k) {
    // A colour of the table in which two bands meet is that of the upper one, as the value there is.
    const double end = std::min(1.0, ((k + 1.0) / kTableColors - kFromEnds) / (1 - 2 * kFromEnds));
    const double share = scale.bands < 2 ? k / (kTableColors - 1.0) : end;
    const Color color = colorAt(scale, share);
    table->SetTableValue(k, color.red, color.green, color.blue);
  }
  table->SetNanColor(kNoValueColor.red, kNoValueColor.green, kNoValueColor.blue, 1);
  table->SetBelowRangeColor(kBelowColor.red, kBelowColor.green, kBelowColor.blue, 1);
  table->SetAboveRangeColor(kBeyondColor.red, kBeyondColor.green, kBeyondColor.blue, 1);
  table->SetUseBelowRangeColor(scale.outside == Outside::Marked);
  table->SetUseAboveRangeColor(scale.outside == Outside::Marked);
  return table;
}

}  // namespace holdfast
