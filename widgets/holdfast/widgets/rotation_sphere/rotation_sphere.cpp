#include "holdfast/widgets/rotation_sphere/rotation_sphere.h"

#include <cmath>
#include <limits>

#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

// Sizes in pixels of the picture.
constexpr double kSpherePointPixels = 4.5;
constexpr double kBallPixels = 14;
constexpr double kMarkPixels = 17;
constexpr double kRingLinePixels = 1;
constexpr double kArcPixels = 2;
constexpr double kTextPixels = 14;
constexpr double kScaleTextPixels = 12;

constexpr double kShellOpacity = 0.8;
constexpr Color kPlainPoint{0.16, 0.38, 0.66};

// Arcs between all of more rotations than this would cover the sphere.
constexpr std::size_t kMostJoined = 12;
// So would their names.
constexpr std::size_t kMostNamed = 24;

// In radii: the place of the names of axes, and how much of an axis must be in the picture for it to be named.
constexpr double kAxisNameRadius = 1.1;
constexpr double kNamedAxis = 0.5;
constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};

// Names of rings and axes are hidden where the surface faces away from the eye.
constexpr double kFarText = -0.1;

// Rings lie between the shell and the points.
constexpr double kShellRadius = 0.985;
constexpr double kGridRadius = 0.993;
constexpr int kShellRings = 48;
constexpr int kShellMeridians = 96;
constexpr int kSteps = 120;
constexpr int kMeridians = 8;

// Degrees of rotation from ring to ring, and of the last one before the whole turn.
constexpr int kRingDegrees = 45;
constexpr int kLastRing = 315;

// Of one ring: more turns than these would hide the sphere.
constexpr int kMostTurnsNamed = 3;

// Between the meridians, where data about coordinate axes are.
constexpr double kNameAzimuth = 22.5;
constexpr double kNameRadius = 1.01;

// Towards where the camera is shifted from the middle of what it shows.
const Vector3 kBeside(0.25, -0.4, 0.2);
constexpr double kEyeDistance = 10;

// Half the height of the picture, in radii: at least, beyond which all of the sphere is shown, and then.
constexpr double kLeastView = 0.5;
constexpr double kWholeView = 0.9;
constexpr double kWholeScale = 1.2;
constexpr double kViewMargin = 1.25;
constexpr double kNearestView = 0.005;
constexpr double kFarthestView = 20;

Vector3 onSphere(double fromPole, double azimuth)
{
  return {std::sin(fromPole) * std::cos(azimuth), std::sin(fromPole) * std::sin(azimuth), std::cos(fromPole)};
}

/// A closed surface a little within the unit sphere: what lies on the sphere is before it.
vtkSmartPointer<vtkPolyData> sphereShell()
{
  vtkNew<vtkSphereSource> shell;
  shell->SetRadius(kShellRadius);
  shell->SetPhiResolution(kShellRings + 1);
  shell->SetThetaResolution(kShellMeridians);
  shell->LatLongTessellationOn();
  shell->Update();
  return shell->GetOutput();
}

/// Rings of rotations by multiples of 45 degrees, whose quaternions lie half that from the pole +z, and meridians.
vtkSmartPointer<vtkPolyData> sphereRings()
{
  std::vector<std::vector<Vector3>> lines;
  const auto addLine = [&](auto placeAt) {
    std::vector<Vector3>& line = lines.emplace_back();
    for (int k = 0; k <= kSteps; ++k) line.push_back(kGridRadius * placeAt(static_cast<double>(k) / kSteps));
  };
  for (int degrees = kRingDegrees; degrees <= kLastRing; degrees += kRingDegrees)
    addLine([&](double share) { return onSphere(degrees / 2.0 * kDegree, share * 2 * std::numbers::pi); });
  for (int meridian = 0; meridian < kMeridians; ++meridian)
    addLine(
        [&](double share) { return onSphere(share * std::numbers::pi, meridian * 2 * std::numbers::pi / kMeridians); });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  setLines(*data, lines);
  return data;
}

double largestDegrees(const std::vector<BoundaryRotation>& boundary)
{
  double largest = 0;
  for (const BoundaryRotation& value : boundary) largest = std::max(largest, value.q.norm() * 2 / kDegree);
  return largest;
}

