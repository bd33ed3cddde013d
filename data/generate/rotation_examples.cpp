#include "rotation_examples.h"

#include <array>
#include <vector>

#include "constraint_text.h"

namespace holdfast::generate {
namespace {

/// Constraints on a disc of the plate that lies at `place`.
std::string discText(const std::string& name, const Vector3& place, const TurnText& turn, const Vector3& translate)
{
  constexpr double kRadius = 9;
  return handleText(name, inSphere(place, kRadius), turn, translate);
}

std::string eyeText(const std::string& name, double x)
{
  constexpr double kReach = 14, kY = -76, kHeight = 25;
  const std::vector<Vector3> around{
      {x + kReach, kY, kHeight}, {x, kY, kHeight + kReach}, {x - kReach, kY, kHeight}, {x, kY, kHeight - kReach}};
  return rigidText(name, inCurve(around));
}

}  // namespace

std::string twistedBar(double degrees)
{
  return constraintFile(
      {fixedText("foot", inHalfSpace({0, 0, 5}, {0, 0, -1})),
       handleText("top", inHalfSpace({0, 0, 95}, {0, 0, 1}), {Vector3::UnitZ(), degrees}, Vector3::Zero())});
}

std::string plateBetweenTwoHandles()
{
  return constraintFile({discText("left", {22, 50, 0}, {{0, -1, 0}, 45}, {8, 0, 12}),
                         discText("right", {78, 50, 0}, {{1, 0, 0}, 45}, {0, 0, 12})});
}

std::string plateBetweenThreeHandles()
{
  return constraintFile({discText("left", {22, 26, 0}, {{1, -2, 0}, 35}, {6, 3, 10}),
                         discText("right", {78, 26, 0}, {{1, 2, 0}, 35}, {-6, 3, 10}),
                         discText("rear", {50, 80, 0}, {{-1, 0, 0}, 35}, {0, -6, 10})});
}

std::string leaningHead()
{
  const Spot nose{NearSpot{}, {0, -104, 0}};
  const Spot mouth{NearSpot{}, {0, -84, -32}};
  return constraintFile({fixedText("neck", inHalfSpace({0, 0, -92}, {0, 0, -1})),
                         handleText("crown", inHalfSpace({0, 0, 92}, {0, 0, 1}),
                                    {Vector3::UnitY(), -30, Vector3(0, 20, -60)}, Vector3::Zero()),
                         eyeText("left eye", 27), eyeText("right eye", -27),
                         relativeText("mouth to nose", nose, mouth, std::nullopt)});
}

}  // namespace holdfast::generate
