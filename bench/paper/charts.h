#pragma once
/// \file
/// Curves and bars of measured numbers, as SVG.

#include <string>
#include <utility>
#include <vector>

namespace holdfast::paper {

enum class Scale { Linear, Log };

struct Axis {
  std::string label;  ///< with its unit
  Scale scale = Scale::Linear;
};

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< x ascending; on a logarithmic axis above 0
};

/// Points joined by lines over axes that reach as far as they do (a linear y axis from 0 where nothing is below), with
/// a legend. What is not finite, or not above 0 on a logarithmic axis, is left out.
[[nodiscard]] std::string curveChart(const std::string& title, const Axis& x, const Axis& y,
                                     const std::vector<Curve>& curves);

/// A bar with its parts, which lie one after the other.
struct Bar {
  std::string name;
  std::vector<double> parts;  ///< not negative
};

/// Bars that lie, a line each, with the names of their parts as legend and their sums at their ends.
[[nodiscard]] std::string barChart(const std::string& title, const std::string& unit,
                                   const std::vector<std::string>& parts, const std::vector<Bar>& bars);

}  // namespace holdfast::paper
