#include "holdfast/constraint_files/constraint_file.h"

#include <algorithm>
#include <map>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/constraint_files/guide_files.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/words/lower_case.h>

namespace holdfast {
namespace {

constexpr std::string_view kFormat = "holdfast-constraints";
constexpr Index kVersion = 2;
constexpr std::array<std::string_view, 4> kListKeys{"format", "version", "units", "constraints"};

void requireFormat(const JsonReader& document)
{
  if (document["format"].text() != kFormat)
    document["format"].fail("{} is expected here, this file says {}; is it a constraint file?", inQuotes(kFormat),
                            inQuotes(document["format"].text()));
  const Index version = document["version"].integer();
  if (version > kVersion)
    document["version"].fail(
        "version {} is newer than this program, which reads versions 1 to {}; write the file as version {} or use a "
        "newer program",
        version, kVersion, kVersion);
  if (version < 1) document["version"].fail("there is no version {}; versions are 1 to {}", version, kVersion);
}

std::vector<Constraint> readConstraintArray(const JsonReader& json)
{
  std::vector<Constraint> constraints;
  std::map<std::string, std::string, std::less<>> pathOf;  // by name
  for (std::size_t i = 0; i < json.size(); ++i) {
    const JsonReader element = json.element(i);
    constraints.push_back(readConstraint(element, i + 1));
    const std::string& name = constraints.back().name;
    const auto [first, isNew] = pathOf.try_emplace(name, element.path());
    if (isNew) continue;
    if (!element.has("name"))
      element.fail("its default name {} is that of {}; give it a name", inQuotes(name), first->second);
    element["name"].fail("{} is the name of {} already; names are unique", inQuotes(name), first->second);
  }
  return constraints;
}

/// Tells whether rings belong to a selection.
struct HasRings {
  bool operator()(const Grown& /*grown*/) const { return true; }
  bool operator()(const AllOf& all) const { return anyOf(all.parts); }
  bool operator()(const AnyOf& any) const { return anyOf(any.parts); }
  bool operator()(const NotIn& none) const { return std::visit(*this, none.part->what); }
  bool operator()(const auto& /*shape*/) const { return false; }

 private:
  [[nodiscard]] bool anyOf(const std::vector<Selection>& parts) const
  {
    return std::ranges::any_of(parts, [&](const Selection& part) { return std::visit(*this, part.what); });
  }
};

/// Tells the first version whose programs read a constraint, but for its selection.
struct FirstVersion {
  Index operator()(const HandleConstraint& handle) const { return handle.scale == Vector3::Ones() ? 1 : 2; }
  Index operator()(const PointConstraint& point) const
  {
    return point.hasTarget() && std::holds_alternative<Exactly>(point.within) ? 1 : 2;
  }
  Index operator()(const SlideConstraint& /*slide*/) const { return 2; }
  Index operator()(const CoincidentConstraint& /*coincident*/) const { return 2; }
  Index operator()(const MirrorConstraint& /*mirror*/) const { return 2; }
  Index operator()(const auto& /*other*/) const { return 1; }
};

/// Files are of the first version that has all of their constraints, so that older programs read them.
Index versionOf(const std::vector<Constraint>& constraints)
{
  Index version = 1;
  for (const Constraint& constraint : constraints) {
    version = std::max(version, std::visit(FirstVersion{}, constraint.what));
    const Selection* selection = selectionOf(constraint);
    if (selection != nullptr && std::visit(HasRings{}, selection->what)) version = kVersion;
  }
  return version;
}

std::string constraintArrayJson(const std::vector<Constraint>& constraints)
{
  std::string json;
  for (const Constraint& constraint : constraints)
    json += (json.empty() ? "\n    " : ",\n    ") + constraintJson(constraint);
  return json.empty() ? "[]" : fmt::format("[{}\n  ]", json);
}

}  // namespace

ConstraintList readConstraintDocument(const JsonReader& document)
{
  requireFormat(document);
  std::vector<std::string_view> keys(kListKeys.begin(), kListKeys.end());
  keys.insert(keys.end(), kSessionKeys.begin(), kSessionKeys.end());
  document.requireKeys(keys);
  ConstraintList list;
  if (document.has("units")) list.units = document["units"].text();
  list.constraints = readConstraintArray(document["constraints"]);
  return list;
}

ConstraintList parseConstraintsJson(std::string_view text, const std::string& name)
{
  const JsonValue root = parseJson(text, name);
  return readConstraintDocument(JsonReader(root, name));
}

bool isPointList(const std::filesystem::path& path, std::string_view text)
{
  const std::string extension = lowerCase(path.extension().string());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string_view::npos && text[first] == '{';
  return extension == kPointListExtensions[0] || (std::ranges::count(kPointListExtensions, extension) != 0 && !isJson);
}

ConstraintList readConstraints(const std::filesystem::path& path)
{
  const std::string text = readTextFile(path);
  if (isPointList(path, text)) return parsePointListCsv(text, path.string());
  ConstraintList list = parseConstraintsJson(text, path.string());
  readGuideFiles(list, path.parent_path(), path.string());
  return list;
}

std::string constraintMembersJson(const ConstraintList& list)
{
  const std::string units = list.units.empty() ? "" : fmt::format("\n  \"units\": {},", jsonText(list.units));
  return fmt::format(
      "\n  \"format\": \"holdfast-constraints\",\n  \"version\": {},{}\n"
      "  \"constraints\": {}\n",
      versionOf(list.constraints), units, constraintArrayJson(list.constraints));
}

std::string constraintsToJson(const ConstraintList& list)
{
  std::string json = fmt::format("{{{}}}\n", constraintMembersJson(list));
  requireReadable("constraint file", [&] { return parseConstraintsJson(json, ""); });
  return json;
}

}  // namespace holdfast
