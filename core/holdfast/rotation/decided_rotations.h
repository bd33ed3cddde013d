#pragma once
/// The rotations that constraints decide: those of rigid regions with several points in them, and those of kept
/// vectors.
///
/// A rigid region with points in it is one rigid body, and the points say how it turns. So only what no rotation meets
/// is a conflict, as where two points are asked to lie farther apart than at rest.
///
/// Gaps are taken in the user's order. A gap turns bodies only by what earlier gaps leave free. Where that does not
/// close it, it turns nothing. At last, gaps that cannot be closed are made as small as the freedom that is left
/// allows.

#include <holdfast/rotation/turning_bodies.h>

namespace holdfast {

/// Constraints leave a body this freedom to turn.
enum class TurningFreedom : char { All, AboutAxis, None };

class DecidedRotations {
 public:
  /// The rows of `system` must be those of `eliminated`.
  DecidedRotations(const EliminatedConstraints& eliminated, const ConstraintSystem& system, const SolverMesh& mesh)
      : turning_(eliminated, system, mesh), turns_(turning_.bodies.size())
  {
  }

  /// Tells whether no constraint decides anything.
  [[nodiscard]] bool isEmpty() const noexcept { return turning_.gaps.empty(); }

  /// Turns bodies from the rotations `q` of all unknowns (n x 3, logs) on, by as little as that takes. It changes the
  /// rows of `q` that belong to regions that were turned. O(gaps). Where bodies hang together, each gap between them
  /// takes a few small least-squares problems.
  void settle(const ConstraintSystem& system, Columns3& q);

  /// Returns `system` with the vectors that were turned. `system` is `rotated` by the `q` that was settled.
  [[nodiscard]] ConstraintSystem withTurnedVectors(ConstraintSystem system) const;

  /// Returns the bodies that `settle` has turned, each region with its unknowns.
  [[nodiscard]] std::vector<const TurningBody*> turnedBodies() const;

  [[nodiscard]] const TurningBodies& bodies() const noexcept { return turning_; }
  [[nodiscard]] TurningFreedom freedomOf(Index body) const noexcept { return turns_[body].freedom; }
  /// Returns the direction of the axis in space, of length 1, where the freedom is that of an axis.
  [[nodiscard]] const Vector3& axisOf(Index body) const noexcept { return turns_[body].axis; }

  /// Returns the dependent rows whose gap was closed, ascending.
  [[nodiscard]] std::vector<Index> closedRows() const;

  /// Returns for each dependent row whose gap was not closed the rows that it contradicts. They are a smallest set,
  /// with an earlier gap that lies wrong to the row's gap where there is one. Else they are a smallest set with the
  /// rows that decide how its bodies turn.
  [[nodiscard]] std::map<Index, std::vector<Index>> reasons() const;

 private:
  struct Turn {
    Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
    TurningFreedom freedom = TurningFreedom::All;
    Vector3 axis = Vector3::Zero();
    std::vector<Index> closed;    // gaps of this body
    std::vector<Index> deciding;  // the closed gaps that took freedom from it
    bool isCoupled = false;       // closed gaps have other bodies as well
    bool hasTurned = false;
  };

  /// Bodies that hang together by gaps that were closed.
  struct BodyGroup {
    std::vector<Index> bodies;  // ascending
    std::vector<Index> closed;
  };

  [[nodiscard]] Vector3 gapAt(const TurningGap& gap) const;
  [[nodiscard]] bool isClosed(const TurningGap& gap) const;
  [[nodiscard]] bool areClosed(const std::vector<Index>& places) const;
  [[nodiscard]] bool isAlone(const TurningGap& gap) const;
  [[nodiscard]] Eigen::Quaterniond turnedTowards(const TurningGap& gap) const;
  void setRotation(Index body, const Eigen::Quaterniond& R);
  [[nodiscard]] bool closeAlone(const TurningGap& gap);
  [[nodiscard]] bool closeTogether(const TurningGap& gap);
  [[nodiscard]] bool turnUntilClosed(const BodyGroup& group, const TurningGap& gap);
  [[nodiscard]] BodyGroup groupOf(const TurningGap& gap) const;
  [[nodiscard]] bool turnTogether(const BodyGroup& group, const TurningGap& gap);
  void close(Index place);
  void narrow(Index place);
  [[nodiscard]] std::vector<Index> contradicted(const TurningGap& gap) const;

  TurningBodies turning_;
  std::vector<Turn> turns_;  // of each body
  std::vector<Index> open_;  // gaps that were not closed
};

/// Returns the conflicting rows of `diagnosis` that rotations which are found would meet, ascending. `diagnosis` was
/// made with the rotations `q` (n x 3, logs).
[[nodiscard]] std::vector<Index> closedWhereFound(const EliminatedConstraints& eliminated,
                                                  const ConstraintSystem& system, const SolverMesh& mesh,
                                                  const Diagnosis& diagnosis, Columns3 q);

}  // namespace holdfast
