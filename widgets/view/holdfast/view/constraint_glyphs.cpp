#include "holdfast/view/constraint_glyphs.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <vtkActor.h>

#include <holdfast/view/evenly_spread.h>

namespace holdfast {
namespace {

/// Sprites of one shape and size, in the order in which they are drawn.
enum Layer { Dots, HollowDots, Balls, Beads, Wedges, HollowPoints, HighlightedDots, Rings, HiddenPoints, LayerCount };

struct LayerLook {
  SpriteShape shape;
  double size;  // of the diameter of a single point's ball
  SpriteDepth depth = SpriteDepth::InFront;
};

// A triangle and a bead on its bar have about the area of a ball.
constexpr std::array<LayerLook, LayerCount> kLooks{{{SpriteShape::Ball, 0.45},
                                                    {SpriteShape::Hollow, 0.65},
                                                    {SpriteShape::Ball, 1},
                                                    {SpriteShape::Bead, 1.75},
                                                    {SpriteShape::Wedge, 1.75},
                                                    {SpriteShape::Hollow, 1.15},
                                                    {SpriteShape::Ball, 0.6},
                                                    {SpriteShape::Ring, 2.5},
                                                    {SpriteShape::Ball, 1, SpriteDepth::Behind}}};
constexpr double kCrowdedDotSize = 0.34;
constexpr double kLineSize = 0.22;

// More dots than this are drawn smaller.
constexpr std::size_t kCrowd = 500;

constexpr Color kRigidColor{0.42, 0.24, 0.08};

bool isOff(ConstraintStatus status)
{
  return status == ConstraintStatus::Conflicting || status == ConstraintStatus::Missed;
}

/// Nothing moved the others yet: they still show where they want to go.
bool hasPull(const ConstraintMark& mark)
{
  const bool isWaiting = mark.status == ConstraintStatus::Independent || mark.status == ConstraintStatus::Disabled;
  return isOff(mark.status) || (isWaiting && isSinglePoint(mark.kind) && mark.target != mark.place);
}

/// Those of `group` that are drawn where there are too many.
std::vector<Index> thinned(const std::vector<ConstraintMark>& marks, const std::vector<Index>& group)
{
  Positions rest(static_cast<Index>(group.size()), 3);
  for (Index k = 0; k < rest.rows(); ++k) rest.row(k) = marks[group[k]].rest;
  std::vector<Index> kept;
  for (const Index k : evenlySpread(rest, kMostDots)) kept.push_back(group[k]);
  return kept;
}

/// Whether both lists hold the same places of the mesh and fared alike: then the same marks are drawn.
bool areDrawnAlike(const std::vector<ConstraintMark>& a, const std::vector<ConstraintMark>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ConstraintMark& p, const ConstraintMark& q) {
    return p.rest == q.rest && p.status == q.status && p.kind == q.kind;
  });
}

Layer layerOf(const ConstraintMark& mark)
{
  const bool isPoint = isSinglePoint(mark.kind);
  if (mark.status == ConstraintStatus::Disabled) return isPoint ? HollowPoints : HollowDots;
  if (!isPoint) return Dots;
  if (mark.kind == MarkKind::Edge) return Beads;
  return mark.kind == MarkKind::Face ? Wedges : Balls;
}

/// What is drawn of some marks.
struct GlyphSet {
  std::array<std::vector<Sprite>, LayerCount> layers;
  std::vector<GlyphLine> lines;

  void add(const ConstraintMark& mark)
  {
    const Color color = glyphColor(mark);
    layers[layerOf(mark)].push_back({mark.place, color});
    if (isSinglePoint(mark.kind)) layers[HiddenPoints].push_back({mark.place, color});
    if (mark.other) {
      lines.push_back({mark.place, *mark.other, color, LineStyle::Dashed});
      layers[layerOf(mark)].push_back({*mark.other, color});
    }
    if (hasPull(mark)) {
      layers[Dots].push_back({mark.target, color});
      lines.push_back({mark.place, mark.target, color});
    }
  }

