#include "holdfast/document/session_file.h"

#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/document/session_mesh.h>
#include <holdfast/document/stated_options.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/io/files/output_file.h>

namespace holdfast {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kProjections{"perspective", "parallel"};

/// Calls `visit(key, member)` for the members of a view, in the order of files.
template <class View, class Visitor>
void forEachMember(View& view, Visitor&& visit)
{
  visit("camera", view.camera);
  visit("color_by", view.colorBy);
  visit("range", view.range);
  visit("scale", view.scale);
  visit("decades", view.decades);
  visit("color_map", view.colorMap);
  visit("rest_shape", view.restShape);
  visit("mesh_edges", view.meshEdges);
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

std::optional<std::string> textOrNone(const JsonReader& json, std::string_view key)
{
  if (!json.has(key)) return std::nullopt;
  return textNotEmpty(json[key]);
}

double positive(const JsonReader& json)
{
  if (!(json.number() > 0)) json.fail("{} is not above 0", json.number());
  return json.number();
}

/// The one of `choices` whose name, by `name`, the text is.
template <class Choice>
Choice chosen(const JsonReader& json, std::span<const Choice> choices)
{
  std::vector<std::string_view> names;
  for (const Choice choice : choices) {
    if (json.text() == name(choice)) return choice;
    names.push_back(name(choice));
  }
  json.fail("{} is not known here{}", inQuotes(json.text()), spellingHint(json.text(), names));
}

Backend readBackend(const JsonReader& json)
{
  constexpr std::array kBackends{Backend::Holdfast, Backend::Cholmod, Backend::Eigen};
  const auto backend = chosen<Backend>(json, kBackends);
  if (!isBuilt(backend))
    json.fail("this program was built without CHOLMOD; leave the key out for the best backend that there is");
  return backend;
}

StatedOptions readOptions(const JsonReader& json)
{
  constexpr std::array kWeights{Weights::Cotangent, Weights::CotangentPaper, Weights::Uniform};
  constexpr std::array kSolvers{SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange};
  json.requireKeys({"weights", "solver", "soft_weight", "backend"});
  StatedOptions options;
  if (json.has("weights")) options.weights = chosen<Weights>(json["weights"], kWeights);
  if (json.has("solver")) options.solver = chosen<SolverKind>(json["solver"], kSolvers);
  if (json.has("soft_weight")) options.softWeight = positive(json["soft_weight"]);
  if (json.has("backend")) options.backend = readBackend(json["backend"]);
  return options;
}

MeshReference readMeshReference(const JsonReader& json)
{
  json.requireKeys({"path", "absolute_path", "checksum"});
  MeshReference mesh{textNotEmpty(json["path"]), textOrNone(json, "absolute_path").value_or(""),
                     textOrNone(json, "checksum").value_or("")};
  if (!mesh.checksum.empty() && !isChecksum(mesh.checksum))
    json["checksum"].fail(
        "{} is not \"fnv1a64:\" and 16 hexadecimal digits; leave the key out where the checksum is not known",
        inQuotes(mesh.checksum));
  return mesh;
}

bool readIsParallel(const JsonReader& json)
{
  if (json.text() != kProjections[0] && json.text() != kProjections[1])
    json.fail("{} is not a projection{}", inQuotes(json.text()), spellingHint(json.text(), kProjections));
  return json.text() == kProjections[1];
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
  if (json.has("projection")) camera.isParallel = readIsParallel(json["projection"]);
}

void read(const JsonReader& json, std::array<double, 2>& range)
{
  json.requireSize(2, "[low, high]");
  range = {json.element(0).number(), json.element(1).number()};
  if (!(range[0] < range[1])) json.fail("low is not below high; leave the key out for an automatic range");
}

void read(const JsonReader& json, Index& decades)
{
  decades = json.integer();
  if (decades < 1) json.fail("{} is not above 0", decades);
}

ViewState readView(const JsonReader& json)
{
  ViewState view;
  std::vector<std::string_view> keys;
  const auto addKey = [&](const char* key, auto& /*member*/) { keys.emplace_back(key); };
  const auto readInto = [](const JsonReader& from) {
    return [&from](const char* key, auto& member) {
      if (from.has(key)) read(from[key], member.emplace());
    };
  };
  forEachMember(view, addKey);
  keys.emplace_back("glyphs");
  json.requireKeys(keys);
  forEachMember(view, readInto(json));
  if (!json.has("glyphs")) return view;
  const JsonReader glyphs = json["glyphs"];
  keys.clear();
  forEachGlyph(view, addKey);
  glyphs.requireKeys(keys);
  forEachGlyph(view, readInto(glyphs));
  return view;
}

Json meshJson(const MeshReference& mesh)
{
  Json json{{"path", mesh.path}};
  if (!mesh.absolutePath.empty()) json["absolute_path"] = mesh.absolutePath;
  if (!mesh.checksum.empty()) json["checksum"] = mesh.checksum;
  return json;
}

/// The backend is written only where it is not the default: a session is then good for a build with another default.
Json optionsJson(const DeformOptions& options)
{
  Json json{{"weights", name(options.weights)}, {"solver", name(options.solver.kind)}};
  if (options.solver.softWeight != SolverOptions().softWeight || options.solver.kind == SolverKind::Soft)
    json["soft_weight"] = options.solver.softWeight;
  if (options.solver.backend != Backend::Holdfast) json["backend"] = name(options.solver.backend);
  return json;
}

template <class Value>
const Value& memberJson(const Value& value)
{
  return value;
}

Json memberJson(const Vector3& v)
{
  return {v.x(), v.y(), v.z()};
}

Json memberJson(const Camera& camera)
{
  return {{"position", memberJson(camera.position)},
          {"focal_point", memberJson(camera.focalPoint)},
          {"view_up", memberJson(camera.viewUp)},
          {"parallel_scale", camera.parallelScale},
          {"projection", kProjections[camera.isParallel ? 1 : 0]}};
}

Json viewJson(const ViewState& view)
{
  const auto addTo = [](Json& json) {
    return [&json](const char* key, const auto& member) {
      if (member) json[key] = memberJson(*member);
    };
  };
  Json json = Json::object();
  forEachMember(view, addTo(json));
  Json glyphs = Json::object();
  forEachGlyph(view, addTo(glyphs));
  if (!glyphs.empty()) json["glyphs"] = std::move(glyphs);
  return json;
}

void requireReadableSession(const std::string& json)
{
  try {
    static_cast<void>(parseSession(json, ""));
  } catch (const InputError& error) {
    throw OutputError("session", std::string("it cannot be written so that it can be read; ") + error.what());
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
  if (json.has("view")) session.view = readView(json["view"]);
  session.original = textOrNone(json, "original").value_or("");
  return session;
}

SessionFile readSession(const std::filesystem::path& path)
{
  return parseSession(readTextFile(path), path.string());
}

StatedConstraints readStatedConstraints(const std::filesystem::path& path)
{
  if (isPointList(path)) return {readConstraints(path), {}};
  const std::string name = path.string();
  const JsonValue root = parseJson(readTextFile(path), name);
  const JsonReader json(root, name);
  return {readConstraintDocument(json), json.has("options") ? readOptions(json["options"]) : StatedOptions{}};
}

std::string sessionToJson(const SessionFile& session)
{
  std::string constraints = constraintMembersJson(session.document.list);
  constraints.pop_back();  // the end of its last line, where members follow
  std::string json = fmt::format("{{{},\n  \"mesh\": {},\n  \"options\": {},\n  \"view\": {}", constraints,
                                 jsonText(meshJson(session.mesh)), jsonText(optionsJson(session.document.options)),
                                 jsonText(viewJson(session.view)));
  if (!session.original.empty()) json += fmt::format(",\n  \"original\": {}", jsonText(session.original));
  json += "\n}\n";
  requireReadableSession(json);
  return json;
}

void writeSession(const std::filesystem::path& path, const SessionFile& session)
{
  OutputFile(path, sessionToJson(session)).commit();
}

}  // namespace holdfast
