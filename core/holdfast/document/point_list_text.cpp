#include "holdfast/document/point_list_text.h"

#include <algorithm>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

constexpr const char* kPointListHeader = "name,x,y,z,target_x,target_y,target_z\n";
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
  const Target* target = std::get_if<Target>(&point.to);
  return fmt::format("{},{},{}\n", csvField(name), coordinates(near == nullptr ? rest : near->place),
                     coordinates(target == nullptr ? rest + std::get<Move>(point.to).shift : target->place));
}

bool hasTabs(std::string_view text)
{
  const std::string_view firstLine = text.substr(0, text.find_first_of("\r\n"));
  return firstLine.find('\t') != std::string_view::npos && firstLine.find(',') == std::string_view::npos;
}

}  // namespace

std::string toPointListCsv(const ConstraintList& list, const std::vector<Index>& indices, const Model& model)
{
  const SurfaceLocator locator = model.locator();
  std::string csv = kPointListHeader;
  for (const Constraint& constraint : extracted(list, indices).constraints)
    csv += row(constraint.name, std::get<PointConstraint>(constraint.what), locator, model);
  return csv;
}

std::string toClipboardText(const ConstraintList& list, const std::vector<Index>& indices, const Model& model)
{
  const ConstraintList part = extracted(list, indices);
  const bool isPoints = std::all_of(part.constraints.begin(), part.constraints.end(), [](const Constraint& constraint) {
    return std::holds_alternative<PointConstraint>(constraint.what);
  });
  return isPoints ? toPointListCsv(list, indices, model) : constraintsToJson(part);
}

ConstraintList fromClipboardText(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.empty())
    throw InputError({kClipboard, 0, ""}, "there is no text to paste; copy constraints or a table of points first");
  if (text.starts_with('{')) return parseConstraintsJson(text, kClipboard);
  return parsePointListCsv(text, kClipboard, hasTabs(text) ? '\t' : ',');
}

}  // namespace holdfast
