#include "holdfast/widgets/marks/constraint_glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace holdfast {
namespace {

// A dash is as long as a gap, and a line begins and ends with one.
constexpr int kDashes = 11;

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

constexpr double kFaceOpacity = 0.10;

// More dots than this are drawn smaller.
constexpr std::ptrdiff_t kCrowd = 500;

constexpr Color kRigidColor{0.42, 0.24, 0.08};

/// Nothing moved the others yet: they still show where they want to go.
bool hasPull(const ConstraintMark& mark)
{
  const bool isWaiting = mark.status == ConstraintStatus::Independent || mark.status == ConstraintStatus::Disabled;
  return isOff(mark.status) || (isWaiting && isSinglePoint(mark.kind) && mark.target != mark.place);
}

Layer layerOf(const ConstraintMark& mark)
{
  const bool isPoint = isSinglePoint(mark.kind);
  if (mark.status == ConstraintStatus::Disabled) return isPoint ? HollowPoints : HollowDots;
  if (!isPoint) return Dots;
  if (mark.kind == MarkKind::Edge) return Beads;
  return mark.kind == MarkKind::Face ? Wedges : Balls;
}

enum class LineStyle { Solid, Dashed };

struct GlyphLine {
  Vector3 from;
  Vector3 to;
  Color color;
  LineStyle style = LineStyle::Solid;
};

void drawLines(vtkPolyData& data, const std::vector<GlyphLine>& lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  colors->SetNumberOfComponents(3);
  const auto addPoint = [&](const Vector3& place, const Color& color) {
    colors->InsertNextTuple3(std::round(255 * color.red), std::round(255 * color.green), std::round(255 * color.blue));
    return points->InsertNextPoint(place.data());
  };
  for (const GlyphLine& line : lines) {
    const int dashes = line.style == LineStyle::Dashed ? kDashes : 1;
    const Vector3 step = (line.to - line.from) / (2 * dashes - 1);
    for (int k = 0; k < dashes; ++k) {
      const Vector3 end = k == dashes - 1 ? line.to : Vector3(line.from + (2 * k + 1) * step);
      cells->InsertNextCell({addPoint(line.from + 2 * k * step, line.color), addPoint(end, line.color)});
    }
  }
  data.SetPoints(points);
  data.SetLines(cells);
  data.GetPointData()->SetScalars(colors);
}

/// The four corners of a plane, in order.
struct GuideFace {
  std::array<Vector3, 4> corners;
  Color color;
};

void drawFaces(vtkPolyData& data, const std::vector<GuideFace>& faces)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  colors->SetNumberOfComponents(3);
  for (const GuideFace& face : faces) {
    std::array<vtkIdType, 4> corners{};
    std::ranges::transform(face.corners, corners.begin(),
                           [&](const Vector3& place) { return points->InsertNextPoint(place.data()); });
    cells->InsertNextCell(4, corners.data());
    colors->InsertNextTuple3(std::round(255 * face.color.red), std::round(255 * face.color.green),
                             std::round(255 * face.color.blue));
  }
  data.SetPoints(points);
  data.SetPolys(cells);
  data.GetCellData()->SetScalars(colors);
}

struct GlyphSet {
  std::optional<SectionPlane> section;
  std::array<std::vector<Sprite>, LayerCount> layers;
  std::vector<GlyphLine> lines;
  std::vector<GuideFace> faces;

  [[nodiscard]] bool isShown(const Vector3& place) const { return !section || isKept(*section, place); }

  void add(const ConstraintMark& mark)
  {
    const Color color = glyphColor(mark);
    const bool isPlaceShown = isShown(mark.place);
    if (isPlaceShown) layers[layerOf(mark)].push_back({mark.place, color});
    if (isPlaceShown && isSinglePoint(mark.kind)) layers[HiddenPoints].push_back({mark.place, color});
    if (mark.other) {
      const bool isOtherShown = isShown(*mark.other);
      if (isPlaceShown || isOtherShown) lines.push_back({mark.place, *mark.other, color, LineStyle::Dashed});
      if (isOtherShown) layers[layerOf(mark)].push_back({*mark.other, color});
    }
    if (isPlaceShown && hasPull(mark)) {
      layers[Dots].push_back({mark.target, color});
      lines.push_back({mark.place, mark.target, color});
    }
  }

