#pragma once
/// Holds the open document, the one truth of the window: constraints, selection and the newest deformation.

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <holdfast/constraints/selector.h>
#include <holdfast/deform/model.h>
#include <holdfast/document/history.h>
#include <holdfast/document/live_deformer.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/surface/vertex_regions.h>
#include <holdfast/threads/progress.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>
#include <holdfast/widgets/scene/scene_contents.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

/// A mesh file and all that the window needs of it, made on any thread.
struct LoadedMesh {
  std::filesystem::path path;
  MeshDocument document;
  std::shared_ptr<const Model> model;
  std::shared_ptr<Selector> selector;
  std::shared_ptr<VertexRegions> regions;
  std::shared_ptr<SceneContents> contents;        ///< at rest, with the coarse triangles of large meshes
  std::shared_ptr<const VisibleSurface> surface;  ///< at rest, ready for rays
  bool isScan = false;                            ///< coordinates of single precision, and hardly a flat place
  double weldTolerance = 0;                       ///< within which vertices of `model` are one
};

/// Reads a mesh file and prepares it. Throws as `readMesh` and `makeModel` do, and what `progress` throws.
[[nodiscard]] LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress, double weldTolerance = 0);

/// Prepares a mesh that is in memory; `path` names it. Throws as `makeModel` does, and what `progress` throws.
[[nodiscard]] LoadedMesh prepareMesh(MeshDocument document, const std::filesystem::path& path, Progress& progress,
                                     double weldTolerance = 0);

/// Tells whether a full picture of the mesh may take too long for a movement.
[[nodiscard]] bool isLarge(const Model& model);

/// Says whether the picture shows the newest state.
enum class SolveState {
  Nothing,    ///< no mesh is open
  Current,    ///< the deformation is that of the state
  Solving,    ///< a newer state is being worked on: the deformation is older
  Cancelled,  ///< the user stopped the work: the deformation is older
  Unusable    ///< the state cannot be solved, `Editor::error` says why: the deformation is older
};

/// Holds what is under the cursor of the picture. With a tool that picks, a click would take it.
struct UnderCursor {
  std::optional<SurfacePick> pick;
  std::optional<Index> constraint;  ///< whose mark it is, by its place in the list
};

