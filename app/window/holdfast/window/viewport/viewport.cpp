#include "holdfast/window/viewport/viewport.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include <vtkBoundingBox.h>
#include <vtkCamera.h>

#include <holdfast/base/thread_priority.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/example_document.h>
#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/window/viewport/view_state.h>
#include <holdfast/window/viewport/viewport_overlay.h>

namespace holdfast {
namespace {

// Threads of Mesa's renderer for machines without a GPU.
constexpr const char* kDrawingThreads = "llvmpipe-";

// Beyond this a moving picture is drawn of fewer triangles.
constexpr double kFluentMilliseconds = 30;
constexpr int kRestMilliseconds = 250;

// Between two looks at the fence.
constexpr int kMillisecondsBetweenLooks = 1;

// Longer than any picture takes.
constexpr std::chrono::seconds kLongestWait(10);

// For the legend and the axes in the corner, and at most a share of the width.
constexpr double kPixelsFreeAtRight = 140;
constexpr double kMostFreeAtRight = 0.25;

constexpr std::size_t kMostViews = 200;

double millisecondsOf(const QElapsedTimer& timer)
{
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

/// Where constraints act on the way from rest.
std::vector<ConstraintMark> marksAt(std::vector<ConstraintMark> marks, double share)
{
  for (ConstraintMark& mark : marks) mark.place = (1 - share) * mark.rest + share * mark.place;
  return marks;
}

/// A mesh at rest would have one dark colour, and look like a result. The user wants a range that he has fixed.
bool saysAnything(const Coloring& coloring, const ColorSettings& settings)
{
  if (std::holds_alternative<FixedRange>(settings.range)) return true;
  // Residuals of zero are a result.
  const bool isZeroShown = settings.field == ColorBy::ConstraintResidual;
  return std::any_of(coloring.values.begin(), coloring.values.end(),
                     [&](double value) { return isZeroShown ? value >= 0 : std::abs(value) > 0; });
}

}  // namespace

Viewport::Viewport(Editor& editor, QWidget* parent) : VtkView(parent), editor_(editor)
{
  setObjectName("viewport");
  setAccessibleName(tr("Picture of the mesh"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);

  window_->SetNumberOfLayers(2);
  window_->AddRenderer(renderer_);
  window_->AddRenderer(widgetRenderer_);
  widgetRenderer_->SetLayer(2);
  widgetRenderer_->SetActiveCamera(renderer_->GetActiveCamera());
  widgetRenderer_->PreserveDepthBufferOn();
  renderer_->GradientBackgroundOn();
  setDarkBackdrop(false);
  interactor()->SetInteractorStyle(style_);
  style_->AutoAdjustCameraClippingRangeOff();
  style_->AddObserver(ContextMenuRequestEvent, this, &Viewport::askForContextMenu);
  addLights(*renderer_);
  addLights(*widgetRenderer_);
  orientation_->SetParentRenderer(renderer_);
  orientation_->AnimateOff();
  orientation_->KeyPressActivationOff();
  orientation_->AddObserver(vtkCommand::EndInteractionEvent, this, &Viewport::lookAlongAxis);
  orientation_->On();

  marksUnderCursor_->SetRenderer(renderer_);
  fence_ = std::make_unique<DrawFence>(*window_);
  slices_ = std::make_unique<SlicedDrawing>(*renderer_);
  kept_ = std::make_unique<KeptScene>(*renderer_, *orientation_->GetDefaultRenderer());
  overlay_ = new ViewportOverlay(editor_, *this);
  renderTimer_.setSingleShot(true);
  connect(&renderTimer_, &QTimer::timeout, this, &Viewport::render);
  restTimer_.setSingleShot(true);
  restTimer_.setInterval(kRestMilliseconds);
  connect(&restTimer_, &QTimer::timeout, this, &Viewport::renderInFull);
  drawnTimer_.setSingleShot(true);
  connect(&drawnTimer_, &QTimer::timeout, this, &Viewport::goOnWhenDrawn);
  connect(this, &QOpenGLWidget::frameSwapped, this, [this] { waiting_.invalidate(); });

  connect(this, &VtkView::renderWanted, this, &Viewport::scheduleWidgets);
  connect(&editor_, &Editor::opened, this, &Viewport::openDocument);
  connect(&editor_, &Editor::deformed, this, &Viewport::showResult);
  connect(&editor_, &Editor::vertexSelectionChanged, this, &Viewport::showSelection);
  connect(&editor_, &Editor::constraintSelectionChanged, this, &Viewport::showSelection);
}

Viewport::~Viewport()
{
  // Widgets must not call the interactor while it is destroyed.
  Q_EMIT closing();
}

void Viewport::warmUp(const ExampleDocument& example)
{
  std::vector<Index> corners(static_cast<std::size_t>(example.model.mesh.vertexCount()));
  std::iota(corners.begin(), corners.end(), Index{0});
  SceneContents contents(example.model);
  contents.addTo(*renderer_);
  contents.showShape(example.deformation);
  contents.setMarks(constraintMarks(example.model, example.list, example.deformation));
  contents.setSelection(corners);
  contents.highlight({0});
  contents.setRotationDisplay(RotationDisplay::Arrows);
  contents.setRestGhost(RestGhost::Surface);
  contents.setMeshEdges(MeshEdges::All);
  renderer_->ResetCamera();
  for (const ColorBy colors : {ColorBy::None, ColorBy::Angle}) {
    contents.color(coloringOf(example.model, example.deformation, colors, ""));
    grabFramebuffer();
  }
  if (kept_->isCurrent()) kept_->drawLayersAbove();
}

void Viewport::setDarkBackdrop(bool isDark)
{
  std::array bottom = isDark ? std::array{0.16, 0.17, 0.19} : std::array{1.0, 1.0, 1.0};
  std::array top = isDark ? std::array{0.24, 0.26, 0.29} : std::array{0.90, 0.915, 0.935};
  renderer_->SetBackground(bottom.data());
  renderer_->SetBackground2(top.data());
  scheduleRender();
}

LegendContent Viewport::legend() const
{
  return overlay_->legend();
}

void Viewport::openDocument()
{
  cancelGesture();
  shownShare_ = 1;
  Q_EMIT shownShareChanged(shownShare_);
  lookUnderCursor(nullptr);
  abandonDrawing();
  renderer_->RemoveAllViewProps();
  contents_.reset();
  coloring_.reset();
  hidden_.reset();
  Q_EMIT hiddenChanged(false);
  if (editor_.isOpen()) {
    contents_ = editor_.mesh().contents;
    contents_->setPixelRatio(pixelRatio());
    contents_->addTo(*renderer_);
    contents_->setSection(section_);
    // A guess until the first full picture was measured.
    fullMilliseconds_ = isLarge(*editor_.model()) ? 2 * kFluentMilliseconds : 0;
    setDisplay(display_);
    showColors();
    setUpAxis(upAxisOf(editor_.mesh()));
    lookFromCorner();
    forgetViews();
    openedFrom_ = Vector3(renderer_->GetActiveCamera()->GetPosition());
  } else {
    Q_EMIT marksChanged();
  }
  showSurface();
  scheduleRender();
}

void Viewport::showSurface()
{
  surface_ = editor_.isOpen() ? shownSurface() : nullptr;
  if (surface_ && (section_ || hidden_))
    surface_ = std::make_shared<const VisibleSurface>(surface_->withSection(section_).withHidden(hidden_));
  if (surface_) contents_->setCut(surface_->cut());
  style_->SetSurface(surface_);
  Q_EMIT surfaceChanged();
}

std::shared_ptr<const VisibleSurface> Viewport::shownSurface() const
{
  const auto& rest = editor_.mesh().surface;
  if (shownShare_ == 0) return rest;
  if (shownShare_ == 1) return editor_.surface();
  return std::make_shared<const VisibleSurface>(rest->movedTo(
      std::make_shared<const Positions>((1 - shownShare_) * rest->positions() + shownShare_ * editor_.positions())));
}

void Viewport::setShownShare(double share)
{
  if (shownShare_ != share && editor_.deformation()) {
    shownShare_ = share;
    prepareToMove();
    showSurface();
    contents_->setPositions(surface_->positions());
    showConstraints();
  }
  Q_EMIT shownShareChanged(shownShare_);
}

void Viewport::setSection(const std::optional<SectionPlane>& section)
{
  if (section_ == section) return;
  section_ = section;
  if (!contents_) return;
  prepareToMove();
  contents_->setSection(section_);
  showSurface();
  scheduleRender();
  Q_EMIT marksChanged();
}

void Viewport::showResult()
{
  prepareToMove();
  if (std::exchange(shownShare_, 1) != 1) Q_EMIT shownShareChanged(1);
  showSurface();
  // So far the picture showed the mesh at rest. A camera that has moved since stays where it is.
  if (const auto eye = std::exchange(openedFrom_, std::nullopt);
      eye && *eye == Vector3(renderer_->GetActiveCamera()->GetPosition())) {
    frameAll();
    forgetViews();
  }
  contents_->showShape(*editor_.deformation());
  showConstraints();
  showColors();
}

void Viewport::showConstraints()
{
  if (!contents_) return;
  if (const auto& marks = editor_.marks())
    contents_->showMarks(shownShare_ == 1 ? marks
                                          : markSet(*editor_.model(), marksAt(marks->marks, shownShare_), marks));
  arrange(*contents_, display_);
  overlay_->update();
  scheduleRender();
  Q_EMIT marksChanged();
}

void Viewport::showColors()
{
  coloring_.reset();
  if (const auto& deformation = editor_.deformation())
    coloring_ = coloringOf(*editor_.model(), *deformation, colors_, editor_.deformedState()->list.units);
  if (coloring_ && !saysAnything(*coloring_, colors_)) coloring_.reset();
  contents_->color(coloring_);
  overlay_->update();
  scheduleRender();
  Q_EMIT coloringChanged(coloring_);
}

void Viewport::showSelection()
{
  if (!contents_) return;
  prepareToMove();
  contents_->setSelection(editor_.selectedVertices());
  contents_->highlight(editor_.selectedConstraints());
  scheduleRender();
}

void Viewport::setColors(const ColorSettings& settings)
{
  colors_ = settings;
  if (contents_) showColors();
}

void Viewport::setDisplay(const DisplaySettings& settings)
{
  display_ = settings;
  showConstraints();
}

const std::vector<ConstraintMark>& Viewport::marks() const noexcept
{
  static const std::vector<ConstraintMark> none;
  return contents_ ? contents_->marks() : none;
}

void Viewport::frameAll()
{
  if (editor_.isOpen()) fitCamera(frameOf(*renderer_->GetActiveCamera()));
}

void Viewport::lookFromCorner()
{
  if (editor_.isOpen()) fitCamera(defaultFrame(shownPositions(), upAxis_));
}

void Viewport::setUpAxis(UpAxis axis)
{
  upAxis_ = axis;
  Q_EMIT upAxisChanged(axis);
}

void Viewport::setCamera(const Camera& camera)
{
  openedFrom_.reset();
  place(*renderer_->GetActiveCamera(), camera);
  cameraMoved();
  Q_EMIT projectionChanged(camera.isParallel);
}

void Viewport::goBack(std::vector<Camera>& from, std::vector<Camera>& to)
{
  noteView();
  if (from.empty()) return;
  to.push_back(*shownView_);
  setCamera(from.back());
  from.pop_back();
  shownView_ = cameraOf(*renderer_->GetActiveCamera());
}

void Viewport::forgetViews()
{
  earlierViews_.clear();
  laterViews_.clear();
  shownView_.reset();
}

/// A drag, or a turn of the wheel by several notches, is one change.
void Viewport::noteView()
{
  const Camera view = cameraOf(*renderer_->GetActiveCamera());
  const Camera before = std::exchange(shownView_, view).value_or(view);
  if (before == view) return;
  if (std::exchange(isNewView_, false)) earlierViews_.push_back(before);
  if (earlierViews_.size() > kMostViews) earlierViews_.erase(earlierViews_.begin());
  laterViews_.clear();
}

void Viewport::fitCamera(const ViewFrame& frame)
{
  const double aspect = static_cast<double>(width()) / std::max(1, height());
  const double freeAtRight = std::min(kPixelsFreeAtRight / std::max(1, width()), kMostFreeAtRight);
  fit(*renderer_->GetActiveCamera(), frame, shownPositions(), aspect, freeAtRight);
  cameraMoved();
}

void Viewport::frameVertices(const std::vector<Index>& vertices)
{
  if (!editor_.isOpen() || vertices.empty()) return;
  framePlaces(editor_.positions()(vertices, Eigen::all));
}

void Viewport::frameConstraints(const std::vector<Index>& constraints)
{
  std::vector<Vector3> places;
  for (const ConstraintMark& mark : marks())
    if (std::binary_search(constraints.begin(), constraints.end(), mark.constraint)) places.push_back(mark.place);
  if (!places.empty())
    framePlaces(Eigen::Map<const Positions>(places.front().data(), static_cast<Index>(places.size()), 3));
}

void Viewport::framePlaces(const Positions& places)
{
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const Vector3 center = (places.colwise().minCoeff() + places.colwise().maxCoeff()).transpose() / 2;
  // A single point is shown with a tenth of the mesh around it.
  const double radius = std::max((places.rowwise() - center.transpose()).rowwise().norm().maxCoeff(),
                                 editor_.model()->solverMesh.diagonal / 20);
  const Vector3 direction = Vector3(camera.GetDirectionOfProjection());
  const double distance = 1.3 * radius / std::sin(camera.GetViewAngle() / 2 * kDegree);
  const Vector3 eye = center - distance * direction;
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(center.data());
  camera.SetParallelScale(1.3 * radius);
  cameraMoved();
}

void Viewport::lookAlong(const Vector3& direction, const Vector3& up)
{
  if (!editor_.isOpen()) return;
  const Vector3 back = -direction.normalized();
  const Vector3 right = up.cross(back).normalized();
  fitCamera({right, back.cross(right), back});
}

/// After a click on the axes in the corner: all of the mesh, with what is up upright.
void Viewport::lookAlongAxis()
{
  constexpr double kAlong = 1 - 1e-9;
  const Vector3 sight(renderer_->GetActiveCamera()->GetDirectionOfProjection());
  const Vector3 along = sight.array().round();
  if (sight.dot(along) < kAlong) return;
  const Vector3 up = upright(upAxis_, Vector3::UnitZ());
  const double rise = along.dot(up);
  lookAlong(along, rise == 0 ? up : upright(upAxis_, -rise * Vector3::UnitY()));
}

void Viewport::setParallelProjection(bool isParallel)
{
  vtkCamera& camera = *renderer_->GetActiveCamera();
  if (isParallel == isParallelProjection()) return;
  // What is at the focal point keeps its size.
  const double slope = std::tan(camera.GetViewAngle() / 2 * kDegree);
  if (isParallel) {
    camera.SetParallelScale(camera.GetDistance() * slope);
  } else {
    const Vector3 eye = Vector3(camera.GetFocalPoint()) -
                        camera.GetParallelScale() / slope * Vector3(camera.GetDirectionOfProjection());
    camera.SetPosition(eye.data());
  }
  camera.SetParallelProjection(isParallel);
  cameraMoved();
  Q_EMIT projectionChanged(isParallel);
}

bool Viewport::isParallelProjection() const
{
  return renderer_->GetActiveCamera()->GetParallelProjection() != 0;
}

void Viewport::cameraMoved()
{
  isNewView_ = true;
  fitClippingRange();
  scheduleRender();
}

void Viewport::fitClippingRange()
{
  vtkBoundingBox shown;
  for (vtkRenderer* renderer : {renderer_.Get(), widgetRenderer_.Get()})
    if (const double* bounds = renderer->ComputeVisiblePropBounds(); vtkBoundingBox::IsValid(bounds))
      shown.AddBounds(bounds);
  std::array<double, 6> bounds{};
  shown.GetBounds(bounds.data());
  if (shown.IsValid()) renderer_->ResetCameraClippingRange(bounds.data());
}

void Viewport::initializeGL()
{
  VtkView::initializeGL();
  spreadOverCores(kDrawingThreads);
}

void Viewport::paintGL()
{
  // Drawing, and putting the drawing into the window, would both wait.
  static_cast<void>(fence_->pass(kLongestWait));
  VtkView::paintGL();
  fence_->set();
}

void Viewport::schedulePicture()
{
  if (renderTimer_.isActive()) return;
  renderTimer_.start(0);
  // What else has changed in the window is shown together with the picture.
  if (!isUnseen()) pause_.begin();
}

void Viewport::scheduleRender()
{
  isSceneDue_ = true;
  schedulePicture();
  if (fullMilliseconds_ > kFluentMilliseconds) restTimer_.start();
}

void Viewport::scheduleWidgets()
{
  // A widget that has moved the camera does not report it, and the kept scene includes the balls in the corner.
  if (orientation_->GetProcessEvents() != 0 || kept_->isOutdated()) return scheduleRender();
  schedulePicture();
}

void Viewport::render()
{
  // A coarse picture under way is finished and shown first. Slices show the widgets, too.
  const bool isOneComing = (drawnTimer_.isActive() && (!slices_->isUnderWay() || !isSceneDue_)) || isUnseen();
  if (!isOneComing) abandonDrawing();
  // The driver still draws what was abandoned, and the next picture would wait for it.
  if (isOneComing || !fence_->pass()) return renderTimer_.start(kMillisecondsBetweenLooks);
  if (!isVisible()) return;
  const bool areOnlyWidgets = !std::exchange(isSceneDue_, false) && kept_->isCurrent();
  if (!areOnlyWidgets) prepareScene();
  Q_EMIT aboutToRender();
  drawing_.start();
  if (!areOnlyWidgets && !isCoarse_) return renderAtOnce();
  // Showing the picture would wait for the drawing.
  window_->SwapBuffersOff();
  if (areOnlyWidgets)
    kept_->drawLayersAbove();
  else
    window_->Render();
  window_->SwapBuffersOn();
  awaitDrawing();
}

/// A large mesh is drawn with fewer triangles until the mouse rests.
void Viewport::prepareScene()
{
  isCoarse_ = contents_ && fullMilliseconds_ > kFluentMilliseconds;
  kept_->setKeeping(!isCoarse_);
  noteView();
  if (contents_) {
    contents_->lookFrom(Vector3(renderer_->GetActiveCamera()->GetPosition()));
    contents_->setDetail(isCoarse_ ? Detail::Coarse : Detail::Full);
  }
  fitClippingRange();
}

void Viewport::renderAtOnce()
{
  window_->Render();
  fence_->set();
  fullMilliseconds_ = millisecondsOf(drawing_);
  Q_EMIT rendered();
  smoothAtRest();
}

/// By another picture of the layers above: what is dragged waits for nothing but its own picture.
void Viewport::smoothAtRest()
{
  if (!isHeld_ && kept_->isRough()) schedulePicture();
}

void Viewport::awaitDrawing()
{
  fence_->set();
  pause_.begin();
  drawnTimer_.start(kMillisecondsBetweenLooks);
}

void Viewport::goOnWhenDrawn()
{
  if (!fence_->pass()) return drawnTimer_.start(kMillisecondsBetweenLooks);
  const bool isRepaintDue = pause_.end();
  if (slices_->isUnderWay()) {
    // Between two slices the window may repaint.
    if (isRepaintDue) return drawnTimer_.start(kMillisecondsBetweenLooks);
    return renderSlice();
  }
  // Before its first painting there is no OpenGL context, and nothing was drawn.
  if (isValid()) window_->Frame();
  waiting_.start();
  Q_EMIT rendered();
}

void Viewport::abandonDrawing()
{
  slices_->abandon();
  pause_.end();
  drawnTimer_.stop();
}

void Viewport::prepareToMove()
{
  if (fullMilliseconds_ <= kFluentMilliseconds) return;
  // A picture in slices is not shown before it is complete.
  if (slices_->isUnderWay()) abandonDrawing();
  contents_->setDetail(Detail::Coarse);
}

void Viewport::renderInFull()
{
  if (!isVisible() || !isValid() || !isCoarse_ || isHeld_) return;
  if (drawnTimer_.isActive() || !fence_->pass()) return restTimer_.start();
  fitClippingRange();
  Q_EMIT aboutToRender();
  drawing_.start();
  kept_->setKeeping(true);
  slices_->begin(*contents_);
  drawnTimer_.start(0);
}

void Viewport::renderSlice()
{
  slices_->advance();
  if (slices_->isUnderWay()) return awaitDrawing();
  isCoarse_ = false;
  fullMilliseconds_ = millisecondsOf(drawing_);
  Q_EMIT rendered();
  smoothAtRest();
}

void Viewport::resizeEvent(QResizeEvent* event)
{
  abandonDrawing();
  VtkView::resizeEvent(event);
  overlay_->setGeometry(rect());
  if (contents_) contents_->setPixelRatio(pixelRatio());
  orientation_->SetPixelRatio(pixelRatio());
  scheduleRender();
}

}  // namespace holdfast
