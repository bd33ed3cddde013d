#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkLightKit.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/view/default_camera.h>
#include <holdfast/view/scalar_legend.h>
#include <holdfast/view/scene.h>

namespace holdfast {
namespace {

// Pixels of larger pictures are fine enough as they are, and no OpenGL need hold a window of twice their size.
constexpr int kLargestSmoothedSide = 4096;

// Nearly white below, a breath of grey above: paper stays paper.
constexpr Color kBottom{1.0, 1.0, 1.0};
constexpr Color kTop{0.90, 0.915, 0.935};

constexpr double kRestOpacity = 0.22;

// In sizes of the text.
constexpr double kLegendWidth = 11.5;
constexpr double kBallSize = 0.62;

int pixelRatioOf(const PictureSize& size)
{
  return std::max(size.width, size.height) <= kLargestSmoothedSide ? 2 : 1;
}

/// In pixels of the window. Grows with the picture, so that a picture looks the same at every size.
double textSizeOf(const PictureSize& size, int pixelRatio)
{
  return pixelRatio * std::max(9.0, std::round(std::min(size.height / 48.0, size.width / 64.0)));
}

bool hasRoomForLegend(const PictureSize& size)
{
  return size.width >= kLeastLegendWidth && size.height >= kLeastLegendHeight;
}

std::vector<KeyEntry> keyOf(const std::vector<ConstraintMark>& marks)
{
  std::vector<KeyEntry> key;
  for (const ConstraintStatus status :
       {ConstraintStatus::Met, ConstraintStatus::Redundant, ConstraintStatus::Conflicting, ConstraintStatus::Missed}) {
    const auto count =
        std::count_if(marks.begin(), marks.end(), [&](const ConstraintMark& mark) { return mark.status == status; });
    if (count > 0) key.push_back({glyphColor(status), fmt::format("{} {}", count, name(status))});
  }
  return key;
}

Positions stacked(const Positions& a, const Positions& b)
{
  Positions all(a.rows() + b.rows(), 3);
  all << a, b;
  return all;
}

}  // namespace

Scene::Scene(const Model& model, const Deformation& deformation, const SceneOptions& options)
    : size_(options.size),
      pixelRatio_(pixelRatioOf(size_)),
      mesh_(model),
      rest_(model),
      glyphs_(constraintMarks(model, deformation))
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetDPI(72);
  window_->SetSize(pixelRatio_ * size_.width, pixelRatio_ * size_.height);
  window_->SetNumberOfLayers(2);
  window_->AddRenderer(backdrop_);
  window_->AddRenderer(meshRenderer_);
  meshRenderer_->SetLayer(1);
  backdrop_->SetBackground(kBottom.red, kBottom.green, kBottom.blue);
  backdrop_->SetBackground2(kTop.red, kTop.green, kTop.blue);
  backdrop_->GradientBackgroundOn();

  LegendContents contents;
  if (const auto coloring = coloringOf(model, deformation, options.colorBy, options.units)) {
    mesh_.setColors(coloring->values, coloring->scale);
    contents.scale = coloring->scale;
  }
  contents.key = keyOf(constraintMarks(model, deformation));
  if (options.legend == Legend::Hidden || !hasRoomForLegend(size_)) contents = {};
  layOut(contents, textSizeOf(size_, pixelRatio_));
  addLights();
  addMesh(model, deformation);
}

Scene::~Scene() = default;

void Scene::layOut(const LegendContents& contents, double textSize)
{
  mesh_.setPixelRatio(pixelRatio_);
  rest_.setPixelRatio(pixelRatio_);
  glyphs_.setBallPixels(kBallSize * textSize);
  if (contents.isEmpty()) return;
  const double width = pixelRatio_ * size_.width;
  const double legendWidth = kLegendWidth * textSize;
  meshRenderer_->SetViewport(0, 0, 1 - legendWidth / width, 1);
  addLegend(*backdrop_, contents,
            {width - legendWidth, legendWidth, static_cast<double>(pixelRatio_) * size_.height, textSize});
}

void Scene::addLights()
{
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.95);
  lights->SetKeyToFillRatio(2.6);
  lights->SetKeyToHeadRatio(3.2);
  lights->SetKeyLightAngle(42, 18);
  lights->SetKeyLightWarmth(0.53);
  lights->SetFillLightWarmth(0.47);
  lights->AddLightsToRenderer(meshRenderer_);
}

void Scene::addMesh(const Model& model, const Deformation& deformation)
{
  mesh_.setPositions(deformation.positions);
  rest_.edges().GetProperty()->SetOpacity(kRestOpacity);
  meshRenderer_->AddActor(&mesh_.surface());
  meshRenderer_->AddActor(&mesh_.edges());
  meshRenderer_->AddActor(&rest_.edges());
  for (vtkActor* actor : glyphs_.actors()) meshRenderer_->AddActor(actor);

  std::array<double, 4> viewport{};
  meshRenderer_->GetViewport(viewport.data());
  const double aspect = (viewport[2] - viewport[0]) * size_.width / size_.height;
  const Positions all = stacked(model.mesh.positions, deformation.positions);
  fit(*meshRenderer_->GetActiveCamera(), defaultFrame(all), all, aspect);
  meshRenderer_->ResetCameraClippingRange();
}

}  // namespace holdfast
