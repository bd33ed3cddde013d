#include "holdfast/document/point_lists.h"

#include <set>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/guide_files.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

constexpr const char* kPointListHeader = "name,x,y,z,target_x,target_y,target_z";
constexpr const char* kClipboard = "clipboard";

std::string coordinates(const Vector3& place)
{
  return fmt::format("{},{},{}", NumberText(place.x()).view(), NumberText(place.y()).view(),
                     NumberText(place.z()).view());
}

std::string row(const std::string& name, const PointConstraint& point, const SurfaceLocator& locator,
                const Model& model)
{
  const Vector3 rest = positionOf(locator.locate(point.at, {name, 0, "at"}), model.mesh.positions);
  const AtNear* near = std::get_if<AtNear>(&point.at);
  return fmt::format("{},{},{}", csvField(name), coordinates(near == nullptr ? rest : near->place),
                     coordinates(placeOf(point, rest)));
}

/// The titles of all that the constraints say besides, in the order in which they come.
std::vector<std::string> extraTitles(const ConstraintList& list)
{
  std::vector<std::string> titles;
  for (const Constraint& constraint : list.constraints)
    for (const ExtraText& extra : constraint.extra)
      if (std::ranges::count(titles, extra.title) == 0) titles.push_back(extra.title);
  return titles;
}

std::string extraFields(const Constraint& constraint, const std::vector<std::string>& titles)
{
  std::string fields;
  for (const std::string& title : titles) {
    const auto found = std::ranges::find(constraint.extra, title, &ExtraText::title);
    fields += ',' + csvField(found == constraint.extra.end() ? "" : found->text);
  }
  return fields;
}

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
  for (const Index corner : model.triangulation.cornersOf(found.triangle))
    for (const Term& term : terms)
      if (model.mesh.faces[face][corner] == term.index) at.weights[corner] = term.coefficient;
  return at;
}

}  // namespace

std::string toClipboardText(const ConstraintList& list, const std::vector<Index>& indices, const Model& model)
{
  const ConstraintList part = extracted(list, indices);
  const bool isPoints = std::ranges::all_of(part.constraints, [](const Constraint& constraint) {
    return std::holds_alternative<PointConstraint>(constraint.what) && hasTarget(constraint);
  });
  if (!isPoints) return constraintsToJson(part);
  const SurfaceLocator locator = model.locator();
  const std::vector<std::string> titles = extraTitles(part);
  std::string csv = kPointListHeader;
  for (const std::string& title : titles) csv += ',' + csvField(title);
  for (const Constraint& constraint : part.constraints)
    csv += '\n' + row(constraint.name, std::get<PointConstraint>(constraint.what), locator, model) +
           extraFields(constraint, titles);
  return csv + '\n';
}

ConstraintList fromClipboardText(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.empty())
    throw InputError({kClipboard, 0, ""}, "there is no text to paste; copy constraints or a table of points first");
  if (!text.starts_with('{')) return parsePointListCsv(text, kClipboard);
  ConstraintList list = parseConstraintsJson(text, kClipboard);
  readGuideFiles(list, {}, kClipboard);
  return list;
}

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
