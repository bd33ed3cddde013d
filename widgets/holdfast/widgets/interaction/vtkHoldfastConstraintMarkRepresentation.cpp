#include "holdfast/widgets/interaction/vtkHoldfastConstraintMarkRepresentation.h"

#include <algorithm>
#include <map>

#include <holdfast/widgets/picking/surface_picker.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastConstraintMarkRepresentation);

void vtkHoldfastConstraintMarkRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Marks: " << this->Marks.get() << '\n';
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Section: " << (this->Section ? "on" : "off") << '\n';
  os << indent << "ReachPixels: " << this->ReachPixels << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

bool vtkHoldfastConstraintMarkRepresentation::HasMarksOf(Index constraint) const
{
  return this->Marks && std::ranges::count(this->Marks->marks, constraint, &ConstraintMark::constraint) > 0;
}

void vtkHoldfastConstraintMarkRepresentation::SetSection(const SectionPlane* section)
{
  assign(*this, this->Section, section != nullptr ? std::optional(*section) : std::nullopt);
}

Index vtkHoldfastConstraintMarkRepresentation::FindConstraint(double displayX, double displayY) const
{
  // Users aim at single points, not at one vertex of a region in the same place.
  constexpr double kRegionHandicapPixels = 2;
  if (this->Renderer == nullptr || !this->Marks) return -1;
  const DisplayTransform toDisplay(*this->Renderer);
  const DisplayPoint cursor = centerOfPixel(displayX, displayY);
  double nearest = this->ReachPixels * this->PixelRatio;
  Index found = -1;
  for (const ConstraintMark& mark : this->Marks->marks) {
    if (this->Section && !isKept(*this->Section, mark.place)) continue;
    const DisplayTransform::Shown shown = toDisplay.show(mark.place);
    if (shown.depth <= 0) continue;
    const double handicap = isSinglePoint(mark.kind) ? 0 : kRegionHandicapPixels * this->PixelRatio;
    const double distance = (shown.point - cursor).norm() + handicap;
    if (distance >= nearest) continue;
    nearest = distance;
    found = mark.constraint;
  }
  return found >= 0 ? found : this->FindRegion(displayX, displayY);
}

Index vtkHoldfastConstraintMarkRepresentation::FindRegion(double displayX, double displayY) const
{
  if (!this->Surface) return -1;
  const auto pick = SurfacePicker(this->Surface).pick(*this->Renderer, displayX, displayY, PickKind::Face, 0);
  if (!pick) return -1;
  const Model& model = this->Surface->model();
  Triangle corners = model.triangulation.triangles[pick->triangle];
  for (int& corner : corners) corner = model.solverMesh.weld.unknownOf[corner];
  constexpr unsigned kAll = 0b111;
  std::map<Index, unsigned> held;  // the corners that a constraint has, as bits
  for (const ConstraintMark& mark : this->Marks->marks)
    for (unsigned k = 0; mark.unknown >= 0 && k < 3; ++k)
      if (corners[k] == mark.unknown || corners[k] == mark.reference) held[mark.constraint] |= 1U << k;
  const auto first = std::ranges::find(held, kAll, [](const auto& each) { return each.second; });
  return first != held.end() ? first->first : -1;
}
