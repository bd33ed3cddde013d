#include "holdfast/widgets/gizmo/gizmo_part_actors.h"

#include <cmath>

#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

using namespace gizmo_layout;
using std::numbers::pi;

constexpr double kShaftRadius = 0.0115;
constexpr double kHeadRadius = 0.046;
constexpr double kHeadRounding = 0.012;
constexpr double kTipRounding = 0.009;
constexpr double kRingTube = 0.0105;
constexpr double kViewRingTube = 0.0085;
constexpr double kBorderTube = 0.0075;
constexpr double kCornerRadius = 0.035;
constexpr double kPartFillOpacity = 0.45;

constexpr int kSides = 32;
constexpr int kTubeSides = 12;
constexpr int kRingSteps = 144;
constexpr int kCornerSteps = 6;
constexpr int kArcSteps = 8;

Index addPoint(GizmoShape& shape, const Vector3& point, const Vector3& normal, double opacity = 1)
{
  shape.points.push_back(point);
  shape.normals.push_back(normal);
  shape.opacities.push_back(opacity);
  return static_cast<Index>(shape.points.size()) - 1;
}

/// A grid of points becomes two triangles a square; rows are closed. `addAt(row, column)` adds one.
template <class AddAt>
void addGrid(GizmoShape& shape, std::size_t rows, Index columns, AddAt addAt)
{
  const auto first = static_cast<Index>(shape.points.size());
  for (std::size_t row = 0; row < rows; ++row)
    for (Index column = 0; column < columns; ++column) addAt(row, static_cast<double>(column));
  for (Index row = 0; row + 1 < static_cast<Index>(rows); ++row)
    for (Index column = 0; column < columns; ++column) {
      const Index a = first + row * columns + column;
      const Index b = first + row * columns + (column + 1) % columns;
      shape.triangles.push_back({a, b, b + columns});
      shape.triangles.push_back({a, b + columns, a + columns});
    }
}

Vector3 acrossZ(double angle)
{
  return {std::cos(angle), std::sin(angle), 0};
}

/// A place of a solid of revolution: its distance from the axis, how far along the axis, and the normal there.
struct ProfilePoint {
  Eigen::Vector2d place;
  Eigen::Vector2d normal;
};

using Profile = std::vector<ProfilePoint>;

/// The surface of `profile`, which goes from the beginning of the axis to its end, rotated about z.
void addRevolved(GizmoShape& shape, const Profile& profile)
{
  addGrid(shape, profile.size(), kSides, [&](std::size_t k, double side) {
    const auto& [place, normal] = profile[k];
    const Vector3 out = acrossZ(2 * pi * side / kSides);
    addPoint(shape, place.x() * out + place.y() * Vector3::UnitZ(), normal.x() * out + normal.y() * Vector3::UnitZ());
  });
}

Profile arc(const Eigen::Vector2d& center, double radius, double from, double to, int steps = kArcSteps)
{
  Profile profile;
  for (int k = 0; k <= steps; ++k) {
    const double angle = from + (to - from) * k / steps;
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    profile.push_back({center + radius * out, out});
  }
  return profile;
}

/// Its edge and its tip are round, and the side is tangent to both.
void addHead(GizmoShape& shape)
{
  const Eigen::Vector2d edge(kHeadRadius - kHeadRounding, kHeadStart + kHeadRounding);
  const Eigen::Vector2d tip(0, kArrowEnd - kTipRounding);
  const Eigen::Vector2d along = (tip - edge).normalized();
  const double sine = (kHeadRounding - kTipRounding) / (tip - edge).norm();
  const Eigen::Vector2d normal = std::sqrt(1 - sine * sine) * Eigen::Vector2d(along.y(), -along.x()) + sine * along;
  const double angle = std::atan2(normal.y(), normal.x());
  const Eigen::Vector2d down(0, -1);
  addRevolved(shape, {{{0, kHeadStart}, down}, {{edge.x(), kHeadStart}, down}});
  Profile profile = arc(edge, kHeadRounding, -pi / 2, angle);
  const Profile end = arc(tip, kTipRounding, angle, pi / 2);
  profile.insert(profile.end(), end.begin(), end.end());
  addRevolved(shape, profile);
}

GizmoShape arrow()
{
  GizmoShape shape;
  Profile shaft = arc({0, kShaftStart + kShaftRadius}, kShaftRadius, -pi / 2, 0);
  shaft.push_back({{kShaftRadius, kHeadStart}, {1, 0}});
  addRevolved(shape, shaft);
  addHead(shape);
  return shape;
}

/// A point of a closed curve across z, and the direction out of it.
struct CurvePoint {
  Vector3 place;
  Vector3 out;
};

