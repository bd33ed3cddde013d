#include "holdfast/document/point_list_import.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

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

}  // namespace

ImportPreview previewImport(const ConstraintList& imported, const ConstraintList& present, const Model& model)
{
  std::set<std::string_view> taken;
  for (const Constraint& constraint : present.constraints) taken.insert(constraint.name);
  ImportPreview preview;
  double sum = 0;
  for (std::size_t k = 0; k < imported.constraints.size(); ++k) {
    const Constraint& constraint = imported.constraints[k];
    if (taken.contains(constraint.name)) ++preview.takenNames;
    const AtNear* near = nearPlaceOf(constraint);
    if (near == nullptr) {
      ++preview.others;
      continue;
    }
    const ClosestPointSearch::Result found = model.locator().closestTo(near->place);
    preview.points.push_back({static_cast<Index>(k), near->place, locationOf(found, model), found.distance});
    preview.maxDistance = std::max(preview.maxDistance, found.distance);
    sum += found.distance;
  }
  if (!preview.points.empty()) preview.meanDistance = sum / static_cast<double>(preview.points.size());
  return preview;
}

}  // namespace holdfast