/// The angles of a ring of the sphere and of the shells above it that rotations up to `largest` degrees reach: "90°",
/// "90°, 630°". Each whole turn goes from pole to pole and ends where the next one begins.
std::string ringText(int degrees, double largest)
{
  constexpr int kTurn = 360;
  std::string text = std::to_string(degrees) + "\u00b0";
  int turn = 1;
  for (; turn * kTurn < largest && turn < kMostTurnsNamed; ++turn) {
    const int further = turn % 2 == 1 ? (turn + 1) * kTurn - degrees : turn * kTurn + degrees;
    if (degrees != kTurn || turn % 2 == 0) text += ", " + std::to_string(further) + "\u00b0";
  }
  return turn * kTurn < largest ? text + " \u2026" : text;
}

}  // namespace

void lookAtPlaces(vtkCamera& camera, const std::vector<Vector3>& places)
{
  Vector3 middle = Vector3::Zero();
  for (const Vector3& place : places) middle += place / static_cast<double>(places.size());
  const Vector3 back = (middle + kBeside).normalized();
  const Vector3 right = Vector3::UnitZ().cross(back).normalized();
  const Vector3 up = back.cross(right);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Vector3& place : places) {
    const Eigen::Vector2d seen(place.dot(right), place.dot(up));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  const double reach = kViewMargin * (high - low).maxCoeff() / 2;
  const bool isWhole = reach > kWholeView;
  const Eigen::Vector2d center = isWhole ? Eigen::Vector2d(0, 0) : Eigen::Vector2d((low + high) / 2);
  const Vector3 focus = center.x() * right + center.y() * up;
  const Vector3 eye = focus + kEyeDistance * back;
  camera.SetFocalPoint(focus.data());
  camera.SetPosition(eye.data());
  camera.SetViewUp(up.data());
  camera.SetParallelScale(isWhole ? std::max(reach, kWholeScale) : std::max(reach, kLeastView));
}

void zoomSphere(vtkCamera& camera, double factor)
{
  camera.SetParallelScale(std::clamp(camera.GetParallelScale() / factor, kNearestView, kFarthestView));
}

RotationSphere::RotationSphere()
{
  auto nothing = std::make_shared<PlacedRotations>();
  nothing->vertices = std::make_shared<const SphereVertices>();
  placed_ = std::move(nothing);
  showData(*points_, *pointData_).ScalarVisibilityOff();
  showData(*balls_, *boundaryData_);
  showData(*arcs_, *arcData_);
  showData(*mark_, *markData_);
  showData(*shell_, *sphereShell());
  showData(*rings_, *sphereRings());
  for (vtkActor* const actor : {points_.Get(), balls_.Get(), mark_.Get()}) {
    actor->GetProperty()->RenderPointsAsSpheresOn();
    actor->GetProperty()->SetAmbient(0.35);
    actor->GetProperty()->SetDiffuse(0.65);
  }
  for (vtkActor* const actor : {rings_.Get(), arcs_.Get()}) actor->GetProperty()->LightingOff();
  shell_->GetProperty()->SetOpacity(kShellOpacity);
  // Nearly flat, so that the colours of points differ at the rim too.
  shell_->GetProperty()->SetAmbient(0.6);
  shell_->GetProperty()->SetDiffuse(0.4);
  // The far half is what is seen through the near one.
  shell_->GetProperty()->BackfaceCullingOn();
  mark_->VisibilityOff();
  applyLook();
}

RotationSphere::~RotationSphere()
{
  if (renderer_) renderer_->RemoveObserver(observer_);
}

void RotationSphere::addTo(vtkRenderer& renderer)
{
  renderer_ = &renderer;
  for (vtkActor* const actor : {rings_.Get(), arcs_.Get(), points_.Get(), balls_.Get(), mark_.Get()})
    renderer.AddActor(actor);
  // What is behind it is seen through it.
  renderer.AddActor(shell_);
  renderer.SetBackgroundAlpha(1);
  renderer.GetActiveCamera()->ParallelProjectionOn();
  observer_ = renderer.AddObserver(vtkCommand::StartEvent, this, &RotationSphere::hideTexts);
  applyLook();
  showScale();
  fitCamera();
}

void RotationSphere::setLook(const SphereLook& look)
{
  look_ = look;
  applyLook();
  showScale();
  showNames();
}

void RotationSphere::applyLook()
{
  if (renderer_) renderer_->SetBackground(look_.background.red, look_.background.green, look_.background.blue);
  setColor(*shell_, look_.shell);
  setColor(*points_, kPlainPoint);
  setColor(*balls_, look_.ink);
  setColor(*arcs_, look_.ink);
  setColor(*rings_, mixed(look_.ink, look_.shell, 0.7));
  setColor(*mark_, look_.mark);
  setPointSize(*points_, kSpherePointPixels * look_.pixelRatio);
  setPointSize(*balls_, kBallPixels * look_.pixelRatio);
  setPointSize(*mark_, kMarkPixels * look_.pixelRatio);
  setLineWidth(*rings_, kRingLinePixels * look_.pixelRatio);
  setLineWidth(*arcs_, kArcPixels * look_.pixelRatio);
}

