#pragma once
/// A field of a deformation colours the surface: it gives the values, their scale and its range.

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

/// The field by which a surface is coloured.
enum class ColorBy {
  None,                ///< one colour
  ConstraintResidual,  ///< how far constraints are from being met; logarithmic, with the promise marked
  Rotation,            ///< |q|, half the angle by which the detail is rotated, radians
  Angle,               ///< the whole angle of the rotation, degrees, not wrapped
  Displacement,        ///< the distance of each vertex from its place at rest
  Detail,              ///< how far the detail is from the rotated detail at rest
  /// How hard constraints pull, on a logarithmic scale. Only hard constraints give values.
  Force,
  DisplacementX,  ///< the displacement along x; it has a sign, as all fields below
  DisplacementY,
  DisplacementZ,
  DisplacementNormal,  ///< the displacement along the normal at rest; outwards is above 0
  AreaChange,          ///< change in area of the triangles at each vertex, percent of their area at rest
  EdgeChange           ///< change in length of the sides of these triangles, percent of their length at rest
};

/// Returns the names on command lines, in the order of `ColorBy`: "none", "constraint-residual", "rotation", ...
[[nodiscard]] std::span<const std::string_view> colorByNames();

/// Returns the field that has this name on command lines. An unknown name gives none.
[[nodiscard]] std::optional<ColorBy> colorByNamed(std::string_view name);

/// The numbers that colour a surface, and the scale that says what they mean.
struct Coloring {
  /// One number for each vertex of the file. It is NaN where there is none.
  std::vector<double> values;
  ColorScale scale;
  /// One number for each point of a `CutSurface`. Where there are any, these are drawn. Where it is empty, each point
  /// has the value of its vertex.
  std::vector<double> pointValues = {};
};

/// The points and triangles of a surface that is cut along its sharp edges. What is measured on faces has a value on
/// each side of such an edge.
struct CutSurface {
  const Polygons& triangles;           ///< the triangles over points, in the order of the triangles of the model
  const std::vector<Index>& vertexOf;  ///< the vertex of the file for each point
};

/// Returns the value at a point of the surface, as the point is coloured. It is NaN where a vertex of the point has no
/// value.
[[nodiscard]] double valueAt(const std::vector<double>& values, const SurfacePoint& point);

/// Returns the value at a place inside a face, from the values at the corners of the face. `pointValues` are those of
/// `Coloring`.
[[nodiscard]] double valueInFace(const std::vector<double>& pointValues, const AtFace& at, const Model& model,
                                 const CutSurface& surface);

/// Computes `Coloring::pointValues`. They are empty for fields that have one value at each vertex. O(T).
[[nodiscard]] std::vector<double> pointValuesOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                                const CutSurface& surface);

/// Makes the values and the scale of a field. `ColorBy::None` gives none. Displacements below `kPromisedResidual` of
/// the diagonal count as 0, and so do changes within rounding. `units` is the user's name of the model's length. It may
/// be empty.
///
///     const auto coloring = coloringOf(model, result, ColorBy::Displacement, "mm");
///     scene.color(coloring);  // SceneContents
///     scene.color(withRange(*coloring, FixedRange{0, 25}));
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                                 const std::string& units);

/// The scale keeps the range that `coloringOf` gave it.
struct AutomaticRange {};

/// The scale goes from `low` to `high`. Pictures that share a range can be compared.
struct FixedRange {
  double low = 0;
  double high = 1;
};

/// The scale begins at a power of ten and ends at the one above the largest value. It covers `decades` powers, 1 or
/// more.
struct LogarithmicRange {
  int decades = 4;
};

using ColorRange = std::variant<AutomaticRange, FixedRange, LogarithmicRange>;

/// Says in a sentence why there is no such range and what to do. Returns an empty text where the range can be used.
[[nodiscard]] std::string whyNoRange(const ColorRange& range);

/// Puts the values of `coloring` on a scale over `range`. `whyNoRange` of it must be empty. With a fixed range that
/// begins above 0, a logarithmic scale stays logarithmic. A logarithmic range changes nothing where no value is above
/// 0. O(N).
[[nodiscard]] Coloring withRange(Coloring coloring, const ColorRange& range);

}  // namespace holdfast
