#include "holdfast/widgets/color/coloring.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/fields.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// In the order of `ColorBy`.
constexpr std::array<std::string_view, 13> kNames{
    "none",       "constraint-residual", "rotation",       "angle",          "displacement",        "detail",
    "force",      "displacement-x",      "displacement-y", "displacement-z", "displacement-normal", "area-change",
    "edge-change"};
static_assert(kNames.size() == static_cast<std::size_t>(ColorBy::EdgeChange) + 1);

// Decades of the logarithmic scale below the promise and, at least, above it: residuals of a good solution are
// hundreds of times smaller than promised.
constexpr double kDecadesBelow = 5;
constexpr double kDecadesAbove = 1;

// Few vertices next to a pin bend far more than all others, and those of a moved selection may be torn out of their
// neighbourhood: the scale ends where this share of the vertices without constraints does.
constexpr double kDetailShare = 0.99;

// Decades of the logarithmic scale of forces below the largest: what is weaker hardly shows in the shape.
constexpr double kForceDecades = 4;

/// The largest finite value; 0 where there is none.
double largestOf(const std::vector<double>& values)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return std::isfinite(largest) ? largest : 0;
}

/// The value that `share` of the finite values do not exceed; 0 where there are none.
double quantile(std::vector<double> values, double share)
{
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// Percent. Coordinates are rounded by 1e-16 of the diagonal: sides of a millionth of it by 1e-8 percent.
constexpr double kRoundedPercent = 1e-7;

/// What is within rounding of 0 is 0: no picture of it says anything.
std::vector<double> withoutRounding(std::vector<double> values, double rounding)
{
  for (double& value : values)
    if (std::abs(value) <= rounding) value = 0;
  return values;
}

/// Of lengths in model units: constraints hold to no more.
double roundingOf(const Model& model)
{
  return kPromisedResidual * model.solverMesh.diagonal;
}

std::string inUnits(const std::string& title, const std::string& units)
{
  return units.empty() ? title : title + "\n[" + units + "]";
}

/// From 0; where all values are 0 as well, to 1.
ColorScale linearScale(std::string title, double high)
{
  return {std::move(title), Scaling::Linear, 0, high > 0 ? high : 1};
}

Coloring residualColoring(const Model& model, const DeformResult& deformation, const std::string& units)
{
  Field field = fieldOf(model, deformation, FieldKind::ConstraintResidual);
  const std::vector<double>& limits = deformation.details->diagnosis.limits;
  const double promise =
      limits.empty() ? kPromisedResidual * model.solverMesh.diagonal : *std::min_element(limits.begin(), limits.end());
  const double largest = largestOf(field.values);
  const double lowest = std::floor(std::log10(promise)) - kDecadesBelow;
  const double highest = std::ceil(std::log10(std::max(largest, promise * std::pow(10, kDecadesAbove))));
  ColorScale scale{inUnits("constraint residual", units), Scaling::Logarithmic, std::pow(10, lowest),
                   std::pow(10, highest)};
  scale.promise = promise;
  return {std::move(field.values), std::move(scale)};
}

Coloring linearColoring(const std::string& title, std::vector<double> values)
{
  ColorScale scale = linearScale(title, largestOf(values));
  return {std::move(values), std::move(scale)};
}

Coloring rotationColoring(const Model& model, const DeformResult& deformation, const std::string& /*units*/)
{
  std::vector<double> lengths;
  for (const Index unknown : model.solverMesh.weld.unknownOf)
    lengths.push_back(deformation.rotations.row(unknown).norm());
  return linearColoring(inUnits("rotation |q|", "rad"), std::move(lengths));
}

Coloring angleColoring(const Model& model, const DeformResult& deformation, const std::string& /*units*/)
{
  Coloring coloring = linearColoring(inUnits("rotation angle", "degrees"),
                                     fieldOf(model, deformation, FieldKind::RotationAngleDegrees).values);
  coloring.scale.steps = TickSteps::Degrees;
  return coloring;
}

/// Lengths of Lagrange multipliers have no units.
Coloring forceColoring(const Model& model, const DeformResult& deformation, const std::string& /*units*/)
{
  Field field = fieldOf(model, deformation, FieldKind::ConstraintForce);
  const double largest = largestOf(field.values);
  const double highest = largest > 0 ? std::ceil(std::log10(largest)) : 0;
  ColorScale scale{"force", Scaling::Logarithmic, std::pow(10, highest - kForceDecades), std::pow(10, highest)};
  return {std::move(field.values), std::move(scale)};
}

Coloring displacementColoring(const Model& model, const DeformResult& deformation, const std::string& units)
{
  std::vector<double> lengths(static_cast<std::size_t>(deformation.positions.rows()));
  parallelBlocks(deformation.positions.rows(), [&](Index v) {
    lengths[v] = (deformation.positions.row(v) - model.mesh.positions.row(v)).stableNorm();
  });
  return linearColoring(inUnits("displacement", units), withoutRounding(std::move(lengths), roundingOf(model)));
}

/// Zero in the middle: a map of two sides shows the sign.
Coloring signedColoring(std::string title, std::vector<double> values)
{
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  if (largest == 0) largest = 1;
  ColorScale scale{std::move(title), Scaling::Linear, -largest, largest};
  scale.map = ColorMap::BlueWhiteRed;
  scale.isSigned = true;
  return {std::move(values), std::move(scale)};
}

template <int Axis>
Coloring componentColoring(const Model& model, const DeformResult& deformation, const std::string& units)
{
  const Eigen::VectorXd along = deformation.positions.col(Axis) - model.mesh.positions.col(Axis);
  return signedColoring(inUnits(std::string("displacement ") + "xyz"[Axis], units),
                        withoutRounding({along.begin(), along.end()}, roundingOf(model)));
}

/// The way along the normal at rest that each point has moved. Its normal is that of the triangles over it.
std::vector<double> waysAlongNormals(const Model& model, const DeformResult& deformation, const CutSurface& surface)
{
  Positions normals = Positions::Zero(static_cast<Index>(surface.vertexOf.size()), 3);
  for (std::size_t t = 0; t < model.triangulation.triangles.size(); ++t) {
    const Vector3 area = areaVector(model.mesh.positions, model.triangulation.triangles[t]);
    for (const Index point : surface.triangles[static_cast<Index>(t)]) normals.row(point) += area;
  }
  std::vector<double> values;
  for (std::size_t point = 0; point < surface.vertexOf.size(); ++point) {
    const Index vertex = surface.vertexOf[point];
    values.push_back((deformation.positions.row(vertex) - model.mesh.positions.row(vertex))
                         .dot(unitOrZero(normals.row(static_cast<Index>(point)).transpose())));
  }
  return withoutRounding(std::move(values), roundingOf(model));
}

Coloring normalColoring(const Model& model, const DeformResult& deformation, const std::string& units)
{
  const SolverMesh& mesh = model.solverMesh;
  Positions normals = Positions::Zero(mesh.unknownCount(), 3);
  for (const Triangle& triangle : mesh.triangles) {
    const Vector3 area = areaVector(mesh.rest, triangle);
    for (const Index unknown : triangle) normals.row(unknown) += area;
  }
  std::vector<double> values;
  for (Index v = 0; v < deformation.positions.rows(); ++v)
    values.push_back((deformation.positions.row(v) - model.mesh.positions.row(v))
                         .dot(unitOrZero(normals.row(mesh.weld.unknownOf[v]).transpose())));
  return signedColoring(inUnits("displacement along\nthe normal", units),
                        withoutRounding(std::move(values), roundingOf(model)));
}

/// By how many percent the sum over the triangles at each of `count` points of `measure(positions, triangle)` is larger
/// than at rest; none where it is 0 there.
template <class PointsOf, class Measure>
std::vector<double> changes(const Model& model, const DeformResult& deformation, std::size_t count,
                            const PointsOf& pointsOf, const Measure& measure)
{
  std::vector<double> rest(count, 0);
  std::vector<double> values(count, 0);
  const std::vector<Triangle>& triangles = model.triangulation.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double before = measure(model.mesh.positions, triangles[t]);
    const double after = measure(deformation.positions, triangles[t]);
    for (const Index point : pointsOf(static_cast<Index>(t))) {
      rest[point] += before;
      values[point] += after;
    }
  }
  for (std::size_t k = 0; k < count; ++k)
    values[k] = rest[k] > 0 ? 100 * (values[k] / rest[k] - 1) : std::numeric_limits<double>::quiet_NaN();
  return withoutRounding(std::move(values), kRoundedPercent);
}