void RotationSphere::show(std::shared_ptr<const PlacedRotations> placed)
{
  const bool isOtherFrame = placed->frame.axes != placed_->frame.axes;
  placed_ = std::move(placed);
  std::vector<Vector3> drawn;
  for (const Index point : placed_->drawn) drawn.push_back(placed_->places[point]);
  setPoints(*pointData_, drawn);
  colorPoints();
  const std::vector<BoundaryRotation>& boundary = placed_->boundary;
  std::vector<Vector3> balls;
  std::vector<std::vector<Vector3>> arcs;
  for (std::size_t a = 0; a < boundary.size(); ++a) {
    balls.push_back(spherePlace(placed_->frame, boundary[a].q));
    for (std::size_t b = a + 1; b < boundary.size() && boundary.size() <= kMostJoined; ++b)
      arcs.push_back(sphereArc(placed_->frame, boundary[a].q, boundary[b].q));
  }
  setPoints(*boundaryData_, balls);
  setLines(*arcData_, arcs);
  placeMark();
  if (isOtherFrame) showScale();
  showNames();
}

void RotationSphere::setColoring(const std::optional<Coloring>& coloring)
{
  coloring_ = coloring;
  colorPoints();
}

void RotationSphere::colorPoints()
{
  vtkMapper& mapper = *points_->GetMapper();
  mapper.SetScalarVisibility(coloring_.has_value());
  if (!coloring_) return;
  vtkNew<vtkDoubleArray> shares;
  shares->Allocate(static_cast<vtkIdType>(placed_->drawn.size()));
  for (const Index point : placed_->drawn) {
    const double value = coloring_->values[placed_->vertices->vertexOf[point]];
    shares->InsertNextValue(shareOf(coloring_->scale, value));
  }
  pointData_->GetPointData()->SetScalars(shares);
  mapper.SetLookupTable(toLookupTable(coloring_->scale));
  mapper.UseLookupTableScalarRangeOn();
}

void RotationSphere::mark(std::optional<Index> vertex)
{
  marked_ = vertex;
  placeMark();
}

void RotationSphere::placeMark()
{
  const auto place = placeOf(marked_.value_or(-1));
  mark_->SetVisibility(place.has_value());
  if (place) setPoints(*markData_, {*place});
}

std::optional<Vector3> RotationSphere::placeOf(Index vertex) const
{
  const std::vector<Index>& pointOf = placed_->vertices->pointOf;
  if (vertex < 0 || vertex >= static_cast<Index>(pointOf.size()) || pointOf[vertex] < 0) return std::nullopt;
  return placed_->places[pointOf[vertex]];
}

vtkSmartPointer<vtkTextActor> RotationSphere::textAt(const std::string& text, const Vector3& place, double pixels) const
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  vtkNew<vtkCoordinate> anchor;
  anchor->SetCoordinateSystemToWorld();
  anchor->SetValue(place.x(), place.y(), place.z());
  vtkCoordinate& position = *actor->GetPositionCoordinate();
  position.SetCoordinateSystemToViewport();
  position.SetReferenceCoordinate(anchor);
  position.SetValue(0, 0);
  vtkTextProperty& property = *actor->GetTextProperty();
  property.SetFontFamilyToArial();
  property.SetFontSize(static_cast<int>(std::lround(pixels * look_.pixelRatio)));
  property.SetColor(look_.ink.red, look_.ink.green, look_.ink.blue);
  property.SetJustificationToCentered();
  property.SetVerticalJustificationToCentered();
  return actor;
}

void RotationSphere::hideTexts()
{
  const Vector3 forward = sightOf(*renderer_->GetActiveCamera());
  const double room = kScaleTextPixels * look_.pixelRatio;
  const auto seenAt = [&](vtkCoordinate& place) {
    return DisplayPoint(place.GetComputedDoubleDisplayValue(renderer_));
  };
  std::vector<DisplayPoint> taken;
  for (const auto& name : nameTexts_) {
    taken.push_back(seenAt(*name->GetPositionCoordinate()));
    taken.push_back(seenAt(*name->GetPositionCoordinate()->GetReferenceCoordinate()));  // of its ball
  }
  for (const auto& text : scaleTexts_) {
    const Vector3 place(text->GetPositionCoordinate()->GetReferenceCoordinate()->GetValue());
    const bool isBeside = (place - place.dot(forward) * forward).norm() > 1;
    const DisplayPoint seen = seenAt(*text->GetPositionCoordinate());
    const bool isNear = isBeside || place.dot(forward) < kFarText;
    const bool isFree = std::none_of(taken.begin(), taken.end(),
                                     [&](const DisplayPoint& other) { return (seen - other).norm() < room; });
    text->SetVisibility(isNear && isFree);
    if (isNear && isFree) taken.push_back(seen);
  }
}

