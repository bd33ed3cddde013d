#pragma once
/// The open document, the one truth of the window: constraints, selection and the newest deformation.

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

#include <holdfast/base/progress.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/deform/model.h>
#include <holdfast/document/history.h>
#include <holdfast/document/live_deformer.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/surface/vertex_regions.h>
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

/// Throws as `readAnyMesh` and `makeModel` do, and what `progress` throws.
[[nodiscard]] LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress, double weldTolerance = 0);

/// The same for a mesh in memory; `path` names it.
[[nodiscard]] LoadedMesh prepareMesh(MeshDocument document, const std::filesystem::path& path, Progress& progress,
                                     double weldTolerance = 0);

/// Whether a full picture of it may take too long for a movement.
[[nodiscard]] bool isLarge(const Model& model);

/// Whether the picture shows the newest state.
enum class SolveState {
  Nothing,    ///< no mesh is open
  Current,    ///< the deformation is that of the state
  Solving,    ///< a newer state is being worked on: the deformation is older
  Cancelled,  ///< the user stopped the work: the deformation is older
  Unusable    ///< the state cannot be solved, `Editor::error` says why: the deformation is older
};

/// What is under the cursor of the picture. With tools that pick it is what a click would take.
struct UnderCursor {
  std::optional<SurfacePick> pick;
  std::optional<Index> constraint;  ///< whose mark it is, by its place in the list
};