  void highlight(const ConstraintMark& mark)
  {
    layers[isSinglePoint(mark.kind) ? Rings : HighlightedDots].push_back({mark.place, kAccentColor});
  }
};

}  // namespace

Color glyphColor(ConstraintStatus status)
{
  switch (status) {
    case ConstraintStatus::Redundant:
      return {1, 1, 1};
    case ConstraintStatus::Conflicting:
      return {0.90, 0.22, 0.05};
    case ConstraintStatus::Missed:
      return {0.72, 0.25, 0.60};
    case ConstraintStatus::Independent:
      return {0.33, 0.38, 0.48};
    case ConstraintStatus::Disabled:
      return {0.47, 0.48, 0.50};
    case ConstraintStatus::Met:
      break;
  }
  return {0.14, 0.15, 0.18};
}

Color glyphColor(const ConstraintMark& mark)
{
  return mark.kind == MarkKind::Rigid && mark.status == ConstraintStatus::Met ? kRigidColor : glyphColor(mark.status);
}

std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks)
{
  std::map<ConstraintStatus, std::vector<Index>> dots;
  std::vector<Index> drawn;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const bool isOneOfMany = !isSinglePoint(marks[k].kind) && !isOff(marks[k].status);
    (isOneOfMany ? dots[marks[k].status] : drawn).push_back(static_cast<Index>(k));
  }
  for (const auto& [status, group] : dots)
    for (const Index k : thinned(marks, group)) drawn.push_back(k);
  // What is disabled hides nothing.
  const auto gravity = [&](Index k) {
    return marks[k].status == ConstraintStatus::Disabled ? -1 : static_cast<int>(marks[k].status);
  };
  std::sort(drawn.begin(), drawn.end(),
            [&](Index a, Index b) { return std::pair(gravity(a), a) < std::pair(gravity(b), b); });
  return drawn;
}

ConstraintGlyphs::ConstraintGlyphs()
{
  for (const LayerLook& look : kLooks) layers_.push_back(std::make_unique<PointSprites>(look.shape, look.depth));
  update();
}

ConstraintGlyphs::~ConstraintGlyphs() = default;

void ConstraintGlyphs::setMarks(std::vector<ConstraintMark> marks)
{
  if (!areDrawnAlike(marks, marks_)) drawn_ = drawnMarks(marks);
  marks_ = std::move(marks);
  update();
}

void ConstraintGlyphs::highlight(std::vector<Index> constraints)
{
  highlighted_ = std::move(constraints);
  std::sort(highlighted_.begin(), highlighted_.end());
  update();
}

void ConstraintGlyphs::update()
{
  GlyphSet glyphs;
  for (const Index k : drawn_) {
    glyphs.add(marks_[k]);
    if (std::binary_search(highlighted_.begin(), highlighted_.end(), marks_[k].constraint)) glyphs.highlight(marks_[k]);
  }
  if (hidden_ == HiddenMarks::Invisible) glyphs.layers[HiddenPoints].clear();
  for (std::size_t layer = 0; layer < LayerCount; ++layer) layers_[layer]->set(glyphs.layers[layer]);
  lines_.set(glyphs.lines);
  isCrowded_ = glyphs.layers[Dots].size() > kCrowd;
  resize();
}

void ConstraintGlyphs::setBallPixels(double pixels)
{
  ballPixels_ = pixels;
  resize();
}

void ConstraintGlyphs::resize()
{
  for (std::size_t layer = 0; layer < LayerCount; ++layer) layers_[layer]->setPixels(kLooks[layer].size * ballPixels_);
  if (isCrowded_) layers_[Dots]->setPixels(kCrowdedDotSize * ballPixels_);
  lines_.setWidth(kLineSize * ballPixels_);
}

void ConstraintGlyphs::setHiddenMarks(HiddenMarks hidden)
{
  hidden_ = hidden;
  update();
}

std::vector<vtkActor*> ConstraintGlyphs::actors() const
{
  std::vector<vtkActor*> actors;
  for (const auto& layer : layers_) actors.push_back(&layer->actor());
  actors.push_back(&lines_.actor());
  return actors;
}

}  // namespace holdfast