/// The tube about a curve that goes counterclockwise.
void addTube(GizmoShape& shape, const std::vector<CurvePoint>& curve, double radius)
{
  addGrid(shape, curve.size() + 1, kTubeSides, [&](std::size_t k, double side) {
    const auto& [place, out] = curve[k % curve.size()];
    const double angle = -2 * pi * side / kTubeSides;
    const Vector3 normal = std::cos(angle) * out + std::sin(angle) * Vector3::UnitZ();
    addPoint(shape, place + radius * normal, normal);
  });
}

GizmoShape ring(double radius, double tube)
{
  std::vector<CurvePoint> curve;
  for (int k = 0; k < kRingSteps; ++k) {
    const Vector3 out = acrossZ(2 * pi * k / kRingSteps);
    curve.push_back({radius * out, out});
  }
  GizmoShape shape;
  addTube(shape, curve, tube);
  for (const Vector3& point : shape.points) shape.arms.push_back(Vector3(point.x(), point.y(), 0).normalized());
  return shape;
}

std::vector<CurvePoint> roundedSquare()
{
  std::vector<CurvePoint> curve;
  const double low = kSquareStart + kCornerRadius;
  const double high = kSquareEnd - kCornerRadius;
  const std::array<Vector3, 4> centers{Vector3(high, high, 0), Vector3(low, high, 0), Vector3(low, low, 0),
                                       Vector3(high, low, 0)};
  for (int corner = 0; corner < 4; ++corner)
    for (int k = 0; k <= kCornerSteps; ++k) {
      const Vector3 out = acrossZ(pi / 2 * (corner + static_cast<double>(k) / kCornerSteps));
      curve.push_back({centers[static_cast<std::size_t>(corner)] + kCornerRadius * out, out});
    }
  return curve;
}

/// A sheet with a fine border.
GizmoShape square()
{
  GizmoShape shape;
  const std::vector<CurvePoint> curve = roundedSquare();
  addTube(shape, curve, kBorderTube);
  const double middle = (kSquareStart + kSquareEnd) / 2;
  const Index center = addPoint(shape, {middle, middle, 0}, Vector3::UnitZ(), kPartFillOpacity);
  for (const CurvePoint& point : curve) addPoint(shape, point.place, Vector3::UnitZ(), kPartFillOpacity);
  const auto count = static_cast<Index>(curve.size());
  for (Index k = 0; k < count; ++k) shape.triangles.push_back({center, center + 1 + k, center + 1 + (k + 1) % count});
  return shape;
}

GizmoShape shapeAlongZ(GizmoPart part)
{
  const GizmoPartKind kind = kindOf(part);
  if (kind == GizmoPartKind::Arrow) return arrow();
  if (kind == GizmoPartKind::Square) return square();
  if (kind == GizmoPartKind::Ring) return ring(kRingRadius, kRingTube);
  if (kind == GizmoPartKind::ViewRing) return ring(1, kViewRingTube);
  GizmoShape ball;
  addRevolved(ball, arc({0, 0}, kBallRadius, -pi / 2, pi / 2, 2 * kArcSteps));
  return ball;
}

constexpr int kSolid = 255;

void setUp(vtkActor& actor, vtkPolyData& data, GizmoPart part)
{
  showData(actor, data);
  vtkProperty& property = *actor.GetProperty();
  property.SetInterpolationToPhong();
  property.SetAmbient(0.58);
  property.SetDiffuse(0.46);
  property.SetSpecular(0.25);
  property.SetSpecularPower(28);
  // The far side of a tube must not shine through the near one; a sheet has two sides.
  property.SetBackfaceCulling(kindOf(part) != GizmoPartKind::Square);
  actor.VisibilityOff();
}

unsigned char byteOf(double share)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

constexpr double kStepDegrees = 3;
constexpr double kSectorOpacity = 0.20;

// A share of the radius of the outer ring.
constexpr double kLineWidth = 0.018;
constexpr double kEndSize = 0.075;

/// From the grabbed place of the ring, one turn at most, to its place now.
void showTurn(const GizmoTrace& trace, double radius, vtkPolyData& lines, vtkPolyData& sector)
{
  const Vector3& center = trace.from.center;
  const auto placeAt = [&](double degrees) -> Vector3 {
    return center + radius * (Eigen::AngleAxisd(degrees * kDegree, trace.motion.axis) * trace.grabbed);
  };
  const double degrees = std::clamp(trace.motion.degrees, -360.0, 360.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(degrees) / kStepDegrees)));
  std::vector<Vector3> arc{placeAt(0)};
  std::vector<std::vector<Vector3>> fan;
  for (int k = 1; k <= steps; ++k) {
    arc.push_back(placeAt(degrees * k / steps));
    fan.push_back({center, arc[arc.size() - 2], arc.back()});
  }
  setLines(lines, {arc, {center, arc.front()}, {center, placeAt(trace.motion.degrees)}});
  setPolygons(sector, fan);
}

