#include "bracket.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "pad.h"
#include "revolved.h"

namespace holdfast::generate {
namespace {

using namespace bracket;
using std::numbers::pi;

constexpr double kLargestEdge = 2;

constexpr double kBaseX = 60, kBaseY = 30, kCornerRadius = 8;
constexpr double kWallFoot = 38;     // half the width of the wall where it meets the base
constexpr double kCrownRadius = 30;  // of the round top of the wall, about the axis of the bore
constexpr double kFilletRadius = 8;
constexpr double kFilletToe = kWallFront - kFilletRadius;
constexpr double kFilletTop = kBaseTop + kFilletRadius;
constexpr double kGussetInner = 22, kGussetOuter = 29, kGussetFront = -12, kGussetToe = 15, kGussetTop = 35;
constexpr double kBossRoot = 2.5;  // radius of the fillet around the boss
constexpr double kSeatRadius = 14, kSeatDepth = 23, kChamfer = 1, kThroughRadius = 11;
constexpr double kScrewRadius = 1.5, kScrewCircle = 18, kScrewDepth = 16;
constexpr double kBoltRadius = 4.5, kCounterboreRadius = 7.5, kCounterboreFloor = 9;

constexpr std::array<double, 2> kSides{-1, 1};

class BracketBuilder {
 public:
  GroupedMesh build()
  {
    for (const double side : kSides) {
      addWallSide(side);
      addGusset(side);
    }
    addBaseSides();
    addFillet();
    addCrown();
    addBore();
    addBolts();
    addPads();
    addBaseTop();
    addBaseBottom();
    addWallFront();
    addWallBack();
    return gathered(shell_.mesh());
  }

 private:
  // -- the outline of the wall: straight flanks that touch the crown --

  // The angle at the axis of the bore, from +x towards +z, where the right flank touches the crown.
  [[nodiscard]] static double touchAngle()
  {
    const double down = kBoreHeight - kBaseTop;
    return std::acos(kCrownRadius / std::hypot(kWallFoot, down)) - std::atan2(down, kWallFoot);
  }

  [[nodiscard]] static Vector3 touchPoint(double side, double y)
  {
    return {side * kCrownRadius * std::cos(touchAngle()), y, kBoreHeight + kCrownRadius * std::sin(touchAngle())};
  }

  [[nodiscard]] static double flankX(double side, double z)
  {
    const Vector3 top = touchPoint(side, 0);
    return side * kWallFoot + (top.x() - side * kWallFoot) * (z - kBaseTop) / (top.z() - kBaseTop);
  }

  [[nodiscard]] static Vector3 onFlank(double side, double y, double z) { return {flankX(side, z), y, z}; }

  // Across the profile of the fillet, from the toe on the base, 0, to the top on the wall, 1.
  [[nodiscard]] static Vector3 onFillet(double t, double x)
  {
    const double angle = t * pi / 2;
    return {x, kFilletToe + kFilletRadius * std::sin(angle), kFilletTop - kFilletRadius * std::cos(angle)};
  }

  Curve filletProfile(double x)
  {
    return shell_.curve([&](double t) { return onFillet(t, x); }, filletSteps());
  }

  [[nodiscard]] static Index filletSteps() { return std::lround(kFilletRadius * pi / 2 / kLargestEdge) + 1; }

  [[nodiscard]] static Circle crown(double y)
  {
    return {{0, y, kBoreHeight}, Vector3::UnitZ(), Vector3::UnitX(), kCrownRadius};
  }

  Curve crownArc(double y) { return shell_.arc(crown(y), touchAngle() - pi / 2, pi / 2 - touchAngle()); }
  Curve crownEnd(double side) { return shell_.segment(touchPoint(side, kWallFront), touchPoint(side, kWallBack)); }
  Curve frontFlank(double side)
  {
    return shell_.segment(onFlank(side, kWallFront, kBaseTop), touchPoint(side, kWallFront));
  }
  Curve backFlank(double side)
  {
    return shell_.segment(onFlank(side, kWallBack, kBaseTop), touchPoint(side, kWallBack));
  }
  Curve flankFoot(double side)
  {
    return shell_.segment(onFlank(side, kWallFront, kBaseTop), onFlank(side, kWallBack, kBaseTop));
  }

