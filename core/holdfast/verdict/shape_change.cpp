#include "holdfast/verdict/shape_change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr Index kItemsOfBlock = 4096;

Index blocksOf(std::size_t count)
{
  return (static_cast<Index>(count) + kItemsOfBlock - 1) / kItemsOfBlock;
}

/// Calls `visit(k)` for each k of a block of `count`.
template <class Visitor>
void forBlock(Index block, std::size_t count, const Visitor& visit)
{
  const Index last = std::min(static_cast<Index>(count), (block + 1) * kItemsOfBlock);
  for (Index k = block * kItemsOfBlock; k < last; ++k) visit(static_cast<int>(k));
}

/// Squares of ratios, in floats: a comparison with limits needs no more digits, and memory is what takes the time.
struct SquaredRatios {
  float least = 1;
  float most = 1;

  void include(double square, float inverse)
  {
    constexpr float kLargest = std::numeric_limits<float>::max();
    const float ratio = inverse > 0 ? std::min(static_cast<float>(square) * inverse, kLargest) : 1.0F;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }

  void include(const SquaredRatios& other)
  {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }

  [[nodiscard]] bool isBeyond(double limit) const
  {
    const auto square = static_cast<float>(limit * limit);
    return least * square < 1 || most > square;
  }
};

using FloatNormals = std::vector<std::array<float, 3>>;

struct TrianglesOfBlock {
  SquaredRatios lengths;
  SquaredRatios areas;
  std::vector<int> suspects;                    // triangles that are beyond the limits
  std::vector<std::pair<int, double>> volumes;  // of one part each: neighbours in the list are summed up
};

void addVolume(TrianglesOfBlock& block, int part, double volume)
{
  if (block.volumes.empty() || block.volumes.back().first != part) block.volumes.emplace_back(part, 0.0);
  block.volumes.back().second += volume;
}

/// Leaves the unit normals of the triangles, none for those with hardly any area, in `normals`.
TrianglesOfBlock measureBlock(const RestSurface& rest, const Positions& now, Index block, FloatNormals& normals)
{
  TrianglesOfBlock result;
  forBlock(block, rest.triangles.size(), [&](int t) {
    const TriangleShape shape = shapeOf(rest.triangles[t], now, rest.perUnit);
    SquaredRatios lengths;
    SquaredRatios area;
    for (int k = 0; k < 3; ++k) lengths.include(shape.sides[k].squaredNorm(), rest.inverseSquares[t][k]);
    const double square = shape.area.squaredNorm();
    area.include(square, rest.inverseSquares[t][3]);
    if (lengths.isBeyond(kLengthLimit) || area.isBeyond(kAreaLimit)) result.suspects.push_back(t);
    result.lengths.include(lengths);
    result.areas.include(area);
    const auto singleSquare = static_cast<float>(square);
    const float toUnit = singleSquare > std::numeric_limits<float>::min() ? 1 / std::sqrt(singleSquare) : 0.0F;
    for (int k = 0; k < 3; ++k) normals[t][k] = toUnit * static_cast<float>(shape.area[k]);
    const Vector3 corner = rest.perUnit * (now.row(rest.triangles[t][0]).transpose() - rest.center);
    addVolume(result, rest.partOf[t], corner.dot(shape.area));
  });
  return result;
}

struct FoldsOfBlock {
  double degrees = 0;
  std::vector<int> hinges;
};

double changeOfBend(const DeformedSurface& surface, const Hinge& hinge)
{
  return std::abs(std::remainder(bendDegrees(surface.rest, hinge, surface.now) - hinge.restDegrees, 360.0));
}

FoldsOfBlock findFolds(const DeformedSurface& surface, Index block, const FloatNormals& normals)
{
  FoldsOfBlock result;
  forBlock(block, surface.rest.hinges.size(), [&](int h) {
    const Hinge& hinge = surface.rest.hinges[h];
    const auto& [ax, ay, az] = normals[hinge.first];
    const auto& [bx, by, bz] = normals[hinge.second];
    if (hinge.side * (ax * bx + ay * by + az * bz) >= hinge.flatCosine) return;
    const double degrees = changeOfBend(surface, hinge);
    if (degrees <= kFoldDegrees) return;
    result.degrees = std::max(result.degrees, degrees);
    result.hinges.push_back(h);
  });
  return result;
}

void addFolds(ShapeChange& change, const DeformedSurface& surface, const FloatNormals& normals)
{
  std::vector<FoldsOfBlock> blocks(blocksOf(surface.rest.hinges.size()));
  parallelFor(static_cast<Index>(blocks.size()),
              [&](Index block) { blocks[block] = findFolds(surface, block, normals); });
  for (const FoldsOfBlock& block : blocks) {
    change.foldDegrees = std::max(change.foldDegrees, block.degrees);
    change.foldedHinges.insert(change.foldedHinges.end(), block.hinges.begin(), block.hinges.end());
  }
}

