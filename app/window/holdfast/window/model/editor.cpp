#include "holdfast/window/model/editor.h"

#include <QTimer>
#include <algorithm>
#include <cassert>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/threads/background_threads.h>
#include <holdfast/widgets/mesh/coarse_surface.h>

namespace holdfast {
namespace {

// Solved states: enough to go back and forth between neighbours at once, and small beside the factor.
constexpr std::size_t kRemembered = 6;

// Scans have flat places by chance alone: 0.0002 to 0.016 of the edges of six of them lie within a plane, and 0.2 to 1
// of those of models of CAD programs.
constexpr double kFlatShareOfScans = 0.02;

// So many coordinates tell.
constexpr Index kSampledCoordinates = 3000;

bool isFloat(double value)
{
  return static_cast<double>(static_cast<float>(value)) == value;
}

/// Tells whether nine digits hold the value: text formats write a float with so many.
bool hasNineDigits(double value)
{
  const std::string digits = fmt::format("{:.9g}", value);
  double read = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), read);
  return read == value;
}

bool hasSinglePrecision(const Positions& positions, bool isText)
{
  const Index step = std::max<Index>(1, positions.size() / kSampledCoordinates);
  for (Index k = 0; k < positions.size(); k += step)
    if (!isFloat(positions.data()[k]) && !(isText && hasNineDigits(positions.data()[k]))) return false;
  return true;
}

}  // namespace

LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress, double weldTolerance)
{
  progress.step(fmt::format("reading {}", path.filename().string()));
  return prepareMesh(readMesh(path), path, progress, weldTolerance);
}

LoadedMesh prepareMesh(MeshDocument document, const std::filesystem::path& path, Progress& progress,
                       double weldTolerance)
{
  progress.step(fmt::format("preparing {} vertices", document.mesh.vertexCount()));
  LoadedMesh loaded;
  loaded.path = path;
  loaded.document = std::move(document);
  loaded.model = std::make_shared<const Model>(makeModelOfFile(loaded.document, path.string(), weldTolerance));
  loaded.weldTolerance = weldTolerance;
  const Model& model = *loaded.model;
  loaded.selector = std::make_shared<Selector>(model.mesh, model.solverMesh, model.locator());
  loaded.regions = std::make_shared<VertexRegions>(model.mesh, model.solverMesh);
  loaded.contents = std::make_shared<SceneContents>(model);
  if (isLarge(model)) loaded.contents->setDetail(Detail::Coarse);
  loaded.surface = std::make_shared<const VisibleSurface>(model);
  loaded.surface->prepare();
  const auto& source = loaded.document.source;
  loaded.isScan = loaded.regions->flatShare() < kFlatShareOfScans &&
                  hasSinglePrecision(model.mesh.positions, source && source->isText());
  return loaded;
}

bool isLarge(const Model& model)
{
  return static_cast<Index>(model.triangulation.triangles.size()) > 2 * kCoarseTriangles;
}

void Editor::open(LoadedMesh mesh, DocumentState state)
{
  close();
  start(std::move(mesh), std::make_unique<History>(std::move(state)));
}

void Editor::remodel(LoadedMesh mesh)
{
  endGesture();
  std::vector<Index> vertices = selectedVertices_;
  std::optional<Selection> shape = selectedShape_;
  std::vector<Index> constraints = selectedConstraints_;
  std::unique_ptr<History> history = std::move(history_);
  DeformOptions options = history->state()->options;
  if (std::exchange(options.weldTolerance, mesh.weldTolerance) != mesh.weldTolerance)
    history->edit(
        mesh.weldTolerance > 0 ? fmt::format("weld within {:.6g}", mesh.weldTolerance) : "weld what coincides only",
        {history->state()->list, options, history->state()->annotations});
  close();
  start(std::move(mesh), std::move(history));
  selectVertices(std::move(vertices), std::move(shape));
  selectConstraints(std::move(constraints));
}

void Editor::start(LoadedMesh mesh, std::unique_ptr<History> history)
{
  assert(mesh.model != nullptr);
  mesh_ = std::move(mesh);
  history_ = std::move(history);
  // The worker prepares the picture, picks and outcomes, so that the window does not wait for them.
  auto prepared = [atRest = mesh_.surface, model = mesh_.model, places = KnownPlaces(),
                   marks = std::shared_ptr<const MarkSet>()](const LiveEvent& event) mutable -> Solved {
    if (event.deformation == nullptr) return {};
    static_cast<void>(event.deformation->report.constraints.all());
    marks = markSet(*model, constraintMarks(*model, event.state->list, *event.deformation, places), marks,
                    constraintGuides(*model, *event.deformation));
    auto surface =
        std::make_shared<const VisibleSurface>(atRest->movedTo({event.deformation, &event.deformation->positions}));
    return {event.state,
            event.deformation,
            std::move(surface),
            marks,
            std::shared_ptr<const Report>(event.deformation, &event.deformation->report),
            event.revision};
  };
  worker_ = std::make_unique<LiveDeformer>(mesh_.model, [this, prepared](const LiveEvent& event) mutable {
    const Solved solved = prepared(event);
    calls_.post([this, event, solved] { handle(event, solved); });
    // The picture does not wait for rays, nor does a drag.
    if (solved.surface && !isDragging_) solved.surface->prepare();
  });
  Q_EMIT opened();
  stateBecame(Supersede::AtNextStep);
}

