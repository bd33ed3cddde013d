#pragma once
/// A frame scheduler decides when the picture of a viewport is drawn, and in how many steps.

#include <QElapsedTimer>
#include <QTimer>

#include <holdfast/widgets/scene/kept_scene.h>
#include <holdfast/widgets/scene/scene_contents.h>
#include <holdfast/widgets/scene/sliced_drawing.h>
#include <holdfast/window/controls/vtk_view.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/draw_fence.h>
#include <holdfast/window/viewport/repaint_pause.h>

namespace holdfast {

/// All requests of one turn of the event loop give one picture. A large mesh that moves is drawn with fewer triangles,
/// and slice by slice in full when it rests. The window answers events while OpenGL draws. docs/rendering.md says why.
class FrameScheduler : public QObject {
  Q_OBJECT

 public:
  /// Draws in `view` what is in its renderers: a scene in the layers from that of `scene` to that of `last`, and
  /// widgets in a layer above. `view` outlives the scheduler.
  FrameScheduler(Editor& editor, VtkView& view, vtkRenderer& scene, vtkRenderer& last);

  /// Gives up the picture under way. `contents`, which outlive the next call, are what the scene shows of the editor's
  /// document; null without a document.
  void setContents(SceneContents* contents);

  void scheduleScene();
  /// Draws only the layers above the scene if that is kept and was not scheduled.
  void schedulePicture();
  /// Draws the layers above the scene now, if that is kept.
  void drawLayersAbove();
  /// Avoids work for a full picture that will not be drawn.
  void prepareToMove();
  /// Gives up the picture under way.
  void abandon();

  /// The mouse has moved, or a button of it has gone down or up. A coarse picture is drawn in full when buttons rest.
  void noteMouse(bool isHeld, bool hasMoved);
  /// The gesture that held a button was cancelled.
  void noteCancelled() { isHeld_ = false; }
  /// Tells whether a button of the mouse is down.
  [[nodiscard]] bool isHeld() const noexcept { return isHeld_; }

  /// The view calls these before and after it is painted.
  void beginPainting();
  void endPainting();

  /// Tells whether the latest picture of the scene is one of all its triangles.
  [[nodiscard]] bool isInFullDetail() const noexcept { return !isCoarse_; }
  /// Tells whether a picture, or one of more detail, is still to come.
  [[nodiscard]] bool isPending() const
  {
    return renderTimer_.isActive() || restTimer_.isActive() || drawnTimer_.isActive();
  }

  /// The mouse rests after this time without a movement.
  static constexpr int kRestMilliseconds = 250;
  /// The next picture waits this long for the window to show the last one. A minimised window shows none.
  static constexpr int kMostMillisecondsUnseen = 100;

 Q_SIGNALS:
  /// The scene is about to be drawn: the last moment to fit the camera to it.
  void aboutToDrawScene();
  void aboutToRender();
  void rendered();

 private:
  void noteSwap();
  void render();
  [[nodiscard]] bool isSolutionAwaited() const;
  [[nodiscard]] bool isUnseen() const { return waiting_.isValid() && waiting_.elapsed() < kMostMillisecondsUnseen; }
  [[nodiscard]] bool movesCoarse() const;
  void prepareScene();
  void renderAtOnce();
  void renderInFull();
  void renderSlice();
  void smoothAtRest();
  void awaitDrawing();
  void goOnWhenDrawn();

  Editor& editor_;
  VtkView& view_;
  vtkRenderWindow& window_;
  vtkRenderer& scene_;
  SceneContents* contents_ = nullptr;

  QTimer renderTimer_;  // draws once a turn of the event loop
  QTimer restTimer_;    // draws the full detail when the mouse rests
  QTimer drawnTimer_;   // looks whether the drawing is done
  DrawFence fence_;
  RepaintPause pause_;  // while something is drawn
  SlicedDrawing slices_;
  KeptScene kept_;
  QElapsedTimer drawing_;        // since the picture was begun
  QElapsedTimer waiting_;        // for the window to show it; invalid once it does
  double fullMilliseconds_ = 0;  // of the last picture in full detail
  bool isHeld_ = false;
  bool isCoarse_ = false;
  bool isSceneDue_ = false;    // the next picture is one of the scene, too
  bool isFullDue_ = false;     // the mouse rests long enough, but a coarse picture is under way
  bool hasRepainted_ = false;  // the window, since the last slice
};

}  // namespace holdfast
