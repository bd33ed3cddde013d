#include "holdfast/window/viewport/frame_scheduler.h"

#include <chrono>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace holdfast {
namespace {

// Between two looks at the fence.
constexpr int kMillisecondsBetweenLooks = 1;

// Since the last picture. A mesh of 173,000 vertices follows a drag within that time.
constexpr int kMostMillisecondsUnsolved = 200;

// Longer than any picture takes.
constexpr std::chrono::seconds kLongestWait(10);

// Beyond this a moving picture is drawn of fewer triangles.
constexpr double kFluentMilliseconds = 30;

double millisecondsOf(const QElapsedTimer& timer)
{
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

}  // namespace

FrameScheduler::FrameScheduler(Editor& editor, VtkView& view, vtkRenderer& scene, vtkRenderer& last)
    : editor_(editor),
      view_(view),
      window_(*view.renderWindow()),
      scene_(scene),
      fence_(window_),
      pause_(view),
      slices_(scene),
      kept_(scene, last)
{
  renderTimer_.setSingleShot(true);
  connect(&renderTimer_, &QTimer::timeout, this, &FrameScheduler::render);
  restTimer_.setSingleShot(true);
  restTimer_.setInterval(kRestMilliseconds);
  connect(&restTimer_, &QTimer::timeout, this, &FrameScheduler::renderInFull);
  drawnTimer_.setSingleShot(true);
  connect(&drawnTimer_, &QTimer::timeout, this, &FrameScheduler::goOnWhenDrawn);
  connect(&view_, &QOpenGLWidget::frameSwapped, this, &FrameScheduler::noteSwap);
}

void FrameScheduler::setContents(SceneContents* contents)
{
  abandon();
  contents_ = contents;
  // A guess until the first full picture was measured.
  if (contents_ != nullptr) fullMilliseconds_ = isLarge(*editor_.model()) ? 2 * kFluentMilliseconds : 0;
}

void FrameScheduler::beginPainting()
{
  // Drawing, and putting the drawing into the window, would both wait.
  static_cast<void>(fence_.pass(kLongestWait));
}

void FrameScheduler::endPainting()
{
  fence_.set();
}

void FrameScheduler::noteMouse(bool isHeld, bool hasMoved)
{
  isHeld_ = isHeld;
  if (!isHeld_ && isCoarse_ && !hasMoved) restTimer_.start();
  smoothAtRest();
}

void FrameScheduler::noteSwap()
{
  waiting_.invalidate();
  if (renderTimer_.isActive()) pause_.begin();
  if (isSceneDue_ || drawnTimer_.isActive()) return;
  // What the mouse has done meanwhile comes first.
  QTimer::singleShot(1, &editor_, &Editor::resultIsSeen);
}

void FrameScheduler::schedulePicture()
{
  if (renderTimer_.isActive()) return;
  renderTimer_.start(0);
  // What else has changed in the window is shown together with the picture.
  if (!isUnseen()) pause_.begin();
}

void FrameScheduler::scheduleScene()
{
  isSceneDue_ = true;
  schedulePicture();
  if (movesCoarse()) restTimer_.start();
}

void FrameScheduler::drawLayersAbove()
{
  if (kept_.isCurrent()) kept_.drawLayersAbove();
}

void FrameScheduler::render()
{
  // A coarse picture under way is finished and shown first. Slices show the widgets, too.
  const bool isOneComing = (drawnTimer_.isActive() && (!slices_.isUnderWay() || !isSceneDue_)) || isUnseen();
  if (isOneComing || isSolutionAwaited()) return renderTimer_.start(kMillisecondsBetweenLooks);
  abandon();
  // The driver still draws what was abandoned, and the next picture would wait for it.
  if (!fence_.pass()) return renderTimer_.start(kMillisecondsBetweenLooks);
  if (!view_.isVisible()) return;
  // Where the cursor moves all the time, coarse pictures would follow one another for ever.
  if (std::exchange(isFullDue_, false) && !isSceneDue_) return renderInFull();
  const bool areOnlyWidgets = !std::exchange(isSceneDue_, false) && kept_.isCurrent();
  if (!areOnlyWidgets) prepareScene();
  Q_EMIT aboutToRender();
  drawing_.start();
  if (!areOnlyWidgets && !isCoarse_) return renderAtOnce();
  // Showing the picture would wait for the drawing.
  window_.SwapBuffersOff();
  if (areOnlyWidgets)
    kept_.drawLayersAbove();
  else
    window_.Render();
  window_.SwapBuffersOn();
  awaitDrawing();
}

/// Tells whether a drag's widgets wait for what they drag. Without a GPU their own pictures take the cores from the
/// solver.
bool FrameScheduler::isSolutionAwaited() const
{
  return !isSceneDue_ && isHeld_ && editor_.solveState() == SolveState::Solving && drawing_.isValid() &&
         drawing_.elapsed() < kMostMillisecondsUnsolved;
}

/// Tells whether a picture is drawn with fewer triangles, and in full when the mouse rests. Fewer of a small mesh would
/// save little.
bool FrameScheduler::movesCoarse() const
{
  return contents_ != nullptr && isLarge(*editor_.model()) && fullMilliseconds_ > kFluentMilliseconds;
}

void FrameScheduler::prepareScene()
{
  isCoarse_ = movesCoarse();
  if (isCoarse_ && !restTimer_.isActive()) restTimer_.start();
  kept_.setKeeping(!isCoarse_);
  if (contents_ != nullptr) {
    contents_->lookFrom(Vector3(scene_.GetActiveCamera()->GetPosition()));
    contents_->setDetail(isCoarse_ ? Detail::Coarse : Detail::Full);
  }
  Q_EMIT aboutToDrawScene();
}

void FrameScheduler::renderAtOnce()
{
  window_.Render();
  fence_.set();
  fullMilliseconds_ = millisecondsOf(drawing_);
  Q_EMIT rendered();
  smoothAtRest();
}

/// By another picture of the layers above: what is dragged waits for nothing but its own picture.
void FrameScheduler::smoothAtRest()
{
  if (!isHeld_ && kept_.isRough()) schedulePicture();
}

void FrameScheduler::awaitDrawing()
{
  fence_.set();
  pause_.begin();
  drawnTimer_.start(kMillisecondsBetweenLooks);
}

void FrameScheduler::goOnWhenDrawn()
{
  if (!fence_.pass()) return drawnTimer_.start(kMillisecondsBetweenLooks);
  const bool isRepaintDue = pause_.end();
  if (slices_.isUnderWay()) {
    // Between two slices the window may repaint once. What changes all the time would keep the next slice from its
    // turn.
    if (isRepaintDue && !std::exchange(hasRepainted_, true)) return drawnTimer_.start(kMillisecondsBetweenLooks);
    hasRepainted_ = false;
    return renderSlice();
  }
  // Before its first painting there is no OpenGL context, and nothing was drawn.
  if (view_.isValid()) window_.Frame();
  waiting_.start();
  Q_EMIT rendered();
}

void FrameScheduler::abandon()
{
  slices_.abandon();
  pause_.end();
  drawnTimer_.stop();
}

void FrameScheduler::prepareToMove()
{
  if (!movesCoarse()) return;
  // A picture in slices is not shown before it is complete.
  if (slices_.isUnderWay()) abandon();
  contents_->setDetail(Detail::Coarse);
}

void FrameScheduler::renderInFull()
{
  if (!view_.isVisible() || !view_.isValid() || !isCoarse_ || isHeld_) return;
  isFullDue_ = drawnTimer_.isActive() || !fence_.pass();
  if (isFullDue_) return restTimer_.start();
  Q_EMIT aboutToDrawScene();
  Q_EMIT aboutToRender();
  drawing_.start();
  kept_.setKeeping(true);
  slices_.begin(*contents_);
  drawnTimer_.start(0);
}

void FrameScheduler::renderSlice()
{
  slices_.advance();
  if (slices_.isUnderWay()) return awaitDrawing();
  isCoarse_ = false;
  fullMilliseconds_ = millisecondsOf(drawing_);
  Q_EMIT rendered();
  smoothAtRest();
}

}  // namespace holdfast
