#include "holdfast/widgets/sphere_panel.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QStackedLayout>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <holdfast/rotation/rotation_log.h>
#include <holdfast/view/example_document.h>
#include <holdfast/view/rotation_sphere.h>
#include <holdfast/view/sphere_camera.h>
#include <holdfast/widgets/background_job.h>
#include <holdfast/widgets/labels.h>
#include <holdfast/widgets/number_words.h>
#include <holdfast/widgets/render_request.h>
#include <holdfast/widgets/vtk_palette.h>

namespace holdfast {
namespace {

// A drag across half the height of the view turns the sphere by so much: about as if the hand held it.
constexpr double kRadiansAcrossHalf = 1.6;
constexpr double kKeyPixels = 20;
constexpr double kZoomPerStep = 1.2;
constexpr double kWheelStep = 120;  // eighths of a degree, by Qt's definition

double largestDegrees(const std::vector<BoundaryRotation>& boundary)
{
  double largest = 0;
  for (const BoundaryRotation& value : boundary) largest = std::max(largest, angleDegrees(value.q));
  return largest;
}

}  // namespace

SpherePanel::SpherePanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("spherePanel");
  summary_ = new QLabel(this);
  summary_->setObjectName("sphereSummary");
  auto* fitButton = new QToolButton(this);
  fitButton->setObjectName("sphereFit");
  fitButton->setText(tr("&Fit"));
  fitButton->setToolTip(tr("Show everything that is prescribed (double click, Home)"));
  fitButton->setAutoRaise(true);
  auto* header = new QHBoxLayout;
  header->setContentsMargins(6, 2, 6, 2);
  header->addWidget(summary_, 1);
  header->addWidget(fitButton);

  view_ = new QVTKOpenGLNativeWidget;
  view_->setObjectName("sphereView");
  view_->setAccessibleName(tr("Rotation sphere"));
  view_->setFocusPolicy(Qt::StrongFocus);
  view_->setMinimumSize(120, 120);
  // Sizes are given in pixels of the window, as in the viewport.
  view_->setEnableHiDPI(false);
  view_->renderWindow()->SetMultiSamples(0);
  view_->installEventFilter(this);
  drawing_ = new RenderRequest(*view_);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(header);
  column->addWidget(view_, 1);

  hint_ = newHint("sphereHint");
  pages_ = new QStackedLayout(this);
  pages_->addWidget(hint_);
  pages_->addWidget(page);

  connect(fitButton, &QToolButton::clicked, this, &SpherePanel::fit);
  connect(&editor_, &Editor::opened, this, &SpherePanel::begin);
  placing_ = new BackgroundJob(this);
  connect(&editor_, &Editor::deformed, this, &SpherePanel::follow);
  begin();
}

SpherePanel::~SpherePanel() = default;

void SpherePanel::begin()
{
  placing_->cancel();
  if (renderer_) view_->renderWindow()->RemoveRenderer(renderer_);
  sphere_.reset();
  renderer_ = nullptr;
  shown_.reset();
  placed_.reset();
  coloring_.reset();
  marked_.reset();
  isFitted_ = false;
  showHint();
  follow();
}

void SpherePanel::warmUp(const ExampleDocument& example)
{
  vtkNew<vtkRenderer> renderer;
  view_->renderWindow()->AddRenderer(renderer);
  RotationSphere sphere;
  sphere.addTo(*renderer);
  sphere.show(placeRotations(example.model, example.deformation, nullptr));
  sphere.mark(0);
  for (const ColorBy colors : {ColorBy::None, ColorBy::Angle}) {
    sphere.setColoring(coloringOf(example.model, example.deformation, colors, ""));
    view_->grabFramebuffer();
  }
  view_->renderWindow()->RemoveRenderer(renderer);
}

void SpherePanel::makeSphere()
{
  renderer_ = vtkSmartPointer<vtkRenderer>::New();
  view_->renderWindow()->AddRenderer(renderer_);
  sphere_ = std::make_unique<RotationSphere>();
  sphere_->addTo(*renderer_);
  sphere_->mark(marked_);
  applyPalette();
}

void SpherePanel::follow()
{
  if (isVisible() && !isCurrent() && !placing_->isRunning()) place();
}

void SpherePanel::place()
{
  // Whether anything turns is not known yet.
  if (!placed_) hint_->clear();
  placing_->start([this, model = editor_.model(), deformation = editor_.deformation(), before = placed_,
                   coloring = coloring_](Progress&) -> BackgroundJob::Finish {
    return [this, deformation, coloring, placed = placeRotations(*model, *deformation, before)] {
      shown_ = deformation;
      placed_ = placed;
      if (hasRotation(placed->boundary))
        showPoints(isCurrent() ? coloring_ : coloring);
      else
        showHint();
      // What came meanwhile.
      follow();
    };
  });
}

void SpherePanel::showHint()
{
  hint_->setText(editor_.isOpen() ? tr("No rotation yet: give a handle a turn.") : tr("No mesh is open."));
  pages_->setCurrentIndex(0);
}

