#include "holdfast/document/point_list_import.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

using Names = std::set<std::string, std::less<>>;

const AtNear* nearPlaceOf(const Constraint& constraint)
{
  const PointConstraint* point = std::get_if<PointConstraint>(&constraint.what);
  return point == nullptr ? nullptr : std::get_if<AtNear>(&point->at);
}

SurfaceLocation locationOf(const ClosestPointSearch::Result& found, const Model& model)
{
  const std::vector<Term>& terms = found.point.terms;
  if (terms.size() == 1) return AtVertex{terms[0].index};
  if (terms.size() == 2) return AtEdge{terms[0].index, terms[1].index, terms[0].coefficient};
  const Index face = model.triangulation.faceOf[found.triangle];
  AtFace at{face, std::vector<double>(model.mesh.faces[face].size(), 0.0)};
  for (const Index corner : model.triangulation.corners[found.triangle])
    for (const Term& term : terms)
      if (model.mesh.faces[face][corner] == term.index) at.weights[corner] = term.coefficient;
  return at;
}

ImportedPoint examined(const Vector3& place, const Model& model)
{
  const ClosestPointSearch::Result found = model.locator().closestTo(place);
  ImportedPoint point;
  point.place = place;
  point.onSurface = positionOf(found.point, model.mesh.positions);
  point.at = locationOf(found, model);
  point.distance = found.distance;
  return point;
}

/// The middle of a list that is not empty; the mean of both where there are two.
double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<Index>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  const double below = *std::max_element(values.begin(), middle);
  return below + (*middle - below) / 2;
}

void summarize(ImportPreview& preview, double tolerance)
{
  std::vector<double> distances;
  for (const ImportedPoint& point : preview.points) distances.push_back(point.distance);
  if (distances.empty()) return;
  preview.maxDistance = *std::max_element(distances.begin(), distances.end());
  preview.meanDistance =
      std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
  preview.medianDistance = median(distances);
  preview.fartherThanTolerance =
      std::count_if(distances.begin(), distances.end(), [&](double distance) { return distance > tolerance; });
}

}  // namespace

ImportPreview previewImport(const ConstraintList& imported, const ConstraintList& present, const Model& model,
                            double tolerance)
{
  Names taken;
  for (const Constraint& constraint : present.constraints) taken.insert(constraint.name);
  ImportPreview preview;
  for (std::size_t k = 0; k < imported.constraints.size(); ++k) {
    const Constraint& constraint = imported.constraints[k];
    const bool isTaken = taken.contains(constraint.name);
    if (isTaken) ++preview.takenNames;
    const AtNear* near = nearPlaceOf(constraint);
    if (near == nullptr) {
      ++preview.others;
      continue;
    }
    ImportedPoint& point = preview.points.emplace_back(examined(near->place, model));
    point.index = static_cast<Index>(k);
    point.name = constraint.name;
    point.isNameTaken = isTaken;
  }
  summarize(preview, tolerance);
  return preview;
}

}  // namespace holdfast