  void addWallSide(double side)
  {
    const Vector3 foot = onFlank(side, 0, kBaseTop);
    const Vector3 up = (touchPoint(side, 0) - foot).normalized();
    const Vector3 normal = side * Vector3::UnitY().cross(up);
    shell_.addPatch("wall", planeChart(foot, normal),
                    {Shell::join({flankFoot(side), backFlank(side), crownEnd(side), frontFlank(side)})});
  }

  void addCrown()
  {
    shell_.addPatch("wall", cylinderChart(crown(0), Facing::kOutward),
                    {Shell::join({crownArc(kWallFront), crownEnd(1), crownArc(kWallBack), crownEnd(-1)})});
  }

  // -- gussets, and the fillet between them --

  Curve gussetAcross(double side, double y, double z)
  {
    return shell_.segment({side * kGussetInner, y, z}, {side * kGussetOuter, y, z});
  }
  Curve gussetFoot(double x) { return shell_.segment({x, kGussetFront, kBaseTop}, onGussetFace(x, 0)); }
  Curve gussetToe(double x) { return shell_.segment({x, kGussetFront, kBaseTop}, {x, kGussetFront, kGussetToe}); }
  Curve gussetSlope(double x) { return shell_.segment({x, kGussetFront, kGussetToe}, {x, kWallFront, kGussetTop}); }
  Curve gussetBack(double x) { return shell_.segment(onGussetFace(x, 1), {x, kWallFront, kGussetTop}); }

  // Where the corner of base and wall starts, 0, and ends, 1, on a gusset: rounded on the inner face, sharp outside.
  [[nodiscard]] static Vector3 onGussetFace(double x, double t)
  {
    return std::abs(x) == kGussetInner ? onFillet(t, x) : Vector3(x, kWallFront, kBaseTop);
  }

  void addGusset(double side)
  {
    const std::string name = side < 0 ? "gusset_1" : "gusset_2";
    const double inner = side * kGussetInner, outer = side * kGussetOuter;
    shell_.addPatch(name, planeChart({inner, 0, 0}, -side * Vector3::UnitX()),
                    {Shell::join({gussetFoot(inner), gussetToe(inner), gussetSlope(inner), gussetBack(inner),
                                  filletProfile(inner)})});
    shell_.addPatch(name, planeChart({outer, 0, 0}, side * Vector3::UnitX()),
                    {Shell::join({gussetFoot(outer), gussetToe(outer), gussetSlope(outer), gussetBack(outer)})});
    const Curve low = gussetAcross(side, kGussetFront, kBaseTop);
    const Curve middle = gussetAcross(side, kGussetFront, kGussetToe);
    const Curve high = gussetAcross(side, kWallFront, kGussetTop);
    shell_.addPatch(name, planeChart({0, kGussetFront, 0}, -Vector3::UnitY()),
                    {Shell::join({low, gussetToe(inner), middle, gussetToe(outer)})});
    const Vector3 slope = Vector3(0, kWallFront - kGussetFront, kGussetTop - kGussetToe).normalized();
    shell_.addPatch(name, planeChart({0, kGussetFront, kGussetToe}, Vector3::UnitX().cross(slope)),
                    {Shell::join({middle, gussetSlope(inner), high, gussetSlope(outer)})});
  }

  Curve filletLine(double t, double fromX, double toX) { return shell_.segment(onFillet(t, fromX), onFillet(t, toX)); }

