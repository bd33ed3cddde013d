#include "holdfast/window/panels/sphere_panel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include <vtkRenderWindow.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// The texts of the sphere in the window's font.
class SphereTexts : public QWidget {
 public:
  SphereTexts(const SpherePanel& panel, VtkView& view) : QWidget(&view), panel_(panel), view_(view)
  {
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override
  {
    if (panel_.sphere() == nullptr) return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    for (const SphereText& text : panel_.sphere()->texts()) {
      QFont font = this->font();
      font.setBold(text.isName);
      painter.setFont(font);
      const QString words = QString::fromStdString(text.text);
      QRectF box = painter.fontMetrics().boundingRect(words);
      box.moveCenter({text.place.x() / view_.pixelRatio(), height() - text.place.y() / view_.pixelRatio()});
      if (text.isName) box.translate(box.width() / 2, 0);
      painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, words);
    }
  }

 private:
  const SpherePanel& panel_;
  const VtkView& view_;
};

constexpr double kWholeTurn = 360;

/// What latitude and longitude say of a rotation. `largest`: degrees.
QString sphereWords(double largest)
{
  QString words = SpherePanel::tr(
      "A point for each vertex. Latitude is the angle of its rotation: 0° at the top, 180° at the equator, 360° at the "
      "bottom. Longitude is the axis.");
  if (largest <= kWholeTurn) return words;
  return words + ' ' +
         SpherePanel::tr(
             "Beyond 360° points lie above the surface and come up again on the far side of the axis: 540° at "
             "the equator, 720° at the top.");
}

}  // namespace

SpherePanel::SpherePanel(Editor& editor) : editor_(editor)
{
  setObjectName("spherePanel");
  summary_ = named(new QLabel, "sphereSummary");
  auto* fitButton = named(new QToolButton, "sphereFit");
  fitButton->setText(tr("F&it"));
  fitButton->setToolTip(tr("Show everything that is prescribed (double click, Home)"));
  fitButton->setAutoRaise(true);
  auto* header = new QHBoxLayout;
  header->setContentsMargins(6, 2, 6, 2);
  header->addWidget(summary_, 1);
  header->addWidget(fitButton);

  view_ = named(new VtkView, "sphereView", tr("Rotation sphere"));
  view_->setFocusPolicy(Qt::StrongFocus);
  view_->setMinimumSize(120, 120);
  view_->installEventFilter(this);
  texts_ = named(new SphereTexts(*this, *view_), "sphereTexts");
  connect(view_, &VtkView::renderWanted, this, &SpherePanel::redraw);
  view_->interactor()->SetInteractorStyle(style_);
  style_->AddObserver(vtkCommand::PickEvent, this, &SpherePanel::pickVertex);
  auto* page = new QWidget;
  auto* column = newLayout<QVBoxLayout>(page, 0, 6);
  column->addLayout(header);
  words_ = newText("sphereWords");
  words_->setContentsMargins(6, 0, 6, 0);
  column->addWidget(words_);
  column->addWidget(view_, 1);

  pages_ = new HintedContent(page, "sphereHint");
  fill(*this, pages_);

  connect(fitButton, &QToolButton::clicked, this, &SpherePanel::fit);
  connect(&editor_, &Editor::opened, this, &SpherePanel::begin);
  connect(&editor_, &Editor::deformed, this, &SpherePanel::refresh);
  begin();
}

void SpherePanel::begin()
{
  placing_.cancel();
  if (renderer_) view_->renderWindow()->RemoveRenderer(renderer_);
  style_->SetSphere(nullptr);
  sphere_.reset();
  renderer_ = nullptr;
  shown_.reset();
  placed_.reset();
  coloring_.reset();
  marked_.reset();
  isFitted_ = false;
  showHint();
  refresh();
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

void SpherePanel::refresh()
{
  if (!isVisible()) return;
  if (isCurrent()) return applyPalette();
  if (!placing_.isRunning()) place();
}

void SpherePanel::place()
{
  // It is not known yet whether anything turns.
  if (!placed_) pages_->showHint({});
  placing_.start([this, model = editor_.model(), deformation = editor_.deformation(), before = placed_,
                  coloring = coloring_](Progress&) -> BackgroundJob::Finish {
    return [this, deformation, coloring, placed = placeRotations(*model, *deformation, before)] {
      shown_ = deformation;
      placed_ = placed;
      if (hasRotation(placed->boundary))
        showPoints(isCurrent() ? coloring_ : coloring);
      else
        showHint();
      // What came meanwhile.
      refresh();
    };
  });
}

void SpherePanel::showPoints(const std::optional<Coloring>& coloring)
{
  if (!sphere_) {
    renderer_ = vtkSmartPointer<vtkRenderer>::New();
    view_->renderWindow()->AddRenderer(renderer_);
    sphere_ = std::make_unique<RotationSphere>();
    sphere_->addTo(*renderer_);
    renderer_->UseFXAAOn();
    renderer_->AddObserver(vtkCommand::EndEvent, this, &SpherePanel::updateTexts);
    sphere_->mark(marked_);
    style_->SetSphere(sphere_.get());
    applyPalette();
  }
  sphere_->show(placed_);
  sphere_->setColoring(coloring);
  if (!isFitted_) sphere_->fitCamera();
  isFitted_ = true;
  double largest = 0;
  for (const BoundaryRotation& value : placed_->boundary) largest = std::max(largest, angleDegrees(value.q));
  summary_->setText(
      tr("Prescribed rotations: %1, largest %2°").arg(placed_->boundary.size()).arg(roundedText(largest)));
  words_->setText(sphereWords(largest));
  pages_->showContent();
  redraw();
}

void SpherePanel::redraw()
{
  if (std::exchange(isDrawingDue_, true)) return;
  const auto draw = [this] {
    isDrawingDue_ = false;
    // Before its first frame the view has no OpenGL, and draws by itself.
    if (view_->isVisible() && view_->isValid()) view_->renderWindow()->Render();
  };
  // After what lays out the window, before what paints it.
  QMetaObject::invokeMethod(this, draw, Qt::QueuedConnection);
}

void SpherePanel::showVertex(std::optional<Index> vertex)
{
  if (std::exchange(marked_, vertex) == vertex || !sphere_) return;
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
  style_->SetPixelRatio(devicePixelRatioF());
  sphere_->setLook({colors.ground, colors.raised, colors.ink, colors.accent, devicePixelRatioF(), false});
  redraw();
}

void SpherePanel::showTip(const QPoint& place)
{
  // Through the pixel's center; VTK counts from below.
  const double ratio = view_->pixelRatio();
  const auto vertex = sphere_->pick((place.x() + 0.5) * ratio, (view_->height() - place.y() - 0.5) * ratio);
  if (!vertex) return QToolTip::hideText();
  const Index unknown = editor_.model()->solverMesh.weld.unknownOf[*vertex];
  const Vector3 q = shown_->rotations.row(unknown).transpose();
  QString text = tr("vertex %1: %2°").arg(*vertex).arg(roundedText(angleDegrees(q)));
  if (const double length = q.norm(); length > 0) text += tr(" about %1").arg(roundedText(Vector3(q / length)));
  QToolTip::showText(view_->mapToGlobal(place), text, view_);
}

bool SpherePanel::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == view_ && event->type() == QEvent::Resize) texts_->setGeometry(view_->rect());
  if (watched != view_ || !sphere_ || event->type() != QEvent::ToolTip) return QWidget::eventFilter(watched, event);
  showTip(static_cast<QHelpEvent*>(event)->pos());
  return true;
}

void SpherePanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyPalette();
}

}  // namespace holdfast
