#pragma once
/// Sessions (`.holdfast`): a mesh, its constraints and how they are looked at, as one file. docs/formats.md describes
/// every key.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <holdfast/document/history.h>

namespace holdfast {

/// Which mesh a session is about. `session_mesh.h` makes it and finds the mesh again.
struct MeshReference {
  std::string path;          ///< from the session's folder, or absolute; '/' between names
  std::string absolutePath;  ///< where the mesh was when the session was written; may be empty
  std::string checksum;      ///< of the file's bytes, "fnv1a64:" and 16 digits; empty where it is not known

  friend bool operator==(const MeshReference&, const MeshReference&) = default;
};

/// Where the model is seen from, in model units.
struct Camera {
  Vector3 position = Vector3::UnitZ();
  Vector3 focalPoint = Vector3::Zero();  ///< differs from `position`
  Vector3 viewUp = Vector3::UnitY();     ///< not zero
  double parallelScale = 1;              ///< half the height of what a parallel projection shows; above 0
  bool isParallel = false;

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// How the model is shown; the view chooses what is absent. Names are those of the view.
struct ViewState {
  std::optional<Camera> camera;
  std::optional<std::string> colorBy;
  std::optional<std::array<double, 2>> range;  ///< low below high; automatic where absent
  std::optional<std::string> scale;            ///< of the colours: "linear", "log"
  std::optional<Index> decades;                ///< powers of ten that a logarithmic scale shows, 1 or more
  std::optional<std::string> colorMap;
  std::optional<std::string> restShape;
  std::optional<std::string> meshEdges;
  std::optional<bool> showsConstraints;
  std::optional<bool> showsRotations;

  friend bool operator==(const ViewState&, const ViewState&) = default;
};

struct SessionFile {
  MeshReference mesh;
  DocumentState document;
  ViewState view;
  std::string original;  ///< of a copy that is kept against a crash: absolute path of the session; else empty
};

/// Reads a session. Throws `InputError` as `readConstraints` does, and with the JSON path where what a session has
/// besides is not as it should be: no mesh, a path that is empty, a checksum of a kind that is not known, options that
/// do not exist or that this build does not have.
[[nodiscard]] SessionFile readSession(const std::filesystem::path& path);

/// The same from text; `name` is that of the file in messages.
[[nodiscard]] SessionFile parseSession(std::string_view text, const std::string& name);

/// The JSON text that reads back as `session`, every double in its shortest exact form. Throws `OutputError` where
/// `session` is not one that a file can say: the text is read again before it is returned.
[[nodiscard]] std::string sessionToJson(const SessionFile& session);

/// Writes the file aside, then puts it in place. Throws `OutputError`; what stood there is untouched then.
void writeSession(const std::filesystem::path& path, const SessionFile& session);

}  // namespace holdfast
