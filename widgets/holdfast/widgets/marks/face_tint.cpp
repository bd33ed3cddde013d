#include "holdfast/widgets/marks/face_tint.h"

#include <algorithm>
#include <utility>

#include <vtkCellArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>

#include <holdfast/threads/parallel.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

// A line has a rim of the other lightness, so that it is seen on every colour.
constexpr double kLight = 0.7;
constexpr Color kLightRim{1, 1, 1};
constexpr Color kDarkRim{0.14, 0.15, 0.18};
constexpr double kTintRimOpacity = 0.75;
constexpr double kRimPixels = 3.6;
constexpr double kLinePixels = 1.8;

// A share of the push of the surface: tints lie between it and the lines on it.
constexpr double kPush = 0.5;

// Of the triangles of a mesh. Smaller tints would lose their shape: of about a hundred coarse triangles or fewer.
constexpr double kSmallShare = 0.005;

}  // namespace

FaceTint::FaceTint(const MeshActor& mesh, const Color& color, double opacity) : mesh_(mesh)
{
  data_->SetPoints(&mesh.points());
  data_->GetPointData()->SetNormals(&mesh.normals());
  lineData_->SetPoints(&mesh.points());
  mapper_->SetInputData(data_);
  coarseMapper_->SetInputData(coarseData_);
  for (vtkPolyDataMapper* const mapper :
       {mapper_.Get(), coarseMapper_.Get(), &showData(*rim_, *lineData_), &showData(*line_, *lineData_)})
    mapper->SetClippingPlanes(&mesh.sectionPlanes());
  // The shades are those of the surface that shines through.
  for (vtkActor* const actor : std::initializer_list<vtkActor*>{faces_, rim_, line_}) {
    actor->GetProperty()->LightingOff();
    setColor(*actor, color);
  }
  setColor(*rim_, color.green > kLight ? kDarkRim : kLightRim);
  rim_->GetProperty()->SetOpacity(kTintRimOpacity);
  faces_->GetProperty()->SetOpacity(opacity);
  faces_->setPush(kPush);
  // They hide nothing that the surface below them does not hide, and need no order.
  faces_->ForceOpaqueOn();
  setPixelRatio(1);
  set({});
}

void FaceTint::set(std::vector<char> isIn)
{
  isIn_ = std::move(isIn);
  setOutline();
  // Made when they are to be drawn.
  for (vtkPolyData* const data : {data_.Get(), coarseData_.Get()}) data->SetPolys(nullptr);
  for (vtkActor* const actor : std::initializer_list<vtkActor*>{faces_, rim_, line_}) actor->SetVisibility(tinted_ > 0);
  updateDetail();
}

bool FaceTint::isBetween(std::span<const int> points, const std::vector<Index>& vertexOf) const
{
  return std::ranges::all_of(points, [&](Index point) { return isIn_[vertexOf[point]] != 0; });
}

void FaceTint::setOutline()
{
  const ShadedSurface& surface = *mesh_.shaded();
  isTinted_.assign(isIn_.empty() ? 0 : surface.triangles.size(), 0);
  parallelBlocks(static_cast<Index>(isTinted_.size()), [&](Index t) {
    isTinted_[t] = !mesh_.isHidden(t) && isBetween(surface.triangles[t], surface.vertexOf) ? 1 : 0;
  });
  tinted_ = std::ranges::count(isTinted_, 1);
  isCovered_.assign(tinted_ > 0 ? isIn_.size() : 0, 0);
  vtkNew<vtkCellArray> lines;
  for (Index t = 0; tinted_ > 0 && t < surface.triangles.size(); ++t) {
    if (isTinted_[t] == 0) continue;
    const auto points = surface.triangles[t];
    for (int side = 0; side < 3; ++side) {
      isCovered_[surface.vertexOf[points[side]]] = 1;
      const Index across = surface.across[t][side];
      if (across < 0 || isTinted_[across] == 0) lines->InsertNextCell({points[side], points[(side + 1) % 3]});
    }
  }
  lineData_->SetLines(lines);
}

void FaceTint::updateDetail()
{
  const auto all = static_cast<double>(mesh_.shaded()->triangles.size());
  const bool isCoarse = mesh_.isCoarse() && static_cast<double>(tinted_) > kSmallShare * all;
  if (!isCoarse && data_->GetNumberOfPolys() < tinted_)
    data_->SetPolys(toCells(mesh_.shaded()->triangles, [this](Index triangle) { return isTinted_[triangle] != 0; }));
  if (isCoarse && coarseData_->GetNumberOfPolys() == 0) {
    const CoarseSurface& coarse = mesh_.coarse();
    coarseData_->SetPoints(coarse.data().GetPoints());
    coarseData_->GetPointData()->SetNormals(coarse.data().GetPointData()->GetNormals());
    coarseData_->SetPolys(toCells(coarse.triangles(), [&](Index triangle) {
      return isBetween(coarse.triangles()[triangle], coarse.vertexOf());
    }));
  }
  faces_->SetMapper(isCoarse ? coarseMapper_ : mapper_);
}

void FaceTint::setPixelRatio(double ratio)
{
  setLineWidth(*rim_, kRimPixels * ratio);
  setLineWidth(*line_, kLinePixels * ratio);
}

}  // namespace holdfast