/// Widgets show this data, change it through the functions below, and keep no copy. Lives on the thread of the window.
class Editor : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void open(LoadedMesh mesh, DocumentState state);
  void close();
  /// Puts the document onto `mesh`, which has the vertices of the mesh before. Where `mesh` is welded within another
  /// length than the state says, that is an edit of the state.
  void remodel(LoadedMesh mesh);
  [[nodiscard]] bool isOpen() const noexcept { return mesh_.model != nullptr; }

  /// The following need an open document.
  [[nodiscard]] const LoadedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const std::shared_ptr<const Model>& model() const noexcept { return mesh_.model; }
  [[nodiscard]] const DocumentState& state() const { return *history_->state(); }
  [[nodiscard]] const ConstraintList& list() const { return state().list; }
  [[nodiscard]] const History& history() const { return *history_; }

  /// How lengths of this document are written. Decimals are the document's own; without a document there are no units.
  [[nodiscard]] LengthStyle lengthStyle() const { return {isOpen() ? list().units : std::string(), decimals_}; }
  [[nodiscard]] std::optional<int> decimals() const noexcept { return decimals_; }
  /// From 0 to `kMostLengthDecimals`, or none. No edit: nothing that is solved or saved as a constraint changes.
  void setDecimals(std::optional<int> decimals);

  /// The newest finished deformation; null before the first, and without a document.
  [[nodiscard]] const std::shared_ptr<const DeformResult>& deformation() const noexcept { return shown_.deformation; }
  /// That of `deformation`, with what a rest has found besides (`LiveEvent::Kind::Examined`); null with it.
  [[nodiscard]] const std::shared_ptr<const Report>& report() const noexcept { return shown_.report; }
  /// Whether `report` says what the solution made of the part: it does some milliseconds after `deformed`.
  [[nodiscard]] bool isResultKnown() const
  {
    return report() == nullptr || report()->solve.status == SolveStatus::Failed ||
           report()->result.status != ResultStatus::NotMeasured;
  }
  /// The state of `deformation`; null with it. Names and places in the report belong to its list.
  [[nodiscard]] const std::shared_ptr<const DocumentState>& deformedState() const noexcept { return shown_.state; }
  [[nodiscard]] const Positions& positions() const { return surface()->positions(); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const
  {
    return shown_.surface ? shown_.surface : mesh_.surface;
  }
  /// Where the constraints of `deformedState` act in `deformation`, disabled ones last; null with it.
  [[nodiscard]] const std::shared_ptr<const MarkSet>& marks() const noexcept { return shown_.marks; }
  /// The outcome of the constraint of this name, probably at `row`; null if nothing was solved with it. O(1) mostly.
  [[nodiscard]] const ConstraintOutcome* outcome(const std::string& name, Index row) const;
  /// That of its outcome; disabled if the list says so, nothing without an outcome or if it was disabled then.
  [[nodiscard]] std::optional<ConstraintStatus> status(const Constraint& constraint, Index row) const;
  [[nodiscard]] SolveState solveState() const noexcept { return solveState_; }
  /// How long the picture has been older than the list, while that is being solved.
  [[nodiscard]] double secondsOlder() const
  {
    return solveState_ == SolveState::Solving ? static_cast<double>(older_.elapsed()) / 1000 : 0;
  }
  /// Whether results are those of the list on screen.
  [[nodiscard]] bool isCurrent() const noexcept { return solveState_ == SolveState::Current; }
  /// Why the newest state cannot be solved; empty otherwise.
  [[nodiscard]] const QString& error() const noexcept { return error_; }
  /// The current step of the worker; empty while it is idle.
  [[nodiscard]] const QString& step() const noexcept { return step_; }

  /// Each is one entry of the history. `name` says what the edit does, for the menu: "move P1".
  void edit(const QString& name, ConstraintList after);
  void setOptions(const QString& name, const DeformOptions& options);
  /// A drag: any number of states, one entry. `cancelGesture` restores the state and the picture before it.
  void beginGesture(const QString& name) { history_->beginGesture(name.toStdString()); }
  void updateGesture(ConstraintList after);
  void endGesture();
  void cancelGesture();
  /// Whether the mesh is welded within the length that the state says. Nothing is solved before it is.
  [[nodiscard]] bool hasItsMesh() const { return state().options.weldTolerance == mesh_.weldTolerance; }
  /// Asks for a mesh welded within this length, by `meshWanted`.
  void weldWithin(double tolerance) { Q_EMIT meshWanted(tolerance); }
  /// Of many in quick succession on a large mesh only the last state is solved and shown.
  void undo()
  {
    if (isOpen() && history_->undo()) stateIsAnother();
  }
  void redo()
  {
    if (isOpen() && history_->redo()) stateIsAnother();
  }
  /// The user's file holds `state`, which was shown before.
  void markSaved(std::shared_ptr<const DocumentState> state);
  /// The document is in no file although nothing was edited: a copy that a crash has left.
  void markUnsaved();

  /// Stops the work under way; the state stays as it is. `solve` starts it again.
  void cancelSolving();
  void solve()
  {
    if (isOpen()) submit(Supersede::AtNextStep);
  }

  /// The deformation is in the picture: `LiveDeformer::resultIsSeen`.
  void resultIsSeen()
  {
    if (isOpen()) worker_->resultIsSeen();
  }

  /// Selected vertices of the file, ascending; and selected constraints by their place in the list, ascending.
  [[nodiscard]] const std::vector<Index>& selectedVertices() const noexcept { return selectedVertices_; }
  [[nodiscard]] const std::vector<Index>& selectedConstraints() const noexcept { return selectedConstraints_; }
  /// `shape` replaces the ids in constraints on these vertices, as long as they stay selected: a curve.
  void selectVertices(std::vector<Index> vertices, std::optional<Selection> shape = std::nullopt);
  [[nodiscard]] Selection selection() const { return selectedShape_.value_or(Selection{VertexIds{selectedVertices_}}); }
  void selectConstraints(std::vector<Index> constraints);

  /// None without a document. Locations of measurements are those of picks. Each change is one entry of the history,
  /// and needs no solution.
  [[nodiscard]] const Annotations& annotations() const;
  [[nodiscard]] const Measurements& measurements() const { return annotations().measurements; }
  /// Where only probes differ, a saved document stays one.
  void setMeasurements(const QString& name, Measurements measurements);
  void setSavedSelections(const QString& name, std::vector<SavedSelection> selections);
  [[nodiscard]] const UnderCursor& underCursor() const noexcept { return underCursor_; }
  void setUnderCursor(UnderCursor underCursor);

 Q_SIGNALS:
  void opened();  ///< another document, or none
  /// The user or an undone state asks for a mesh that is welded so; `DocumentFiles` prepares it and calls `remodel`.
  void meshWanted(double weldTolerance);
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
