#pragma once
/// Shows the picture of the open document, with VTK's interactor in it.

#include <QElapsedTimer>
#include <QMouseEvent>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/document/session_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/vtkHoldfastConstraintMarkRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastOrientationWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>
#include <holdfast/widgets/scene/scene_contents.h>
#include <holdfast/window/controls/vtk_view.h>
#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/frame_scheduler.h>
#include <holdfast/window/viewport/tool.h>
#include <holdfast/window/viewport/viewport_legend.h>

namespace holdfast {

class ViewportOverlay;
struct ExampleDocument;
struct ViewFrame;

/// The viewport shows the editor's document. Qt's events go to VTK's interactor, whose widgets and camera style
/// interpret them. All their requests of one turn of the event loop give one picture.
class Viewport : public VtkView {
  Q_OBJECT

 public:
  explicit Viewport(Editor& editor, QWidget* parent = nullptr);
  ~Viewport() override;

  /// Draws an example for `MainWindow::warmUp`. Call it before a document is opened.
  void warmUp(const ExampleDocument& example);

  [[nodiscard]] Editor& editor() noexcept { return editor_; }

  void setTool(Tool* tool);
  /// Sets a tool that works beside every chosen tool: the gizmo.
  void setFirstTool(Tool* tool);
  /// Sets what a click would take. Tools call it.
  void setPreview(const std::optional<SurfacePick>& pick);
  /// Tells the chosen tool that the mouse has left the surface. Call it when the mouse is over an object that hides the
  /// surface from the tool.
  void leaveTool();
  /// Takes back what is under way with the mouse. Returns false if nothing is.
  bool cancelGesture();
  /// Takes back what is under way, or else removes what the chosen tool has made last. Returns false if there is
  /// neither.
  bool takeBack() { return cancelGesture() || (tool_ && tool_->remove()); }

  void setColors(const ColorSettings& settings);
  [[nodiscard]] const ColorSettings& colors() const noexcept { return colors_; }
  void setDisplay(const DisplaySettings& settings);
  [[nodiscard]] const DisplaySettings& display() const noexcept { return display_; }
  /// Returns the present colouring. There is none for one colour, for an empty viewport, and for a field that is zero
  /// everywhere.
  [[nodiscard]] const std::optional<Coloring>& coloring() const noexcept { return coloring_; }
  void setDarkBackdrop(bool isDark);
  /// Sets how much of the way from rest, 0, to the deformation, 1, the picture shows. The next deformation is shown in
  /// full.
  void setShownShare(double share);
  [[nodiscard]] double shownShare() const noexcept { return shownShare_; }
  /// Returns what the legend over the picture says.
  [[nodiscard]] LegendContent legend() const;
  /// Returns the box of the legend in the widget's coordinates; an empty box if the legend says nothing.
  [[nodiscard]] QRectF legendBox() const { return boxOf(legend(), font(), rect()); }

  /// Shows all of the mesh from the direction of the camera; in parallel projection, too. The legend and the axes in
  /// the corner stay clear of the mesh. Places of the first tool (`Tool::extent`) are shown as well, unless they are
  /// farther from the mesh than it is large.
  void frameAll();
  /// Shows all of the mesh from a corner, as it is first shown.
  void lookFromCorner();
  /// Sets the camera. The first deformation no longer frames the mesh then.
  void setCamera(const Camera& camera);
  /// Goes back to the view before. Each drag, each turn of the wheel and each call of the functions here leads to
  /// another view of this document.
  void showPreviousView() { goBack(earlierViews_, laterViews_); }
  void showNextView() { goBack(laterViews_, earlierViews_); }
  void frameVertices(const std::vector<Index>& vertices);
  /// Frames the marks of constraints, which are ascending places in the list.
  void frameConstraints(const std::vector<Index>& constraints);
  void lookAlong(const Vector3& direction, const Vector3& up);
  /// Sets the up axis of the model, for `lookFromCorner`. The camera stays as it is. A new document has the axis that
  /// `upAxisOf` returns.
  void setUpAxis(UpAxis axis);
  [[nodiscard]] UpAxis upAxis() const noexcept { return upAxis_; }
  void setParallelProjection(bool isParallel);
  [[nodiscard]] bool isParallelProjection() const;

  /// Returns the surface that is visible and can be picked, without what the section plane cuts away. It is null
  /// without a document.
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const noexcept { return surface_; }
  /// Sets a plane that cuts the picture, not the mesh. Without a plane all of the mesh is shown. The plane applies to
  /// the next document, too.
  void setSection(const std::optional<SectionPlane>& section);
  [[nodiscard]] const std::optional<SectionPlane>& section() const noexcept { return section_; }

