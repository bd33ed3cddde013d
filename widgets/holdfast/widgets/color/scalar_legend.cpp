#include "holdfast/widgets/color/scalar_legend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

namespace holdfast {
namespace {

constexpr Color kInk{0.13, 0.15, 0.19};
constexpr int kBarSteps = 256;
constexpr int kDiscCorners = 48;
constexpr int kMostTicks = 7;
constexpr int kMostBorders = 10;

// From an end of the bar, in sizes of the text.
constexpr double kOutsideAt = 1.3;

// So many roundings at most, each of the size of the ends, lie between a multiple of the step and the end that it is.
constexpr double kRoundings = 4;
// Seen on no screen: a share of the step.
constexpr double kBesideEnd = 1e-9;
constexpr double kLeastDigits = 6;
// From 0 to an end. Rounding moves a tick by a thousandth of a step at most.
constexpr double kMostStepsFromZero = 1e12;

/// Shapes in pixels of the window, a colour a point.
class Shape {
 public:
  Shape()
  {
    colors_->SetNumberOfComponents(3);
    data_->SetPoints(points_);
    data_->SetPolys(cells_);
    data_->GetPointData()->SetScalars(colors_);
  }

  vtkIdType add(double x, double y, const Color& color)
  {
    colors_->InsertNextTuple3(std::round(255 * color.red), std::round(255 * color.green), std::round(255 * color.blue));
    return points_->InsertNextPoint(x, y, 0);
  }

  void addPolygon(const std::vector<vtkIdType>& corners)
  {
    cells_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }

  void addRectangle(double left, double bottom, double right, double top, const Color& color)
  {
    addPolygon({add(left, bottom, color), add(right, bottom, color), add(right, top, color), add(left, top, color)});
  }

  void show(vtkRenderer& renderer) const
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data_);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    renderer.AddActor2D(actor);
  }

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

enum class TextWeight { Normal, Bold };
enum class TextAnchor { Top, Middle };

struct TextStyle {
  double size;
  TextWeight weight = TextWeight::Normal;
  TextAnchor anchor = TextAnchor::Middle;
};

void addText(vtkRenderer& renderer, const std::string& text, double x, double y, const TextStyle& style)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  vtkTextProperty& property = *actor->GetTextProperty();
  property.SetFontFamilyToArial();
  property.SetFontSize(static_cast<int>(std::lround(style.size)));
  property.SetBold(style.weight == TextWeight::Bold);
  property.SetColor(kInk.red, kInk.green, kInk.blue);
  property.SetLineSpacing(1.2);
  style.anchor == TextAnchor::Top ? property.SetVerticalJustificationToTop()
                                  : property.SetVerticalJustificationToCentered();
  renderer.AddActor2D(actor);
}

void addDisc(Shape& shape, double x, double y, double radius, const Color& color)
{
  std::vector<vtkIdType> corners;
  for (int k = 0; k < kDiscCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDiscCorners;
    corners.push_back(shape.add(x + radius * std::cos(angle), y + radius * std::sin(angle), color));
  }
  shape.addPolygon(corners);
}

/// The smallest round number of degrees, or of whole turns, that is no less than `least`.
double degreeStep(double least)
{
  if (least <= 10) return roundStep(least);
  for (const double degrees : {15.0, 30.0, 45.0, 90.0, 180.0})
    if (degrees >= least) return degrees;
  return 360 * roundStep(std::max(1.0, least / 360));
}

std::vector<Tick> endTicks(const ColorScale& scale)
{
  return {{scale.low, fmt::format("{}", scale.low)}, {scale.high, fmt::format("{}", scale.high)}};
}

