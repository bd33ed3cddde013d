// Faces of the mesh that are not shown.

#include <algorithm>
#include <utility>

#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

/// Tells for each triangle whether it belongs to a face whose corners are all among `vertices`.
std::vector<char> trianglesBetween(const std::vector<Index>& vertices, const Model& model)
{
  std::vector<char> isIn(static_cast<std::size_t>(model.mesh.vertexCount()), 0);
  for (const Index vertex : vertices) isIn[vertex] = 1;
  std::vector<char> isBetween;
  isBetween.reserve(model.triangulation.faceOf.size());
  for (const Index face : model.triangulation.faceOf)
    isBetween.push_back(std::ranges::all_of(model.mesh.faces[face], [&](Index v) { return isIn[v] != 0; }) ? 1 : 0);
  return isBetween;
}

}  // namespace

bool Viewport::hide(const std::vector<Index>& vertices)
{
  return editor_.isOpen() && hideToo(trianglesBetween(vertices, *editor_.model()));
}

bool Viewport::isolate(const std::vector<Index>& vertices)
{
  if (!editor_.isOpen()) return false;
  auto others = trianglesBetween(vertices, *editor_.model());
  for (char& each : others) each = each != 0 ? 0 : 1;
  return hideToo(std::move(others));
}

bool Viewport::hideToo(std::vector<char> triangles)
{
  if (std::ranges::count(triangles, 1) == 0) return false;
  for (std::size_t t = 0; hidden_ && t < triangles.size(); ++t) triangles[t] |= (*hidden_)[t];
  if (std::ranges::count(triangles, 0) == 0) return false;
  setHidden(std::make_shared<const std::vector<char>>(std::move(triangles)));
  return true;
}

std::vector<std::array<Index, 2>> Viewport::hiddenFaces() const
{
  std::vector<std::array<Index, 2>> ranges;
  const std::vector<int>& faceOf = editor_.model()->triangulation.faceOf;
  for (std::size_t t = 0; hidden_ && t < faceOf.size(); ++t) {
    if ((*hidden_)[t] == 0) continue;
    if (ranges.empty() || ranges.back()[1] + 1 < faceOf[t]) ranges.push_back({faceOf[t], faceOf[t]});
    ranges.back()[1] = faceOf[t];
  }
  return ranges;
}

void Viewport::hideFaces(const std::vector<std::array<Index, 2>>& ranges)
{
  if (!editor_.isOpen()) return;
  const std::vector<int>& faceOf = editor_.model()->triangulation.faceOf;
  std::vector<char> triangles(faceOf.size(), 0);
  for (const auto& [first, last] : ranges)
    std::fill(triangles.begin() + (std::ranges::lower_bound(faceOf, first) - faceOf.begin()),
              triangles.begin() + (std::ranges::upper_bound(faceOf, last) - faceOf.begin()), 1);
  hideToo(std::move(triangles));
}

std::vector<Index> Viewport::shownAmong(std::vector<Index> vertices) const
{
  if (hidden_) std::erase_if(vertices, [this](Index vertex) { return !surface_->isShown(vertex); });
  return vertices;
}

void Viewport::showHidden()
{
  if (hidden_) setHidden(nullptr);
}

void Viewport::setHidden(std::shared_ptr<const std::vector<char>> hidden)
{
  hidden_ = std::move(hidden);
  contents_->setHidden(hidden_ ? *hidden_ : std::vector<char>());
  showSurface();
  scheduleRender();
  Q_EMIT marksChanged();
  Q_EMIT hiddenChanged(hidden_ != nullptr);
}

/// Of the corners of faces that are shown; of all vertices where there are none. A vertex of no face may lie anywhere.
Positions Viewport::shownPositions() const
{
  const SolverMesh& mesh = editor_.model()->solverMesh;
  std::vector<Index> shown;
  for (Index v = 0; v < editor_.positions().rows(); ++v)
    if (hidden_ ? surface_->isShown(v) : mesh.componentOf[mesh.weld.unknownOf[v]] >= 0) shown.push_back(v);
  return shown.empty() ? editor_.positions() : editor_.positions()(shown, Eigen::all);
}

}  // namespace holdfast
