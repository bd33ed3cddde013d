#include "holdfast/window/viewport/viewport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <vtkCamera.h>

#include <holdfast/threads/thread_priority.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/example_document.h>
#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/window/viewport/view_state.h>
#include <holdfast/window/viewport/viewport_overlay.h>

namespace holdfast {
namespace {

// Threads of Mesa's renderer for machines without a GPU.
constexpr const char* kDrawingThreads = "llvmpipe-";

/// Returns the marks where constraints act on the way from rest.
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
  frames_ = std::make_unique<FrameScheduler>(editor_, *this, *renderer_, *orientation_->GetDefaultRenderer());
  connect(frames_.get(), &FrameScheduler::aboutToDrawScene, this, &Viewport::prepareCamera);
  connect(frames_.get(), &FrameScheduler::aboutToRender, this, &Viewport::aboutToRender);
  connect(frames_.get(), &FrameScheduler::rendered, this, &Viewport::rendered);
  overlay_ = new ViewportOverlay(editor_, *this);
  setDarkBackdrop(false);

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
  frames_->drawLayersAbove();
}

void Viewport::initializeGL()
{
  VtkView::initializeGL();
  spreadOverCores(kDrawingThreads);
}

void Viewport::paintGL()
{
  frames_->beginPainting();
  VtkView::paintGL();
  frames_->endPainting();
}

void Viewport::resizeEvent(QResizeEvent* event)
{
  frames_->abandon();
  VtkView::resizeEvent(event);
  overlay_->setGeometry(rect());
  if (contents_) contents_->setPixelRatio(pixelRatio());
  orientation_->SetPixelRatio(pixelRatio());
  keepClearOfLegend();
  scheduleRender();
}

void Viewport::scheduleRender()
{
  frames_->scheduleScene();
}

void Viewport::scheduleWidgets()
{
  // A widget that has moved the camera does not report it, and the kept scene includes the balls in the corner.
  const bool isAnotherView = shownView_ != cameraOf(*renderer_->GetActiveCamera());
  if (orientation_->GetProcessEvents() != 0 || isAnotherView) return frames_->scheduleScene();
  frames_->schedulePicture();
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
  frames_->setContents(nullptr);
  renderer_->RemoveAllViewProps();
  contents_.reset();
  coloring_.reset();
  framed_.reset();
  hidden_.reset();
  Q_EMIT hiddenChanged(false);
  if (editor_.isOpen()) {
    contents_ = editor_.mesh().contents;
    contents_->setPixelRatio(pixelRatio());
    contents_->addTo(*renderer_);
    contents_->setSection(section_);
    frames_->setContents(contents_.get());
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
    frames_->prepareToMove();
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
  frames_->prepareToMove();
  contents_->setSection(section_);
  showSurface();
  scheduleRender();
  Q_EMIT marksChanged();
}

void Viewport::showResult()
{
  frames_->prepareToMove();
  if (std::exchange(shownShare_, 1) != 1) Q_EMIT shownShareChanged(1);
  showSurface();
  contents_->showShape(*editor_.deformation());
  showConstraints();
  showColors();
  // So far the picture showed the mesh at rest. A camera that has moved since stays where it is.
  if (const auto eye = std::exchange(openedFrom_, std::nullopt);
      eye && *eye == Vector3(renderer_->GetActiveCamera()->GetPosition())) {
    frameAll();
    forgetViews();
  }
}

void Viewport::showConstraints()
{
  if (!contents_) return;
  if (const auto& marks = editor_.marks())
    contents_->showMarks(
        shownShare_ == 1 ? marks : markSet(*editor_.model(), marksAt(marks->marks, shownShare_), marks, marks->guides));
  arrange(*contents_, display_);
  overlay_->followLegend();
  overlay_->followState();
  scheduleRender();
  Q_EMIT marksChanged();
}

void Viewport::showColors()
{
  coloring_.reset();
  if (const auto& deformation = editor_.deformation())
    coloring_ = coloringOf(*editor_.model(), *deformation, colors_, editor_.deformedState()->list.units,
                           contents_->mesh().shaded().get());
  if (coloring_ && !saysAnything(*coloring_, colors_)) coloring_.reset();
  contents_->color(coloring_);
  overlay_->followLegend();
  scheduleRender();
  Q_EMIT coloringChanged(coloring_);
}

void Viewport::showSelection()
{
  if (!contents_) return;
  frames_->prepareToMove();
  contents_->setSelection(editor_.selectedVertices());
  contents_->highlight(editor_.selectedConstraints());
  scheduleRender();
}

void Viewport::setColors(const ColorSettings& settings)
{
  colors_ = settings;
  if (contents_) showColors();
  keepClearOfLegend();
}

void Viewport::setDisplay(const DisplaySettings& settings)
{
  display_ = settings;
  showConstraints();
  keepClearOfLegend();
}

const std::vector<ConstraintMark>& Viewport::marks() const noexcept
{
  static const std::vector<ConstraintMark> kNoMarks;
  return contents_ ? contents_->marks() : kNoMarks;
}

}  // namespace holdfast
