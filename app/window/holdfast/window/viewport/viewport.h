#pragma once
/// \file
/// The picture of the open document, and VTK's interactor in it.

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include <vtkNew.h>

#include <holdfast/document/session_file.h>
#include <holdfast/widgets/interaction/corner_axes.h>
#include <holdfast/widgets/interaction/surface_camera_style.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>
#include <holdfast/widgets/scene/display_settings.h>
#include <holdfast/widgets/scene/kept_scene.h>
#include <holdfast/widgets/scene/sliced_drawing.h>
#include <holdfast/window/controls/vtk_view.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/draw_fence.h>
#include <holdfast/window/viewport/repaint_pause.h>
#include <holdfast/window/viewport/tool.h>

class vtkRenderWindow;
class vtkRenderer;

namespace holdfast {

class ViewportOverlay;
struct ExampleDocument;

/// Shows the editor's document. Qt's events go to VTK's interactor, whose widgets and camera style interpret them; what
/// these ask to be drawn is drawn once in a turn of the event loop, however many events it had.
class Viewport : public VtkView {
  Q_OBJECT

 public:
  explicit Viewport(Editor& editor, QWidget* parent = nullptr);
  ~Viewport() override;

  /// Draws an example that nobody sees: `MainWindow::warmUp`. Before a document is opened.
  void warmUp(const ExampleDocument& example);

  /// The tool that is chosen; null for none. Stays its owner's.
  void setTool(Tool* tool);
  /// A tool that is there whatever tool is chosen: the gizmo.
  void setFirstTool(Tool* tool);
  /// The mouse is over something in front of what the chosen tool works on.
  void leaveTool();
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

  /// What is seen and picked, without what the section plane cuts away; null without a document.
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const noexcept { return surface_; }
  /// Cuts the picture, not the mesh; none: shows all of it. Stays for the next document.
  void setSection(const std::optional<SectionPlane>& section);
  [[nodiscard]] const std::optional<SectionPlane>& section() const noexcept { return section_; }
  [[nodiscard]] SceneContents* contents() noexcept { return contents_.get(); }
  /// The constraints that are drawn, those that the section plane cuts away as well; none without a document.
  [[nodiscard]] const std::vector<ConstraintMark>& marks() const noexcept;
  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// A layer over the picture of the document, with its camera and its depths: what widgets draw is drawn here, without
  /// drawing the document again.
  [[nodiscard]] vtkRenderer& widgetRenderer() { return *widgetRenderer_; }

  /// To the widget's own coordinates: from the upper left corner.
  [[nodiscard]] QPointF toPlace(const DisplayPoint& display) const;

  /// How long a picture may wait to be put into the window before the next one is drawn all the same: nothing is put
  /// into a window that is minimised.
  static constexpr int kMostMillisecondsUnseen = 100;

  /// Draws at the next turn of the event loop.
  void scheduleRender();
  /// The same of the layers above the document alone, where it has not changed: what VTK's interactor asks for.
  void scheduleWidgets();
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
  /// What a click of the chosen tool would take, or nothing; tools say it.
  void previewChanged(const std::optional<SurfacePick>& pick);
  /// Another field, another scale, or other values of it.
  void coloringChanged(const std::optional<Coloring>& coloring);
  /// `surface` is another one.
  void surfaceChanged();
  /// Other constraints are drawn, or elsewhere: `marks` and `section`.
  void marksChanged();
  void contextMenuWanted(const QPoint& place);
  /// Before each picture.
  void aboutToRender();
  /// The last time to take a widget away from the interactor.
  void closing();
  void rendered();

 protected:
  void initializeGL() override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void askForContextMenu();
  void wakeOrientation(const QPointF& place);
  void paintTools();

  void openDocument();
  void showSurface();
  void showResult();
  void showColors();
  void showConstraints();
  void showSelection();
  void cameraMoved();
  void framePlaces(const Positions& places);
  /// Nothing is worked out for the full picture of what comes next, where it will not be drawn.
  void prepareToMove();
  void render();
  void renderWidgets();
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
  std::shared_ptr<const VisibleSurface> surface_;
  std::optional<SectionPlane> section_;
  std::optional<Vector3> openedFrom_;  // the camera's place until the first deformation
  std::optional<Coloring> coloring_;
  ColorSettings colors_;
  DisplaySettings display_;

  vtkRenderWindow* window_ = renderWindow();
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderer> widgetRenderer_;
  vtkNew<SurfaceCameraStyle> style_;
  vtkNew<OrientationWidget> orientation_;  // in the corner
  ViewportOverlay* overlay_;

  Tool* tool_ = nullptr;
  Tool* firstTool_ = nullptr;
  bool isHeld_ = false;  // a button of the mouse is down
  bool isOverOrientation_ = false;

  QTimer renderTimer_;  // draws once a turn of the event loop
  QTimer restTimer_;    // draws the full detail when the hand rests
  QTimer drawnTimer_;   // goes on when what was ordered is drawn
  std::unique_ptr<DrawFence> fence_;
  RepaintPause pause_{*this};  // while something is drawn
  std::unique_ptr<SlicedDrawing> slices_;
  std::unique_ptr<KeptScene> kept_;
  QElapsedTimer drawing_;  // since the picture was begun
  QElapsedTimer waiting_;  // since it was to be put into the window; invalid when it is there
  double renderMilliseconds_ = 0;
  double fullMilliseconds_ = 0;  // of the last picture in full detail
  bool isCoarse_ = false;
  bool isSceneDue_ = false;  // the next picture is one of the document, too
};

}  // namespace holdfast
