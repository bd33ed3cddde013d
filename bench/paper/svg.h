#pragma once
/// \file
/// Drawings as SVG files: white ground, one font.

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace holdfast::paper {

using Point2 = Eigen::Vector2d;

/// How a shape is drawn.
struct Stroke {
  std::string_view color = "#303642";
  double width = 1.5;
  std::string_view fill = "none";
  std::string_view dashes = "";  ///< of SVG: lengths of dashes and gaps
};

enum class Anchor { Start, Middle, End };

/// Colours that differ for people with any colour vision too (Okabe and Ito), first the ones that differ most.
[[nodiscard]] std::string_view seriesColor(std::size_t index);

/// A drawing of `width` x `height` pixels; y goes down.
class Svg {
 public:
  Svg(double width, double height);

  void polygon(const std::vector<Point2>& corners, const Stroke& stroke);
  void polyline(const std::vector<Point2>& points, const Stroke& stroke);
  void line(const Point2& from, const Point2& to, const Stroke& stroke) { polyline({from, to}, stroke); }
  void disc(const Point2& center, double radius, std::string_view color);
  /// `content` is text of SVG: no <, & but as entities. Turned by `degrees` about `at`.
  void text(const Point2& at, std::string_view content, Anchor anchor = Anchor::Start, double size = 14,
            std::string_view color = "#20242c", double degrees = 0);

  /// The whole file.
  [[nodiscard]] std::string str() const { return text_ + "</svg>\n"; }

 private:
  void path(const std::vector<Point2>& points, std::string_view element, const Stroke& stroke);

  std::string text_;
};

}  // namespace holdfast::paper
