// From where the camera looks, and the views that it had before.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

// The axes in the corner and a legend of usual numbers need so much room. It is at most a share of the width.
constexpr double kPixelsFree = 140;
constexpr double kMostFree = 0.25;

// A legend of long numbers takes more. What is left shows the mesh.
constexpr double kMostForLegend = 0.45;
constexpr double kBesideLegend = 14;

// The gizmo has a size in pixels, so its place depends on the camera: a step leaves at most half of the error of the
// one before in a picture of 460 pixels.
constexpr int kGizmoSteps = 5;

constexpr std::size_t kMostViews = 200;

/// Tells whether these places lie farther from the mesh than it is large: beside them it would be a speck.
bool isFarFrom(const Eigen::AlignedBox3d& mesh, const std::vector<Vector3>& places)
{
  Vector3 middle = Vector3::Zero();
  for (const Vector3& place : places) middle += place / static_cast<double>(places.size());
  return mesh.exteriorDistance(middle) > mesh.diagonal().norm();
}

}  // namespace

void Viewport::frameAll()
{
  if (editor_.isOpen()) fitCamera(frameOf(*renderer_->GetActiveCamera()));
}

void Viewport::lookFromCorner()
{
  if (editor_.isOpen()) fitCamera(defaultFrame(shownPositions(), upAxis_));
}

void Viewport::setUpAxis(UpAxis axis)
{
  upAxis_ = axis;
  Q_EMIT upAxisChanged(axis);
}

void Viewport::setCamera(const Camera& camera)
{
  openedFrom_.reset();
  place(*renderer_->GetActiveCamera(), camera);
  cameraMoved();
  Q_EMIT projectionChanged(camera.isParallel);
}

void Viewport::goBack(std::vector<Camera>& from, std::vector<Camera>& to)
{
  noteView();
  if (from.empty()) return;
  to.push_back(*shownView_);
  setCamera(from.back());
  from.pop_back();
  shownView_ = cameraOf(*renderer_->GetActiveCamera());
}

void Viewport::forgetViews()
{
  earlierViews_.clear();
  laterViews_.clear();
  shownView_.reset();
}

/// A drag, or a turn of the wheel by several notches, is one change.
void Viewport::noteView()
{
  const Camera view = cameraOf(*renderer_->GetActiveCamera());
  const Camera before = std::exchange(shownView_, view).value_or(view);
  if (before == view) return;
  if (std::exchange(isNewView_, false)) earlierViews_.push_back(before);
  if (earlierViews_.size() > kMostViews) earlierViews_.erase(earlierViews_.begin());
  laterViews_.clear();
}

void Viewport::fitCamera(const ViewFrame& frame)
{
  const double aspect = static_cast<double>(width()) / std::max(1, height());
  const FreeSides free = freeSides();
  vtkCamera& camera = *renderer_->GetActiveCamera();
  Positions places = shownPositions();
  fit(camera, frame, places, aspect, free);
  const Eigen::AlignedBox3d mesh = boundingBox(places);
  const Index count = places.rows();
  for (int step = 0; step < kGizmoSteps && firstTool_ != nullptr; ++step) {
    const std::vector<Vector3> extent = firstTool_->extent();
    if (extent.empty() || isFarFrom(mesh, extent)) break;
    places.conservativeResize(count + static_cast<Index>(extent.size()), Eigen::NoChange);
    for (std::size_t k = 0; k < extent.size(); ++k) places.row(count + static_cast<Index>(k)) = extent[k];
    fit(camera, frame, places, aspect, free);
  }
  framed_ = {cameraOf(camera), free};
  cameraMoved();
}

FreeSides Viewport::freeSides() const
{
  const double pixels = std::max(1, width());
  const double usual = std::min(kPixelsFree / pixels, kMostFree);
  const double legend = std::clamp((legendBox().width() + kBesideLegend) / pixels, usual, kMostForLegend);
  switch (display_.legend) {
    case LegendSide::Left:
      return {legend, usual};
    case LegendSide::Right:
      return {0, legend};
    case LegendSide::Hidden:
      break;
  }
  return {0, usual};
}

