#include <vector>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/json_text_internal.h>
#include <holdfast/document/session_file.h>
#include <holdfast/io/files/output_file.h>

namespace holdfast {
namespace {

/// An object made member by member. What is empty or absent is left out.
class ObjectJson {
 public:
  ObjectJson& add(std::string_view key, const std::string& valueJson)
  {
    members_ += fmt::format(R"({}"{}": {})", members_.empty() ? "" : ", ", key, valueJson);
    return *this;
  }
  ObjectJson& addText(std::string_view key, std::string_view text)
  {
    return text.empty() ? *this : add(key, textJson(text));
  }
  ObjectJson& addOptional(std::string_view key, const std::optional<std::string>& text)
  {
    return text ? add(key, textJson(*text)) : *this;
  }
  ObjectJson& addOptional(std::string_view key, const std::optional<bool>& value)
  {
    return value ? add(key, *value ? "true" : "false") : *this;
  }
  ObjectJson& addObject(std::string_view key, const ObjectJson& object)
  {
    return object.members_.empty() ? *this : add(key, object.json());
  }

  [[nodiscard]] std::string json() const { return '{' + members_ + '}'; }

 private:
  std::string members_;
};

ObjectJson meshJson(const MeshReference& mesh)
{
  ObjectJson json;
  json.add("path", textJson(mesh.path));
  json.addText("absolute_path", mesh.absolutePath).addText("checksum", mesh.checksum);
  return json;
}

/// The backend is written only where it is not the default: a session is then good for a build with another default.
ObjectJson optionsJson(const DeformOptions& options)
{
  ObjectJson json;
  json.addText("weights", name(options.weights)).addText("solver", name(options.solver.kind));
  if (options.solver.softWeight != SolverOptions().softWeight || options.solver.kind == SolverKind::Soft)
    json.add("soft_weight", numberJson(options.solver.softWeight));
  if (options.solver.backend != defaultBackend()) json.addText("backend", name(options.solver.backend));
  return json;
}

ObjectJson cameraJson(const Camera& camera)
{
  ObjectJson json;
  json.add("position", vectorJson(camera.position)).add("focal_point", vectorJson(camera.focalPoint));
  json.add("view_up", vectorJson(camera.viewUp)).add("parallel_scale", numberJson(camera.parallelScale));
  json.addText("projection", camera.isParallel ? "parallel" : "perspective");
  return json;
}

ObjectJson viewJson(const ViewState& view)
{
  ObjectJson json;
  if (view.camera) json.addObject("camera", cameraJson(*view.camera));
  json.addOptional("color_by", view.colorBy);
  if (view.range) json.add("range", listJson(*view.range, [](double value) { return numberJson(value); }));
  json.addOptional("scale", view.scale);
  if (view.decades) json.add("decades", std::to_string(*view.decades));
  json.addOptional("color_map", view.colorMap);
  json.addOptional("rest_shape", view.restShape).addOptional("mesh_edges", view.meshEdges);
  ObjectJson glyphs;
  glyphs.addOptional("constraints", view.showsConstraints).addOptional("rotations", view.showsRotations);
  return json.addObject("glyphs", glyphs);
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
                                 meshJson(session.mesh).json(), optionsJson(session.document.options).json(),
                                 viewJson(session.view).json());
  if (!session.original.empty()) json += fmt::format(",\n  \"original\": {}", textJson(session.original));
  json += "\n}\n";
  requireReadableSession(json);
  return json;
}

void writeSession(const std::filesystem::path& path, const SessionFile& session)
{
  OutputFile(path, sessionToJson(session)).commit();
}

}  // namespace holdfast