/// Adds something of a size, with the ids that show it, where it is beyond the limit.
void addBeyond(Ratios& ratios, double ratio, double limit, std::initializer_list<Index> ids)
{
  if (ratio * limit < 1) {
    ++ratios.shrunkCount;
    ratios.shrunk.insert(ratios.shrunk.end(), ids);
  } else if (ratio > limit) {
    ++ratios.grownCount;
    ratios.grown.insert(ratios.grown.end(), ids);
  }
}

/// Adds the sides and the area of a triangle, as far as their change can be seen.
void addSuspect(ShapeChange& change, const DeformedSurface& surface, int t)
{
  const RestSurface& rest = surface.rest;
  const Triangle& triangle = rest.triangles[t];
  const TriangleShape before = shapeOf(triangle, surface.atRest, rest.perUnit);
  const TriangleShape after = shapeOf(triangle, surface.now, rest.perUnit);
  bool isVisible = false;
  for (int k = 0; k < 3; ++k) {
    const double from = before.sides[k].norm();
    const double to = after.sides[k].norm();
    if (std::abs(to - from) < kVisible) continue;
    isVisible = true;
    const bool isOwn = (rest.ownSides[t] >> static_cast<unsigned>(k) & 1U) != 0;
    if (isOwn && rest.inverseSquares[t][k] > 0)
      addBeyond(change.lengths, to / from, kLengthLimit, {triangle[k], triangle[(k + 1) % 3]});
  }
  if (isVisible && rest.inverseSquares[t][3] > 0)
    addBeyond(change.areas, after.area.norm() / before.area.norm(), kAreaLimit, {surface.mesh.faceOf[t]});
}

void addVolumes(ShapeChange& change, const DeformedSurface& surface, const std::vector<double>& volumes)
{
  for (std::size_t part = 0; part < volumes.size(); ++part) {
    if (surface.rest.volumes[part] == 0) continue;
    const double ratio = volumes[part] / surface.rest.volumes[part];
    change.volumes.least = std::min(change.volumes.least, ratio);
    change.volumes.most = std::max(change.volumes.most, ratio);
    addBeyond(change.volumes, ratio, kVolumeLimit, {surface.rest.vertexOfPart[part]});
  }
}

void sortIds(Ratios& ratios)
{
  ratios.shrunk = sortedOnce(std::move(ratios.shrunk));
  ratios.grown = sortedOnce(std::move(ratios.grown));
}

}  // namespace

ShapeChange changeOf(const DeformedSurface& surface)
{
  FloatNormals normals(surface.rest.triangles.size());
  std::vector<TrianglesOfBlock> blocks(blocksOf(normals.size()));
  parallelFor(static_cast<Index>(blocks.size()),
              [&](Index block) { blocks[block] = measureBlock(surface.rest, surface.now, block, normals); });
  ShapeChange change;
  SquaredRatios lengths;
  SquaredRatios areas;
  std::vector<double> volumes(surface.rest.volumes.size(), 0.0);
  for (const TrianglesOfBlock& block : blocks) {
    lengths.include(block.lengths);
    areas.include(block.areas);
    for (const int t : block.suspects) addSuspect(change, surface, t);
    for (const auto& [part, volume] : block.volumes) volumes[part] += volume;
  }
  std::tie(change.lengths.least, change.lengths.most) = std::pair(std::sqrt(lengths.least), std::sqrt(lengths.most));
  std::tie(change.areas.least, change.areas.most) = std::pair(std::sqrt(areas.least), std::sqrt(areas.most));
  addVolumes(change, surface, volumes);
  addFolds(change, surface, normals);
  for (Ratios* ratios : {&change.lengths, &change.areas, &change.volumes}) sortIds(*ratios);
  return change;
}

std::vector<int> invertedTriangles(const RestSurface& rest, const std::vector<int>& foldedHinges)
{
  if (foldedHinges.empty()) return {};
  DisjointSets sides(static_cast<Index>(rest.triangles.size()));  // triangles that hang together without a fold
  std::vector<bool> isFolded(rest.hinges.size(), false);
  for (const int h : foldedHinges) isFolded[h] = true;
  for (std::size_t h = 0; h < rest.hinges.size(); ++h)
    if (!isFolded[h]) sides.unite(rest.hinges[h].first, rest.hinges[h].second);
  std::vector<Index> sizes(rest.triangles.size(), 0);
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) ++sizes[sides.find(static_cast<Index>(t))];
  std::vector<bool> isInverted(rest.triangles.size(), false);  // by representative
  for (const int h : foldedHinges) {
    const Index a = sides.find(rest.hinges[h].first);
    const Index b = sides.find(rest.hinges[h].second);
    if (a != b) isInverted[std::pair(sizes[a], a) < std::pair(sizes[b], b) ? a : b] = true;
  }
  std::vector<int> inverted;
  for (std::size_t t = 0; t < rest.triangles.size(); ++t)
    if (isInverted[sides.find(static_cast<Index>(t))]) inverted.push_back(static_cast<int>(t));
  return inverted;
}

std::vector<Index> facesOf(const SolverMesh& mesh, const std::vector<int>& triangles)
{
  std::vector<Index> faces;
  faces.reserve(triangles.size());
  for (const int t : triangles) faces.push_back(mesh.faceOf[t]);
  return sortedOnce(std::move(faces));
}

}  // namespace holdfast