  void addFillet()
  {
    const Vector3 middle = Vector3(0, 1, -1).normalized(), onward = Vector3(0, 1, 1).normalized();
    const Chart chart = cylinderChart({{0, kFilletToe, kFilletTop}, middle, onward, kFilletRadius}, Facing::kInward);
    shell_.addPatch("fillet", chart,
                    {Shell::join({filletLine(0, -kGussetInner, kGussetInner), filletProfile(kGussetInner),
                                  filletLine(1, -kGussetInner, kGussetInner), filletProfile(-kGussetInner)})});
  }

  // Where the wall meets the base outside the gussets.
  Curve wallFoot(double side)
  {
    return shell_.segment({side * kGussetOuter, kWallFront, kBaseTop}, {side * kWallFoot, kWallFront, kBaseTop});
  }

  // -- the base plate --

  [[nodiscard]] static Circle baseCorner(double sideX, double sideY, double z)
  {
    const Vector3 outward = Vector3(sideX, sideY, 0).normalized();
    return {{sideX * (kBaseX - kCornerRadius), sideY * (kBaseY - kCornerRadius), z},
            outward,
            Vector3::UnitZ().cross(outward),
            kCornerRadius};
  }
  Curve cornerArc(double sideX, double sideY, double z)
  {
    return shell_.arc(baseCorner(sideX, sideY, z), -pi / 4, pi / 4);
  }
  Curve alongX(double sideY, double z)
  {
    constexpr double kReach = kBaseX - kCornerRadius;
    return shell_.segment({-kReach, sideY * kBaseY, z}, {kReach, sideY * kBaseY, z});
  }
  Curve alongY(double sideX, double z)
  {
    constexpr double kReach = kBaseY - kCornerRadius;
    return shell_.segment({sideX * kBaseX, -kReach, z}, {sideX * kBaseX, kReach, z});
  }
  Curve backStep(double side)
  {
    return shell_.segment(onFlank(side, kWallBack, kBaseTop), {side * (kBaseX - kCornerRadius), kBaseY, kBaseTop});
  }
  Curve upright(double x, double y) { return shell_.segment({x, y, 0}, {x, y, kBaseTop}); }

  void addBaseSides()
  {
    constexpr double kReachX = kBaseX - kCornerRadius, kReachY = kBaseY - kCornerRadius;
    shell_.addPatch(
        "base", planeChart({0, -kBaseY, 0}, -Vector3::UnitY()),
        {Shell::join({alongX(-1, 0), upright(kReachX, -kBaseY), alongX(-1, kBaseTop), upright(-kReachX, -kBaseY)})});
    for (const double side : kSides) {
      const double x = side * kBaseX;
      shell_.addPatch(
          "base", planeChart({x, 0, 0}, side * Vector3::UnitX()),
          {Shell::join({alongY(side, 0), upright(x, kReachY), alongY(side, kBaseTop), upright(x, -kReachY)})});
      for (const double sideY : kSides) addBaseCorner(side, sideY);
    }
  }

  void addBaseCorner(double sideX, double sideY)
  {
    constexpr double kReachX = kBaseX - kCornerRadius, kReachY = kBaseY - kCornerRadius;
    shell_.addPatch("base", cylinderChart(baseCorner(sideX, sideY, 0), Facing::kOutward),
                    {Shell::join({cornerArc(sideX, sideY, 0), upright(sideX * kBaseX, sideY * kReachY),
                                  cornerArc(sideX, sideY, kBaseTop), upright(sideX * kReachX, sideY * kBaseY)})});
  }

  void addBaseTop()
  {
    std::vector<Curve> outline{alongX(-1, kBaseTop), cornerArc(1, -1, kBaseTop),
                               alongY(1, kBaseTop),  cornerArc(1, 1, kBaseTop),
                               backStep(1),          flankFoot(1)};
    appendFootprint(outline, 1);
    outline.push_back(filletLine(0, -kGussetInner, kGussetInner));
    appendFootprint(outline, -1);
    for (const Curve& curve :
         {flankFoot(-1), backStep(-1), cornerArc(-1, 1, kBaseTop), alongY(-1, kBaseTop), cornerArc(-1, -1, kBaseTop)}) {
      outline.push_back(curve);
    }
    std::vector<Ring> rings{Shell::join(outline)};
    rings.insert(rings.end(), topHoles_.begin(), topHoles_.end());
    shell_.addPatch("base", planeChart({0, 0, kBaseTop}, Vector3::UnitZ()), rings);
  }

