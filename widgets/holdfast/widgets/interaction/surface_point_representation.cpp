#include "holdfast/widgets/interaction/surface_point_representation.h"

#include <utility>

#include <vtkCellArray.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPropCollection.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>
#include <holdfast/widgets/mesh/actor_setup.h>
#include <holdfast/widgets/mesh/blended_actor.h>

namespace holdfast {
namespace {

// Pixels of a display of ordinary resolution.
constexpr double kPreviewBallPixels = 9;
constexpr double kHaloPixels = 3.5;
constexpr double kOutlinePixels = 1.6;

// Nearer to the eye than the lines of the mesh, which lie in the same place.
constexpr double kOutlineFactor = -2;
constexpr double kOutlineUnits = -8;

constexpr Color kHaloColor{1, 1, 1};

MarkKind markKindOf(const SurfaceLocation& location)
{
  if (std::holds_alternative<AtVertex>(location)) return MarkKind::Vertex;
  return std::holds_alternative<AtEdge>(location) ? MarkKind::Edge : MarkKind::Face;
}

}  // namespace

vtkStandardNewMacro(SurfacePointRepresentation);

SurfacePointRepresentation::SurfacePointRepresentation()
{
  this->AddLines(vtkSmartPointer<BehindActor>::New(), kAccentColor);
  this->AddLines(vtkSmartPointer<BlendedActor>::New(), kHaloColor);
  this->AddLines(vtkSmartPointer<BlendedActor>::New(), kAccentColor);
  this->SetPixelRatio(1);
}

void SurfacePointRepresentation::AddLines(vtkSmartPointer<vtkActor> actor, const Color& color)
{
  drawLinesNearer(showData(*actor, *this->Outline), kOutlineFactor, kOutlineUnits);
  setColor(*actor, color);
  actor->GetProperty()->LightingOff();
  this->Lines.push_back(std::move(actor));
}

void SurfacePointRepresentation::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  if (!surface || !this->Surface || !surface->isSameMesh(*this->Surface)) this->Preview.reset();
  this->Surface = std::move(surface);
  this->SetPreview(std::exchange(this->Preview, std::nullopt));
}

void SurfacePointRepresentation::SetPreview(std::optional<SurfacePick> pick)
{
  this->Preview = this->Surface ? std::move(pick) : std::nullopt;
  if (this->Preview)
    this->Preview->place =
        positionOf(pointOf(this->Preview->location, this->Surface->model().mesh), this->Surface->positions());
  this->Modified();
}

void SurfacePointRepresentation::SetPixelRatio(double ratio)
{
  this->PixelRatio = ratio;
  this->Point.setBallPixels(kPreviewBallPixels * ratio);
  for (std::size_t k = 0; k < this->Lines.size(); ++k) {
    const bool isHalo = k == 1;
    setLineWidth(*this->Lines[k], (isHalo ? kHaloPixels : kOutlinePixels) * ratio);
  }
  this->Modified();
}

/// The ends of the edge, the corners of the face; none for a vertex.
std::vector<Index> SurfacePointRepresentation::OutlineVertices() const
{
  if (const auto* edge = std::get_if<AtEdge>(&this->Preview->location)) return {edge->i, edge->j};
  const auto* at = std::get_if<AtFace>(&this->Preview->location);
  if (at == nullptr) return {};
  const auto corners = this->Surface->model().mesh.faces[at->face];
  return {corners.begin(), corners.end()};
}

void SurfacePointRepresentation::BuildRepresentation()
{
  if (this->BuildTime > this->GetMTime()) return;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  if (this->Preview) {
    const std::vector<Index> vertices = this->OutlineVertices();
    for (const Index vertex : vertices) {
      const Vector3 place = this->Surface->positions().row(vertex);
      points->InsertNextPoint(place.data());
    }
    const auto count = static_cast<vtkIdType>(vertices.size());
    for (vtkIdType k = 0; k < count; ++k) lines->InsertNextCell({k, (k + 1) % count});
  }
  this->Outline->SetPoints(points);
  this->Outline->SetLines(lines);
  if (this->Preview)
    this->Point.set(PreviewedPoint{this->Preview->place, markKindOf(this->Preview->location)});
  else
    this->Point.set(std::nullopt);
  this->BuildTime.Modified();
}

void SurfacePointRepresentation::GetActors(vtkPropCollection* actors)
{
  for (const auto& line : this->Lines) actors->AddItem(line);
  for (vtkActor* const actor : this->Point.actors()) actors->AddItem(actor);
}

void SurfacePointRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& line : this->Lines) line->ReleaseGraphicsResources(window);
  for (vtkActor* const actor : this->Point.actors()) actor->ReleaseGraphicsResources(window);
}

int SurfacePointRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->BuildRepresentation();
  if (!this->Preview) return 0;
  int count = 0;
  if (this->Outline->GetNumberOfLines() > 0)
    for (const auto& line : this->Lines) count += line->RenderOpaqueGeometry(viewport);
  for (vtkActor* const actor : this->Point.actors())
    if (actor->GetVisibility() != 0) count += actor->RenderOpaqueGeometry(viewport);
  return count;
}

}  // namespace holdfast
