#include "holdfast/document/session_file.h"

#include <system_error>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/constraint_files/guide_files.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/io/files/output_file.h>

namespace holdfast {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kProjections{"perspective", "parallel"};

/// Calls `visit(key, member)` for the members of a view, in the order of files.
template <class View, class Visitor>
void forEachMember(View& view, Visitor&& visit)
{
  visit("camera", view.camera);
  visit("up_axis", view.upAxis);
  visit("color_by", view.colorBy);
  visit("range", view.range);
  visit("scale", view.scale);
  visit("decades", view.decades);
  visit("color_map", view.colorMap);
  visit("bands", view.bands);
  visit("legend", view.legend);
  visit("decimals", view.decimals);
  visit("rest_shape", view.restShape);
  visit("mesh_edges", view.meshEdges);
  visit("surface", view.surface);
  visit("hidden_faces", view.hiddenFaces);
}

/// The same for those below "glyphs".
template <class View, class Visitor>
void forEachGlyph(View& view, Visitor&& visit)
{
  visit("constraints", view.showsConstraints);
  visit("rotations", view.showsRotations);
}

std::string textNotEmpty(const JsonReader& json)
{
  if (json.text().empty()) json.fail("the text is empty; leave the key out, or say what is meant");
  return json.text();
}

/// Empty where the key is missing.
std::string textOf(const JsonReader& json, std::string_view key)
{
  return json.has(key) ? textNotEmpty(json[key]) : std::string();
}

double positive(const JsonReader& json)
{
  if (!(json.number() > 0)) json.fail("{} is not above 0", json.number());
  return json.number();
}

template <class Choice, std::size_t Count>
Choice chosen(const JsonReader& json, const std::array<Choice, Count>& choices)
{
  std::array<std::string_view, Count> names;
  std::ranges::transform(choices, names.begin(), [](Choice choice) { return name(choice); });
  return choices[json.choice(names, "{} is not known here")];
}

Backend readBackend(const JsonReader& json)
{
  const auto backend = chosen(json, kAllBackends);
  if (!isBuilt(backend))
    json.fail("this program was built without CHOLMOD; leave the key out for the best backend that there is");
  return backend;
}

StatedOptions readOptions(const JsonReader& json)
{
  json.requireKeys(
      {"weights", "solver", "soft_weight", "backend", "rotations", "rotation_change", "near_limit", "weld"});
  StatedOptions options;
  if (json.has("weights")) options.weights = chosen(json["weights"], kAllWeights);
  if (json.has("solver")) options.solver = chosen(json["solver"], kAllSolvers);
  if (json.has("soft_weight")) options.softWeight = positive(json["soft_weight"]);
  if (json.has("backend")) options.backend = readBackend(json["backend"]);
  if (json.has("rotations")) options.rotations = chosen(json["rotations"], kAllRotations);
  if (json.has("rotation_change")) options.rotationChange = positive(json["rotation_change"]);
  if (json.has("near_limit")) options.nearLimit = positive(json["near_limit"]);
  if (json.has("weld")) options.weldTolerance = positive(json["weld"]);
  return options;
}

constexpr std::string_view kAlgorithm = "fnv1a64:";
constexpr std::size_t kDigits = 16;

bool isChecksum(std::string_view text)
{
  if (!text.starts_with(kAlgorithm) || text.size() != kAlgorithm.size() + kDigits) return false;
  return text.find_first_not_of("0123456789abcdef", kAlgorithm.size()) == std::string_view::npos;
}

MeshReference readMeshReference(const JsonReader& json)
{
  json.requireKeys({"path", "absolute_path", "checksum"});
  MeshReference mesh{textNotEmpty(json["path"]), textOf(json, "absolute_path"), textOf(json, "checksum")};
  if (!mesh.checksum.empty() && !isChecksum(mesh.checksum))
    json["checksum"].fail(
        "{} is not \"fnv1a64:\" and 16 hexadecimal digits; leave the key out where the checksum is not known",
        inQuotes(mesh.checksum));
  return mesh;
}

void read(const JsonReader& json, std::string& text)
{
  text = textNotEmpty(json);
}

void read(const JsonReader& json, bool& isShown)
{
  isShown = json.boolean();
}

void read(const JsonReader& json, Camera& camera)
{
  json.requireKeys({"position", "focal_point", "view_up", "parallel_scale", "projection"});
  camera.position = json["position"].vector();
  camera.focalPoint = json["focal_point"].vector();
  if (camera.position == camera.focalPoint)
    json["focal_point"].fail("this is the camera's own place; name a point that it looks at");
  camera.viewUp = json["view_up"].direction();
  if (json.has("parallel_scale")) camera.parallelScale = positive(json["parallel_scale"]);
  if (json.has("projection"))
    camera.isParallel = json["projection"].choice(kProjections, "{} is not a projection") == 1;
}

void read(const JsonReader& json, std::array<double, 2>& range)
{
  json.requireSize(2, "[low, high]");
  range = {json.element(0).number(), json.element(1).number()};
  if (!(range[0] < range[1])) json.fail("low is not below high; leave the key out for an automatic range");
}

void read(const JsonReader& json, Index& count)
{
  count = json.integer();
  if (count < 1) json.fail("{} is not above 0", count);
}

void read(const JsonReader& json, int& decimals)
{
  const Index typed = json.integer();
  if (typed < 0 || typed > kMostLengthDecimals)
    json.fail("{} decimals cannot be shown; give 0 to {}", typed, kMostLengthDecimals);
  decimals = static_cast<int>(typed);
}

void read(const JsonReader& json, std::vector<std::array<Index, 2>>& ranges)
{
  ranges = json.list([](const JsonReader& range) {
    range.requireSize(2, "[first, last]");
    const std::array ends{range.element(0).id(), range.element(1).id()};
    if (ends[0] > ends[1]) range.fail("{} is not below {}; give the first and the last face", ends[0], ends[1]);
    return ends;
  });
}

/// Reads the members that `forEach` visits. An object has no keys but theirs and `others`.
template <class ForEach>
void readMembers(const JsonReader& json, const ForEach& forEach, std::initializer_list<std::string_view> others)
{
  std::vector<std::string_view> keys;
  forEach([&](const char* key, auto& /*member*/) { keys.emplace_back(key); });
  keys.insert(keys.end(), others);
  json.requireKeys(keys);
  forEach([&](const char* key, auto& member) {
    if (json.has(key)) read(json[key], member.emplace());
  });
}

ViewState readView(const JsonReader& json)
{
  ViewState view;
  readMembers(json, [&](auto&& visit) { forEachMember(view, visit); }, {"glyphs"});
  if (json.has("glyphs")) readMembers(json["glyphs"], [&](auto&& visit) { forEachGlyph(view, visit); }, {});
  return view;
}

SavedSelection readSavedSelection(const JsonReader& json)
{
  json.requireKeys({"name", "select"});
  return {textNotEmpty(json["name"]), readSelection(json["select"])};
}

std::vector<SavedSelection> readSelections(const JsonReader& json)
{
  std::vector<SavedSelection> selections;
  for (std::size_t k = 0; k < json.size(); ++k) {
    SavedSelection saved = readSavedSelection(json.element(k));
    if (std::ranges::count(selections, saved.name, &SavedSelection::name) != 0)
      json.element(k)["name"].fail("{} is the name of an earlier selection; names are unique", inQuotes(saved.name));
    selections.push_back(std::move(saved));
  }
  return selections;
}

SurfaceLocation readMeasuredPlace(const JsonReader& json)
{
  SurfaceLocation place = readLocation(json);
  if (std::holds_alternative<AtNear>(place)) json.fail("measured places are vertices, edges or faces; name one");
  return place;
}

std::array<SurfaceLocation, 2> readRuler(const JsonReader& json)
{
  json.requireSize(2, "the places of both ends");
  return {readMeasuredPlace(json.element(0)), readMeasuredPlace(json.element(1))};
}

Measurements readMeasurements(const JsonReader& json)
{
  json.requireKeys({"probes", "rulers"});
  Measurements measurements;
  if (json.has("probes")) measurements.probes = json["probes"].list(readMeasuredPlace);
  if (json.has("rulers")) measurements.rulers = json["rulers"].list(readRuler);
  return measurements;
}

Annotations readAnnotations(const JsonReader& json)
{
  Annotations annotations;
  if (json.has("selections")) annotations.selections = readSelections(json["selections"]);
  if (json.has("measurements")) annotations.measurements = readMeasurements(json["measurements"]);
  return annotations;
}

Json meshJson(const MeshReference& mesh)
{
  Json json{{"path", mesh.path}};
  if (!mesh.absolutePath.empty()) json["absolute_path"] = mesh.absolutePath;
  if (!mesh.checksum.empty()) json["checksum"] = mesh.checksum;
  return json;
}

/// The backend is written only where it is not the default: a session is then good for a build with another default.
/// The same holds for keys of rotations: earlier programs read such a session.
Json optionsJson(const DeformOptions& options)
{
  Json json{{"weights", name(options.weights)}, {"solver", name(options.solver.kind)}};
  if (options.solver.softWeight != SolverOptions().softWeight || options.solver.kind == SolverKind::Soft)
    json["soft_weight"] = options.solver.softWeight;
  if (options.solver.backend != Backend::Holdfast) json["backend"] = name(options.solver.backend);
  if (options.rotations.source != RotationSource::Given) json["rotations"] = name(options.rotations.source);
  if (options.rotations.change != kFoundChange) json["rotation_change"] = options.rotations.change;
  if (options.nearLimit != kNearLimit) json["near_limit"] = options.nearLimit;
  if (options.weldTolerance != 0) json["weld"] = options.weldTolerance;
  return json;
}

Json selectionsJson(const std::vector<SavedSelection>& selections)
{
  Json json = Json::array();
  for (const SavedSelection& saved : selections) json.push_back({{"name", saved.name}, {"select", saved.select}});
  return json;
}

Json measurementsJson(const Measurements& measurements)
{
  Json probes = Json::array();
  for (const SurfaceLocation& probe : measurements.probes) probes.push_back(probe);
  Json rulers = Json::array();
  for (const auto& [from, to] : measurements.rulers) rulers.push_back(Json::array({from, to}));
  return {{"probes", probes}, {"rulers", rulers}};
}

/// Where there are none nothing is written: such a session is good for earlier programs, which refuse these keys.
std::string annotationMembersJson(const Annotations& annotations)
{
  std::string json;
  if (!annotations.selections.empty())
    json += fmt::format(",\n  \"selections\": {}", jsonText(selectionsJson(annotations.selections)));
  const auto& [probes, rulers] = annotations.measurements;
  if (!probes.empty() || !rulers.empty())
    json += fmt::format(",\n  \"measurements\": {}", jsonText(measurementsJson(annotations.measurements)));
  return json;
}

void addMember(Json& json, const char* key, const auto& value)
{
  json[key] = value;
}

void addMember(Json& json, const char* key, const Camera& camera)
{
  json[key] = {{"position", camera.position},
               {"focal_point", camera.focalPoint},
               {"view_up", camera.viewUp},
               {"parallel_scale", camera.parallelScale},
               {"projection", kProjections[camera.isParallel ? 1 : 0]}};
}

Json viewJson(const ViewState& view)
{
  const auto addTo = [](Json& json) {
    return [&json](const char* key, const auto& member) {
      if (member) addMember(json, key, *member);
    };
  };
  Json json = Json::object();
  forEachMember(view, addTo(json));
  Json glyphs = Json::object();
  forEachGlyph(view, addTo(glyphs));
  if (!glyphs.empty()) json["glyphs"] = std::move(glyphs);
  return json;
}

/// `path` with the links of its folders followed, not its own: a link to a mesh moves with the folder that it is in.
fs::path inRealFolder(const fs::path& path)
{
  std::error_code ignored;
  const fs::path absolute = fs::absolute(path, ignored).lexically_normal();
  const fs::path folder = fs::weakly_canonical(absolute.parent_path(), ignored);
  return (folder.empty() ? absolute.parent_path() : folder) / absolute.filename();
}

ResolvedMesh examined(const fs::path& path, const std::string& checksum)
{
  try {
    const std::string found = checksumOfFile(path);
    if (checksum.empty() || found == checksum) return {path, MeshState::Same, ""};
    return {
        path, MeshState::Changed,
        fmt::format("{}: the mesh is not the one that the session was saved with (checksum {} instead of {}). Vertex "
                    "and face ids may mean other places now: check the constraints, or bring the old file back",
                    path.string(), found, checksum)};
  } catch (const InputError& error) {
    return {path, MeshState::Missing, fmt::format("{}. Choose where the mesh of the session is", error.what())};
  }
}

}  // namespace