void Editor::close()
{
  if (!isOpen()) return;
  isDragging_ = false;
  worker_.reset();
  history_.reset();
  isShowDue_ = false;
  mesh_ = {};
  submitted_.clear();
  solved_.clear();
  outcomeOf_.clear();
  shown_ = {};
  selectedVertices_.clear();
  selectedShape_.reset();
  selectedConstraints_.clear();
  lastAnnotations_.reset();
  underCursor_ = {};
  setSolveState(SolveState::Nothing, {});  // first: while one solves there is a document
  setStep({});
  Q_EMIT opened();
}

const ConstraintOutcome* Editor::outcome(const std::string& name, Index row) const
{
  if (deformation() == nullptr) return nullptr;
  const ConstraintOutcomes& outcomes = deformation()->report.constraints;
  if (row < static_cast<Index>(outcomes.size()) && outcomes[row].name == name) return &outcomes[row];
  if (outcomeOf_.empty())
    for (const ConstraintOutcome& outcome : outcomes)
      outcomeOf_.emplace(outcome.name, static_cast<Index>(outcomeOf_.size()));
  const auto found = outcomeOf_.find(name);
  return found == outcomeOf_.end() ? nullptr : &outcomes[found->second];
}

std::optional<ConstraintStatus> Editor::status(const Constraint& constraint, Index row) const
{
  if (!constraint.isEnabled) return ConstraintStatus::Disabled;
  const ConstraintOutcome* found = outcome(constraint.name, row);
  if (found == nullptr || found->status == ConstraintStatus::Disabled) return std::nullopt;
  return found->status;
}

void Editor::edit(const QString& name, ConstraintList after)
{
  history_->edit(name.toStdString(), {std::move(after), state().options, state().annotations});
  stateBecame(Supersede::AtNextStep);
}

void Editor::setOptions(const QString& name, const DeformOptions& options)
{
  history_->edit(name.toStdString(), {list(), options, state().annotations});
  stateBecame(Supersede::AtNextStep);
}

void Editor::updateGesture(ConstraintList after)
{
  isDragging_ = true;
  history_->updateGesture({std::move(after), state().options, state().annotations});
  stateBecame(Supersede::WhenDone);
}

void Editor::endGesture()
{
  if (!history_->isInGesture()) return;
  history_->endGesture();
  isDragging_ = false;
  if (shown_.surface) startBackgroundThread([surface = shown_.surface] { surface->prepare(); });
  // Rotations were found from frame to frame; the state has to have those that any other program finds for it.
  if (state().options.rotations.source != RotationSource::Given) submit(Supersede::AtNextStep);
  Q_EMIT stateChanged();
}

void Editor::cancelGesture()
{
  if (!history_->isInGesture()) return;
  history_->cancelGesture();
  isDragging_ = false;
  stateBecame(Supersede::AtNextStep);
}

void Editor::markSaved(std::shared_ptr<const DocumentState> state)
{
  history_->markSaved(std::move(state));
  Q_EMIT saved();
}

void Editor::markUnsaved()
{
  history_->markUnsaved();
  Q_EMIT saved();
}

void Editor::cancelSolving()
{
  if (solveState_ != SolveState::Solving) return;
  worker_->cancel();
  submitted_.clear();
  setStep({});
  setSolveState(SolveState::Cancelled, {});
}

void Editor::submit(Supersede supersede)
{
  if (!hasItsMesh()) {
    setSolveState(SolveState::Solving, {});
    return weldWithin(state().options.weldTolerance);
  }
  const auto state = history_->state();
  ++revision_;
  submitted_.emplace_back(revision_, state);
  setSolveState(SolveState::Solving, {});
  worker_->submit(revision_, state, mesh_.path.filename().string(), supersede);
}

void Editor::stateBecame(Supersede supersede)
{
  keepSelection();
  showOrSubmit(supersede);
  tellState();
}

void Editor::tellState()
{
  Q_EMIT stateChanged();
  if (std::exchange(lastAnnotations_, state().annotations) != state().annotations) Q_EMIT annotationsChanged();
}

void Editor::stateIsAnother()
{
  if (!isLarge(*model())) return stateBecame(Supersede::AtNextStep);
  keepSelection();
  worker_->cancel();
  submitted_.clear();
  setSolveState(SolveState::Solving, {});
  isShowDue_ = true;
  // Keys that are waiting come first.
  QTimer::singleShot(0, this, [this] {
    if (isOpen() && isShowDue_) showOrSubmit(Supersede::AtNextStep);
  });
  tellState();
}

void Editor::keepSelection()
{
  auto kept = selectedConstraints_;
  std::erase_if(kept, [&](Index k) { return k >= static_cast<Index>(list().constraints.size()); });
  selectConstraints(std::move(kept));
}

