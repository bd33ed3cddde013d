#include "bench/paper/svg.h"

#include <array>

#include <fmt/format.h>

namespace holdfast::paper {
namespace {

constexpr std::array<std::string_view, 8> kSeries{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#303642", "#8a6d3b"};
constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};

}  // namespace

std::string_view seriesColor(std::size_t index)
{
  return kSeries[index % kSeries.size()];
}

Svg::Svg(double width, double height)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
                        "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"sans-serif\">\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                        width, height))
{
}

void Svg::path(const std::vector<Point2>& points, std::string_view element, const Stroke& stroke)
{
  text_ += fmt::format("<{} points=\"", element);
  for (const Point2& point : points) text_ += fmt::format("{:.2f},{:.2f} ", point.x(), point.y());
  text_.back() = '"';
  text_ += fmt::format(" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\"", stroke.fill,
                       stroke.color, stroke.width);
  if (!stroke.dashes.empty()) text_ += fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes);
  text_ += "/>\n";
}

void Svg::polygon(const std::vector<Point2>& corners, const Stroke& stroke)
{
  path(corners, "polygon", stroke);
}

void Svg::polyline(const std::vector<Point2>& points, const Stroke& stroke)
{
  path(points, "polyline", stroke);
}

void Svg::disc(const Point2& center, double radius, std::string_view color)
{
  text_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:g}\" fill=\"{}\"/>\n", center.x(), center.y(), radius,
                       color);
}

void Svg::text(const Point2& at, std::string_view content, Anchor anchor, double size, std::string_view color,
               double degrees)
{
  text_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"", at.x(),
                       at.y(), size, color, kAnchors[static_cast<std::size_t>(anchor)]);
  if (degrees != 0) text_ += fmt::format(" transform=\"rotate({:g} {:.2f} {:.2f})\"", degrees, at.x(), at.y());
  text_ += fmt::format(">{}</text>\n", content);
}

}  // namespace holdfast::paper
