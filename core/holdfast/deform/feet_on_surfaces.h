#pragma once
/// Points that stay on surfaces beside the mesh, while the place of the least energy is looked for.

#include <vector>

#include <Eigen/Dense>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/solve/allowed_places.h>

namespace holdfast {

/// Each point moves along the tangent plane at its foot, to where the energy is least. Its next foot is the foot of
/// that place, and so on. A point whose plane leads it off the surface, as over an edge or on a rough scan, is damped:
/// its steps shrink until they keep to the surface.
class FeetOnSurfaces {
 public:
  /// Finds no feet before the first step: the surface goes where it would go without these points. `stiffness` has for
  /// each tolerant row how its own pull grows with its offset.
  FeetOnSurfaces(const ConstraintSystem& system, const Eigen::VectorXd& stiffness, double diagonal);

  /// Gives `allowed`, what the tolerance of a tolerant row allows, what the search for its foot asks for besides.
  void restrict(std::size_t point, AllowedOffset& allowed) const;

  /// Takes tolerant rows to the feet of the places that have these `offsets` (rows x 3, model units) from their
  /// targets. Makes the offsets those from the new feet. Returns whether another step is needed.
  bool follow(ConstraintSystem& system, Positions& offsets);

  /// Notes constraints with points that still moved when the search ended, and those with points on a border.
  [[nodiscard]] std::vector<ConstraintNote> notes(const ConstraintSystem& system) const;

 private:
  struct Search {
    std::size_t point = 0;  // place in `ConstraintSystem::tolerant`
    double stiffness = 0;
    double damping = 0.01;           // in stiffnesses
    Vector3 step = Vector3::Zero();  // of the foot, the last one
    bool isOnBorder = false;
    bool isUnsettled = false;  // it still moved in the last step that was free to
  };

  static void follow(Search& search, ConstraintSystem& system, Vector3& offset);

  std::vector<Search> searches_;
  double diagonal_;
  int steps_ = 0;
};

}  // namespace holdfast
