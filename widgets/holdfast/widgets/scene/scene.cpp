#include "holdfast/widgets/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/default_camera.h>
#include <holdfast/widgets/color/scalar_legend.h>
#include <holdfast/widgets/scene/lighting.h>

namespace holdfast {
namespace {

// Pixels of larger pictures are fine enough as they are, and no OpenGL need hold a window of twice their size.
constexpr int kLargestSmoothedSide = 4096;

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

Scene::Scene(const Model& model, const DeformResult& deformation, const SceneOptions& options)
    : size_(options.size), pixelRatio_(pixelRatioOf(size_)), contents_(model)
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetDPI(72);
  window_->SetSize(pixelRatio_ * size_.width, pixelRatio_ * size_.height);
  window_->SetNumberOfLayers(2);
  window_->AddRenderer(backdrop_);
  window_->AddRenderer(meshRenderer_);
  meshRenderer_->SetLayer(1);
  addBackground(*backdrop_);
  addLights(*meshRenderer_);

  const auto coloring =
      options.coloring ? options.coloring : coloringOf(model, deformation, options.colorBy, options.units);
  contents_.setHiddenMarks(HiddenMarks::Invisible);
  contents_.show(deformation);
  contents_.color(coloring);
  contents_.addTo(*meshRenderer_);

  LegendContents legend;
  if (coloring) legend.scale = coloring->scale;
  legend.key = keyOf(contents_.marks());
  if (options.legend == Legend::Hidden || !hasRoomForLegend(size_)) legend = {};
  layOut(legend, textSizeOf(size_, pixelRatio_));
  placeCamera(model, deformation);
}

Scene::~Scene() = default;

void Scene::layOut(const LegendContents& contents, double textSize)
{
  contents_.setPixelRatio(pixelRatio_);
  contents_.setBallSize(kBallSize * textSize / pixelRatio_);
  if (contents.isEmpty()) return;
  const double width = pixelRatio_ * size_.width;
  const double legendWidth = kLegendWidth * textSize;
  meshRenderer_->SetViewport(0, 0, 1 - legendWidth / width, 1);
  addLegend(*backdrop_, contents,
            {width - legendWidth, legendWidth, static_cast<double>(pixelRatio_) * size_.height, textSize});
}

void Scene::placeCamera(const Model& model, const DeformResult& deformation)
{
  std::array<double, 4> viewport{};
  meshRenderer_->GetViewport(viewport.data());
  const double aspect = (viewport[2] - viewport[0]) * size_.width / size_.height;
  const Positions all = stacked(model.mesh.positions, deformation.positions);
  fit(*meshRenderer_->GetActiveCamera(), defaultFrame(all), all, aspect);
  meshRenderer_->ResetCameraClippingRange();
}

}  // namespace holdfast
