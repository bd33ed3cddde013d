#include <array>
#include <map>

#include <fmt/format.h>

#include <holdfast/base/lower_case.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/io/files/file_bytes.h>

namespace holdfast {
namespace {

using Keys = std::span<const std::string_view>;
using What = decltype(Constraint::what);

constexpr std::string_view kFormat = "holdfast-constraints";
constexpr Index kVersion = 1;
constexpr std::array<std::string_view, 8> kDocumentKeys{
    "format", "version", "units", "constraints", kSessionKeys[0], kSessionKeys[1], kSessionKeys[2], kSessionKeys[3]};

/// A type of constraint: its name in files, the keys it may have, and what reads it.
struct Type {
  std::string_view name;
  Keys keys;
  What (*read)(const JsonReader&);
};

constexpr std::array<std::string_view, 4> kRegionKeys{"type", "name", "enabled", "select"};
constexpr std::array<std::string_view, 11> kHandleKeys{"type",  "name",    "enabled",   "select",    "rotate",   "turn",
                                                       "frame", "targets", "translate", "turn_near", "rotations"};
constexpr std::array<std::string_view, 6> kPointKeys{"type", "name", "enabled", "at", "target", "move"};
constexpr std::array<std::string_view, 6> kRelativeKeys{"type", "name", "enabled", "from", "to", "offset"};
constexpr std::array<std::string_view, 2> kDestinations{"target", "move"};

/// A constraint that is its selection alone.
template <class Region>
What readRegion(const JsonReader& json)
{
  return Region{readSelection(json["select"])};
}

What readPoint(const JsonReader& json)
{
  PointConstraint point{readLocation(json["at"]), {}};
  if (json.oneKeyOf(kDestinations) == "target")
    point.to = Target{json["target"].vector()};
  else
    point.to = Move{json["move"].vector()};
  return point;
}

What readRelative(const JsonReader& json)
{
  RelativeConstraint relative{readLocation(json["from"]), readLocation(json["to"]), std::nullopt};
  if (json.has("offset")) relative.offset = json["offset"].vector();
  return relative;
}

constexpr std::array<Type, 5> kTypes{
    {{"fixed", kRegionKeys, readRegion<FixedConstraint>},
     {"handle", kHandleKeys, [](const JsonReader& json) { return What(readHandle(json)); }},
     {"point", kPointKeys, readPoint},
     {"rigid", kRegionKeys, readRegion<RigidConstraint>},
     {"relative", kRelativeKeys, readRelative}}};

Type readType(const JsonReader& json)
{
  const std::string& name = json.text();
  for (const Type& type : kTypes)
    if (type.name == name) return type;
  std::array<std::string_view, kTypes.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kTypes[i].name;
  json.fail("unknown type {}{}", inQuotes(name), spellingHint(name, names));
}

/// The name, or the default for the constraint at `place`, counted from 1.
std::string readName(const JsonReader& json, std::string_view type, std::size_t place)
{
  if (!json.has("name")) return fmt::format("{} {}", type, place);
  const JsonReader name = json["name"];
  if (name.text().empty()) name.fail("the name is empty; leave the key out for the default name");
  return name.text();
}

Constraint readConstraint(const JsonReader& json, std::size_t place)
{
  const Type type = readType(json["type"]);
  json.requireKeys(type.keys);
  const bool isEnabled = !json.has("enabled") || json["enabled"].boolean();
  return {readName(json, type.name, place), isEnabled, type.read(json)};
}

void requireFormat(const JsonReader& document)
{
  if (document["format"].text() != kFormat)
    document["format"].fail("{} is expected here, this file says {}; is it a constraint file?", inQuotes(kFormat),
                            inQuotes(document["format"].text()));
  const Index version = document["version"].integer();
  if (version > kVersion)
    document["version"].fail(
        "version {} is newer than this program, which reads version {}; write the file as version {} or use a newer "
        "program",
        version, kVersion, kVersion);
  if (version < kVersion) document["version"].fail("there is no version {}; the version is {}", version, kVersion);
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

}  // namespace

ConstraintList readConstraintDocument(const JsonReader& document)
{
  requireFormat(document);
  document.requireKeys(kDocumentKeys);
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

bool isPointList(const std::filesystem::path& path)
{
  return lowerCase(path.extension().string()) == ".csv";
}

ConstraintList readConstraints(const std::filesystem::path& path)
{
  const std::string text = readTextFile(path);
  return isPointList(path) ? parsePointListCsv(text, path.string()) : parseConstraintsJson(text, path.string());
}

}  // namespace holdfast