  // The border of base and fillet on one side, around the foot of the gusset, from right to left.
  void appendFootprint(std::vector<Curve>& outline, double side)
  {
    std::vector<Curve> part{wallFoot(side), gussetFoot(side * kGussetOuter), gussetAcross(side, kGussetFront, kBaseTop),
                            gussetFoot(side * kGussetInner)};
    if (side < 0) std::ranges::reverse(part);
    outline.insert(outline.end(), part.begin(), part.end());
  }

  void addBaseBottom()
  {
    std::vector<Ring> rings{Shell::join({alongX(-1, 0), cornerArc(1, -1, 0), alongY(1, 0), cornerArc(1, 1, 0),
                                         alongX(1, 0), cornerArc(-1, 1, 0), alongY(-1, 0), cornerArc(-1, -1, 0)})};
    rings.insert(rings.end(), bottomHoles_.begin(), bottomHoles_.end());
    shell_.addPatch("base", planeChart({0, 0, 0}, -Vector3::UnitZ()), rings);
  }

  // -- the large faces of the wall --

  void addWallFront()
  {
    const Ring outline = Shell::join({crownArc(kWallFront), frontFlank(1), wallFoot(1), gussetBack(kGussetOuter),
                                      gussetAcross(1, kWallFront, kGussetTop), gussetBack(kGussetInner),
                                      filletLine(1, -kGussetInner, kGussetInner), gussetBack(-kGussetInner),
                                      gussetAcross(-1, kWallFront, kGussetTop), gussetBack(-kGussetOuter), wallFoot(-1),
                                      frontFlank(-1)});
    shell_.addPatch("wall", planeChart({0, kWallFront, 0}, -Vector3::UnitY()), {outline, bossRoot_});
  }

  void addWallBack()
  {
    constexpr double kReach = kBaseX - kCornerRadius;
    const Ring outline = Shell::join({crownArc(kWallBack), backFlank(1), backStep(1), upright(kReach, kBaseY),
                                      alongX(1, 0), upright(-kReach, kBaseY), backStep(-1), backFlank(-1)});
    shell_.addPatch("wall", planeChart({0, kWallBack, 0}, Vector3::UnitY()), {outline, boreEnd_});
  }

  // -- bore, boss, holes, pads --

  // The axis through `at` that points to the front, or up.
  [[nodiscard]] static Circle frontward(const Vector3& at) { return {at, Vector3::UnitX(), Vector3::UnitZ(), 1}; }
  [[nodiscard]] static Circle upward(const Vector3& at) { return {at, Vector3::UnitX(), Vector3::UnitY(), 1}; }

  void addBore()
  {
    const Circle axis = frontward({0, 0, kBoreHeight});
    const Shell::BandEnds boss = addBoss({axis, 80});
    const Shell::BandEnds seat = addSeat({axis, 64});
    const Shell::BandEnds through =
        addCylinder(shell_, "bore", {axis, 48}, {kThroughRadius, -kSeatDepth}, {kThroughRadius, -kWallBack});
    bossRoot_ = boss.first;
    boreEnd_ = through.last;
    shell_.addPatch("bore", planeChart({0, kSeatDepth, 0}, -Vector3::UnitY()), {seat.last, through.first});
    std::vector<Ring> rings{boss.last, seat.first};
    for (Index i = 0; i < 4; ++i) rings.push_back(addScrewHole(i));
    shell_.addPatch("boss", planeChart({0, kBossFront, 0}, -Vector3::UnitY()), rings);
  }

