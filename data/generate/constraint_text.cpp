#include "constraint_text.h"

#include <cmath>
#include <utility>

#include "write.h"

namespace holdfast::generate {
namespace {

std::string quoted(const std::string& text)
{
  return '"' + text + '"';
}

std::string joined(const std::vector<std::string>& parts)
{
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string object(const std::vector<std::pair<std::string, std::string>>& members)
{
  std::vector<std::string> parts;
  for (const auto& [key, value] : members) parts.push_back(quoted(key) + ": " + value);
  return "{" + joined(parts) + "}";
}

std::string vectorText(const Vector3& vector)
{
  return "[" + joined({numberText(vector.x()), numberText(vector.y()), numberText(vector.z())}) + "]";
}

std::string pointText(const std::string& name, const Spot& spot, const std::string& key, const Vector3& value)
{
  return object({{"type", quoted("point")}, {"name", quoted(name)}, {"at", atText(spot)}, {key, vectorText(value)}});
}

}  // namespace

std::string inSphere(const Vector3& centre, double radius)
{
  return object({{"sphere", object({{"center", vectorText(centre)}, {"radius", numberText(radius)}})}});
}

std::string inBox(const Vector3& min, const Vector3& max)
{
  return object({{"box", object({{"min", vectorText(min)}, {"max", vectorText(max)}})}});
}

std::string inHalfSpace(const Vector3& point, const Vector3& normal)
{
  return object({{"halfspace", object({{"point", vectorText(point)}, {"normal", vectorText(normal)}})}});
}

std::string inComponent(Index component)
{
  return object({{"component", std::to_string(component)}});
}

std::string inCurve(const std::vector<Vector3>& places)
{
  std::vector<std::string> through;
  for (const Vector3& place : places) through.push_back(object({{"near", vectorText(place)}}));
  return object({{"curve", object({{"through", "[" + joined(through) + "]"}})}});
}

std::string allOf(const std::vector<std::string>& parts)
{
  return object({{"all", "[" + joined(parts) + "]"}});
}

std::string anyOf(const std::vector<std::string>& parts)
{
  return object({{"any", "[" + joined(parts) + "]"}});
}

std::string notIn(const std::string& part)
{
  return object({{"not", part}});
}

std::string fixedText(const std::string& name, const std::string& select)
{
  return object({{"type", quoted("fixed")}, {"name", quoted(name)}, {"select", select}});
}

std::string pointTo(const std::string& name, const Spot& spot, const Vector3& target)
{
  return pointText(name, spot, "target", target);
}

std::string pointBy(const std::string& name, const Spot& spot, const Vector3& move)
{
  return pointText(name, spot, "move", move);
}

std::string pointInFace(const std::string& name, Index face, const std::array<double, 3>& weights, const Vector3& move)
{
  const std::string at =
      object({{"face", std::to_string(face)}, {"weights", vectorText({weights[0], weights[1], weights[2]})}});
  return object({{"type", quoted("point")}, {"name", quoted(name)}, {"at", at}, {"move", vectorText(move)}});
}

std::string rigidText(const std::string& name, const std::string& select)
{
  return object({{"type", quoted("rigid")}, {"name", quoted(name)}, {"select", select}});
}

std::string relativeText(const std::string& name, const Spot& from, const Spot& to,
                         const std::optional<Vector3>& offset)
{
  std::vector<std::pair<std::string, std::string>> members{
      {"type", quoted("relative")}, {"name", quoted(name)}, {"from", atText(from)}, {"to", atText(to)}};
  if (offset) members.emplace_back("offset", vectorText(*offset));
  return object(members);
}

std::string handleText(const std::string& name, const std::string& select, const TurnText& turn,
                       const Vector3& translate)
{
  std::vector<std::pair<std::string, std::string>> members{{"axis", vectorText(turn.axis)},
                                                           {"degrees", numberText(turn.degrees)}};
  if (turn.center) members.emplace_back("center", vectorText(*turn.center));
  const std::string rotate = object(members);
  return object({{"type", quoted("handle")},
                 {"name", quoted(name)},
                 {"select", select},
                 {"rotate", rotate},
                 {"translate", vectorText(translate)}});
}

std::string handleText(const std::string& name, const std::string& select, const Vector3& translate)
{
  return object(
      {{"type", quoted("handle")}, {"name", quoted(name)}, {"select", select}, {"translate", vectorText(translate)}});
}

std::string constraintFile(const std::vector<std::string>& constraints)
{
  std::string text = "{\n  \"format\": \"holdfast-constraints\", \"version\": 1, \"units\": \"mm\",\n";
  text += "  \"constraints\": [";
  for (std::size_t i = 0; i < constraints.size(); ++i) text += (i == 0 ? "\n    " : ",\n    ") + constraints[i];
  return text + "\n  ]\n}\n";
}

std::string pointList(const std::vector<MeasuredPoint>& points)
{
  std::string text = "name,x,y,z,target_x,target_y,target_z\n";
  for (const MeasuredPoint& point : points) {
    text += point.name;
    for (const Vector3& place : {point.spot.rest, point.target}) {
      for (const double coordinate : place) text += "," + numberText(coordinate);
    }
    text += "\n";
  }
  return text;
}

}  // namespace holdfast::generate
