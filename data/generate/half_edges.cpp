#include "half_edges.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace holdfast::generate {

HalfEdges::HalfEdges(const std::vector<Triangle>& triangles, Index vertexCount) : outgoing_(vertexCount, kNone)
{
  std::map<std::pair<Index, Index>, Index> halfEdgeOf;
  for (const Triangle& triangle : triangles) {
    const Index first = 3 * addFace();
    for (Index k = 0; k < 3; ++k) {
      setOrigin(first + k, triangle[k]);
      const bool isNew = halfEdgeOf.try_emplace({triangle[k], triangle[(k + 1) % 3]}, first + k).second;
      if (!isNew) throw std::logic_error("not an oriented manifold: two faces turn alike along an edge");
    }
  }
  for (const auto& [ends, halfEdge] : halfEdgeOf) {
    const auto other = halfEdgeOf.find({ends.second, ends.first});
    twin_[halfEdge] = other == halfEdgeOf.end() ? kNone : other->second;
  }
}

std::vector<Index> HalfEdges::outgoing(Index vertex) const
{
  constexpr Index kUsual = 8;
  std::vector<Index> result;
  result.reserve(kUsual);
  const Index start = outgoing_[vertex];
  Index halfEdge = start;
  while (halfEdge != kNone && (result.empty() || halfEdge != start)) {
    result.push_back(halfEdge);
    halfEdge = twin(previous(halfEdge));
  }
  return result;
}

Index HalfEdges::addVertex()
{
  outgoing_.push_back(kNone);
  return vertexCount() - 1;
}

void HalfEdges::flip(Index halfEdge)
{
  const Index h = halfEdge;
  const Index t = twin(h);
  const Index a = origin(h), b = origin(t), c = apex(h), d = apex(t);
  const Index acrossCA = twin(previous(h)), acrossAD = twin(next(t));
  const Index acrossDB = twin(previous(t)), acrossBC = twin(next(h));
  setOrigin(h, d);
  setOrigin(next(h), c);
  setOrigin(previous(h), a);
  setOrigin(t, c);
  setOrigin(next(t), d);
  setOrigin(previous(t), b);
  link(next(h), acrossCA);
  link(previous(h), acrossAD);
  link(next(t), acrossDB);
  link(previous(t), acrossBC);
}

void HalfEdges::splitFace(Index face, Index vertex)
{
  const auto [a, b, c] = corners(face);
  const Index ab = 3 * face;
  const Index acrossBC = twin(ab + 1), acrossCA = twin(ab + 2);
  const Index bc = 3 * addFace();
  const Index ca = 3 * addFace();
  for (const auto& [first, from, to] : {std::array{ab, a, b}, std::array{bc, b, c}, std::array{ca, c, a}}) {
    setOrigin(first, from);
    setOrigin(first + 1, to);
    setOrigin(first + 2, vertex);
  }
  link(bc, acrossBC);
  link(ca, acrossCA);
  link(ab + 1, bc + 2);
  link(bc + 1, ca + 2);
  link(ca + 1, ab + 2);
}

void HalfEdges::splitEdge(Index halfEdge, Index vertex)
{
  const Index place = halfEdge % 3;
  const Index added = faceCount();
  splitFace(halfEdge / 3, vertex);
  flip(place == 0 ? halfEdge : 3 * (added + place - 1));
}

bool HalfEdges::canCollapse(Index halfEdge) const
{
  std::vector<Index> around;
  for (const Index h : outgoing(origin(halfEdge))) around.push_back(target(h));
  Index shared = 0;
  for (const Index h : outgoing(target(halfEdge))) shared += std::ranges::count(around, target(h));
  const auto valence = [&](Index vertex) { return outgoing(vertex).size(); };
  return shared == 2 && valence(apex(halfEdge)) > 3 && valence(apex(twin(halfEdge))) > 3;
}

void HalfEdges::collapse(Index halfEdge)
{
  const Index kept = origin(halfEdge), gone = target(halfEdge);
  const Index other = twin(halfEdge);
  for (const Index h : outgoing(gone)) origin_[h] = kept;
  closeGap(halfEdge);
  closeGap(other);
  outgoing_[gone] = kNone;
}

// Removes the face of `halfEdge`, whose two ends are one vertex by now, and joins its two neighbours.
void HalfEdges::closeGap(Index halfEdge)
{
  const Index ahead = twin(next(halfEdge)), behind = twin(previous(halfEdge));
  outgoing_[apex(halfEdge)] = ahead;
  outgoing_[origin(behind)] = behind;
  link(ahead, behind);
  for (const Index h : {halfEdge, next(halfEdge), previous(halfEdge)}) {
    origin_[h] = kNone;
    twin_[h] = kNone;
  }
}

void HalfEdges::link(Index halfEdge, Index twin)
{
  twin_[halfEdge] = twin;
  if (twin != kNone) twin_[twin] = halfEdge;
}

void HalfEdges::setOrigin(Index halfEdge, Index vertex)
{
  origin_[halfEdge] = vertex;
  outgoing_[vertex] = halfEdge;
}

Index HalfEdges::addFace()
{
  origin_.insert(origin_.end(), 3, kNone);
  twin_.insert(twin_.end(), 3, kNone);
  return faceCount() - 1;
}

}  // namespace holdfast::generate
