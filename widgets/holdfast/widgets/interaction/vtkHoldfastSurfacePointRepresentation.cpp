#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointRepresentation.h"

#include <array>
#include <utility>

#include <holdfast/widgets/mesh/poly_data.h>

using namespace holdfast;

namespace {

// Pixels of a display of ordinary resolution.
constexpr double kPreviewBallPixels = 9;
constexpr double kHaloPixels = 3.5;
constexpr double kOutlinePixels = 1.6;

constexpr Color kHaloColor{1, 1, 1};

}  // namespace

vtkStandardNewMacro(vtkHoldfastSurfacePointRepresentation);

vtkHoldfastSurfacePointRepresentation::vtkHoldfastSurfacePointRepresentation()
{
  const auto addLine = [this](vtkActor& actor, const Color& color) {
    showData(actor, *this->Outline);
    setColor(actor, color);
    actor.GetProperty()->LightingOff();
    this->Props.push_back(&actor);
  };
  addLine(*this->LineBehind, kAccentColor);
  addLine(*this->LineHalo, kHaloColor);
  addLine(*this->Line, kAccentColor);
  for (vtkActor* const actor : this->Point.actors()) this->Props.push_back(actor);
  this->SetPixelRatio(1);
}

void vtkHoldfastSurfacePointRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Preview: " << (this->Preview ? "on" : "off") << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void vtkHoldfastSurfacePointRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  if (!surface || !this->Surface || !surface->isSameMesh(*this->Surface)) this->Preview.reset();
  this->Surface = std::move(surface);
  this->SetPreview(this->GetPreview());
}

void vtkHoldfastSurfacePointRepresentation::SetPreview(const SurfacePick* pick)
{
  this->Preview = this->Surface && pick != nullptr ? std::optional(*pick) : std::nullopt;
  if (this->Preview)
    this->Preview->place =
        positionOf(pointOf(this->Preview->location, this->Surface->model().mesh), this->Surface->positions());
  this->Modified();
}

void vtkHoldfastSurfacePointRepresentation::SetPixelRatio(double ratio)
{
  this->PixelRatio = ratio;
  this->Point.setBallPixels(kPreviewBallPixels * ratio);
  setLineWidth(*this->LineBehind, kOutlinePixels * ratio);
  setLineWidth(*this->LineHalo, kHaloPixels * ratio);
  setLineWidth(*this->Line, kOutlinePixels * ratio);
  this->Modified();
}

void vtkHoldfastSurfacePointRepresentation::BuildRepresentation()
{
  if (this->BuildTime > this->GetMTime()) return;
  std::vector<Vector3> outline;
  const auto add = [&](Index vertex) { outline.emplace_back(this->Surface->positions().row(vertex)); };
  const SurfaceLocation* const at = this->Preview ? &this->Preview->location : nullptr;
  if (const auto* edge = std::get_if<AtEdge>(at)) {
    add(edge->i);
    add(edge->j);
  }
  if (const auto* face = std::get_if<AtFace>(at))
    for (const Index corner : this->Surface->model().mesh.faces[face->face]) add(corner);
  if (!outline.empty()) outline.push_back(outline.front());
  setLines(*this->Outline, {outline});
  std::optional<PreviewedPoint> point;
  // In the order of `SurfaceLocation`; no pick is near a place.
  constexpr std::array kKinds{MarkKind::Vertex, MarkKind::Edge, MarkKind::Face};
  static_assert(std::variant_size_v<SurfaceLocation> == kKinds.size() + 1);
  if (this->Preview) point.emplace(PreviewedPoint{this->Preview->place, kKinds.at(this->Preview->location.index())});
  this->Point.set(point);
  this->BuildTime.Modified();
}