std::vector<Tick> linearTicks(const ColorScale& scale)
{
  // One by one: the difference of the ends may be no number.
  const double least = scale.high / (kMostTicks - 1) - scale.low / (kMostTicks - 1);
  const double step = scale.steps == TickSteps::Degrees ? degreeStep(least) : roundStep(least);
  const double steps = std::max(std::abs(scale.low), std::abs(scale.high)) / step;
  // No multiple of a finer step is rounder than the ends, and beyond 2^53 not every multiple is a number.
  if (!(steps <= kMostStepsFromZero)) return endTicks(scale);
  const double beside = std::max(kBesideEnd, kRoundings * std::numeric_limits<double>::epsilon() * steps);
  const double first = std::ceil(scale.low / step - beside);
  const double last = std::floor(scale.high / step + beside);
  // Neighbours differ in their texts.
  const int digits = static_cast<int>(std::max(kLeastDigits, std::ceil(std::log10(steps)) + 1));
  std::vector<Tick> ticks;
  for (int k = 0; k <= last - first; ++k) {
    // No sum is -0.
    const double value = (first + k) * step + 0.0;
    ticks.push_back({value, fmt::format("{:.{}g}", value, digits)});
  }
  return ticks;
}

std::vector<Tick> decadeTicks(const ColorScale& scale)
{
  const double first = std::ceil(std::log10(scale.low) - 1e-9);
  const double last = std::floor(std::log10(scale.high) + 1e-9);
  const double step = std::max(1.0, std::ceil((last - first) / (kMostTicks - 1)));
  std::vector<Tick> ticks;
  for (double power = first; power <= last; power += step)
    ticks.push_back({std::pow(10, power), power == 0 ? "1" : fmt::format("1e{:.0f}", power)});
  return ticks;
}

/// The share of a class border's value that is rounding of the sum that makes it.
constexpr double kBorderRounding = 1e-9;

/// Digits that tell the borders of equal classes apart.
int digitsOfBorders(const ColorScale& scale, double width)
{
  const double largest = std::max(std::abs(scale.low), std::abs(scale.high));
  return std::clamp(static_cast<int>(std::ceil(std::log10(largest / width))) + 2, 3, 9);
}

double borderOf(const ColorScale& scale, double share)
{
  if (scale.scaling == Scaling::Logarithmic) return scale.low * std::pow(scale.high / scale.low, share);
  const double value = std::lerp(scale.low, scale.high, share);
  return std::abs(value) < kBorderRounding * (scale.high - scale.low) ? 0 : value;
}

/// Each `step`-th border, where that is a round part of all of them from end to end.
int borderStep(int bands)
{
  int step = (bands + kMostBorders - 1) / kMostBorders;
  while (bands % step != 0 && step < 2 * bands / kMostBorders) ++step;
  return step;
}

/// Returns a tick at each place where colours change.
std::vector<Tick> borderTicks(const ColorScale& scale)
{
  const bool isLinear = scale.scaling == Scaling::Linear;
  const int digits = isLinear ? digitsOfBorders(scale, (scale.high - scale.low) / scale.bands) : 3;
  std::vector<Tick> ticks;
  for (int k = 0, step = borderStep(scale.bands); k <= scale.bands; k += step) {
    const double value = borderOf(scale, k / static_cast<double>(scale.bands));
    ticks.push_back({value, fmt::format("{:.{}g}", value, digits)});
  }
  return ticks;
}

struct Bar {
  double left;
  double right;
  double bottom;
  double top;

  [[nodiscard]] double heightOf(double share) const { return bottom + share * (top - bottom); }
};

void addColors(Shape& shape, const Bar& bar, const ColorScale& scale)
{
  for (int k = 0; k < kBarSteps; ++k) {
    const double low = bar.heightOf(k / static_cast<double>(kBarSteps));
    const double high = bar.heightOf((k + 1) / static_cast<double>(kBarSteps));
    shape.addRectangle(bar.left, low, bar.right, high, colorAt(scale, (k + 0.5) / kBarSteps));
  }
}

