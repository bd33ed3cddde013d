#include <algorithm>
#include <cassert>
#include <limits>

#include <holdfast/constraint_files/constraint_file_internal.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/words/spelling.h>

namespace holdfast {
namespace {

// More than a constraint file can need, and little enough to recurse.
constexpr std::size_t kMaximumJsonDepth = 300;

/// From 1, the column in bytes.
struct TextPlace {
  Index line = 1;
  Index column = 1;
};

/// The place of byte `offset`, or of the end.
TextPlace placeInText(std::string_view text, std::size_t offset)
{
  const std::string_view before = text.substr(0, offset);
  const auto column = static_cast<Index>(before.size() - (before.rfind('\n') + 1)) + 1;  // no line end: npos + 1 is 0
  return {static_cast<Index>(std::count(before.begin(), before.end(), '\n')) + 1, column};
}

bool isPlainWord(std::string_view key)
{
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  constexpr std::size_t kLongestWord = 60;
  return !key.empty() && key.size() <= kLongestWord && std::all_of(key.begin(), key.end(), isPlain);
}

std::string namedPath(const std::string& path)
{
  return path.empty() ? "top level" : path;
}

std::string memberPath(const std::string& path, std::string_view key)
{
  if (!isPlainWord(key)) return fmt::format("{}[{}]", path, inQuotes(key));
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::string elementPath(const std::string& path, std::size_t place)
{
  // Once for each element of a list that is read, most of them for no message: piece by piece this takes half the time.
  std::string element;
  element.reserve(path.size() + std::numeric_limits<std::size_t>::digits10 + 3);
  element.append(path).append(1, '[').append(fmt::format_int(place).c_str()).append(1, ']');
  return element;
}

/// What the parser's message says once its own number and place are taken off.
std::string causeOf(const nlohmann::json::exception& error)
{
  const std::string_view message = error.what();
  const std::size_t colon = message.find(": ");
  return std::string(colon == std::string_view::npos ? message : message.substr(colon + 2));
}

/// The number that `digits` say. The parser's own conversion depends on the locale, and cuts numbers short where the
/// decimal sign takes several bytes; it has also put that sign into `digits`.
ParsedNumber<double> doubleFrom(std::string digits)
{
  constexpr std::string_view kPlain = "0123456789+-eE";
  std::replace_if(
      digits.begin(), digits.end(), [&](char c) { return kPlain.find(c) == std::string_view::npos; }, '.');
  return parseNumber<double>(digits);
}

JsonValue::object_t& membersOf(JsonValue& object)
{
  return object.get_ref<JsonValue::object_t&>();
}

/// Receives the parser's events and grows the tree. The parser itself does not recurse.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) { return open(JsonValue::object()); }
  bool start_array(std::size_t /*size*/) { return open(JsonValue::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool number_float(double /*value*/, const std::string& digits)
  {
    const auto [value, fault] = doubleFrom(digits);
    place(value);
    if (fault != NumberFault::None)
      throw InputError({std::string(file_), 0, namedPath(openPath())},
                       fmt::format("{} does not fit a number in double precision", shortened(digits)));
    return true;
  }

  bool key(std::string& key)
  {
    membersOf(*open_.back()).emplace_back(std::move(key), nullptr);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error)
  {
    constexpr int kNumberOverflow = 406;
    const TextPlace place = placeInText(text_, position == 0 ? 0 : position - 1);
    const std::string reason =
        error.id == kNumberOverflow
            ? fmt::format("{} is too large for a number in double precision", shortened(token))
            : fmt::format(
                  "not valid JSON: {}. (JSON knows no comments, no comma before a closing bracket, no NaN; "
                  "keys and text stand in double quotes)",
                  cut(causeOf(error)));
    throw InputError({std::string(file_), place.line, fmt::format("column {}", place.column)}, reason);
  }

  JsonValue finish() { return std::move(root_); }

 private:
  /// The parser quotes the text that it could not read, which may be long.
  static std::string cut(const std::string& cause)
  {
    const std::size_t lastRead = cause.find("last read: '");
    if (lastRead == std::string::npos) return cause;
    const std::size_t token = cause.find('\'', lastRead) + 1;
    const std::size_t end = cause.rfind('\'');
    return cause.substr(0, token) + shortened(std::string_view(cause).substr(token, end - token)) + cause.substr(end);
  }

  JsonValue* place(JsonValue value)
  {
    JsonValue* target = &root_;
    if (!open_.empty() && open_.back()->is_array())
      target = &open_.back()->emplace_back(nullptr);
    else if (!open_.empty())
      target = &membersOf(*open_.back()).back().second;
    *target = std::move(value);
    return target;
  }

  bool add(JsonValue value)
  {
    place(std::move(value));
    return true;
  }

  bool open(JsonValue container)
  {
    // The containers that are open do not grow while a child of theirs is open, so that the addresses last.
    open_.push_back(place(std::move(container)));
    if (open_.size() <= kMaximumJsonDepth) return true;
    throw InputError({std::string(file_), 0, shortened(namedPath(openPath()))},
                     fmt::format("lists and objects are nested deeper than {}; take levels out", kMaximumJsonDepth));
  }

  bool close()
  {
    open_.pop_back();
    return true;
  }

  [[nodiscard]] std::string openPath() const
  {
    std::string path;
    for (JsonValue* const container : open_) {
      if (container->empty()) continue;
      path = container->is_array() ? elementPath(path, container->size() - 1)
                                   : memberPath(path, membersOf(*container).back().first);
    }
    return path;
  }

  std::string_view text_;
  std::string_view file_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
};

const JsonValue::object_t::value_type* findMember(const JsonValue::object_t& object, std::string_view key)
{
  const auto found = std::ranges::find(object, key, &JsonValue::object_t::value_type::first);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

std::string_view requireUtf8(std::string_view text, std::string_view file)
{
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError({std::string(file), 1, ""}, "not UTF-8 text but UTF-16; save the file in the encoding UTF-8");
  for (std::size_t offset = 0; offset < text.size();) {
    const std::size_t length = utf8Length(text.substr(offset));
    if (length == 0)
      throw InputError({std::string(file), placeInText(text, offset).line, ""},
                       fmt::format("not UTF-8 text (byte 0x{:02X}); save the file in the encoding UTF-8",
                                   static_cast<unsigned char>(text[offset])));
    offset += length;
  }
  return text;
}

std::string listInQuotes(std::span<const std::string_view> words)
{
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + inQuotes(word);
  return list;
}

std::string spellingHint(std::string_view word, std::span<const std::string_view> known)
{
  const std::optional<std::string_view> closest = closestSpelling(word, known);
  const std::string guess = closest ? fmt::format("; did you mean {}? ", inQuotes(*closest)) : "; ";
  return fmt::format("{}Known here: {}", guess, listInQuotes(known));
}

JsonValue parseJson(std::string_view text, std::string_view file)
{
  const std::string_view characters = requireUtf8(text, file);
  if (characters.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InputError({std::string(file), 1, ""}, "the file is empty; a JSON text is expected");
  TreeBuilder builder(characters, file);
  nlohmann::json::sax_parse(characters.begin(), characters.end(), &builder);
  return builder.finish();
}

void JsonReader::requireKeys(std::span<const std::string_view> known) const
{
  for (const auto& member : object()) {
    const std::string& key = member.first;
    const auto at = [&] { return JsonReader(member.second, file_, memberPath(path_, key)); };
    if (std::find(known.begin(), known.end(), key) == known.end())
      at().fail("unknown key {}{}", inQuotes(key), spellingHint(key, known));
    if (findMember(object(), key) != &member) at().fail("this key stands here more than once; keep one");
  }
}

std::vector<std::string_view> JsonReader::keys() const
{
  std::vector<std::string_view> keys;
  for (const auto& member : object()) keys.emplace_back(member.first);
  requireKeys(std::span<const std::string_view>(keys));
  return keys;
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
  const auto* const member = findMember(object(), key);
  if (member == nullptr) fail("the key {} is missing; add it", inQuotes(key));
  return {member->second, file_, memberPath(path_, key)};
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
  if (!value_->is_number()) failKind("a number");
  return value_->get<double>();
}

Index JsonReader::integer() const
{
  if (value_->is_number_float())
    fail("{} is not an integer of at most 64 bits, written without point and exponent", value_->get<double>());
  if (!value_->is_number_integer()) failKind("an integer");
  constexpr Index kLargest = std::numeric_limits<Index>::max();
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > static_cast<std::uint64_t>(kLargest))
    fail("{} is too large for an integer here; the largest is {}", value_->get<std::uint64_t>(), kLargest);
  return value_->get<Index>();
}

Index JsonReader::id() const
{
  const Index value = integer();
  if (value < 0) fail("{} is negative; ids count from 0 in the order of the mesh file", value);
  return value;
}

std::size_t JsonReader::choice(std::span<const std::string_view> names, fmt::string_view unknown) const
{
  const auto found = std::find(names.begin(), names.end(), text());
  if (found == names.end())
    fail("{}{}", fmt::format(fmt::runtime(unknown), inQuotes(text())), spellingHint(text(), names));
  return static_cast<std::size_t>(found - names.begin());
}

Vector3 JsonReader::vector() const
{
  requireSize(3, "[x, y, z]");
  return {element(0).number(), element(1).number(), element(2).number()};
}

std::array<std::optional<double>, 3> JsonReader::coordinates() const
{
  requireSize(3, "[x, y, z]");
  std::array<std::optional<double>, 3> values;
  for (std::size_t k = 0; k < 3; ++k)
    if (const JsonReader value = element(k); !value.value_->is_null()) values[k] = value.number();
  if (!values[0] && !values[1] && !values[2])
    fail("no coordinate is given; give one at least, and null for those in which the point is free");
  return values;
}

Vector3 JsonReader::direction() const
{
  Vector3 value = vector();
  if ((value.array() == 0).all()) fail("a direction cannot be zero in x, y and z; its length does not matter");
  return value;
}

void JsonReader::failBelow(const std::string& key, const std::string& reason) const
{
  throw InputError({std::string(file_), 0, namedPath(path_ + key)}, reason);
}

void JsonReader::failKind(std::string_view expected) const
{
  // In the order of `nlohmann::json::value_t`.
  constexpr std::array kKinds{"null",          "an object",  "a list",     "text",
                              "true or false", "an integer", "an integer", "a number"};
  fail("{} is expected here, this is {}", expected, kKinds[static_cast<std::size_t>(value_->type())]);
}

}  // namespace holdfast
