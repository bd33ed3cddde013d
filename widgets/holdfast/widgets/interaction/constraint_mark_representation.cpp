#include "holdfast/widgets/interaction/constraint_mark_representation.h"

#include <algorithm>
#include <utility>

#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {
namespace {

// A hand aims at single points, not at one vertex of a region that lies there as well.
constexpr double kRegionHandicapPixels = 2;

}  // namespace

vtkStandardNewMacro(ConstraintMarkRepresentation);

void ConstraintMarkRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Marks: " << (this->Marks ? this->Marks->marks.size() : 0) << '\n';
  os << indent << "Section: " << (this->Section ? "set" : "(none)") << '\n';
  os << indent << "ReachPixels: " << this->ReachPixels << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void ConstraintMarkRepresentation::SetMarks(std::shared_ptr<const MarkSet> marks)
{
  this->Marks = std::move(marks);
  this->Modified();
}

bool ConstraintMarkRepresentation::HasMarksOf(Index constraint) const
{
  return this->Marks && std::any_of(this->Marks->marks.begin(), this->Marks->marks.end(),
                                    [&](const ConstraintMark& mark) { return mark.constraint == constraint; });
}

std::optional<Index> ConstraintMarkRepresentation::FindConstraint(double displayX, double displayY) const
{
  if (this->Renderer == nullptr || !this->Marks) return std::nullopt;
  const DisplayTransform toDisplay(*this->Renderer);
  const DisplayPoint cursor = centerOfPixel(displayX, displayY);
  double nearest = this->ReachPixels * this->PixelRatio;
  std::optional<Index> found;
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
  return found;
}

}  // namespace holdfast
