#include "holdfast/widgets/rotation_sphere/sphere_shapes.h"

#include <cmath>
#include <numbers>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <holdfast/geometry/degree.h>
#include <holdfast/widgets/mesh/poly_data.h>

namespace holdfast {
namespace {

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

// Between the meridians, where data about coordinate axes are.
constexpr double kNameAzimuth = 22.5;
constexpr double kNameRadius = 1.01;

Vector3 onSphere(double fromPole, double azimuth)
{
  return {std::sin(fromPole) * std::cos(azimuth), std::sin(fromPole) * std::sin(azimuth), std::cos(fromPole)};
}

}  // namespace

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

std::vector<RingName> ringNames()
{
  std::vector<RingName> names;
  for (int degrees = kRingDegrees; degrees <= kLastRing; degrees += kRingDegrees)
    for (const double azimuth : {-90 + kNameAzimuth, 90 + kNameAzimuth})
      names.push_back(
          {std::to_string(degrees) + "\u00b0", kNameRadius * onSphere(degrees / 2.0 * kDegree, azimuth * kDegree)});
  names.push_back({"360\u00b0", -1.05 * Vector3::UnitZ()});
  return names;
}

Color mixed(const Color& from, const Color& to, double share)
{
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

}  // namespace holdfast