SessionFile parseSession(std::string_view text, const std::string& name)
{
  const JsonValue root = parseJson(text, name);
  const JsonReader json(root, name);
  SessionFile session;
  session.document.list = readConstraintDocument(json);
  if (!json.has("mesh"))
    json.fail("the key \"mesh\" is missing: this is a constraint file; open a mesh, then the constraints");
  session.mesh = readMeshReference(json["mesh"]);
  if (json.has("options")) session.document.options = withStated({}, readOptions(json["options"]));
  session.document.annotations = std::make_shared<const Annotations>(readAnnotations(json));
  if (json.has("view")) session.view = readView(json["view"]);
  session.original = textOf(json, "original");
  return session;
}

SessionFile readSession(const fs::path& path)
{
  SessionFile session = parseSession(readTextFile(path), path.string());
  readGuideFiles(session.document.list, path.parent_path(), path.string());
  return session;
}

StatedConstraints readStatedConstraints(const fs::path& path, BadRows badRows)
{
  const std::string name = path.string();
  const std::string text = readTextFile(path);
  if (isPointList(path, text)) {
    PointList points = parsePointList(text, name, badRows);
    return {std::move(points.list), {}, std::move(points.skippedRows)};
  }
  if (badRows == BadRows::Skip)
    throw InputError({name, 0, ""}, "this is no point list, and bad rows can be skipped only in point lists");
  const JsonValue root = parseJson(text, name);
  const JsonReader json(root, name);
  StatedConstraints stated{readConstraintDocument(json),
                           json.has("options") ? readOptions(json["options"]) : StatedOptions{}};
  readGuideFiles(stated.list, path.parent_path(), name);
  return stated;
}

