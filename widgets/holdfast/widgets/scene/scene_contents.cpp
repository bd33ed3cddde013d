#include "holdfast/widgets/scene/scene_contents.h"

#include <algorithm>
#include <utility>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <holdfast/deform/deform_details.h>

namespace holdfast {
namespace {

constexpr double kGhostEdgeOpacity = 0.22;
constexpr double kGhostSurfaceOpacity = 0.16;

constexpr double kCutPixels = 2;

// A share of a ball's diameter.
constexpr double kSelectionDotSize = 0.42;

/// Each once, in the order of the constraints.
std::vector<std::shared_ptr<const GuideSurface>> guideSurfacesOf(const DeformResult& deformation)
{
  std::vector<std::shared_ptr<const GuideSurface>> surfaces;
  if (deformation.details == nullptr) return surfaces;
  for (const TolerantRow& tolerant : deformation.details->system.tolerant)
    if (tolerant.surface != nullptr && std::ranges::count(surfaces, tolerant.surface) == 0)
      surfaces.push_back(tolerant.surface);
  return surfaces;
}

}  // namespace

SceneContents::SceneContents(const Model& model, std::shared_ptr<const ShadedSurface> shaded)
    : positions_(model.mesh.positions),
      mesh_(model, std::move(shaded)),
      rest_(model, mesh_.shaded()),
      regions_(mesh_),
      selection_(model, mesh_),
      arrows_(model)
{
  rest_.edges().GetProperty()->SetOpacity(kGhostEdgeOpacity);
  rest_.surface().GetProperty()->SetOpacity(kGhostSurfaceOpacity);
  restSurface_->SetProperty(rest_.surface().GetProperty());
  showData(*cut_, *cutLines_);
  setColor(*cut_, kAccentColor);
  cut_->GetProperty()->LightingOff();
  for (vtkActor* const actor : arrows_.actors()) actor->GetMapper()->SetClippingPlanes(&mesh_.sectionPlanes());
  setRestGhost(RestGhost::Edges);
  setRotationDisplay(RotationDisplay::Hidden);
  resize();
}

void SceneContents::addTo(vtkRenderer& renderer)
{
  leave();
  for (vtkActor* const actor : actors()) renderer.AddActor(actor);
  renderer_ = &renderer;
}

void SceneContents::leave()
{
  if (renderer_ == nullptr) return;
  for (vtkActor* const actor : actors()) renderer_->RemoveActor(actor);
}

/// In the order in which they are drawn.
std::vector<vtkActor*> SceneContents::actors()
{
  std::vector<vtkActor*> all{&mesh_.surface()};
  const auto add = [&](const std::vector<vtkActor*>& some) { all.insert(all.end(), some.begin(), some.end()); };
  for (const FaceTint* tint : tints()) add({&tint->faces()});
  add({&mesh_.meshEdges()});
  for (const FaceTint* tint : tints()) add(tint->outline());
  add(arrows_.actors());
  add({&selection_.dots()});
  add(glyphs_.actors());
  add({&mesh_.edges(), &rest_.edges(), restSurface_, &guides_.actor(), cut_});
  return all;
}

/// In the order in which they are drawn.
std::vector<FaceTint*> SceneContents::tints()
{
  std::vector<FaceTint*> tints;
  for (const auto& tint : regions_.tints()) tints.push_back(tint.get());
  tints.push_back(&selection_.tint());
  return tints;
}

void SceneContents::show(const DeformResult& deformation)
{
  showShape(deformation);
  const Model& model = mesh_.model();
  showMarks(markSet(model, constraintMarks(model, deformation), glyphs_.marks(), constraintGuides(model, deformation)));
}

void SceneContents::showShape(const DeformResult& deformation)
{
  rotations_ = deformation.rotations;
  guides_.show(guideSurfacesOf(deformation));
  setPositions(deformation.positions);
}

void SceneContents::setPositions(const Positions& positions)
{
  positions_ = positions;
  mesh_.setPositions(positions);
  updateArrows();
}

std::vector<ActorSlices*> SceneContents::slices()
{
  std::vector<ActorSlices*> all{&mesh_.surfaceSlices()};
  for (FaceTint* tint : tints()) all.push_back(&tint->slices());
  all.push_back(&mesh_.meshEdgeSlices());
  std::erase_if(all,
                [](const ActorSlices* slices) { return slices->actor().GetVisibility() == 0 || slices->count() == 0; });
  return all;
}

void SceneContents::color(const std::optional<Coloring>& coloring)
{
  if (coloring)
    mesh_.setColors(coloring->values, coloring->scale, coloring->pointValues);
  else
    mesh_.clearColors();
}

void SceneContents::setSection(const std::optional<SectionPlane>& section)
{
  mesh_.setSection(section);
  rest_.setSection(section);
  glyphs_.setSection(section);
}

void SceneContents::setHidden(const std::vector<char>& isHidden)
{
  const Model& model = mesh_.model();
  mesh_.setHidden(isHidden);
  rest_.setHiddenAs(mesh_);
  restSurface_->SetMapper(rest_.surface().GetMapper());
  const auto count = static_cast<std::size_t>(model.solverMesh.unknownCount());
  isUnknownHidden_.assign(isHidden.empty() ? 0 : count, 1);
  for (std::size_t t = 0; t < isHidden.size(); ++t)
    for (const Index vertex : model.triangulation.triangles[t])
      if (isHidden[t] == 0) isUnknownHidden_[model.solverMesh.weld.unknownOf[vertex]] = 0;
  std::vector<char> isVertexHidden;
  for (const Index unknown : model.solverMesh.weld.unknownOf)
    if (!isUnknownHidden_.empty()) isVertexHidden.push_back(isUnknownHidden_[unknown]);
  regions_.refresh();
  selection_.refresh();
  arrows_.setHidden(std::move(isVertexHidden));
  updateArrows();
  if (allMarks_) showMarks(allMarks_);
}

void SceneContents::showMarks(std::shared_ptr<const MarkSet> marks)
{
  allMarks_ = std::move(marks);
  const auto shown = shownMarks();
  regions_.show(shown);
  glyphs_.setMarks(shown);
}

std::shared_ptr<const MarkSet> SceneContents::shownMarks() const
{
  if (isUnknownHidden_.empty()) return allMarks_;
  std::vector<ConstraintMark> shown = allMarks_->marks;
  std::erase_if(
      shown, [this](const ConstraintMark& mark) { return mark.nearest >= 0 && isUnknownHidden_[mark.nearest] != 0; });
  return markSet(mesh_.model(), std::move(shown), glyphs_.marks(), allMarks_->guides);
}

void SceneContents::setCut(const std::vector<std::array<Vector3, 2>>& segments)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(2 * static_cast<vtkIdType>(segments.size()));
  vtkNew<vtkCellArray> lines;
  for (vtkIdType end = 0; end < points->GetNumberOfPoints(); ++end) {
    points->SetPoint(end, segments[static_cast<std::size_t>(end / 2)][end % 2].data());
    if (end % 2 == 1) lines->InsertNextCell({end - 1, end});
  }
  cutLines_->SetPoints(points);
  cutLines_->SetLines(lines);
}

