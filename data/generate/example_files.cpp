// The bar, the plate, the head and the small meshes, each with its constraints.

#include <cmath>
#include <numbers>

#include "box_surface.h"
#include "constraint_text.h"
#include "files.h"
#include "head.h"
#include "planted_conflicts.h"
#include "plate.h"
#include "rotation_examples.h"
#include "small_meshes.h"
#include "write.h"

namespace holdfast::generate {
namespace {

struct Aim {
  const char* name;
  Vector3 place;
  Vector3 shift;
};

// `aims` on the vertices nearest to them.
std::string aimedPoints(const GroupedMesh& mesh, const std::vector<Aim>& aims)
{
  std::vector<MeasuredPoint> points;
  for (const Aim& aim : aims) {
    const Spot spot = findSpot(mesh, SpotKind::kVertex, aim.place);
    points.push_back({aim.name, spot, rounded(Vector3(spot.rest + aim.shift))});
  }
  return pointList(points);
}

constexpr double kBarLength = 100, kBarHalf = 5, kBarEnd = 5;

std::string barFoot()
{
  return fixedText("foot", inHalfSpace({0, 0, kBarEnd}, {0, 0, -1}));
}
std::string barTop()
{
  return inHalfSpace({0, 0, kBarLength - kBarEnd}, {0, 0, 1});
}

// The free part becomes a quarter of a circle of its own length.
std::string bentBar()
{
  const double radius = (kBarLength - 2 * kBarEnd) / (std::numbers::pi / 2);
  const double restHeight = kBarLength - kBarEnd / 2;
  const Vector3 end(radius + kBarEnd / 2, 0, kBarEnd + radius - restHeight);
  return constraintFile({barFoot(), handleText("top", barTop(), {Vector3::UnitY(), 90}, rounded(end))});
}

constexpr double kPlateSide = 100;

std::string raisedPlate()
{
  const std::string inner = inBox({0.5, 0.5, -1}, {kPlateSide - 0.5, kPlateSide - 0.5, 1});
  return constraintFile(
      {fixedText("border", notIn(inner)), handleText("middle", inSphere({50, 50, 0}, 8), Vector3(0, 0, 25))});
}

std::string turnedHead()
{
  const Spot nose{NearSpot{}, {0, -104, 0}};
  return constraintFile({fixedText("neck", inHalfSpace({0, 0, -92}, {0, 0, -1})),
                         handleText("left ear", inSphere({86, 10, 24}, 22), {Vector3::UnitY(), -25}, {16, 0, 14}),
                         pointTo("nose tip", nose, {0, -126, 8})});
}

}  // namespace

std::vector<File> barFiles()
{
  const GroupedMesh mesh = boxSurface({-kBarHalf, -kBarHalf, 0}, 1, {10, 10, 100});
  const Vector3 stay = Vector3::Zero();
  const std::vector<Aim> aims{{"foot 1", {-5, -5, 0}, stay},
                              {"foot 2", {5, -5, 0}, stay},
                              {"foot 3", {5, 5, 0}, stay},
                              {"foot 4", {-5, 5, 0}, stay},
                              {"side 25", {5, 0, 25}, {0.4, 0, 0}},
                              {"side 50", {5, 0, 50}, {1.7, 0.1, 0}},
                              {"side 75", {5, 0, 75}, {3.8, 0.2, 0}},
                              {"top 1", {5, -5, 100}, {6.8, 0.3, -0.4}},
                              {"top 2", {-5, 5, 100}, {6.8, 0.3, 0.6}}};
  return {{"bar.obj", objText(mesh, "Holdfast example: a square bar, mm")},
          {"bar.constraints.json", bentBar()},
          {"bar.twist_90.constraints.json", twistedBar(90)},
          {"bar.twist_180.constraints.json", twistedBar(180)},
          {"bar.twist_360.constraints.json", twistedBar(360)},
          {"bar.twist_720.constraints.json", twistedBar(720)},
          {"bar.measured.csv", aimedPoints(mesh, aims)}};
}

std::vector<File> plateFiles()
{
  const GroupedMesh mesh = rounded(makePlate());
  const Vector3 stay = Vector3::Zero();
  const std::vector<Aim> aims{{"corner 1", {0, 0, 0}, stay},
                              {"corner 2", {100, 0, 0}, stay},
                              {"corner 3", {100, 100, 0}, stay},
                              {"corner 4", {0, 100, 0}, stay},
                              {"middle", {50, 50, 0}, {0, 0, 6}},
                              {"fine side", {20, 50, 0}, {0, 0, 3.5}},
                              {"coarse side", {80, 50, 0}, {0, 0, 3.5}},
                              {"front", {50, 20, 0}, {0, 0, 3.5}},
                              {"rear", {50, 80, 0}, {0, 0, 3.5}}};
  return {{"plate_unsymmetric.off", offText(mesh, "Holdfast example: a plate, fine and coarse without symmetry, mm")},
          {"plate_unsymmetric.constraints.json", raisedPlate()},
          {"plate_unsymmetric.two_handles.constraints.json", plateBetweenTwoHandles()},
          {"plate_unsymmetric.three_handles.constraints.json", plateBetweenThreeHandles()},
          {"plate_unsymmetric.conflict.constraints.json", plantedConflicts(mesh)},
          {"plate_unsymmetric.measured.csv", aimedPoints(mesh, aims)}};
}

std::vector<File> headFiles()
{
  const GroupedMesh mesh = rounded(makeHead());
  const Vector3 stay = Vector3::Zero();
  const std::vector<Aim> aims{{"neck front", {0, -11, -100}, stay},
                              {"neck left", {37, 26, -100}, stay},
                              {"neck right", {-37, 26, -100}, stay},
                              {"neck back", {0, 63, -100}, stay},
                              {"chin", {0, -68, -66}, {0, -5, -4}},
                              {"nose tip", {0, -104, 0}, {0, -6, 3}},
                              {"mouth corner left", {38, -66, -24}, {5, 1, 4}},
                              {"mouth corner right", {-38, -66, -24}, {-5, 1, 4}},
                              {"brow left", {33, -76, 60}, {0, -1, 5}},
                              {"brow right", {-33, -76, 60}, {0, 0, -1}},
                              {"crown", {0, 6, 116}, {0, 0, 3}},
                              {"back", {0, 86, 42}, {0, 2, 0}}};
  return {{"head.ply", plyBytes(mesh, "Holdfast example: a head, mm")},
          {"head.constraints.json", turnedHead()},
          {"head.rigid_eyes.constraints.json", leaningHead()},
          {"head.measured.csv", aimedPoints(mesh, aims)}};
}

std::vector<File> smallFiles()
{
  const std::string parts =
      constraintFile({fixedText("left part, its left side", allOf({inComponent(0), inBox({-1, -1, -1}, {0, 11, 11})})),
                      pointTo("left part, an edge", {NearSpot{}, {5, 10, 10}}, {5, 12, 11})});
  const std::string torus =
      constraintFile({fixedText("left", inHalfSpace({-22, 0, 0}, {-1, 0, 0})),
                      handleText("right", inHalfSpace({22, 0, 0}, {1, 0, 0}), {Vector3::UnitX(), 60}, {6, 0, 0})});
  const std::string cube = constraintFile({fixedText("bottom", inHalfSpace({0, 0, 0.5}, {0, 0, -1})),
                                           handleText("top", inHalfSpace({0, 0, 9.5}, {0, 0, 1}), Vector3(0, 0, 2))});
  return {{"cube_unwelded.stl", unweldedCubeStl()}, {"cube_unwelded.constraints.json", cube},
          {"two_parts.obj", twoPartsObj()},         {"two_parts.constraints.json", parts},
          {"quads.obj", quadsObj("quads.mtl")},     {"quads.mtl", quadsMaterials()},
          {"quads.constraints.json", torus}};
}

}  // namespace holdfast::generate
