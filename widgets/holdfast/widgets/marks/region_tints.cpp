#include "holdfast/widgets/marks/region_tints.h"

#include <algorithm>
#include <utility>

namespace holdfast {
namespace {

// The tints of disabled constraints are hollow.
constexpr double kHollow = 0.10;
constexpr double kFilled = 0.45;

}  // namespace

RegionTints::RegionTints(const MeshActor& mesh) : mesh_(mesh)
{
  for (std::size_t look = 0; look < kRegionLooks; ++look) {
    const bool isRigid = look + 1 == kRegionLooks;
    ConstraintMark mark;
    mark.status = isRigid ? ConstraintStatus::Met : static_cast<ConstraintStatus>(look);
    mark.kind = isRigid ? MarkKind::Rigid : MarkKind::Selection;
    const double opacity = mark.status == ConstraintStatus::Disabled ? kHollow : kFilled;
    tints_.push_back(std::make_unique<FaceTint>(mesh, glyphColor(mark), opacity));
  }
  tints_.push_back(std::make_unique<FaceTint>(mesh, kSelectedColor));
}

void RegionTints::show(const std::shared_ptr<const MarkSet>& marks)
{
  const bool isSame = marks->looks == marks_->looks;
  marks_ = marks;
  if (isSame) return;
  for (std::size_t look = 0; look < kRegionLooks; ++look)
    set(*tints_[look], static_cast<std::uint8_t>(1U << look), marks_->looks ? *marks_->looks : RegionLooks());
  updateHighlight();
}

void RegionTints::set(FaceTint& tint, std::uint8_t bit, const RegionLooks& looks) const
{
  if (std::ranges::none_of(looks, [bit](std::uint8_t bits) { return (bits & bit) != 0; })) return tint.set({});
  std::vector<char> isIn;
  for (const Index unknown : mesh_.model().solverMesh.weld.unknownOf)
    isIn.push_back((looks[unknown] & bit) != 0 ? 1 : 0);
  tint.set(std::move(isIn));
}

void RegionTints::refresh()
{
  for (const auto& tint : tints_) tint->refresh();
}

void RegionTints::highlight(std::vector<Index> constraints)
{
  std::ranges::sort(constraints);
  if (highlighted_ == constraints) return;
  highlighted_ = std::move(constraints);
  updateHighlight();
}

void RegionTints::updateHighlight()
{
  RegionLooks looks(marks_->looks && !highlighted_.empty() ? marks_->looks->size() : 0);
  for (const ConstraintMark& mark : marks_->marks)
    if (!looks.empty() && std::ranges::binary_search(highlighted_, mark.constraint))
      for (const Index unknown : {mark.unknown, mark.reference})
        if (unknown >= 0) looks[unknown] = 1;
  set(*tints_.back(), 1, looks);
}

}  // namespace holdfast
