#pragma once
/// The fields that colour a surface: values, scale and range.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

enum class ColorBy {
  None,                ///< one colour
  ConstraintResidual,  ///< how far constraints are from being met; logarithmic, the promise marked
  Rotation,            ///< |q|, half the angle by which the detail is rotated, radians
  Angle,               ///< the whole of it, degrees, not wrapped
  Displacement,        ///< the length of the way from rest
  Detail,              ///< how far the detail is from the rotated one at rest
  Force,               ///< how hard constraints pull; logarithmic. Of hard constraints only, else nowhere a value
  DisplacementX,       ///< the part of the way from rest along x; with both signs, as all that follow
  DisplacementY,
  DisplacementZ,
  DisplacementNormal,  ///< that along the surface's normal at rest: outwards is above 0
  AreaChange,          ///< of the triangles at each vertex, as a share of their area at rest, percent
  EdgeChange           ///< of the lengths of their sides, likewise
};

/// The names on command lines, in the order of `ColorBy`: "none", "constraint-residual", "rotation", ...
[[nodiscard]] std::span<const std::string_view> colorByNames();

[[nodiscard]] std::optional<ColorBy> colorByNamed(std::string_view name);

/// One number for each vertex of the file, NaN where there is none, and what they mean as colours.
struct Coloring {
  std::vector<double> values;
  ColorScale scale;
  std::vector<double> pointValues = {};  ///< of each point of a `CutSurface`, which are drawn; empty: as at vertices
};

/// A surface cut along its sharp edges, over points: what is measured on faces has a value on each side of an edge.
struct CutSurface {
  const Polygons& triangles;           ///< over points, in the order of the model's
  const std::vector<Index>& vertexOf;  ///< of the file, for each point
};

/// The value at a point of the surface, as it is coloured; NaN where a vertex of it has none.
[[nodiscard]] double valueAt(const std::vector<double>& values, const SurfacePoint& point);

/// The same inside a face, by the values of its corners.
[[nodiscard]] double valueInFace(const std::vector<double>& pointValues, const AtFace& at, const Model& model,
                                 const CutSurface& surface);

/// For `Coloring::pointValues`: empty for fields of which a vertex has one value. O(T).
[[nodiscard]] std::vector<double> pointValuesOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                                const CutSurface& surface);

/// None for `ColorBy::None`. Displacements below `kPromisedResidual` of the diagonal, and changes within rounding, are
/// 0. `units` is the user's name of the model's length; it may be empty.
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                                 const std::string& units);

/// The range that a colouring has by itself.
struct AutomaticRange {};

/// From one value to another: two pictures of one range can be compared.
struct FixedRange {
  double low = 0;
  double high = 1;
};

/// Powers of ten from that above the largest value down by `decades`, 1 or more.
struct LogarithmicRange {
  int decades = 4;
};

using ColorRange = std::variant<AutomaticRange, FixedRange, LogarithmicRange>;

/// Why there is no such range, in a sentence that says what to do; empty where there is one.
[[nodiscard]] std::string whyNoRange(const ColorRange& range);

/// The same values on a scale over `range`, for which `whyNoRange` is empty. A fixed range keeps its scale logarithmic
/// where it begins above 0; a logarithmic one changes nothing where no value is above 0. O(N).
[[nodiscard]] Coloring withRange(Coloring coloring, const ColorRange& range);

}  // namespace holdfast
