#include "holdfast/window/model/editor.h"

#include <QFileInfo>
#include <algorithm>
#include <cassert>
#include <utility>

namespace holdfast {
namespace {

// Solved states: enough to go back and forth between neighbours at once, and small beside the factor.
constexpr std::size_t kRemembered = 6;

std::shared_ptr<const VisibleSurface> moved(const VisibleSurface& atRest,
                                            const std::shared_ptr<const DeformResult>& deformation)
{
  return std::make_shared<const VisibleSurface>(atRest.movedTo({deformation, &deformation->positions}));
}

}  // namespace

Editor::Editor(QObject* parent) : QObject(parent) {}

Editor::~Editor() = default;

void Editor::open(LoadedMesh mesh, DocumentState state)
{
  assert(mesh.model != nullptr);
  close();
  mesh_ = std::move(mesh);
  history_ = std::make_unique<History>(std::move(state));
  // The worker prepares the picture and picks, so that the window does not wait for them.
  auto prepared = [atRest = mesh_.surface, model = mesh_.model,
                   marks = std::shared_ptr<const MarkSet>()](const LiveEvent& event) mutable -> Solved {
    if (event.deformation == nullptr) return {};
    marks = markSet(constraintMarks(*model, event.state->list, *event.deformation), marks);
    return {event.state, event.deformation, moved(*atRest, event.deformation), marks};
  };
  worker_ = std::make_unique<LiveDeformer>(mesh_.model, [this, prepared](const LiveEvent& event) mutable {
    calls_.post([this, event, solved = prepared(event)] { handle(event, solved); });
  });
  Q_EMIT opened();
  stateBecame(Supersede::AtNextStep);
}

void Editor::close()
{
  if (!isOpen()) return;
  worker_.reset();
  history_.reset();
  mesh_ = {};
  submitted_.clear();
  solved_.clear();
  deformation_.reset();
  deformedState_.reset();
  deformedSurface_.reset();
  deformedMarks_.reset();
  selectedVertices_.clear();
  selectedShape_.reset();
  selectedConstraints_.clear();
  setStep({});
  setSolveState(SolveState::Nothing, {});
  Q_EMIT opened();
}

const std::shared_ptr<const VisibleSurface>& Editor::surface() const
{
  return deformedSurface_ ? deformedSurface_ : mesh_.surface;
}

void Editor::edit(const QString& name, ConstraintList after)
{
  history_->edit(name.toStdString(), {std::move(after), state().options});
  stateBecame(Supersede::AtNextStep);
}

void Editor::setOptions(const QString& name, const DeformOptions& options)
{
  history_->edit(name.toStdString(), {list(), options});
  stateBecame(Supersede::AtNextStep);
}

void Editor::beginGesture(const QString& name)
{
  history_->beginGesture(name.toStdString());
}

void Editor::updateGesture(ConstraintList after)
{
  history_->updateGesture({std::move(after), state().options});
  stateBecame(Supersede::WhenDone);
}

void Editor::endGesture()
{
  if (!history_->isInGesture()) return;
  history_->endGesture();
  Q_EMIT stateChanged();
}

void Editor::cancelGesture()
{
  if (!history_->isInGesture()) return;
  history_->cancelGesture();
  stateBecame(Supersede::AtNextStep);
}

void Editor::undo()
{
  if (isOpen() && history_->undo()) stateBecame(Supersede::AtNextStep);
}

void Editor::redo()
{
  if (isOpen() && history_->redo()) stateBecame(Supersede::AtNextStep);
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

void Editor::solve()
{
  if (!isOpen()) return;
  const auto state = history_->state();
  ++revision_;
  submitted_.emplace_back(revision_, state);
  setSolveState(SolveState::Solving, {});
  worker_->submit(revision_, state, mesh_.path.filename().string(), Supersede::AtNextStep);
}

void Editor::stateBecame(Supersede supersede)
{
  dropVanishedSelection();
  const auto state = history_->state();
  if (const auto known = remembered(state)) {
    worker_->cancel();
    submitted_.clear();
    setStep({});
    show(*known);
    setSolveState(SolveState::Current, {});
    Q_EMIT stateChanged();
    return;
  }
  ++revision_;
  submitted_.emplace_back(revision_, state);
  setSolveState(SolveState::Solving, {});
  worker_->submit(revision_, state, mesh_.path.filename().string(), supersede);
  Q_EMIT stateChanged();
}

void Editor::show(Solved solved)
{
  remember(solved);
  deformedState_ = std::move(solved.state);
  deformation_ = std::move(solved.deformation);
  deformedSurface_ = std::move(solved.surface);
  deformedMarks_ = std::move(solved.marks);
  Q_EMIT deformed();
}

void Editor::remember(const Solved& solved)
{
  std::erase_if(solved_, [&](const Solved& other) { return other.state == solved.state; });
  solved_.push_back(solved);
  if (solved_.size() > kRemembered) solved_.pop_front();
}

std::optional<Editor::Solved> Editor::remembered(const std::shared_ptr<const DocumentState>& state) const
{
  const auto found =
      std::find_if(solved_.begin(), solved_.end(), [&](const Solved& solved) { return solved.state == state; });
  return found == solved_.end() ? std::nullopt : std::optional(*found);
}

void Editor::handle(const LiveEvent& event, Solved solved)
{
  using Kind = LiveEvent::Kind;
  // Ignores events of states that were cancelled, shown from memory or belong to another document.
  while (!submitted_.empty() && submitted_.front().first < event.revision) submitted_.pop_front();
  if (submitted_.empty() || submitted_.front().first != event.revision) return;
  if (event.kind == Kind::Started) return;
  if (event.kind == Kind::Step) return setStep(QString::fromStdString(event.message));

  submitted_.pop_front();
  const bool isNewest = submitted_.empty();
  if (isNewest) setStep({});
  if (event.kind == Kind::Done) show(std::move(solved));
  if (!isNewest) return;
  if (event.kind == Kind::Done) setSolveState(SolveState::Current, {});
  if (event.kind == Kind::Cancelled) setSolveState(SolveState::Cancelled, {});
  if (event.kind == Kind::Unusable || event.kind == Kind::Broken)
    setSolveState(SolveState::Unusable, QString::fromStdString(event.message));
}

void Editor::setSolveState(SolveState solveState, const QString& error)
{
  if (solveState_ == solveState && error_ == error) return;
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
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  selectedShape_ = std::move(shape);
  if (vertices == selectedVertices_) return;
  selectedVertices_ = std::move(vertices);
  Q_EMIT vertexSelectionChanged();
}

Selection Editor::selection() const
{
  return selectedShape_ ? *selectedShape_ : Selection{VertexIds{selectedVertices_}};
}

void Editor::selectConstraints(std::vector<Index> constraints)
{
  std::sort(constraints.begin(), constraints.end());
  constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());
  if (constraints == selectedConstraints_) return;
  selectedConstraints_ = std::move(constraints);
  Q_EMIT constraintSelectionChanged();
}

void Editor::dropVanishedSelection()
{
  auto kept = selectedConstraints_;
  const Index size = static_cast<Index>(list().constraints.size());
  std::erase_if(kept, [&](Index k) { return k >= size; });
  selectConstraints(std::move(kept));
}

}  // namespace holdfast
