#include "bench/paper/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "bench/paper/svg.h"

namespace holdfast::paper {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kLeft = 80;
constexpr double kRight = 520;  // the legend is beyond
constexpr double kTop = 46;
constexpr double kBottom = 380;
constexpr Stroke kGrid{"#d9dce1", 1, "none", ""};

/// From numbers to pixels along one axis.
struct Ruler {
  Scale scale = Scale::Linear;
  double low = 0;   // scaled
  double high = 1;  // scaled
  double from = 0;  // pixels
  double to = 1;

  [[nodiscard]] double scaled(double value) const { return scale == Scale::Log ? std::log10(value) : value; }
  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (scale != Scale::Log || value > 0); }
  [[nodiscard]] double pixel(double value) const { return from + (to - from) * (scaled(value) - low) / (high - low); }
};

/// 1, 2 or 5 times a power of ten: about five of them make `range`.
double stepFor(double range)
{
  const double power = std::pow(10, std::floor(std::log10(range / 5)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= 6) return factor * power;
  return 10 * power;
}

std::vector<double> ticksOf(const Ruler& ruler)
{
  const double step = ruler.scale == Scale::Log ? std::max(1.0, std::ceil((ruler.high - ruler.low) / 8))
                                                : stepFor(ruler.high - ruler.low);
  std::vector<double> ticks;
  for (double k = std::ceil(ruler.low / step - 1e-9); k * step <= ruler.high + 1e-9 * step; ++k)
    ticks.push_back(ruler.scale == Scale::Log ? std::pow(10, k * step) : k * step);
  return ticks;
}

/// Reaches over all values that it shows.
Ruler rulerFor(Scale scale, const std::vector<double>& values, double from, double to)
{
  Ruler ruler{scale, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), from, to};
  for (const double value : values) {
    if (!ruler.shows(value)) continue;
    ruler.low = std::min(ruler.low, ruler.scaled(value));
    ruler.high = std::max(ruler.high, ruler.scaled(value));
  }
  if (!(ruler.low <= ruler.high)) return {scale, 0, 1, from, to};
  if (scale == Scale::Log) {
    ruler.low = std::floor(ruler.low);
    ruler.high = std::ceil(ruler.high);
  }
  if (ruler.high == ruler.low) ruler.high = ruler.low + 1;
  return ruler;
}

std::string numberText(double value, Scale scale)
{
  return scale == Scale::Log && (value < 1e-2 || value >= 1e4) ? fmt::format("1e{:.0f}", std::log10(value))
                                                               : fmt::format("{:g}", value);
}

void drawAxes(Svg& svg, const Ruler& x, const Axis& xAxis, const Ruler& y, const Axis& yAxis)
{
  for (const double tick : ticksOf(x)) {
    svg.line({x.pixel(tick), kTop}, {x.pixel(tick), kBottom}, kGrid);
    svg.text({x.pixel(tick), kBottom + 18}, numberText(tick, x.scale), Anchor::Middle, 12);
  }
  for (const double tick : ticksOf(y)) {
    svg.line({kLeft, y.pixel(tick)}, {kRight, y.pixel(tick)}, kGrid);
    svg.text({kLeft - 6, y.pixel(tick) + 4}, numberText(tick, y.scale), Anchor::End, 12);
  }
  svg.text({(kLeft + kRight) / 2, kBottom + 42}, xAxis.label, Anchor::Middle);
  svg.text({22, (kTop + kBottom) / 2}, yAxis.label, Anchor::Middle, 14, "#20242c", -90);
}

void drawCurve(Svg& svg, const Curve& curve, const Ruler& x, const Ruler& y, std::string_view color)
{
  std::vector<Point2> points;
  for (const auto& [u, v] : curve.points)
    if (x.shows(u) && y.shows(v)) points.emplace_back(x.pixel(u), y.pixel(v));
  if (points.size() > 1) svg.polyline(points, {color, 2, "none", ""});
  for (const Point2& point : points) svg.disc(point, 3.5, color);
}

void drawLegend(Svg& svg, const std::vector<std::string>& names, double left, double top)
{
  for (std::size_t k = 0; k < names.size(); ++k) {
    svg.disc({left, top + 20.0 * static_cast<double>(k) - 4}, 5, seriesColor(k));
    svg.text({left + 12, top + 20.0 * static_cast<double>(k)}, names[k], Anchor::Start, 13);
  }
}

constexpr double kBarStart = 190;
constexpr double kBarTop = 70;
constexpr double kBarPitch = 34;
constexpr double kBarHeight = 22;

double sumOf(const Bar& bar)
{
  return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0);
}

/// The names of the parts, side by side.
void drawParts(Svg& svg, const std::vector<std::string>& parts)
{
  double left = kBarStart;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    svg.disc({left, 48}, 6, seriesColor(k));
    svg.text({left + 12, 53}, parts[k], Anchor::Start, 13);
    left += 40 + 7.5 * static_cast<double>(parts[k].size());
  }
}

void drawBar(Svg& svg, const Bar& bar, double top, double pixelsPerUnit, const std::string& unit)
{
  svg.text({kBarStart - 10, top + 16}, bar.name, Anchor::End, 13);
  double x = kBarStart;
  for (std::size_t part = 0; part < bar.parts.size(); ++part) {
    const double end = x + pixelsPerUnit * bar.parts[part];
    svg.polygon({{x, top}, {end, top}, {end, top + kBarHeight}, {x, top + kBarHeight}},
                {"white", 1, seriesColor(part), ""});
    x = end;
  }
  svg.text({x + 8, top + 16}, fmt::format("{:.3g} {}", sumOf(bar), unit), Anchor::Start, 13);
}

}  // namespace

std::string curveChart(const std::string& title, const Axis& xAxis, const Axis& yAxis, const std::vector<Curve>& curves)
{
  std::vector<double> us;
  std::vector<double> vs;
  std::vector<std::string> names;
  for (const Curve& curve : curves) {
    names.push_back(curve.name);
    for (const auto& [u, v] : curve.points) {
      us.push_back(u);
      vs.push_back(v);
    }
  }
  if (yAxis.scale == Scale::Linear) vs.push_back(0);
  const Ruler x = rulerFor(xAxis.scale, us, kLeft, kRight);
  const Ruler y = rulerFor(yAxis.scale, vs, kBottom, kTop);
  Svg svg(kWidth, kHeight);
  svg.text({kLeft, 26}, title, Anchor::Start, 16);
  drawAxes(svg, x, xAxis, y, yAxis);
  for (std::size_t k = 0; k < curves.size(); ++k) drawCurve(svg, curves[k], x, y, seriesColor(k));
  drawLegend(svg, names, kRight + 24, kTop + 12);
  return svg.str();
}

std::string barChart(const std::string& title, const std::string& unit, const std::vector<std::string>& parts,
                     const std::vector<Bar>& bars)
{
  constexpr double kRoomForNumbers = 90;
  double longest = 0;
  for (const Bar& bar : bars) longest = std::max(longest, sumOf(bar));
  const double pixelsPerUnit = longest > 0 ? (kWidth - kBarStart - kRoomForNumbers) / longest : 0;
  Svg svg(kWidth, kBarTop + kBarPitch * static_cast<double>(bars.size()) + 10);
  svg.text({20, 26}, title, Anchor::Start, 16);
  drawParts(svg, parts);
  for (std::size_t k = 0; k < bars.size(); ++k)
    drawBar(svg, bars[k], kBarTop + kBarPitch * static_cast<double>(k), pixelsPerUnit, unit);
  return svg.str();
}

}  // namespace holdfast::paper
