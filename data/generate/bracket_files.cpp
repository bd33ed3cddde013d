// The bracket, and what was "measured" on one that was made: its wall has bent forward and twisted a little, its base
// has bowed, and each reading is off by some hundredths of a millimetre.

#include <cmath>
#include <numbers>
#include <random>

#include "bracket.h"
#include "constraint_text.h"
#include "files.h"
#include "session_text.h"
#include "write.h"

namespace holdfast::generate {
namespace {

using namespace bracket;

constexpr double kBoltReach = 10;  // around the middle of a bolt hole, its counterbore and a rim included

Vector3 asBuilt(const Vector3& place)
{
  constexpr double kHeight = 68, kBend = -2.3, kShift = 0.7, kTwist = 0.014, kBow = 0.4, kHalfLength = 60;
  const double up = std::max(place.z() - kBaseTop, 0.0) / kHeight;
  const double bow = kBow * std::cos(std::numbers::pi / 2 * place.x() / kHalfLength);
  return place + Vector3(kShift * up * up, kBend * up * up + kTwist * place.x() * up, bow);
}

// Evenly distributed over +-0.04 mm. The engine's numbers are the same everywhere.
Vector3 readingError(std::minstd_rand& engine)
{
  constexpr double kLargest = 0.04;
  Vector3 result;
  for (double& coordinate : result) {
    coordinate = kLargest * (2 * static_cast<double>(engine()) / static_cast<double>(std::minstd_rand::max()) - 1);
  }
  return result;
}

struct Probe {
  const char* name;
  SpotKind kind;
  Vector3 place;
};

std::vector<Probe> probes()
{
  constexpr double kRim = 15, kFlange = 18, kCrown = 30, kShoulder = 12.5, kShoulderY = 23;
  const double slant = kCrown / std::numbers::sqrt2;
  return {{"bore rim east", SpotKind::kVertex, {kRim, kBossFront, kBoreHeight}},
          {"bore rim north", SpotKind::kVertex, {0, kBossFront, kBoreHeight + kRim}},
          {"bore rim west", SpotKind::kVertex, {-kRim, kBossFront, kBoreHeight}},
          {"bore rim south", SpotKind::kVertex, {0, kBossFront, kBoreHeight - kRim}},
          {"flange east", SpotKind::kFace, {kFlange, kBossFront, kBoreHeight}},
          {"flange west", SpotKind::kFace, {-kFlange, kBossFront, kBoreHeight}},
          {"bore shoulder east", SpotKind::kNear, {kShoulder, kShoulderY, kBoreHeight}},
          {"bore shoulder west", SpotKind::kNear, {-kShoulder, kShoulderY, kBoreHeight}},
          {"crown left", SpotKind::kEdge, {-slant, kWallFront, kBoreHeight + slant}},
          {"crown top", SpotKind::kEdge, {0, kWallFront, kBoreHeight + kCrown}},
          {"crown right", SpotKind::kEdge, {slant, kWallFront, kBoreHeight + slant}},
          {"wall back top", SpotKind::kNear, {0, kWallBack, 71}},
          {"wall back left", SpotKind::kNear, {-25, kWallBack, 36}},
          {"wall back right", SpotKind::kNear, {25, kWallBack, 36}},
          {"pad 1", SpotKind::kFace, {0, -17, 14.5}},
          {"pad 2", SpotKind::kNear, {-kBoltX, 0, 14}},
          {"pad 3", SpotKind::kEdge, {kBoltX, 0, 14}},
          {"gusset left", SpotKind::kFace, {-25.5, 3, 25}},
          {"gusset right", SpotKind::kFace, {25.5, 3, 25}}};
}

std::vector<MeasuredPoint> measured(const GroupedMesh& mesh)
{
  std::minstd_rand engine(1);
  std::vector<MeasuredPoint> result;
  for (const Probe& probe : probes()) {
    const Spot spot = findSpot(mesh, probe.kind, probe.place);
    result.push_back({probe.name, spot, rounded(Vector3(asBuilt(spot.rest) + readingError(engine)))});
  }
  return result;
}

// The corners of the base stay where they are: without a fixed part, the list can be used alone.
std::vector<MeasuredPoint> datums(const GroupedMesh& mesh)
{
  std::vector<MeasuredPoint> result;
  for (const double y : {-kBoltY, kBoltY}) {
    for (const double x : {-kBoltX, kBoltX}) {
      const Spot spot = findSpot(mesh, SpotKind::kVertex, {x + 4.5, y, 0});
      result.push_back({"datum " + std::to_string(result.size() + 1), spot, spot.rest});
    }
  }
  return result;
}

std::string fixedBolts()
{
  const auto around = [](double x, double y) { return inSphere({x, y, kBaseTop / 2}, kBoltReach); };
  const std::string below = inHalfSpace({0, 0, kBaseTop + 0.5}, {0, 0, -1});
  return fixedText("bolts front", anyOf({around(-kBoltX, -kBoltY), around(kBoltX, -kBoltY)})) + ",\n    " +
         fixedText("bolt rear left", inBox({-57, 11, -1}, {-41, 27, kBaseTop + 1})) + ",\n    " +
         fixedText("bolt rear right", allOf({around(kBoltX, kBoltY), below}));
}

std::string asBuiltConstraints(const std::vector<MeasuredPoint>& points)
{
  std::vector<std::string> constraints{fixedBolts()};
  for (const MeasuredPoint& point : points) constraints.push_back(pointTo(point.name, point.spot, point.target));
  return constraintFile(constraints);
}

std::string conflictingConstraints(const GroupedMesh& mesh)
{
  const Spot crown = findSpot(mesh, SpotKind::kVertex, {0, kWallFront, 80});
  const Spot bolt = findSpot(mesh, SpotKind::kVertex, {-kBoltX + 7.5, -kBoltY, kBaseTop});
  const Spot flange = findSpot(mesh, SpotKind::kFace, {18, kBossFront, kBoreHeight});
  const Index face = std::get<FaceSpot>(flange.where).face;
  const Vector3 forward(0, -1.5, 0), further(0, -3.5, 0), flangeMove(0.25, -1, 0), flangeOff(0.25, -1.75, 0);
  return constraintFile(
      {fixedBolts(), pointBy("bolt 1 stays, as it is fixed (redundant)", bolt, Vector3::Zero()),
       pointBy("bolt 1 lifted by 0.5 though it is fixed (conflicting)", bolt, {0, 0, 0.5}),
       pointBy("crown forward by 1.5", crown, forward),
       pointBy("crown forward by 3.5 instead (conflicting)", crown, further),
       pointBy("crown forward by 1.5 once more (redundant)", crown, forward),
       pointInFace("flange 1", face, {0.5, 0.25, 0.25}, flangeMove),
       pointInFace("flange 2", face, {0.25, 0.5, 0.25}, flangeMove),
       pointInFace("flange 3", face, {0.25, 0.25, 0.5}, flangeMove),
       pointInFace("flange 4, 0.75 off the plane of 1 to 3 (conflicting)", face, {0.375, 0.375, 0.25}, flangeOff),
       pointInFace("flange 5, in the plane of 1 to 3 (redundant)", face, {0.375, 0.25, 0.375}, flangeMove)});
}

}  // namespace

std::vector<File> bracketFiles()
{
  const GroupedMesh mesh = rounded(makeBracket());
  const std::vector<MeasuredPoint> points = measured(mesh);
  std::vector<MeasuredPoint> list = datums(mesh);
  list.insert(list.end(), points.begin(), points.end());
  const File obj{"bracket.obj", objText(mesh, "Holdfast example: a machined bracket, mm")};
  const std::string asBuilt = asBuiltConstraints(points);
  return {obj,
          {"bracket.constraints.json", asBuilt},
          {"bracket.holdfast", sessionText(obj, asBuilt)},
          {"bracket.conflict.constraints.json", conflictingConstraints(mesh)},
          {"bracket.measured.csv", pointList(list)}};
}

}  // namespace holdfast::generate