  /// Hides the faces whose corners are all among `vertices`. They are neither drawn nor picked, nor are the constraints
  /// on them alone. What was hidden before stays hidden. If there is no such face, or if no face would stay visible,
  /// the function changes nothing and returns false. Faces are hidden for this document only. O(T).
  bool hide(const std::vector<Index>& vertices);
  /// Hides all other faces, as `hide` does.
  bool isolate(const std::vector<Index>& vertices);
  void showHidden();
  /// Returns the hidden faces as ascending ranges of faces of the file, each with its first and its last face.
  [[nodiscard]] std::vector<std::array<Index, 2>> hiddenFaces() const;
  /// Hides ranges of faces as `hide` does. The file may have fewer faces than the ranges say.
  void hideFaces(const std::vector<std::array<Index, 2>>& ranges);
  /// Returns those of some vertices that are not hidden. A command that selects in one step beyond the cursor calls it
  /// to leave hidden vertices as they are.
  [[nodiscard]] std::vector<Index> shownAmong(std::vector<Index> vertices) const;
  /// Returns for each triangle whether it is hidden; null if none is.
  [[nodiscard]] const std::shared_ptr<const std::vector<char>>& hidden() const noexcept { return hidden_; }

  [[nodiscard]] SceneContents* contents() noexcept { return contents_.get(); }
  /// Returns the marks of the constraints that are drawn, including those that the section plane cuts away. There are
  /// none without a document.
  [[nodiscard]] const std::vector<ConstraintMark>& marks() const noexcept;
  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// Returns a layer for widgets over the picture, with the camera and the depths of the picture. Drawing this layer
  /// does not draw the document again.
  [[nodiscard]] vtkRenderer& widgetRenderer() { return *widgetRenderer_; }

  /// Returns where a pixel of the render window is, in the widget's coordinates from the upper left corner.
  [[nodiscard]] QPointF toPlace(const DisplayPoint& display) const;

  void scheduleRender();
  /// Schedules a picture for VTK's interactor. If the document and the view have not changed, only the layers above the
  /// document are drawn.
  void scheduleWidgets();
  /// Tells whether the latest picture of the document is one of all its triangles.
  [[nodiscard]] bool isInFullDetail() const noexcept { return frames_->isInFullDetail(); }
  /// Tells whether a picture, or one of more detail, is still to come.
  [[nodiscard]] bool isRenderPending() const { return frames_->isPending(); }

 Q_SIGNALS:
  /// The field, the scale or the values of the colouring have changed.
  void coloringChanged(const std::optional<Coloring>& coloring);
  void surfaceChanged();
  void shownShareChanged(double share);
  void projectionChanged(bool isParallel);
  void upAxisChanged(UpAxis axis);
  /// `marks` or `section` has changed.
  void marksChanged();
  /// Something is hidden, or all is shown again.
  void hiddenChanged(bool isSomethingHidden);
  void contextMenuWanted(const QPoint& place);
  void legendDoubleClicked();
  void aboutToRender();
  /// The viewport is about to be destroyed. This is the last moment to take a widget away from the interactor.
  void closing();
  void rendered();

 protected:
  void initializeGL() override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] bool isForLegend(const QEvent& event);
  void leavePicture();
  void askForContextMenu();
  void wakeOrientation(const QPointF& place);
  void lookUnderCursor(const QMouseEvent* move);

  void openDocument();
  [[nodiscard]] std::shared_ptr<const VisibleSurface> shownSurface() const;
  void showSurface();
  bool hideToo(std::vector<char> triangles);
  void setHidden(std::shared_ptr<const std::vector<char>> hidden);
  [[nodiscard]] Positions shownPositions() const;
  void showResult();
  void showColors();
  void showConstraints();
  void showSelection();
  void lookAlongAxis();
  void cameraMoved();
  void goBack(std::vector<Camera>& from, std::vector<Camera>& to);
  void forgetViews();
  void noteView();
  void fitCamera(const ViewFrame& frame);
  [[nodiscard]] FreeSides freeSides() const;
  void keepClearOfLegend();
  void framePlaces(const Positions& places);
  void prepareCamera();
  void fitClippingRange();

  Editor& editor_;
  std::shared_ptr<SceneContents> contents_;
  std::shared_ptr<const VisibleSurface> surface_;
  std::optional<SectionPlane> section_;
  std::shared_ptr<const std::vector<char>> hidden_;
  double shownShare_ = 1;
  std::optional<Vector3> openedFrom_;  // the camera's place until the first deformation
  UpAxis upAxis_ = UpAxis::Z;
  std::optional<Camera> shownView_;                     // in the latest picture
  std::optional<std::pair<Camera, FreeSides>> framed_;  // when all of the mesh was framed last
  std::vector<Camera> earlierViews_;
  std::vector<Camera> laterViews_;  // the next one last
  bool isNewView_ = false;          // the next change of the camera leads to one
  QElapsedTimer wheel_;             // since it was turned last
  std::optional<Coloring> coloring_;
  ColorSettings colors_;
  DisplaySettings display_;

  vtkRenderWindow* window_ = renderWindow();
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderer> widgetRenderer_;
  vtkNew<vtkHoldfastSurfaceCameraStyle> style_;
  vtkNew<vtkHoldfastOrientationWidget> orientation_;  // in the corner
  vtkNew<vtkHoldfastConstraintMarkRepresentation> marksUnderCursor_;
  std::unique_ptr<FrameScheduler> frames_;
  ViewportOverlay* overlay_;

  Tool* tool_ = nullptr;
  Tool* firstTool_ = nullptr;
  bool isLegendPressed_ = false;  // the left one, on the legend
  bool isOverOrientation_ = false;
};

}  // namespace holdfast