  // From the root of its fillet on the wall to the rim of its face.
  Shell::BandEnds addBoss(const Revolution& revolution)
  {
    constexpr Index kRootRows = 3;
    std::vector<Meridian> meridian;
    for (Index i = 0; i <= kRootRows; ++i) {
      const double angle = pi / 2 * static_cast<double>(i) / kRootRows;
      meridian.push_back(
          {kBossRadius + kBossRoot * (1 - std::sin(angle)), -kWallFront + kBossRoot * (1 - std::cos(angle))});
    }
    const double edge = revolution.edgeAt(kBossRadius);
    for (const Meridian& point : straightMeridian(meridian.back(), {kBossRadius, -kBossFront}, edge)) {
      meridian.push_back(point);
    }
    return addRevolved(shell_, "boss", revolution, meridian);
  }

  // From the chamfer at the face of the boss to the shoulder.
  Shell::BandEnds addSeat(const Revolution& revolution)
  {
    std::vector<Meridian> meridian{{kSeatRadius + kChamfer, -kBossFront}, {kSeatRadius, -kBossFront - kChamfer}};
    const double edge = revolution.edgeAt(kSeatRadius);
    for (const Meridian& point : straightMeridian(meridian.back(), {kSeatRadius, -kSeatDepth}, edge)) {
      meridian.push_back(point);
    }
    return addRevolved(shell_, "bore", revolution, meridian);
  }

  Ring addScrewHole(Index i)
  {
    const std::string name = "screw_" + std::to_string(i + 1);
    const double angle = pi / 4 + static_cast<double>(i) * pi / 2;
    const Vector3 at(kScrewCircle * std::cos(angle), 0, kBoreHeight + kScrewCircle * std::sin(angle));
    const Shell::BandEnds hole =
        addCylinder(shell_, name, {frontward(at), 14}, {kScrewRadius, -kBossFront}, {kScrewRadius, -kScrewDepth});
    shell_.addPatch(name, planeChart({0, kScrewDepth, 0}, -Vector3::UnitY()), {hole.last});
    return hole.first;
  }

  void addBolts()
  {
    Index number = 0;
    for (const double sideY : kSides) {
      for (const double sideX : kSides) {
        addBolt("bolt_" + std::to_string(++number), upward({sideX * kBoltX, sideY * kBoltY, 0}));
      }
    }
  }

  void addBolt(const std::string& name, const Circle& axis)
  {
    const Shell::BandEnds wide =
        addCylinder(shell_, name, {axis, 32}, {kCounterboreRadius, kBaseTop}, {kCounterboreRadius, kCounterboreFloor});
    const Shell::BandEnds narrow =
        addCylinder(shell_, name, {axis, 26}, {kBoltRadius, kCounterboreFloor}, {kBoltRadius, 0});
    shell_.addPatch(name, planeChart({0, 0, kCounterboreFloor}, Vector3::UnitZ()), {wide.last, narrow.first});
    topHoles_.push_back(wide.first);
    bottomHoles_.push_back(narrow.last);
  }

  void addPads()
  {
    topHoles_.push_back(addPad(shell_, "pad_1", {{0, -17, kBaseTop}, 12, 6, 3, 2.5}));
    topHoles_.push_back(addPad(shell_, "pad_2", {{-kBoltX, 0, kBaseTop}, 6, 6, 6, 2}));
    topHoles_.push_back(addPad(shell_, "pad_3", {{kBoltX, 0, kBaseTop}, 6, 6, 6, 2}));
  }

  Shell shell_{kLargestEdge};
  Ring bossRoot_;
  Ring boreEnd_;
  std::vector<Ring> topHoles_;
  std::vector<Ring> bottomHoles_;
};

}  // namespace

GroupedMesh makeBracket()
{
  return BracketBuilder().build();
}

}  // namespace holdfast::generate
