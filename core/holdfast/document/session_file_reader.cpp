#include <span>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/constraint_files/json_reader_internal.h>
#include <holdfast/document/session_file.h>
#include <holdfast/document/session_mesh.h>
#include <holdfast/document/stated_options.h>
#include <holdfast/io/files/file_bytes.h>

namespace holdfast {
namespace {

constexpr std::array<std::string_view, 3> kMeshKeys{"path", "absolute_path", "checksum"};
constexpr std::array<std::string_view, 4> kOptionKeys{"weights", "solver", "soft_weight", "backend"};
constexpr std::array<std::string_view, 9> kViewKeys{"camera",    "color_by",   "range",      "scale", "decades",
                                                    "color_map", "rest_shape", "mesh_edges", "glyphs"};
constexpr std::array<std::string_view, 5> kCameraKeys{"position", "focal_point", "view_up", "parallel_scale",
                                                      "projection"};
constexpr std::array<std::string_view, 2> kGlyphKeys{"constraints", "rotations"};

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

std::optional<bool> booleanOrNone(const JsonReader& json, std::string_view key)
{
  if (!json.has(key)) return std::nullopt;
  return json[key].boolean();
}

double positive(const JsonReader& json)
{
  if (!(json.number() > 0)) json.fail(fmt::format("{} is not above 0", json.number()));
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
  json.fail(fmt::format("{} is not known here{}", inQuotes(json.text()), spellingHint(json.text(), names)));
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
  json.requireKeys(kOptionKeys);
  StatedOptions options;
  if (json.has("weights")) options.weights = chosen<Weights>(json["weights"], kWeights);
  if (json.has("solver")) options.solver = chosen<SolverKind>(json["solver"], kSolvers);
  if (json.has("soft_weight")) options.softWeight = positive(json["soft_weight"]);
  if (json.has("backend")) options.backend = readBackend(json["backend"]);
  return options;
}

MeshReference readMeshReference(const JsonReader& json)
{
  json.requireKeys(kMeshKeys);
  MeshReference mesh{textNotEmpty(json["path"]), textOrNone(json, "absolute_path").value_or(""),
                     textOrNone(json, "checksum").value_or("")};
  if (!mesh.checksum.empty() && !isChecksum(mesh.checksum))
    json["checksum"].fail(fmt::format(
        "{} is not \"fnv1a64:\" and 16 hexadecimal digits; leave the key out where the checksum is not known",
        inQuotes(mesh.checksum)));
  return mesh;
}

bool readIsParallel(const JsonReader& json)
{
  constexpr std::array<std::string_view, 2> kProjections{"perspective", "parallel"};
  if (json.text() != kProjections[0] && json.text() != kProjections[1])
    json.fail(fmt::format("{} is not a projection{}", inQuotes(json.text()), spellingHint(json.text(), kProjections)));
  return json.text() == kProjections[1];
}

Camera readCamera(const JsonReader& json)
{
  json.requireKeys(kCameraKeys);
  Camera camera;
  camera.position = json["position"].vector();
  camera.focalPoint = json["focal_point"].vector();
  if (camera.position == camera.focalPoint)
    json["focal_point"].fail("this is the camera's own place; name a point that it looks at");
  camera.viewUp = json["view_up"].direction();
  if (json.has("parallel_scale")) camera.parallelScale = positive(json["parallel_scale"]);
  if (json.has("projection")) camera.isParallel = readIsParallel(json["projection"]);
  return camera;
}

std::array<double, 2> readRange(const JsonReader& json)
{
  json.requireSize(2, "[low, high]");
  const std::array<double, 2> range{json.element(0).number(), json.element(1).number()};
  if (!(range[0] < range[1])) json.fail("low is not below high; leave the key out for an automatic range");
  return range;
}

Index readDecades(const JsonReader& json)
{
  if (json.integer() < 1) json.fail(fmt::format("{} is not above 0", json.integer()));
  return json.integer();
}

ViewState readView(const JsonReader& json)
{
  json.requireKeys(kViewKeys);
  ViewState view;
  if (json.has("camera")) view.camera = readCamera(json["camera"]);
  view.colorBy = textOrNone(json, "color_by");
  if (json.has("range")) view.range = readRange(json["range"]);
  view.scale = textOrNone(json, "scale");
  if (json.has("decades")) view.decades = readDecades(json["decades"]);
  view.colorMap = textOrNone(json, "color_map");
  view.restShape = textOrNone(json, "rest_shape");
  view.meshEdges = textOrNone(json, "mesh_edges");
  if (!json.has("glyphs")) return view;
  json["glyphs"].requireKeys(kGlyphKeys);
  view.showsConstraints = booleanOrNone(json["glyphs"], "constraints");
  view.showsRotations = booleanOrNone(json["glyphs"], "rotations");
  return view;
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

}  // namespace holdfast