void Editor::showOrSubmit(Supersede supersede)
{
  isShowDue_ = false;
  const auto known = std::find_if(solved_.begin(), solved_.end(),
                                  [&](const Solved& solved) { return solved.state == history_->state(); });
  if (known == solved_.end()) return submit(supersede);
  worker_->cancel();
  submitted_.clear();
  setStep({});
  if (known->deformation == shown_.deformation)
    shown_.state = known->state;
  else
    show(Solved(*known));
  remember();
  setSolveState(SolveState::Current, {});
}

void Editor::show(Solved solved)
{
  outcomeOf_.clear();
  shown_ = std::move(solved);
  older_.start();
  Q_EMIT deformed();
}

void Editor::remember()
{
  std::erase_if(solved_, [&](const Solved& other) { return other.state == shown_.state; });
  solved_.push_back(shown_);
  if (solved_.size() > kRemembered) solved_.pop_front();
}

void Editor::handle(const LiveEvent& event, Solved solved)
{
  using Kind = LiveEvent::Kind;
  if (event.kind == Kind::Examined) return takeReport(event);
  // Ignores events of states that were cancelled, shown from memory or belong to another document.
  while (!submitted_.empty() && submitted_.front().first < event.revision) submitted_.pop_front();
  if (submitted_.empty() || submitted_.front().first != event.revision) return;
  if (event.kind == Kind::Started) return;
  if (event.kind == Kind::Step) return setStep(QString::fromStdString(event.message));
  if (event.kind == Kind::Iterate) return show(std::move(solved));

  submitted_.pop_front();
  const bool isNewest = submitted_.empty();
  if (isNewest) setStep({});
  if (event.kind == Kind::Done) {
    show(std::move(solved));
    remember();
  }
  if (!isNewest) return;
  if (event.kind == Kind::Done) setSolveState(SolveState::Current, {});
  if (event.kind == Kind::Cancelled) setSolveState(SolveState::Cancelled, {});
  if (event.kind == Kind::Unusable || event.kind == Kind::Broken)
    setSolveState(SolveState::Unusable, QString::fromStdString(event.message));
}

void Editor::takeReport(const LiveEvent& event)
{
  const auto isExamined = [&](const Solved& solved) { return solved.revision == event.revision; };
  for (Solved& solved : solved_)
    if (isExamined(solved)) solved.report = event.report;
  if (!isExamined(shown_)) return;
  shown_.report = event.report;
  Q_EMIT examined();
}

void Editor::setSolveState(SolveState solveState, const QString& error)
{
  if (solveState_ == solveState && error_ == error) return;
  if (solveState_ != SolveState::Solving) older_.start();
  solveState_ = solveState;
  error_ = error;
  Q_EMIT solveStateChanged();
}

void Editor::setStep(const QString& step)
{
  if (step_ == step) return;
  step_ = step;
  Q_EMIT stepChanged();
}

void Editor::selectVertices(std::vector<Index> vertices, std::optional<Selection> shape)
{
  vertices = sortedOnce(std::move(vertices));
  selectedShape_ = std::move(shape);
  if (vertices == selectedVertices_) return;
  selectedVertices_ = std::move(vertices);
  Q_EMIT vertexSelectionChanged();
}

void Editor::selectConstraints(std::vector<Index> constraints)
{
  constraints = sortedOnce(std::move(constraints));
  if (constraints == selectedConstraints_) return;
  selectedConstraints_ = std::move(constraints);
  Q_EMIT constraintSelectionChanged();
}

const Annotations& Editor::annotations() const
{
  static const Annotations kEmpty;
  return isOpen() ? *state().annotations : kEmpty;
}

void Editor::setMeasurements(const QString& name, Measurements measurements)
{
  const bool areRulersSame = measurements.rulers == this->measurements().rulers;
  annotate(name, {annotations().selections, std::move(measurements)},
           areRulersSame ? EditKind::Aside : EditKind::OfDocument);
}

void Editor::setSavedSelections(const QString& name, std::vector<SavedSelection> selections)
{
  annotate(name, {std::move(selections), measurements()}, EditKind::OfDocument);
}

void Editor::annotate(const QString& name, Annotations after, EditKind kind)
{
  history_->edit(name.toStdString(), {list(), state().options, std::make_shared<const Annotations>(std::move(after))},
                 kind);
  // What is being solved is solved for this state as well.
  if (isCurrent()) {
    shown_.state = history_->state();
    remember();
  }
  tellState();
}

void Editor::setDecimals(std::optional<int> decimals)
{
  if (std::exchange(decimals_, decimals) != decimals) Q_EMIT decimalsChanged();
}

void Editor::setUnderCursor(UnderCursor underCursor)
{
  const bool wasAnything = underCursor_.pick || underCursor_.constraint;
  underCursor_ = std::move(underCursor);
  if (wasAnything || underCursor_.pick || underCursor_.constraint) Q_EMIT underCursorChanged();
}

}  // namespace holdfast
