#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/json_text_internal.h>
#include <holdfast/document/session_file.h>
#include <holdfast/io/files/output_file.h>

namespace holdfast {
namespace {

using Json = nlohmann::ordered_json;

/// Adds a member that is there.
template <class Value>
void add(Json& json, const char* key, const std::optional<Value>& value)
{
  if (value) json[key] = *value;
}

void addText(Json& json, const char* key, const std::string& text)
{
  if (!text.empty()) json[key] = text;
}

Json meshJson(const MeshReference& mesh)
{
  Json json{{"path", mesh.path}};
  addText(json, "absolute_path", mesh.absolutePath);
  addText(json, "checksum", mesh.checksum);
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

Json vectorJson(const Vector3& v)
{
  return {v.x(), v.y(), v.z()};
}

Json cameraJson(const Camera& camera)
{
  return {{"position", vectorJson(camera.position)},
          {"focal_point", vectorJson(camera.focalPoint)},
          {"view_up", vectorJson(camera.viewUp)},
          {"parallel_scale", camera.parallelScale},
          {"projection", camera.isParallel ? "parallel" : "perspective"}};
}

Json viewJson(const ViewState& view)
{
  Json json = Json::object();
  if (view.camera) json["camera"] = cameraJson(*view.camera);
  add(json, "color_by", view.colorBy);
  add(json, "range", view.range);
  add(json, "scale", view.scale);
  add(json, "decades", view.decades);
  add(json, "color_map", view.colorMap);
  add(json, "rest_shape", view.restShape);
  add(json, "mesh_edges", view.meshEdges);
  Json glyphs = Json::object();
  add(glyphs, "constraints", view.showsConstraints);
  add(glyphs, "rotations", view.showsRotations);
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