template <class Measure>
Coloring changeColoring(const Model& model, const DeformResult& deformation, const char* title, const Measure& measure)
{
  const auto cornersOf = [&](Index t) -> const Triangle& { return model.triangulation.triangles[t]; };
  return signedColoring(inUnits(title, "%"), changes(model, deformation, model.mesh.vertexCount(), cornersOf, measure));
}

double areaOf(const Positions& positions, const Triangle& triangle)
{
  return areaVector(positions, triangle).norm() / 2;
}

double sidesOf(const Positions& positions, const Triangle& triangle)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (positions.row(triangle[(k + 1) % 3]) - positions.row(triangle[k])).norm();
  return sum;
}

Coloring detailColoring(const Model& model, const DeformResult& deformation, const std::string& units)
{
  Field field = fieldOf(model, deformation, FieldKind::DetailResidual);
  const bool isLength = deformation.details->operators->weights == Weights::Uniform;
  const std::string unit = units.empty() || isLength ? units : "1/" + units;
  std::vector<double> free = field.values;
  const std::vector<double> residuals = fieldOf(model, deformation, FieldKind::ConstraintResidual).values;
  for (std::size_t v = 0; v < free.size(); ++v)
    if (!std::isnan(residuals[v])) free[v] = std::numeric_limits<double>::quiet_NaN();
  const double high = quantile(std::move(free), kDetailShare);
  return {std::move(field.values), linearScale(inUnits("detail residual", unit), high)};
}

