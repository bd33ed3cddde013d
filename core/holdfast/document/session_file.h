#pragma once
/// A session (`.holdfast`) keeps a mesh, its constraints and how they are looked at. docs/formats.md describes every
/// key.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/deform.h>
#include <holdfast/document/history.h>

namespace holdfast {

struct MeshReference {
  std::string path;          ///< from the session's folder, or absolute; '/' between names
  std::string absolutePath;  ///< where the mesh was when the session was written; may be empty
  std::string checksum;      ///< of the file's bytes, "fnv1a64:" and 16 digits; empty where it is not known

  friend bool operator==(const MeshReference&, const MeshReference&) = default;
};

/// Says where the model is seen from, in model units.
struct Camera {
  Vector3 position = Vector3::UnitZ();
  Vector3 focalPoint = Vector3::Zero();  ///< differs from `position`
  Vector3 viewUp = Vector3::UnitY();     ///< not zero
  double parallelScale = 1;              ///< half the height of what a parallel projection shows; above 0
  bool isParallel = false;

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// More decimals say nothing of a double between 1 and 10.
inline constexpr int kMostLengthDecimals = 15;

/// Says how the model is shown. The view chooses what is absent. Names are those of the view.
struct ViewState {
  std::optional<Camera> camera;
  std::optional<std::string> upAxis;  ///< of the model: "y", "z"
  std::optional<std::string> colorBy;
  std::optional<std::array<double, 2>> range;  ///< low below high; automatic where absent
  std::optional<std::string> scale;            ///< of the colours: "linear", "log"
  std::optional<Index> decades;                ///< powers of ten that a logarithmic scale shows, 1 or more
  std::optional<std::string> colorMap;
  std::optional<Index> bands;         ///< of one colour each, 1 or more; colours change with every value where absent
  std::optional<std::string> legend;  ///< where it is
  std::optional<int> decimals;        ///< of lengths, 0 to `kMostLengthDecimals`
  std::optional<std::string> restShape;
  std::optional<std::string> meshEdges;
  std::optional<std::string> surface;
  std::optional<std::vector<std::array<Index, 2>>> hiddenFaces;  ///< first and last of each range, ascending
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

/// Reads a session. Throws `InputError` as `readConstraints` does, also for what a session has besides. It refuses a
/// session without a mesh, a path that is empty, and a checksum of a kind that is not known. It refuses options that do
/// not exist or that this build does not have.
[[nodiscard]] SessionFile readSession(const std::filesystem::path& path);

/// Reads a session from text in the same way. Messages call the file `name`.
[[nodiscard]] SessionFile parseSession(std::string_view text, const std::string& name);

/// Returns text that reads back as `session`, every double in its shortest exact form. Throws `OutputError` for what no
/// file can say.
[[nodiscard]] std::string sessionToJson(const SessionFile& session);

/// Writes the session to `path`. Throws `OutputError`, and what stood there is untouched then.
void writeSession(const std::filesystem::path& path, const SessionFile& session);

/// Returns "fnv1a64:" and 16 digits: the 64-bit FNV-1a hash of the file's bytes. Throws `InputError`.
[[nodiscard]] std::string checksumOfFile(const std::filesystem::path& path);

/// Returns the reference of a session at `session` to the mesh at `mesh`. Neither of them need exist. The path of the
/// reference is relative.
[[nodiscard]] MeshReference referenceTo(const std::filesystem::path& mesh, const std::filesystem::path& session,
                                        std::string checksum);

enum class MeshState {
  Same,     ///< as it was, or the session does not say how it was
  Changed,  ///< the bytes of the file are others
  Missing   ///< neither where the session says nor where it was when that was written, or not to be read
};

struct ResolvedMesh {
  std::filesystem::path path;
  MeshState state = MeshState::Missing;
  std::string message;  ///< for the user, of a mesh that is not the same: what is wrong, where, and what to do
};

/// Finds the mesh of the session at `sessionPath`, in its folder first. A mesh that is the same goes before a changed
/// one.
[[nodiscard]] ResolvedMesh resolveMesh(const SessionFile& session, const std::filesystem::path& sessionPath);

/// Options may name these, in the order in which messages list them.
inline constexpr std::array kAllWeights{Weights::Cotangent, Weights::CotangentPaper, Weights::Uniform};
inline constexpr std::array kAllSolvers{SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange};
inline constexpr std::array kAllRotations{RotationSource::Given, RotationSource::Found, RotationSource::FoundSmooth};
inline constexpr std::array kAllBackends{Backend::Holdfast, Backend::Cholmod, Backend::Eigen};

/// A session or a command line states these options of a deformation. Any of them may be left out.
struct StatedOptions {
  std::optional<Weights> weights;
  std::optional<SolverKind> solver;
  std::optional<double> softWeight;
  std::optional<Backend> backend;
  std::optional<RotationSource> rotations;
  std::optional<double> rotationChange;
  std::optional<double> nearLimit;
  std::optional<double> weldTolerance;
};

/// Returns `options` with what is stated in place of their own.
[[nodiscard]] inline DeformOptions withStated(DeformOptions options, const StatedOptions& stated)
{
  options.weights = stated.weights.value_or(options.weights);
  options.solver.kind = stated.solver.value_or(options.solver.kind);
  options.solver.softWeight = stated.softWeight.value_or(options.solver.softWeight);
  options.solver.backend = stated.backend.value_or(options.solver.backend);
  options.rotations.source = stated.rotations.value_or(options.rotations.source);
  options.rotations.change = stated.rotationChange.value_or(options.rotations.change);
  options.nearLimit = stated.nearLimit.value_or(options.nearLimit);
  options.weldTolerance = stated.weldTolerance.value_or(options.weldTolerance);
  return options;
}

struct StatedConstraints {
  ConstraintList list;
  StatedOptions options;
  std::vector<SkippedRow> skippedRows = {};  ///< of a point list
};

/// Reads constraints as `readConstraints` does, with the options of a session. Throws `InputError` where bad rows are
/// to be skipped in a file that is no point list.
[[nodiscard]] StatedConstraints readStatedConstraints(const std::filesystem::path& path,
                                                      BadRows badRows = BadRows::Refuse);

}  // namespace holdfast
