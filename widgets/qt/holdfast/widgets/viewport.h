#pragma once
/// \file
/// The picture of the open document, and the mouse in it.

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>

#include <holdfast/document/session_file.h>
#include <holdfast/view/display_settings.h>
#include <holdfast/view/sliced_drawing.h>
#include <holdfast/view/surface_picker.h>
#include <holdfast/widgets/draw_fence.h>
#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/repaint_pause.h>
#include <holdfast/widgets/tool.h>

class QMouseEvent;
class QWheelEvent;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace holdfast {

class ViewportOverlay;
struct ExampleDocument;

/// Shows the editor's document. The right button turns the picture, the middle one shifts it, the wheel goes nearer;
/// the left button is the tool's, and turns the picture where the tool leaves it alone. However many events come in one
/// turn of the event loop, the picture is drawn once.
class Viewport : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit Viewport(Editor& editor, QWidget* parent = nullptr);
  ~Viewport() override;

  /// Draws an example that nobody sees: `MainWindow::warmUp`. Before a document is opened.
  void warmUp(const ExampleDocument& example);

  /// The tool that the left button is for; null for none. Stays its owner's.
  void setTool(Tool* tool);
  /// A tool that is asked first, whatever tool is chosen: the gizmo.
  void setFirstTool(Tool* tool);
  /// Takes back what is under way with the mouse; false where nothing is.
  bool cancelGesture();

  void setColors(const ColorSettings& settings);
  [[nodiscard]] const ColorSettings& colors() const noexcept { return colors_; }
  void setDisplay(const DisplaySettings& settings);
  [[nodiscard]] const DisplaySettings& display() const noexcept { return display_; }
  /// What the surface is coloured by now; none for one colour, for an empty viewport, and where the chosen field is
  /// zero everywhere.
  [[nodiscard]] const std::optional<Coloring>& coloring() const noexcept { return coloring_; }
  void setDarkBackdrop(bool isDark);

  /// The camera.
  void frameAll();
  /// Stays as it is from then on, where it was not moved since the document was opened, too.
  void setCamera(const Camera& camera);
  void frameVertices(const std::vector<Index>& vertices);
  /// Ascending places in the list.
  void frameConstraints(const std::vector<Index>& constraints);
  void lookAlong(const Vector3& direction, const Vector3& up);
  void setParallelProjection(bool isParallel);
  [[nodiscard]] bool isParallelProjection() const;

  /// Null without a document.
  [[nodiscard]] const SurfacePicker* picker() const noexcept { return picker_.get(); }
  [[nodiscard]] SceneContents* contents() noexcept { return contents_.get(); }
  /// The constraints that are drawn; none without a document.
  [[nodiscard]] const std::vector<ConstraintMark>& marks() const noexcept;
  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// Over the picture of the document: the gizmo's.
  [[nodiscard]] vtkRenderer& frontRenderer() { return *front_; }

  /// Pixels of the render window for each of the widget's.
  [[nodiscard]] double pixelRatio() const { return devicePixelRatioF(); }
  /// From and to the widget's coordinates.
  [[nodiscard]] DisplayPoint toDisplayPoint(const QPointF& place) const;
  [[nodiscard]] QPointF toPlace(const DisplayPoint& display) const;
  [[nodiscard]] Pointer pointerAt(const QPointF& place, Qt::KeyboardModifiers modifiers) const;

  /// Marks what a click would take; none for nothing.
  void setPreview(const std::optional<SurfacePick>& pick);
  [[nodiscard]] const std::optional<SurfacePick>& preview() const noexcept { return preview_; }

  /// How long a picture may wait to be put into the window before the next one is drawn all the same: nothing is put
  /// into a window that is minimised.
  static constexpr int kMostMillisecondsUnseen = 100;

  /// Draws at the next turn of the event loop.
  void scheduleRender();
  /// Whether only some triangles of a large mesh are drawn: it moves, and moved a moment ago.
  [[nodiscard]] bool isCoarse() const noexcept { return isCoarse_; }
  /// Whether a picture, or one of more detail, is still to come.
  [[nodiscard]] bool isRenderPending() const
  {
    return renderTimer_.isActive() || restTimer_.isActive() || drawnTimer_.isActive();
  }
  /// Milliseconds that the last picture took to draw, what was done meanwhile included.
  [[nodiscard]] double lastRenderMilliseconds() const noexcept { return renderMilliseconds_; }

 Q_SIGNALS:
  void previewChanged(const std::optional<SurfacePick>& pick);
  /// Another field, another scale, or other values of it.
  void coloringChanged(const std::optional<Coloring>& coloring);
  void contextMenuWanted(const QPoint& place);
  /// Before each picture: time to follow the camera.
  void aboutToRender();
  void rendered();

 protected:
  void initializeGL() override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Hand { Empty, Pressed, Tool, Orbit, Pan };  // what the mouse is doing

  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void hover(const Pointer& pointer);
  void release(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);
  void turnOrShift(const QPointF& to);
  void beginCamera(Hand hand, const QPointF& place);
  void paintTools();
  [[nodiscard]] bool offerPress(const Pointer& pointer);
  [[nodiscard]] Vector3 placeUnder(const DisplayPoint& display);

  void openDocument();
  void showDeformation();
  void showColors();
  void showConstraints();
  void showSelection();
  void cameraMoved();
  void framePlaces(const Positions& places);
  /// Nothing is worked out for the full picture of what comes next, where it will not be drawn.
  void prepareToMove();
  void render();
  void renderAtOnce();
  void renderCoarse();
  void renderInFull();
  void renderSlice();
  void awaitDrawing();
  void goOnWhenDrawn();
  [[nodiscard]] bool isUnseen() const;
  void abandonDrawing();
  void fitClippingRange();

  Editor& editor_;
  std::shared_ptr<SceneContents> contents_;
  std::unique_ptr<SurfacePicker> picker_;
  std::optional<Vector3> openedFrom_;  // the camera's place until the first deformation
  std::optional<Coloring> coloring_;
  ColorSettings colors_;
  DisplaySettings display_;

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderer> front_;
  ViewportOverlay* overlay_;

  Tool* tool_ = nullptr;
  Tool* firstTool_ = nullptr;
  Tool* pressed_ = nullptr;  // the one whose press was true
  Hand hand_ = Hand::Empty;
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF pressedAt_;
  QPointF movedTo_;
  Vector3 pivot_ = Vector3::Zero();
  std::optional<SurfacePick> preview_;

  QTimer renderTimer_;  // draws once a turn of the event loop
  QTimer restTimer_;    // draws the full detail when the hand rests
  QTimer drawnTimer_;   // goes on when what was ordered is drawn
  std::unique_ptr<DrawFence> fence_;
  RepaintPause pause_{*this};  // while something is drawn
  std::unique_ptr<SlicedDrawing> slices_;
  QElapsedTimer drawing_;  // since the picture was begun
  QElapsedTimer waiting_;  // since it was to be put into the window; invalid when it is there
  double renderMilliseconds_ = 0;
  double fullMilliseconds_ = 0;  // of the last picture in full detail
  bool isCoarse_ = false;
};

}  // namespace holdfast