Coloring areaColoring(const Model& model, const DeformResult& deformation, const std::string& /*units*/)
{
  return changeColoring(model, deformation, "change of area", areaOf);
}

Coloring edgeColoring(const Model& model, const DeformResult& deformation, const std::string& /*units*/)
{
  return changeColoring(model, deformation, "change of edge length", sidesOf);
}

/// The point of a corner of a face.
Index pointAt(const Model& model, const CutSurface& surface, Index face, Index vertex)
{
  const std::vector<int>& faceOf = model.triangulation.faceOf;
  const std::vector<Triangle>& triangles = model.triangulation.triangles;
  for (Index t = std::ranges::lower_bound(faceOf, face) - faceOf.begin();; ++t) {
    assert(faceOf[t] == face);  // each corner of a face is one of its triangles'
    const auto corner = std::ranges::find(triangles[t], vertex);
    if (corner != triangles[t].end()) return surface.triangles[t][corner - triangles[t].begin()];
  }
}

// In the order of `ColorBy`, without `None`.
constexpr std::array kColorings{residualColoring,     rotationColoring, angleColoring,        displacementColoring,
                                detailColoring,       forceColoring,    componentColoring<0>, componentColoring<1>,
                                componentColoring<2>, normalColoring,   areaColoring,         edgeColoring};
static_assert(kColorings.size() + 1 == kNames.size());

}  // namespace

std::span<const std::string_view> colorByNames()
{
  return kNames;
}

std::optional<ColorBy> colorByNamed(std::string_view name)
{
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<ColorBy>(found - kNames.begin());
}

double valueAt(const std::vector<double>& values, const SurfacePoint& point)
{
  double value = 0;
  for (const Term& term : point.terms) value += term.coefficient * values[term.index];
  return value;
}

double valueInFace(const std::vector<double>& pointValues, const AtFace& at, const Model& model,
                   const CutSurface& surface)
{
  const auto corners = model.mesh.faces[at.face];
  double value = 0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    value += at.weights[k] * pointValues[pointAt(model, surface, at.face, corners[k])];
  return value;
}

std::vector<double> pointValuesOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                  const CutSurface& surface)
{
  const auto pointsOf = [&](Index t) { return surface.triangles[t]; };
  const std::size_t count = surface.vertexOf.size();
  switch (colorBy) {
    case ColorBy::DisplacementNormal:
      return waysAlongNormals(model, deformation, surface);
    case ColorBy::AreaChange:
      return changes(model, deformation, count, pointsOf, areaOf);
    case ColorBy::EdgeChange:
      return changes(model, deformation, count, pointsOf, sidesOf);
    default:
      return {};
  }
}

std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                   const std::string& units)
{
  if (colorBy == ColorBy::None) return std::nullopt;
  return kColorings[static_cast<std::size_t>(colorBy) - 1](model, deformation, units);
}

std::string whyNoRange(const ColorRange& range)
{
  if (const auto* const decades = std::get_if<LogarithmicRange>(&range))
    return decades->decades >= 1 ? "" : "the range has no decade; give one or more";
  const auto* const fixed = std::get_if<FixedRange>(&range);
  if (fixed == nullptr) return {};
  if (!std::isfinite(fixed->low) || !std::isfinite(fixed->high) || !std::isfinite(fixed->high - fixed->low))
    return "the ends of the range are not finite numbers; give two that are";
  return fixed->low < fixed->high ? "" : "the range does not end above where it begins; give a larger end";
}

Coloring withRange(Coloring coloring, const ColorRange& range)
{
  assert(whyNoRange(range).empty());
  ColorScale& scale = coloring.scale;
  if (const auto* const fixed = std::get_if<FixedRange>(&range)) {
    scale.low = fixed->low;
    scale.high = fixed->high;
    scale.outside = Outside::Marked;
    if (fixed->low <= 0) scale.scaling = Scaling::Linear;
  } else if (const auto* const decades = std::get_if<LogarithmicRange>(&range)) {
    const double end = std::ceil(std::log10(largestOf(coloring.values)));
    const double low = std::pow(10, end - decades->decades);
    const double high = std::pow(10, end);
    if (!(low > 0) || !std::isfinite(high)) return coloring;
    scale.scaling = Scaling::Logarithmic;
    // All of it is on one side of 0.
    if (std::exchange(scale.isSigned, false)) scale.map = ColorScale().map;
    scale.low = low;
    scale.high = high;
  }
  return coloring;
}

}  // namespace holdfast