/// The legend may take more room than when the mesh was framed. A camera that has moved since stays where it is.
void Viewport::keepClearOfLegend()
{
  if (!editor_.isOpen() || !framed_ || framed_->first != cameraOf(*renderer_->GetActiveCamera())) return;
  const FreeSides now = freeSides();
  if (now.left > framed_->second.left || now.right > framed_->second.right) frameAll();
}

void Viewport::frameVertices(const std::vector<Index>& vertices)
{
  if (!editor_.isOpen() || vertices.empty()) return;
  framePlaces(editor_.positions()(vertices, Eigen::all));
}

void Viewport::frameConstraints(const std::vector<Index>& constraints)
{
  std::vector<Vector3> places;
  for (const ConstraintMark& mark : marks())
    if (std::binary_search(constraints.begin(), constraints.end(), mark.constraint)) places.push_back(mark.place);
  if (!places.empty())
    framePlaces(Eigen::Map<const Positions>(places.front().data(), static_cast<Index>(places.size()), 3));
}

void Viewport::framePlaces(const Positions& places)
{
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const Vector3 center = (places.colwise().minCoeff() + places.colwise().maxCoeff()).transpose() / 2;
  // A single point is shown with a tenth of the mesh around it.
  const double radius = std::max((places.rowwise() - center.transpose()).rowwise().norm().maxCoeff(),
                                 editor_.model()->solverMesh.diagonal / 20);
  const Vector3 direction = Vector3(camera.GetDirectionOfProjection());
  const double distance = 1.3 * radius / std::sin(camera.GetViewAngle() / 2 * kDegree);
  const Vector3 eye = center - distance * direction;
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(center.data());
  camera.SetParallelScale(1.3 * radius);
  cameraMoved();
}

void Viewport::lookAlong(const Vector3& direction, const Vector3& up)
{
  if (!editor_.isOpen()) return;
  const Vector3 back = -direction.normalized();
  const Vector3 right = up.cross(back).normalized();
  fitCamera({right, back.cross(right), back});
}

/// After a click on the axes in the corner: all of the mesh, with what is up upright.
void Viewport::lookAlongAxis()
{
  constexpr double kAlong = 1 - 1e-9;
  const Vector3 sight(renderer_->GetActiveCamera()->GetDirectionOfProjection());
  const Vector3 along = sight.array().round();
  if (sight.dot(along) < kAlong) return;
  const Vector3 up = upright(upAxis_, Vector3::UnitZ());
  const double rise = along.dot(up);
  lookAlong(along, rise == 0 ? up : upright(upAxis_, -rise * Vector3::UnitY()));
}

void Viewport::setParallelProjection(bool isParallel)
{
  vtkCamera& camera = *renderer_->GetActiveCamera();
  if (isParallel == isParallelProjection()) return;
  // What is at the focal point keeps its size.
  const double slope = std::tan(camera.GetViewAngle() / 2 * kDegree);
  if (isParallel) {
    camera.SetParallelScale(camera.GetDistance() * slope);
  } else {
    const Vector3 eye = Vector3(camera.GetFocalPoint()) -
                        camera.GetParallelScale() / slope * Vector3(camera.GetDirectionOfProjection());
    camera.SetPosition(eye.data());
  }
  camera.SetParallelProjection(isParallel);
  cameraMoved();
  Q_EMIT projectionChanged(isParallel);
}

bool Viewport::isParallelProjection() const
{
  return renderer_->GetActiveCamera()->GetParallelProjection() != 0;
}

void Viewport::cameraMoved()
{
  isNewView_ = true;
  fitClippingRange();
  scheduleRender();
}

void Viewport::prepareCamera()
{
  noteView();
  fitClippingRange();
}

void Viewport::fitClippingRange()
{
  vtkBoundingBox shown;
  for (vtkRenderer* renderer : {renderer_.Get(), widgetRenderer_.Get()})
    if (const double* bounds = renderer->ComputeVisiblePropBounds(); vtkBoundingBox::IsValid(bounds))
      shown.AddBounds(bounds);
  std::array<double, 6> bounds{};
  shown.GetBounds(bounds.data());
  if (shown.IsValid()) renderer_->ResetCameraClippingRange(bounds.data());
}

}  // namespace holdfast
