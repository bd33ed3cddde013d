// When the picture is drawn, and in how many steps: docs/rendering.md explains them.

#include <chrono>
#include <utility>

#include <vtkCamera.h>

#include <holdfast/base/thread_priority.h>
#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/viewport/viewport_overlay.h>

namespace holdfast {
namespace {

// Threads of Mesa's renderer for machines without a GPU.
constexpr const char* kDrawingThreads = "llvmpipe-";

// Between two looks at the fence.
constexpr int kMillisecondsBetweenLooks = 1;

// Since the last picture. A mesh of 173,000 vertices follows a drag within that time.
constexpr int kMostMillisecondsUnsolved = 200;

// Longer than any picture takes.
constexpr std::chrono::seconds kLongestWait(10);

double millisecondsOf(const QElapsedTimer& timer)
{
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

}  // namespace

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

void Viewport::noteSwap()
{
  waiting_.invalidate();
  if (renderTimer_.isActive()) pause_.begin();
  if (isSceneDue_ || drawnTimer_.isActive()) return;
  // What the mouse has done meanwhile comes first.
  QTimer::singleShot(1, &editor_, &Editor::resultIsSeen);
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
  if (movesCoarse()) restTimer_.start();
}

void Viewport::scheduleWidgets()
{
  // A widget that has moved the camera does not report it, and the kept scene includes the balls in the corner.
  const bool isAnotherView = shownView_ != cameraOf(*renderer_->GetActiveCamera());
  if (orientation_->GetProcessEvents() != 0 || isAnotherView) return scheduleRender();
  schedulePicture();
}

void Viewport::render()
{
  // A coarse picture under way is finished and shown first. Slices show the widgets, too.
  const bool isOneComing = (drawnTimer_.isActive() && (!slices_->isUnderWay() || !isSceneDue_)) || isUnseen();
  if (isOneComing || isSolutionAwaited()) return renderTimer_.start(kMillisecondsBetweenLooks);
  abandonDrawing();
  // The driver still draws what was abandoned, and the next picture would wait for it.
  if (!fence_->pass()) return renderTimer_.start(kMillisecondsBetweenLooks);
  if (!isVisible()) return;
  // Where the cursor moves all the time, coarse pictures would follow one another for ever.
  if (std::exchange(isFullDue_, false) && !isSceneDue_) return renderInFull();
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

/// Whether a drag's widgets wait for what they drag. Without a GPU their own pictures take the cores from the solver.
bool Viewport::isSolutionAwaited() const
{
  return !isSceneDue_ && isHeld_ && editor_.solveState() == SolveState::Solving && drawing_.isValid() &&
         drawing_.elapsed() < kMostMillisecondsUnsolved;
}

/// Whether a picture is drawn with fewer triangles, and in full when the mouse rests. Fewer of a small mesh would save
/// little.
bool Viewport::movesCoarse() const
{
  return contents_ && isLarge(*editor_.model()) && fullMilliseconds_ > kFluentMilliseconds;
}

void Viewport::prepareScene()
{
  isCoarse_ = movesCoarse();
  if (isCoarse_ && !restTimer_.isActive()) restTimer_.start();
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
  if (!movesCoarse()) return;
  // A picture in slices is not shown before it is complete.
  if (slices_->isUnderWay()) abandonDrawing();
  contents_->setDetail(Detail::Coarse);
}

void Viewport::renderInFull()
{
  if (!isVisible() || !isValid() || !isCoarse_ || isHeld_) return;
  isFullDue_ = drawnTimer_.isActive() || !fence_->pass();
  if (isFullDue_) return restTimer_.start();
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
  keepClearOfLegend();
  scheduleRender();
}

}  // namespace holdfast
