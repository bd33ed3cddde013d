#pragma once
/// \file
/// Deformations like those of the survey of Botsch and Sorkine (On linear variational surface deformation methods,
/// 2008) on meshes of our own, and bends and twists of a bar by any angle.

#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/deform.h>

namespace holdfast::paper {

/// A mesh of which one part is fixed and another one moved rigidly.
struct SurveyTask {
  std::string name;
  Positions rest = {};
  Triangles triangles = {};
  std::vector<Index> fixed = {};
  std::vector<Index> handle = {};
  AxisRotation rotation = {};
  Vector3 translation = Vector3::Zero();

  /// The places of the fixed vertices and of the handle; all others at rest.
  [[nodiscard]] Positions targets() const;
  /// Of the bounding box at rest.
  [[nodiscard]] double diagonal() const;
};

[[nodiscard]] SurveyTask bentBar(double degrees = 135);
[[nodiscard]] SurveyTask twistedBar(double degrees);
[[nodiscard]] SurveyTask bentCactus(double degrees = 70);
[[nodiscard]] SurveyTask twistedCylinder(double degrees = 120);
[[nodiscard]] SurveyTask liftedPlane(double height = 25);
/// The tenth at the lower end of the longest side is held, the one at the upper end bent by 60 degrees.
[[nodiscard]] SurveyTask bentAtItsEnd(const std::string& name, Mesh mesh);

/// What a handle tells about rotations.
enum class HandleRotation { Stated, None };

/// The constraints of `task`. With `HandleRotation::None` its handle is moved as stated and turns nothing.
[[nodiscard]] ConstraintList constraintsOf(const SurveyTask& task, HandleRotation rotation = HandleRotation::Stated);

}  // namespace holdfast::paper
