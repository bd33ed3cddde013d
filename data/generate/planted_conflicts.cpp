#include "planted_conflicts.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "constraint_text.h"

namespace holdfast::generate {
namespace {

using Texts = std::vector<std::string>;

/// A pin in a rigid region places all of it; a second one has to agree.
void addRigidRegion(Texts& texts, const GroupedMesh& plate)
{
  const Vector3 middle(26, 30, 0);
  const auto at = [&](double x, double y) { return findSpot(plate, SpotKind::kVertex, middle + Vector3(x, y, 0)); };
  texts.push_back(rigidText("badge", inSphere(middle, 8)));
  texts.push_back(pointBy("badge corner 1", at(-5, 0), {0, 0, 3}));
  texts.push_back(pointBy("badge corner 2, with the first (redundant)", at(5, 0), {0, 0, 3}));
  texts.push_back(pointBy("badge corner 3, 2 above the first (conflicting)", at(0, 5), {0, 0, 5}));
}

/// Two selections that share vertices and move differently.
void addOverlappingHandles(Texts& texts)
{
  texts.push_back(handleText("lift", inSphere({70, 30, 0}, 9), Vector3(0, 0, 3)));
  texts.push_back(handleText("lift beside it by 0.5 more (conflicting)", inSphere({78, 30, 0}, 9), {0, 0, 3.5}));
}

/// The corners of two triangles that share an edge: the face, and the places of the edge's ends among its corners.
struct EdgeInFace {
  Index face;
  std::size_t from;
  std::size_t to;
};

EdgeInFace neighbourAcrossFirstEdge(const GroupedMesh& plate, Index face)
{
  const Index a = plate.triangles[face][0], b = plate.triangles[face][1];
  for (std::size_t other = 0; other < plate.triangles.size(); ++other)
    for (std::size_t k = 0; k < 3; ++k)
      if (plate.triangles[other][k] == b && plate.triangles[other][(k + 1) % 3] == a)
        return {static_cast<Index>(other), (k + 1) % 3, k};
  throw std::logic_error("the face lies on the border");
}

/// The point a quarter of the way along an edge, named as a point of one face and of the other.
void addPointOfTwoFaces(Texts& texts, const GroupedMesh& plate)
{
  const Index face = std::get<FaceSpot>(findSpot(plate, SpotKind::kFace, {70, 66, 0}).where).face;
  const EdgeInFace other = neighbourAcrossFirstEdge(plate, face);
  std::array<double, 3> weights{};
  weights[other.from] = 0.75;
  weights[other.to] = 0.25;
  texts.push_back(pointInFace("seam", face, {0.75, 0.25, 0}, {0, 0, 2}));
  texts.push_back(pointInFace("seam, from the other face (redundant)", other.face, weights, {0, 0, 2}));
  texts.push_back(
      pointInFace("seam, from the other face, 0.25 aside (conflicting)", other.face, weights, {0.25, 0, 2}));
}

/// Vectors around a triangle, which sum to zero or cannot hold.
void addLoop(Texts& texts, const GroupedMesh& plate)
{
  const Spot a = findSpot(plate, SpotKind::kVertex, {22, 68, 0});
  const Spot b = findSpot(plate, SpotKind::kVertex, {36, 68, 0});
  const Spot c = findSpot(plate, SpotKind::kVertex, {29, 80, 0});
  const Vector3 ab = a.rest - b.rest + Vector3(-1, 0, 0.5), bc = b.rest - c.rest + Vector3(0, -1, 0);
  texts.push_back(relativeText("loop 1", a, b, rounded(ab)));
  texts.push_back(relativeText("loop 2", b, c, rounded(bc)));
  texts.push_back(relativeText("loop 3, which closes it (redundant)", c, a, rounded(Vector3(-ab - bc))));
  texts.push_back(
      relativeText("loop 3 by 1.5 more (conflicting)", c, a, rounded(Vector3(Vector3(0, 0, 1.5) - ab - bc))));
}

}  // namespace

std::string plantedConflicts(const GroupedMesh& plate)
{
  Texts texts{fixedText("border", notIn(inBox({0.5, 0.5, -1}, {99.5, 99.5, 1})))};
  addRigidRegion(texts, plate);
  addOverlappingHandles(texts);
  addPointOfTwoFaces(texts, plate);
  addLoop(texts, plate);
  return constraintFile(texts);
}

}  // namespace holdfast::generate