/// What is not on the scale, below the bar and above it.
void addOutside(vtkRenderer& renderer, Shape& shape, const Bar& bar, double textSize)
{
  const auto add = [&](double middle, const Color& color, const char* text) {
    shape.addRectangle(bar.left, middle - 0.4 * textSize, bar.right, middle + 0.4 * textSize, color);
    addText(renderer, text, bar.right + 0.8 * textSize, middle, {textSize});
  };
  add(bar.bottom - kOutsideAt * textSize, kBelowColor, "below");
  add(bar.top + kOutsideAt * textSize, kBeyondColor, "beyond");
}

void addTicks(vtkRenderer& renderer, Shape& shape, const ColorScale& scale, const Bar& bar, double textSize)
{
  const double line = std::max(1.0, std::round(textSize / 12));
  const auto addTick = [&](double value, const std::string& text, double from, TextWeight weight) {
    const double y = std::round(bar.heightOf(shareOf(scale, value)));
    shape.addRectangle(from, y - line / 2, bar.right + 0.45 * textSize, y + line / 2, kInk);
    addText(renderer, text, bar.right + 0.8 * textSize, y, {textSize, weight});
  };
  // Numbers that would run into the mark of the promise give way.
  const double room = 1.3 * textSize / (bar.top - bar.bottom);
  for (const Tick& tick : ticksOf(scale))
    if (!scale.promise || std::abs(shareOf(scale, tick.value) - shareOf(scale, *scale.promise)) > room)
      addTick(tick.value, tick.text, bar.right, TextWeight::Normal);
  if (scale.promise)
    addTick(*scale.promise, fmt::format("{:.1e} promised", *scale.promise), bar.left, TextWeight::Bold);
}

void addKey(vtkRenderer& renderer, const std::vector<KeyEntry>& key, const LegendPlace& place, double bottom)
{
  Shape shape;
  const double radius = 0.36 * place.textSize;
  for (std::size_t k = 0; k < key.size(); ++k) {
    const double y = bottom + (static_cast<double>(key.size() - k) - 0.5) * 1.7 * place.textSize;
    addDisc(shape, place.left + radius, y, radius * 1.18, kInk);
    addDisc(shape, place.left + radius, y, radius, key[k].color);
    addText(renderer, key[k].text, place.left + 1.3 * place.textSize, y, {place.textSize});
  }
  shape.show(renderer);
}

}  // namespace

double roundStep(double least)
{
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

std::vector<Tick> ticksOf(const ColorScale& scale)
{
  if (scale.bands >= 2) return borderTicks(scale);
  return scale.scaling == Scaling::Linear ? linearTicks(scale) : decadeTicks(scale);
}

void addLegend(vtkRenderer& renderer, const LegendContents& contents, const LegendPlace& place)
{
  const double margin = 2.2 * place.textSize;
  const double keyHeight = static_cast<double>(contents.key.size()) * 1.7 * place.textSize;
  addKey(renderer, contents.key, place, margin);
  if (!contents.scale) return;
  const auto titleLines = 1 + std::count(contents.scale->title.begin(), contents.scale->title.end(), '\n');
  const double titleBottom = place.height - margin - (1.35 * static_cast<double>(titleLines) + 0.9) * place.textSize;
  const double barBottom = margin + keyHeight + (contents.key.empty() ? 0 : 1.8 * place.textSize);
  addText(renderer, contents.scale->title, place.left, place.height - margin,
          {place.textSize * 1.05, TextWeight::Bold, TextAnchor::Top});
  const bool isMarked = contents.scale->outside == Outside::Marked;
  const double room = isMarked ? (kOutsideAt + 0.8) * place.textSize : 0;
  const Bar bar{place.left, place.left + 1.3 * place.textSize, std::round(barBottom + room),
                std::round(titleBottom - room)};
  Shape shape;
  addColors(shape, bar, *contents.scale);
  if (isMarked) addOutside(renderer, shape, bar, place.textSize);
  addTicks(renderer, shape, *contents.scale, bar, place.textSize);
  shape.show(renderer);
}

}  // namespace holdfast
