#pragma once
/// \file
/// The balls of a vtkCameraOrientationWidget, cheap to draw again and again.

#include <utility>

#include <vtkCameraOrientationRepresentation.h>

namespace holdfast {

/// Its superclass makes meshes and letters anew for each picture, and a renderer on the processor waits for what is
/// being drawn before it takes them. Here the balls are moved, and letters are made where another ball is picked.
class OrientationRepresentation : public vtkCameraOrientationRepresentation {
 public:
  static OrientationRepresentation* New();
  vtkTypeMacro(OrientationRepresentation, vtkCameraOrientationRepresentation)

 protected:
  OrientationRepresentation();
  ~OrientationRepresentation() override = default;

  void CreateDefaultGeometry() override {}
  void PositionHandles() override;
  void HighlightHandle() override;

 private:
  OrientationRepresentation(const OrientationRepresentation&) = delete;
  void operator=(const OrientationRepresentation&) = delete;

  std::pair<int, int> LetteredFor{-2, -2};  // axis and direction of the ball that was picked
};

}  // namespace holdfast