/// The editor holds the open document. Widgets show this data, change it through the functions below, and keep no copy.
/// The editor lives on the thread of the window.
class Editor : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void open(LoadedMesh mesh, DocumentState state);
  void close();
  /// Puts the document onto `mesh`, which has the vertices of the mesh before. If `mesh` is welded within another
  /// length than the state says, the state is edited to say that length.
  void remodel(LoadedMesh mesh);
  [[nodiscard]] bool isOpen() const noexcept { return mesh_.model != nullptr; }

  /// This function and the next four need an open document.
  [[nodiscard]] const LoadedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const std::shared_ptr<const Model>& model() const noexcept { return mesh_.model; }
  [[nodiscard]] const DocumentState& state() const { return *history_->state(); }
  [[nodiscard]] const ConstraintList& list() const { return state().list; }
  [[nodiscard]] const History& history() const { return *history_; }

  /// Returns how lengths of this document are written. The decimals are the document's own. Without a document there
  /// are no units.
  [[nodiscard]] LengthStyle lengthStyle() const { return {isOpen() ? list().units : std::string(), decimals_}; }
  [[nodiscard]] std::optional<int> decimals() const noexcept { return decimals_; }
  /// Sets the decimals of lengths, from 0 to `kMostLengthDecimals`, or none. This is no edit: nothing that is solved or
  /// saved as a constraint changes.
  void setDecimals(std::optional<int> decimals);

  /// Returns the newest finished deformation; null before the first, and without a document.
  [[nodiscard]] const std::shared_ptr<const DeformResult>& deformation() const noexcept { return shown_.deformation; }
  /// Returns the report of `deformation`; null without a deformation. What the worker finds later, while it rests, is
  /// added to the report (`LiveEvent::Kind::Examined`).
  [[nodiscard]] const std::shared_ptr<const Report>& report() const noexcept { return shown_.report; }
  /// Tells whether `report` says what the solution made of the part. It does so some milliseconds after `deformed`.
  [[nodiscard]] bool isResultKnown() const
  {
    return report() == nullptr || report()->solve.status == SolveStatus::Failed ||
           report()->result.status != ResultStatus::NotMeasured;
  }
  /// Returns the state of `deformation`; null without a deformation. Names and places in the report belong to the list
  /// of this state.
  [[nodiscard]] const std::shared_ptr<const DocumentState>& deformedState() const noexcept { return shown_.state; }
  [[nodiscard]] const Positions& positions() const { return surface()->positions(); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const
  {
    return shown_.surface ? shown_.surface : mesh_.surface;
  }
  /// Returns where the constraints of `deformedState` act in `deformation`; null without a deformation. Disabled
  /// constraints are last.
  [[nodiscard]] const std::shared_ptr<const MarkSet>& marks() const noexcept { return shown_.marks; }
  /// Returns the outcome of the constraint of this name; null if nothing was solved with it. The constraint is probably
  /// at `row`: this mostly takes O(1).
  [[nodiscard]] const ConstraintOutcome* outcome(const std::string& name, Index row) const;
  /// Returns the status of the constraint's outcome, or `Disabled` if the constraint itself is disabled. It returns
  /// nothing without an outcome, and if the constraint was disabled when it was solved.
  [[nodiscard]] std::optional<ConstraintStatus> status(const Constraint& constraint, Index row) const;
  [[nodiscard]] SolveState solveState() const noexcept { return solveState_; }
  /// Returns how long the picture has been older than the list, in seconds; 0 unless the list is being solved.
  [[nodiscard]] double secondsOlder() const
  {
    return solveState_ == SolveState::Solving ? static_cast<double>(older_.elapsed()) / 1000 : 0;
  }
  /// Tells whether results are those of the list on screen.
  [[nodiscard]] bool isCurrent() const noexcept { return solveState_ == SolveState::Current; }
  /// Returns why the newest state cannot be solved; empty otherwise.
  [[nodiscard]] const QString& error() const noexcept { return error_; }
  /// Returns the current step of the worker; empty while it is idle.
  [[nodiscard]] const QString& step() const noexcept { return step_; }

  /// Makes the list another one. This function and the next each add one entry to the history. `name` says in the menu
  /// what the edit does: "move P1".
  void edit(const QString& name, ConstraintList after);
  void setOptions(const QString& name, const DeformOptions& options);
  /// Begins a drag, which has any number of states and is one entry. `cancelGesture` restores the state and the picture
  /// from before the drag.
  void beginGesture(const QString& name) { history_->beginGesture(name.toStdString()); }
  void updateGesture(ConstraintList after);
  void endGesture();
  void cancelGesture();
  /// Tells whether the mesh is welded within the length that the state says. Nothing is solved before it is.
  [[nodiscard]] bool hasItsMesh() const { return state().options.weldTolerance == mesh_.weldTolerance; }
  /// Asks by `meshWanted` for a mesh that is welded within this length.
  void weldWithin(double tolerance) { Q_EMIT meshWanted(tolerance); }
  /// Goes back one entry. Several calls of `undo` and `redo` may come in quick succession. On a large mesh, only the
  /// last state is then solved and shown.
  void undo()
  {
    if (isOpen() && history_->undo()) stateIsAnother();
  }
  void redo()
  {
    if (isOpen() && history_->redo()) stateIsAnother();
  }
  /// Notes that the user's file holds `state`, which was shown before.
  void markSaved(std::shared_ptr<const DocumentState> state);
  /// Notes that the document is in no file although nothing was edited. A copy that a crash has left is such a
  /// document.
  void markUnsaved();

  /// Stops the work under way; the state stays as it is. `solve` starts it again.
  void cancelSolving();
  void solve()
  {
    if (isOpen()) submit(Supersede::AtNextStep);
  }

  /// Tells the worker that the deformation is in the picture, by `LiveDeformer::resultIsSeen`.
  void resultIsSeen()
  {
    if (isOpen()) worker_->resultIsSeen();
  }

  /// Returns the selected vertices of the file, ascending.
  [[nodiscard]] const std::vector<Index>& selectedVertices() const noexcept { return selectedVertices_; }
  /// Returns the selected constraints by their places in the list, ascending.
  [[nodiscard]] const std::vector<Index>& selectedConstraints() const noexcept { return selectedConstraints_; }
  /// Selects vertices. `shape`, such as a curve, replaces the ids in constraints on these vertices, as long as they
  /// stay selected.
  void selectVertices(std::vector<Index> vertices, std::optional<Selection> shape = std::nullopt);
  [[nodiscard]] Selection selection() const { return selectedShape_.value_or(Selection{VertexIds{selectedVertices_}}); }
  void selectConstraints(std::vector<Index> constraints);

  /// Returns the measurements and the saved selections; none without a document. Locations of measurements are those of
  /// picks. Each change of the annotations is one entry of the history, and needs no solution.
  [[nodiscard]] const Annotations& annotations() const;
  [[nodiscard]] const Measurements& measurements() const { return annotations().measurements; }
  /// Replaces the measurements. If only probes differ, a saved document stays a saved one.
  void setMeasurements(const QString& name, Measurements measurements);
  void setSavedSelections(const QString& name, std::vector<SavedSelection> selections);
  [[nodiscard]] const UnderCursor& underCursor() const noexcept { return underCursor_; }
  void setUnderCursor(UnderCursor underCursor);

 Q_SIGNALS:
  void opened();  ///< another document, or none
  /// The user or an undone state asks for a mesh that is welded so; `DocumentFiles` prepares it and calls `remodel`.
  void meshWanted(double weldTolerance);
  /// The constraints of these rows are to stay on another mesh, or without rows a new slide of the selected vertices.
  /// `DocumentFiles` asks for the mesh.
  void guideMeshWanted(const std::vector<Index>& rows);
  void stateChanged();       ///< the list or the options; the history with them
  void deformed();           ///< another deformation
  void examined();           ///< the report of the deformation says more than before
  void solveStateChanged();  ///< or the error
  void stepChanged();        ///< of the worker
  void vertexSelectionChanged();
  void constraintSelectionChanged();
  void annotationsChanged();
  void decimalsChanged();
  void underCursorChanged();
  void saved();  ///< the history is where the file is, or `markUnsaved` was called

 private:
  struct Solved {
    std::shared_ptr<const DocumentState> state;
    std::shared_ptr<const DeformResult> deformation;
    std::shared_ptr<const VisibleSurface> surface;  // where the deformation has moved it
    std::shared_ptr<const MarkSet> marks;
    std::shared_ptr<const Report> report;
    std::uint64_t revision = 0;
  };

  void start(LoadedMesh mesh, std::unique_ptr<History> history);
  void submit(Supersede supersede);
  void stateBecame(Supersede supersede);
  void stateIsAnother();
  void annotate(const QString& name, Annotations after, EditKind kind);
  void tellState();
  void keepSelection();
  void showOrSubmit(Supersede supersede);
  void show(Solved solved);
  void remember();
  void handle(const LiveEvent& event, Solved solved);
  void takeReport(const LiveEvent& event);
  void setSolveState(SolveState solveState, const QString& error);
  void setStep(const QString& step);

  LoadedMesh mesh_;
  std::unique_ptr<History> history_;
  std::optional<int> decimals_;
  std::atomic<bool> isDragging_ = false;  // frames follow one another sooner than rays meet them
  PostedCalls calls_;                     // by the worker; outlives it
  std::unique_ptr<LiveDeformer> worker_;

  std::uint64_t revision_ = 0;  // of the newest state that was submitted, of any document
  std::deque<std::pair<std::uint64_t, std::shared_ptr<const DocumentState>>> submitted_;
  std::deque<Solved> solved_;  // the latest few, so that undo shows at once what was there
  Solved shown_;
  mutable std::unordered_map<std::string_view, Index>
      outcomeOf_;  // by name, in the report of `shown_`; empty until used
  SolveState solveState_ = SolveState::Nothing;
  bool isShowDue_ = false;  // of the state that undo or redo has come to
  QElapsedTimer older_;     // since the picture was shown, or was current
  QString error_;
  QString step_;

  std::vector<Index> selectedVertices_;
  std::optional<Selection> selectedShape_;
  std::vector<Index> selectedConstraints_;
  std::shared_ptr<const Annotations> lastAnnotations_;  // of the last signal
  UnderCursor underCursor_;
};

}  // namespace holdfast