void RotationSphere::replace(Texts& texts, Texts with)
{
  if (!renderer_) return;
  for (const auto& text : texts) renderer_->RemoveActor(text);
  texts = std::move(with);
  for (const auto& text : texts)
    if (look_.areTextsDrawn) renderer_->AddActor(text);
}

std::vector<SphereText> RotationSphere::texts() const
{
  std::vector<SphereText> shown;
  for (const Texts* texts : {&scaleTexts_, &nameTexts_})
    for (const auto& text : *texts)
      if (text->GetVisibility() != 0)
        shown.push_back({text->GetInput(),
                         DisplayPoint(text->GetPositionCoordinate()->GetComputedDoubleDisplayValue(renderer_)),
                         texts == &nameTexts_});
  return shown;
}

void RotationSphere::showScale()
{
  Texts texts;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 shown(placed_->frame.axes(axis, 0), placed_->frame.axes(axis, 1), 0);
    if (shown.norm() < kNamedAxis) continue;
    texts.push_back(textAt(kAxisNames[axis], kAxisNameRadius * shown.normalized(), kTextPixels));
    texts.push_back(
        textAt(std::string("\u2212") + kAxisNames[axis], -kAxisNameRadius * shown.normalized(), kTextPixels));
  }
  const auto addRing = [&](int degrees, const Vector3& place) {
    texts.push_back(textAt(ringText(degrees, largestDegrees(placed_->boundary)), place, kScaleTextPixels));
    texts.back()->GetTextProperty()->SetOpacity(0.7);
  };
  for (int degrees = kRingDegrees; degrees <= kLastRing; degrees += kRingDegrees)
    for (const double azimuth : {-90 + kNameAzimuth, 90 + kNameAzimuth})
      addRing(degrees, kNameRadius * onSphere(degrees / 2.0 * kDegree, azimuth * kDegree));
  addRing(360, -1.05 * Vector3::UnitZ());
  replace(scaleTexts_, std::move(texts));
}

void RotationSphere::showNames()
{
  Texts texts;
  for (std::size_t k = 0; k < std::min(placed_->boundary.size(), kMostNamed); ++k) {
    const BoundaryRotation& value = placed_->boundary[k];
    texts.push_back(textAt(value.label, 1.02 * spherePlace(placed_->frame, value.q), kTextPixels));
    const double away = 0.85 * kBallPixels * look_.pixelRatio;
    texts.back()->GetPositionCoordinate()->SetValue(away, away);
    texts.back()->GetTextProperty()->SetJustificationToLeft();
    texts.back()->GetTextProperty()->SetBold(1);
  }
  replace(nameTexts_, std::move(texts));
}

void RotationSphere::fitCamera() const
{
  if (!renderer_) return;
  std::vector<Vector3> places{Vector3::UnitZ()};
  for (const BoundaryRotation& value : placed_->boundary)
    for (const Vector3& place : sphereArc(placed_->frame, Vector3::Zero(), value.q)) places.push_back(place);
  lookAtPlaces(*renderer_->GetActiveCamera(), places);
  renderer_->ResetCameraClippingRange();
}

std::optional<Index> RotationSphere::pick(double displayX, double displayY) const
{
  if (!renderer_) return std::nullopt;
  const DisplayTransform toDisplay(*renderer_);
  const Vector3 forward = sightOf(*renderer_->GetActiveCamera());
  // Squared distances; of the near side, of the far one.
  const double reach = std::pow(kSphereReach * look_.pixelRatio, 2);
  std::array<double, 2> least{reach, reach};
  std::array<std::optional<Index>, 2> found;
  for (std::size_t k = 0; k < placed_->places.size(); ++k) {
    const Vector3& place = placed_->places[k];
    const double distance = (toDisplay.show(place).point - DisplayPoint(displayX, displayY)).squaredNorm();
    const std::size_t side = place.dot(forward) > 0 ? 1 : 0;
    if (distance > least[side] || (found[side] && distance == least[side])) continue;
    least[side] = distance;
    found[side] = placed_->vertices->vertexOf[k];
  }
  return found[0] ? found[0] : found[1];
}

}  // namespace holdfast
