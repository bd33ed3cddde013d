#pragma once
/// \file
/// A closed surface put together from patches that share the vertices of their borders.

#include <functional>
#include <string>
#include <vector>

#include "grouped_mesh.h"
#include "region.h"

namespace holdfast::generate {

/// Vertex ids along a border curve, both ends included.
using Curve = std::vector<Index>;
/// Vertex ids around a closed border curve, each once.
using Ring = std::vector<Index>;

/// Isometric coordinates on a plane or an unrolled cylinder: u x v points out of the body.
struct Chart {
  std::function<Vector2(const Vector3&)> flatten;
  std::function<Vector3(const Vector2&)> lift;
};

/// The plane through `origin` across the unit vector `normal`, which points out of the body.
[[nodiscard]] Chart planeChart(const Vector3& origin, const Vector3& normal);

/// A circle, or the cylinder over it: centre + radius (cos(angle) x + sin(angle) y), x and y orthonormal.
struct Circle {
  Vector3 centre;
  Vector3 x;
  Vector3 y;
  double radius;

  [[nodiscard]] Vector3 at(double angle) const;
  /// In (-pi, pi].
  [[nodiscard]] double angleOf(const Vector3& place) const;
};

/// The cylinder over `circle` unrolled, for a patch that does not reach the angle pi. Outside is away from the axis
/// (`Outward`) or towards it (`Inward`).
enum class Facing { kOutward, kInward };
[[nodiscard]] Chart cylinderChart(const Circle& circle, Facing facing);

/// Collects patches. Border vertices are found again by place, so two patches that sample a common border alike share
/// its vertices.
class Shell {
 public:
  explicit Shell(double largestEdge) : largestEdge_(largestEdge) {}

  /// Points at `count` equal steps of the parameter from 0 to 1.
  Curve curve(const std::function<Vector3(double)>& place, Index count);
  /// The segment between two places, in steps of about the largest edge.
  Curve segment(const Vector3& from, const Vector3& to);
  /// The arc of `circle` from one angle to another, in steps of about the largest edge.
  Curve arc(const Circle& circle, double fromAngle, double toAngle);

  /// Joins curves end to end to a ring; each is turned as needed. Throws std::logic_error where they do not meet.
  [[nodiscard]] static Ring join(const std::vector<Curve>& curves);

  /// Fills the part of the chart between `rings`.
  void addPatch(const std::string& group, const Chart& chart, const std::vector<Ring>& rings);

  /// A band of `rows` + 1 rings of `count` vertices, every other ring turned by half a step, so that its triangles are
  /// nearly equilateral. `place(row, t)` gives the point of `row` at t in [0, 1); (d/dt) x (d/drow) points outward.
  struct Band {
    Index rows;
    Index count;
    std::function<Vector3(Index row, double t)> place;
  };
  struct BandEnds {
    Ring first;
    Ring last;
  };
  BandEnds addBand(const std::string& group, const Band& band);

  [[nodiscard]] const GroupedMesh& mesh() const { return mesh_; }
  [[nodiscard]] double largestEdge() const { return largestEdge_; }

 private:
  Index borderVertex(const Vector3& place);
  Index innerVertex(const Vector3& place);

  double largestEdge_;
  GroupedMesh mesh_;
  std::vector<Index> border_;
};

}  // namespace holdfast::generate
