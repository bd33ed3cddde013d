#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file_json_internal.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/constraints/handle_validation.h>

namespace holdfast {
namespace {

using Motion = decltype(HandleConstraint::motion);

constexpr std::array<std::string_view, 4> kMotions{"rotate", "turn", "frame", "targets"};
constexpr std::array<std::string_view, 6> kNeeded{"rotate", "turn", "frame", "targets", "translate", "rotations"};
constexpr std::array<std::string_view, 1> kTurns{"about-fixed"};

bool hasAnyOf(const JsonReader& json, std::span<const std::string_view> keys)
{
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return json.has(key); });
}

AxisRotation readAxisRotation(const JsonReader& json)
{
  json.requireKeys({"axis", "degrees", "center"});
  AxisRotation turn{json["axis"].direction(), json["degrees"].number(), std::nullopt};
  if (json.has("center")) turn.center = json["center"].vector();
  return turn;
}

AxisAngle readAxisAngle(const JsonReader& json)
{
  json.requireKeys({"axis", "degrees"});
  return {json["axis"].direction(), json["degrees"].number()};
}

RotationAboutFixed readRotationAboutFixed(const JsonReader& handle)
{
  const JsonReader json = handle["turn"];
  if (json.text() != kTurns[0])
    json.fail("unknown way to turn {}{}", inQuotes(json.text()), spellingHint(json.text(), kTurns));
  if (!handle.has("translate"))
    json.fail(R"(the handle turns as "translate" moves it about the fixed vertices; add "translate")");
  if (!handle.has("turn_near")) return {};
  return {readAxisAngle(handle["turn_near"])};
}

Frame readFrame(const JsonReader& json)
{
  json.requireKeys({"origin", "x", "y"});
  Frame frame;
  if (json.has("origin")) frame.origin = json["origin"].vector();
  if (json.has("x")) frame.x = json["x"].direction();
  if (json.has("y")) frame.y = json["y"].direction();
  return frame;
}

FrameMotion readFrameMotion(const JsonReader& json)
{
  json.requireKeys({"from", "to", "turns"});
  FrameMotion motion;
  if (json.has("from")) motion.from = readFrame(json["from"]);
  motion.to = readFrame(json["to"]);
  if (json.has("turns")) motion.turns = json["turns"].integer();
  return motion;
}

VertexTargets readTargets(const JsonReader& json)
{
  VertexTargets targets;
  for (std::size_t k = 0; k < json.sizeAboveZero(); ++k) targets.places.push_back(json.element(k).vector());
  return targets;
}

std::vector<AxisAngle> readRotations(const JsonReader& json)
{
  std::vector<AxisAngle> rotations;
  for (std::size_t k = 0; k < json.sizeAboveZero(); ++k) rotations.push_back(readAxisAngle(json.element(k)));
  return rotations;
}

Motion readMotion(const JsonReader& json)
{
  if (json.has("turn_near") && !json.has("turn"))
    json.failBelow(".turn_near", R"(says which "turn" is meant, and there is none; add "turn": "about-fixed")");
  if (!hasAnyOf(json, kMotions)) return std::monostate{};
  const std::string_view kind = json.oneKeyOf(kMotions);
  if (kind == "rotate") return readAxisRotation(json[kind]);
  if (kind == "turn") return readRotationAboutFixed(json);
  if (kind == "frame") return readFrameMotion(json[kind]);
  return readTargets(json[kind]);
}

}  // namespace

HandleConstraint readHandle(const JsonReader& json)
{
  HandleConstraint handle{readSelection(json["select"]), {}, Vector3::Zero(), {}};
  if (!hasAnyOf(json, kNeeded))
    json.fail(R"(a handle needs "rotate", "translate" or both, or another way to go: "turn", "frame", "targets", )"
              R"("rotations"; "fixed" is the type of what stays where it is)");
  handle.motion = readMotion(json);
  if (json.has("translate")) handle.translate = json["translate"].vector();
  if (json.has("rotations")) handle.rotations = readRotations(json["rotations"]);
  if (const std::optional<HandleError> error = validateHandle(handle)) json.failBelow(error->key, error->reason);
  return handle;
}

}  // namespace holdfast