void SpherePanel::showPoints(const std::optional<Coloring>& coloring)
{
  if (!sphere_) makeSphere();
  sphere_->show(placed_);
  sphere_->setColoring(coloring);
  if (!isFitted_) sphere_->fitCamera();
  isFitted_ = true;
  summary_->setText(tr("Prescribed rotations: %1, largest %2°")
                        .arg(placed_->boundary.size())
                        .arg(roundedText(largestDegrees(placed_->boundary))));
  summary_->setToolTip(tr("A point for each vertex: half its angle from the pole, towards its axis"));
  pages_->setCurrentIndex(1);
  redraw();
}

void SpherePanel::redraw()
{
  drawing_->post();
}

void SpherePanel::showVertex(std::optional<Index> vertex)
{
  marked_ = vertex;
  if (!sphere_) return;
  sphere_->mark(vertex);
  redraw();
}

void SpherePanel::setColoring(const std::optional<Coloring>& coloring)
{
  const bool fits = coloring && editor_.isOpen() &&
                    static_cast<Index>(coloring->values.size()) == editor_.model()->mesh.vertexCount();
  coloring_ = fits ? coloring : std::nullopt;
  // Values of a deformation are shown with its points.
  if (!sphere_ || !isCurrent()) return;
  sphere_->setColoring(coloring_);
  redraw();
}

void SpherePanel::fit()
{
  if (!sphere_) return;
  sphere_->fitCamera();
  redraw();
}

void SpherePanel::applyPalette()
{
  if (!sphere_) return;
  const PictureColors colors = pictureColors(palette());
  sphere_->setLook({colors.ground, colors.raised, colors.ink, colors.accent, devicePixelRatioF()});
  redraw();
}

void SpherePanel::turn(const QPointF& pixels)
{
  const double radians = kRadiansAcrossHalf / std::max(1.0, view_->height() / 2.0);
  turnSphere(*renderer_->GetActiveCamera(), radians * pixels.x(), -radians * pixels.y());
  redraw();
}

void SpherePanel::zoom(double steps)
{
  zoomSphere(*renderer_->GetActiveCamera(), std::pow(kZoomPerStep, steps));
  redraw();
}

std::optional<Index> SpherePanel::vertexAt(const QPointF& place) const
{
  // Through the pixel's centre; VTK counts from below.
  const double ratio = view_->devicePixelRatioF();
  return sphere_->pick((place.x() + 0.5) * ratio, (view_->height() - place.y() - 0.5) * ratio);
}

void SpherePanel::showTip(const QPoint& place)
{
  const auto vertex = vertexAt(place);
  if (!vertex) return QToolTip::hideText();
  const Index unknown = editor_.model()->solverMesh.weld.unknownOf[*vertex];
  const Vector3 q = shown_->rotations.row(unknown).transpose();
  QString text = tr("vertex %1: %2°").arg(*vertex).arg(roundedText(angleDegrees(q)));
  if (const double length = q.norm(); length > 0)
    text += tr(" about (%1, %2, %3)")
                .arg(roundedText(q.x() / length), roundedText(q.y() / length), roundedText(q.z() / length));
  QToolTip::showText(view_->mapToGlobal(place), text, view_);
}

bool SpherePanel::handleKey(int key)
{
  switch (key) {
    case Qt::Key_Left:
      turn({-kKeyPixels, 0});
      return true;
    case Qt::Key_Right:
      turn({kKeyPixels, 0});
      return true;
    case Qt::Key_Up:
      turn({0, -kKeyPixels});
      return true;
    case Qt::Key_Down:
      turn({0, kKeyPixels});
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoom(1);
      return true;
    case Qt::Key_Minus:
      zoom(-1);
      return true;
    case Qt::Key_Home:
      fit();
      return true;
    default:
      return false;
  }
}

bool SpherePanel::eventFilter(QObject* watched, QEvent* event)
{
  if (watched != view_ || !sphere_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      handlePress(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseMove:
      handleMove(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonRelease:
      handleRelease(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonDblClick:
      fit();
      return true;
    case QEvent::Wheel:
      zoom(static_cast<QWheelEvent*>(event)->angleDelta().y() / kWheelStep);
      return true;
    case QEvent::KeyPress:
      return handleKey(static_cast<QKeyEvent*>(event)->key());
    case QEvent::ToolTip:
      showTip(static_cast<QHelpEvent*>(event)->pos());
      return true;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

void SpherePanel::handlePress(const QMouseEvent& event)
{
  if (event.button() != Qt::LeftButton) return;
  pressed_ = last_ = event.localPos();
  isDragging_ = false;
}

void SpherePanel::handleMove(const QMouseEvent& event)
{
  if (!pressed_) return;
  const QPointF way = event.localPos() - *pressed_;
  isDragging_ = isDragging_ || way.manhattanLength() >= QApplication::startDragDistance();
  if (isDragging_) turn(event.localPos() - last_);
  last_ = event.localPos();
}

void SpherePanel::handleRelease(const QMouseEvent& event)
{
  if (event.button() != Qt::LeftButton || !pressed_) return;
  pressed_.reset();
  if (isDragging_) return;
  if (const auto vertex = vertexAt(event.localPos())) Q_EMIT vertexPicked(*vertex);
}

void SpherePanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  applyPalette();
  follow();
}

void SpherePanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyPalette();
}

}  // namespace holdfast