std::string sessionToJson(const SessionFile& session)
{
  std::string constraints = constraintMembersJson(session.document.list);
  constraints.pop_back();  // the end of its last line, where members follow
  std::string json =
      fmt::format("{{{},\n  \"mesh\": {},\n  \"options\": {}{},\n  \"view\": {}", constraints,
                  jsonText(meshJson(session.mesh)), jsonText(optionsJson(session.document.options)),
                  annotationMembersJson(*session.document.annotations), jsonText(viewJson(session.view)));
  if (!session.original.empty()) json += fmt::format(",\n  \"original\": {}", jsonText(session.original));
  json += "\n}\n";
  requireReadable("session", [&] { return parseSession(json, ""); });
  return json;
}

void writeSession(const fs::path& path, const SessionFile& session)
{
  SessionFile written = session;
  written.document.list = withGuidePathsFrom(std::move(written.document.list), path.parent_path());
  OutputFile(path, sessionToJson(written)).commit();
}

std::string checksumOfFile(const fs::path& path)
{
  // The Fowler-Noll-Vo hash, variant 1a, with the published constants.
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char byte : readFileBytes(path)) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3U;
  return fmt::format("{}{:016x}", kAlgorithm, hash);
}

MeshReference referenceTo(const fs::path& mesh, const fs::path& session, std::string checksum)
{
  const fs::path target = inRealFolder(mesh);
  return {target.lexically_proximate(inRealFolder(session).parent_path()).generic_string(), target.generic_string(),
          std::move(checksum)};
}

ResolvedMesh resolveMesh(const SessionFile& session, const fs::path& sessionPath)
{
  const MeshReference& mesh = session.mesh;
  std::vector<ResolvedMesh> found{examined(sessionPath.parent_path() / mesh.path, mesh.checksum)};
  if (!mesh.absolutePath.empty() && found.front().path != mesh.absolutePath)
    found.push_back(examined(mesh.absolutePath, mesh.checksum));
  // Same before Changed before Missing; of equals the likelier.
  return *std::ranges::min_element(found, {}, &ResolvedMesh::state);
}

}  // namespace holdfast
