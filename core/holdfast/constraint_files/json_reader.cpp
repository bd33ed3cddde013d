#include <algorithm>
#include <cassert>
#include <limits>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file_text_internal.h>
#include <holdfast/constraint_files/json_reader_internal.h>

namespace holdfast {
namespace {

const JsonMember* findMember(const JsonObject& object, std::string_view key)
{
  const auto found = std::find_if(object.begin(), object.end(), [&](const JsonMember& m) { return m.key == key; });
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

void JsonReader::requireKeys(std::span<const std::string_view> known) const
{
  for (const JsonMember& member : object()) {
    const auto at = [&](const JsonValue& value) { return JsonReader(value, file_, memberPath(path_, member.key)); };
    if (std::find(known.begin(), known.end(), member.key) == known.end())
      at(member.value).fail("unknown key {}{}", inQuotes(member.key), spellingHint(member.key, known));
    if (findMember(object(), member.key) != &member) at(*value_).fail("this key stands here more than once; keep one");
  }
}

bool JsonReader::has(std::string_view key) const
{
  return findMember(object(), key) != nullptr;
}

std::string_view JsonReader::oneKeyOf(std::span<const std::string_view> choices) const
{
  std::vector<std::string_view> found;
  for (const std::string_view choice : choices)
    if (has(choice)) found.push_back(choice);
  if (found.empty()) fail("one of these keys is missing: {}", listInQuotes(choices));
  if (found.size() > 1) fail("{} exclude one another; keep one", listInQuotes(found));
  return found.front();
}

JsonReader JsonReader::operator[](std::string_view key) const
{
  const JsonMember* member = findMember(object(), key);
  if (member == nullptr) fail("the key {} is missing; add it", inQuotes(key));
  return {member->value, file_, memberPath(path_, key)};
}

std::size_t JsonReader::sizeAboveZero() const
{
  if (array().empty()) fail("the list is empty; give at least one element");
  return size();
}

void JsonReader::requireSize(std::size_t count, std::string_view meaning) const
{
  if (size() != count) fail("a list of {} is expected, {}; this one has {}", count, meaning, size());
}

JsonReader JsonReader::element(std::size_t place) const
{
  assert(place < size());
  return {array()[place], file_, elementPath(path_, place)};
}

double JsonReader::number() const
{
  if (const auto* value = std::get_if<double>(&value_->what)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&value_->what)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&value_->what)) return static_cast<double>(*value);
  failKind("a number");
}

Index JsonReader::integer() const
{
  if (const auto* value = std::get_if<std::int64_t>(&value_->what)) return *value;
  if (const auto* value = std::get_if<double>(&value_->what))
    fail("{} is not an integer of at most 64 bits, written without point and exponent", *value);
  const auto* value = std::get_if<std::uint64_t>(&value_->what);
  if (value == nullptr) failKind("an integer");
  if (*value > static_cast<std::uint64_t>(std::numeric_limits<Index>::max()))
    fail("{} is too large for an integer here; the largest is {}", *value, std::numeric_limits<Index>::max());
  return static_cast<Index>(*value);
}

Index JsonReader::id() const
{
  const Index value = integer();
  if (value < 0) fail("{} is negative; ids count from 0 in the order of the mesh file", value);
  return value;
}

Vector3 JsonReader::vector() const
{
  requireSize(3, "[x, y, z]");
  return {element(0).number(), element(1).number(), element(2).number()};
}

Vector3 JsonReader::direction() const
{
  const Vector3 value = vector();
  if ((value.array() == 0).all()) fail("a direction cannot be zero in x, y and z; its length does not matter");
  return value;
}

void JsonReader::fail(const std::string& reason) const
{
  throw InputError({std::string(file_), 0, namedPath(path_)}, reason);
}

void JsonReader::failBelow(const std::string& key, const std::string& reason) const
{
  throw InputError({std::string(file_), 0, path_ + key}, reason);
}

void JsonReader::failKind(std::string_view expected) const
{
  fail("{} is expected here, this is {}", expected, kindOf(*value_));
}

}  // namespace holdfast
