#pragma once
/// A panel with the rotation sphere. It shows which rotations there are, and which vertex has which rotation.

#include <memory>
#include <optional>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/interaction/vtkHoldfastRotationSphereStyle.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>
#include <holdfast/widgets/scene/example_document.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/vtk_view.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The panel shows the rotations of the editor's deformation. It places points in the background, and shows them all at
/// once.
class SpherePanel : public RefreshedPanel {
  Q_OBJECT

 public:
  explicit SpherePanel(Editor& editor);

  /// Draws an example for `MainWindow::warmUp`. Call it before a document is opened.
  void warmUp(const ExampleDocument& example);

  /// Returns the sphere that is shown; null before there is a rotation to show.
  [[nodiscard]] const RotationSphere* sphere() const { return sphere_.get(); }
  /// Tells whether the sphere shows the editor's newest deformation.
  [[nodiscard]] bool isCurrent() const { return shown_ == editor_.deformation(); }

 public Q_SLOTS:
  void showVertex(std::optional<Index> vertex);
  /// Colours points as the mesh. The colouring has one value for each vertex of the file. Without a colouring all
  /// points have one colour.
  void setColoring(const std::optional<Coloring>& coloring);
  void fit();

 Q_SIGNALS:
  void vertexPicked(Index vertex);  ///< of the file

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void begin();
  void refresh() override;
  void place();
  void showPoints(const std::optional<Coloring>& coloring);
  void showHint()
  {
    pages_->showHint(editor_.isOpen() ? tr("No rotation yet: rotate a handle.") : tr("No mesh is open."));
  }
  void applyPalette();
  void updateTexts() { texts_->update(); }
  /// Draws once for all requests of one turn of the event loop.
  void redraw();
  void pickVertex(vtkObject* /*caller*/, unsigned long /*event*/, void* vertex)
  {
    Q_EMIT vertexPicked(*static_cast<const Index*>(vertex));
  }
  void showTip(const QPoint& place);

  Editor& editor_;
  HintedContent* pages_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* words_ = nullptr;
  VtkView* view_ = nullptr;
  QWidget* texts_ = nullptr;  // over the view
  bool isDrawingDue_ = false;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkNew<vtkHoldfastRotationSphereStyle> style_;
  std::unique_ptr<RotationSphere> sphere_;  // from the first rotation that is to be shown
  std::shared_ptr<const DeformResult> shown_;
  std::shared_ptr<const PlacedRotations> placed_;  // the latest of this mesh
  std::optional<Index> marked_;
  std::optional<Coloring> coloring_;
  bool isFitted_ = false;
  BackgroundJob placing_;  // last: its thread uses what is above
};

}  // namespace holdfast