void SceneContents::setRestGhost(RestGhost ghost)
{
  rest_.edges().SetVisibility(ghost != RestGhost::Hidden);
  restSurface_->SetVisibility(ghost == RestGhost::Surface);
  ghost_ = ghost;
  updateDetail();
}

void SceneContents::setRotationDisplay(RotationDisplay display)
{
  rotationDisplay_ = display;
  for (vtkActor* const actor : arrows_.actors()) actor->SetVisibility(display == RotationDisplay::Arrows);
  updateArrows();
}

void SceneContents::setDetail(Detail detail)
{
  detail_ = detail;
  updateDetail();
}

void SceneContents::updateDetail()
{
  mesh_.setDetail(detail_);
  for (FaceTint* tint : tints()) tint->updateDetail();
  // The surface is too faint for its fewer triangles to be seen.
  if (ghost_ == RestGhost::Surface) rest_.setDetail(Detail::Coarse);
  restSurface_->SetMapper(rest_.surface().GetMapper());
}

void SceneContents::setPixelRatio(double ratio)
{
  pixelRatio_ = ratio;
  resize();
}

void SceneContents::setBallSize(double pixels)
{
  ballSize_ = pixels;
  resize();
}

void SceneContents::resize()
{
  mesh_.setPixelRatio(pixelRatio_);
  rest_.setPixelRatio(pixelRatio_);
  setLineWidth(*cut_, kCutPixels * pixelRatio_);
  for (FaceTint* tint : tints()) tint->setPixelRatio(pixelRatio_);
  glyphs_.setBallPixels(pixelRatio_ * ballSize_);
  selection_.setDotPixels(kSelectionDotSize * pixelRatio_ * ballSize_);
}

void arrange(SceneContents& contents, const DisplaySettings& settings)
{
  contents.setRestGhost(settings.rest);
  contents.setMeshEdges(settings.edges);
  contents.mesh().setSurfaceDisplay(settings.surface);
  contents.setRotationDisplay(settings.rotations);
  if (!settings.areConstraintsShown) contents.setMarks({});
}

std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, const ColorSettings& settings,
                                   const std::string& units, const ShadedSurface* shaded)
{
  std::optional<Coloring> coloring = coloringOf(model, deformation, settings.field, units);
  if (!coloring) return std::nullopt;
  coloring = withRange(std::move(*coloring), settings.range);
  if (shaded != nullptr)
    coloring->pointValues = pointValuesOf(model, deformation, settings.field, cutSurfaceOf(*shaded));
  if (settings.map) coloring->scale.map = *settings.map;
  coloring->scale.bands = settings.bands;
  return coloring;
}

}  // namespace holdfast