void setUp(vtkActor& actor, vtkPolyData& data)
{
  showData(actor, data);
  setColor(actor, kHighlightColor);
  actor.GetProperty()->LightingOff();
  actor.VisibilityOff();
}

}  // namespace

GizmoShape gizmoShape(GizmoPart part)
{
  GizmoShape shape = shapeAlongZ(part);
  const int axis = axisIndexOf(part);
  if (axis < 0 || axis == 2) return shape;
  // z becomes the part's axis, and x and y the two that follow it: squares stay between the positive axes.
  const auto rotated = [axis](const Vector3& v) {
    Vector3 result;
    for (int k = 0; k < 3; ++k) result[(axis + 1 + k) % 3] = v[k];
    return result;
  };
  for (std::vector<Vector3>* const vectors : {&shape.points, &shape.normals, &shape.arms})
    std::transform(vectors->begin(), vectors->end(), vectors->begin(), rotated);
  return shape;
}

GizmoPartActors::GizmoPartActors(GizmoPart part) : part_(part), shape_(gizmoShape(part))
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t k = 0; k < shape_.points.size(); ++k) {
    points_->InsertNextPoint(shape_.points[k].data());
    normals->InsertNextTuple(shape_.normals[k].data());
  }
  colors_->SetNumberOfComponents(4);
  colors_->SetNumberOfTuples(static_cast<vtkIdType>(shape_.points.size()));
  for (vtkPolyData* data : {solidData_.Get(), fadedData_.Get()}) {
    data->SetPoints(points_);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(colors_);
  }
  setUp(*solid_, *solidData_, part);
  setUp(*faded_, *fadedData_, part);
  // Actors that are drawn last may be blended directly. VTK's own translucent pass takes three times as long as the
  // rest of the gizmo on a machine without a GPU.
  solid_->ForceOpaqueOn();
  faded_->ForceOpaqueOn();
}

void GizmoPartActors::show(const GizmoPlacement& placement, const Color& color, double visibility, const Vector3& sight)
{
  solid_->VisibilityOff();
  faded_->VisibilityOff();
  if (!(visibility > 0) || !(placement.scale > 0)) return;
  const Vector3 localSight = placement.frame.axes.transpose() * sight;
  for (std::size_t k = 0; k < shape_.points.size(); ++k) {
    const double ofRing = kindOf(part_) == GizmoPartKind::Ring ? ringVisibility(shape_.arms[k], localSight) : 1;
    const unsigned char bytes[] = {byteOf(color.red), byteOf(color.green), byteOf(color.blue),
                                   byteOf(visibility * ofRing * shape_.opacities[k])};
    colors_->SetTypedTuple(static_cast<vtkIdType>(k), bytes);
  }
  vtkNew<vtkCellArray> solid;
  vtkNew<vtkCellArray> faded;
  for (const auto& [a, b, c] : shape_.triangles) {
    const int least = std::min(
        {colors_->GetTypedComponent(a, 3), colors_->GetTypedComponent(b, 3), colors_->GetTypedComponent(c, 3)});
    (least == kSolid ? solid : faded)->InsertNextCell({a, b, c});
  }
  colors_->Modified();
  solidData_->SetPolys(solid);
  fadedData_->SetPolys(faded);
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> place = Eigen::Matrix4d::Identity();
  place.topLeftCorner<3, 3>() = placement.scale * placement.frame.axes;
  place.topRightCorner<3, 1>() = placement.frame.center;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(place.data());
  for (vtkActor* actor : {solid_.Get(), faded_.Get()}) actor->SetUserMatrix(matrix);
  solid_->SetVisibility(solid->GetNumberOfCells() > 0);
  faded_->SetVisibility(faded->GetNumberOfCells() > 0);
}

GizmoTraceActors::GizmoTraceActors()
{
  setUp(*lines_, *lineData_);
  setUp(*sector_, *sectorData_);
  setUp(*ends_, *endData_);
  sector_->GetProperty()->SetOpacity(kSectorOpacity);
  sector_->ForceOpaqueOn();  // as with parts that are faded
  ends_->GetProperty()->RenderPointsAsSpheresOn();
}

void GizmoTraceActors::show(const GizmoTrace& trace, double radius, double pixels)
{
  const bool isTurn = isRotation(trace.part);
  if (isTurn) {
    showTurn(trace, radius, *lineData_, *sectorData_);
  } else {
    const std::vector<Vector3> ends{trace.from.center, trace.from.center + trace.motion.translation};
    setLines(*lineData_, {ends});
    setPoints(*endData_, ends);
  }
  setLineWidth(*lines_, kLineWidth * pixels);
  setPointSize(*ends_, kEndSize * pixels);
  lines_->VisibilityOn();
  sector_->SetVisibility(isTurn);
  ends_->SetVisibility(!isTurn);
}

void GizmoTraceActors::hide()
{
  for (vtkProp* prop : props()) prop->VisibilityOff();
}

}  // namespace holdfast