  void add(const ConstraintGuide& guide, const Color& color)
  {
    if (!isShown(guide.center)) return;
    for (const auto& [from, to] : outlineOf(guide)) lines.push_back({from, to, color});
    if (guide.shape == GuideShape::Plane) faces.push_back({cornersOf(guide), color});
  }

  void highlight(const ConstraintMark& mark)
  {
    if (!isShown(mark.place)) return;
    layers[isSinglePoint(mark.kind) ? Rings : HighlightedDots].push_back({mark.place, kSelectedColor});
  }
};

}  // namespace

Color glyphColor(ConstraintStatus status)
{
  // In the order of `ConstraintStatus`.
  constexpr std::array<Color, 6> kColors{
      {{0.33, 0.38, 0.48}, {0.14, 0.15, 0.18}, {1, 1, 1}, {0.90, 0.22, 0.05}, {0.72, 0.25, 0.60}, {0.47, 0.48, 0.50}}};
  return kColors[static_cast<std::size_t>(status)];
}

Color glyphColor(const ConstraintMark& mark)
{
  return mark.kind == MarkKind::Rigid && mark.status == ConstraintStatus::Met ? kRigidColor : glyphColor(mark.status);
}

ConstraintGlyphs::ConstraintGlyphs() : marks_(std::make_shared<const MarkSet>())
{
  for (const LayerLook& look : kLooks) layers_.push_back(std::make_unique<PointSprites>(look.shape, look.depth));
  showData(*lines_, *lineData_);
  lines_->GetProperty()->LightingOff();
  showData(*faces_, *faceData_);
  faces_->GetProperty()->LightingOff();
  faces_->GetProperty()->SetOpacity(kFaceOpacity);
  update();
}

void ConstraintGlyphs::setMarks(std::shared_ptr<const MarkSet> marks)
{
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
  glyphs.section = section_;
  for (const Index k : marks_->drawn) {
    const ConstraintMark& mark = marks_->marks[k];
    glyphs.add(mark);
    if (std::binary_search(highlighted_.begin(), highlighted_.end(), mark.constraint)) glyphs.highlight(mark);
  }
  for (const ConstraintGuide& guide : marks_->guides)
    glyphs.add(guide,
               std::ranges::binary_search(highlighted_, guide.constraint) ? kSelectedColor : glyphColor(guide.status));
  if (hidden_ == HiddenMarks::Invisible) glyphs.layers[HiddenPoints].clear();
  for (std::size_t layer = 0; layer < LayerCount; ++layer) layers_[layer]->set(glyphs.layers[layer]);
  drawLines(*lineData_, glyphs.lines);
  lines_->SetVisibility(!glyphs.lines.empty());
  drawFaces(*faceData_, glyphs.faces);
  faces_->SetVisibility(!glyphs.faces.empty());
  // Marks that are cut away count too: sizes do not change while a plane moves.
  isCrowded_ = std::count_if(marks_->drawn.begin(), marks_->drawn.end(),
                             [&](Index k) { return layerOf(marks_->marks[k]) == Dots; }) > kCrowd;
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
  setLineWidth(*lines_, kLineSize * ballPixels_);
}

void ConstraintGlyphs::setHiddenMarks(HiddenMarks hidden)
{
  hidden_ = hidden;
  update();
}

void ConstraintGlyphs::setSection(const std::optional<SectionPlane>& section)
{
  section_ = section;
  update();
}

std::vector<vtkActor*> ConstraintGlyphs::actors() const
{
  std::vector<vtkActor*> actors;
  for (const auto& layer : layers_) actors.push_back(&layer->actor());
  actors.push_back(lines_);
  actors.push_back(faces_);
  return actors;
}

}  // namespace holdfast
