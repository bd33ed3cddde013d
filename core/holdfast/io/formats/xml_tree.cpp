#include "holdfast/io/formats/xml_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <exception>
#include <memory>
#include <new>

#include <expat.h>
#include <fmt/format.h>

#include <holdfast/words/error.h>

namespace holdfast {
namespace {

constexpr std::string_view kXmlBlank = " \t\r\n";

// Expat 2.9 counts in 64 bits everywhere, by functions of other names.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
constexpr auto kCurrentByte = XML_GetCurrentByteIndex64;
constexpr auto kCurrentCount = XML_GetCurrentByteCount64;
constexpr auto kCurrentLine = XML_GetCurrentLineNumber64;
#else
constexpr auto kCurrentByte = XML_GetCurrentByteIndex;
constexpr auto kCurrentCount = XML_GetCurrentByteCount;
constexpr auto kCurrentLine = XML_GetCurrentLineNumber;
#endif

/// Makes a tree of the events that expat reports.
class XmlTreeBuilder {
 public:
  XmlTreeBuilder(std::string_view bytes, const std::string& file, std::string_view last)
      : bytes_(bytes), file_(file), last_(last), parser_(XML_ParserCreate(nullptr), XML_ParserFree)
  {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), onBegin, onEnd);
    XML_SetCharacterDataHandler(parser_.get(), onText);
  }

  [[nodiscard]] XmlElement build()
  {
    constexpr std::size_t kPart = std::size_t{1} << 20U;  // expat counts in int
    bool isWhole = true;
    bool isFinal = false;
    for (std::size_t at = 0; isWhole && !isFinal; at += kPart) {
      const std::string_view part = bytes_.substr(at, kPart);
      isFinal = at + part.size() == bytes_.size();
      isWhole = XML_Parse(parser_.get(), part.data(), static_cast<int>(part.size()), isFinal ? 1 : 0) == XML_STATUS_OK;
    }
    if (fault_ != nullptr) std::rethrow_exception(fault_);
    if (!isWhole && !isAtLast_)
      fail(fmt::format("this is no whole XML file: {}; write it anew",
                       XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    return std::move(top_.children.at(0));
  }

 private:
  static void onBegin(void* self, const XML_Char* name, const XML_Char** attributes)
  {
    guard(self, [&](XmlTreeBuilder& builder) { builder.begin(name, attributes); });
  }

  static void onEnd(void* self, const XML_Char* /*name*/)
  {
    guard(self, [](XmlTreeBuilder& builder) { builder.end(); });
  }

  static void onText(void* self, const XML_Char* data, int size)
  {
    guard(self, [&](XmlTreeBuilder& builder) { builder.addText({data, static_cast<std::size_t>(size)}); });
  }

  /// Nothing may be thrown through functions of C.
  template <class Action>
  static void guard(void* self, const Action& action) noexcept
  {
    auto& builder = *static_cast<XmlTreeBuilder*>(self);
    if (builder.fault_ != nullptr || builder.isAtLast_) return;
    try {
      action(builder);
    } catch (...) {
      builder.fault_ = std::current_exception();
      XML_StopParser(builder.parser_.get(), XML_FALSE);
    }
  }

  void begin(std::string_view name, const XML_Char** attributes)
  {
    constexpr std::size_t kMostLevels = 32;
    if (open_.size() > kMostLevels) fail("its elements are nested too deep; the file is damaged");
    XmlElement& element = open_.back()->children.emplace_back();
    element.name = name;
    element.place = place();
    element.tagSize = size();
    // Behind those that the tag states there may be others, which a DOCTYPE gives to each element.
    for (int k = 0; k < XML_GetSpecifiedAttributeCount(parser_.get()); k += 2) {
      count(std::string_view(attributes[k + 1]).size());
      element.attributes.emplace(attributes[k], attributes[k + 1]);
    }
    // An element has no new siblings while it is open, so that it stays where it is.
    open_.push_back(&element);
    isAtLast_ = open_.size() == 3 && name == last_;
    if (isAtLast_) XML_StopParser(parser_.get(), XML_FALSE);
  }

  void end() { open_.pop_back(); }

  void addText(std::string_view data)
  {
    count(data.size());
    std::vector<XmlText>& texts = open_.back()->texts;
    // Ends of lines come as LF, whatever the file has.
    const std::string_view stated = bytes_.substr(place(), size());
    const bool isVerbatim = data == stated || (data == "\n" && stated.starts_with('\r'));
    XmlText* const before = texts.empty() ? nullptr : &texts.back();
    if (isVerbatim && before != nullptr && before->resolved.empty() && before->place + before->size == place())
      before->size += size();
    else if (!isVerbatim && before != nullptr && before->place == place())
      before->resolved += data;
    else
      texts.push_back({place(), size(), isVerbatim ? "" : std::string(data)});
  }

  /// Counts what is kept. Only entities make it more than the file.
  void count(std::size_t letters)
  {
    letters_ += letters;
    if (letters_ > bytes_.size()) fail("its entities make it longer than it is; write it anew without them");
  }

  [[nodiscard]] std::size_t place() const { return static_cast<std::size_t>(kCurrentByte(parser_.get())); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(kCurrentCount(parser_.get())); }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw InputError({file_, static_cast<Index>(kCurrentLine(parser_.get())), ""}, reason);
  }

  std::string_view bytes_;
  const std::string& file_;
  std::string_view last_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  XmlElement top_;  // its child is the root
  std::vector<XmlElement*> open_{&top_};
  bool isAtLast_ = false;
  std::size_t letters_ = 0;
  std::exception_ptr fault_;
};

/// The value of an attribute in a tag that is XML, between its quotes. It is empty at the end where there is none.
std::string_view valueIn(std::string_view tag, std::string_view name)
{
  std::size_t at = tag.find_first_of(" \t\r\n/>");
  while ((at = tag.find_first_not_of(kXmlBlank, at)) < tag.size() && tag[at] != '/' && tag[at] != '>') {
    const std::string_view found = tag.substr(at, tag.find_first_of(" \t\r\n=", at) - at);
    const std::size_t quote = tag.find_first_of("\"'", at);
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (found == name) return tag.substr(quote + 1, end - quote - 1);
    at = end + 1;
  }
  return tag.substr(tag.size());
}

}  // namespace

std::optional<std::string_view> XmlElement::attribute(std::string_view wanted) const
{
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? std::nullopt : std::optional<std::string_view>(found->second);
}

const XmlElement* XmlElement::child(std::string_view wanted) const
{
  const auto found = std::ranges::find(children, wanted, &XmlElement::name);
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::text(std::string_view bytes) const
{
  std::string whole;
  for (const XmlText& part : texts) whole += part.in(bytes);
  return whole;
}

XmlElement parseXml(std::string_view bytes, const std::string& file, std::string_view last)
{
  return XmlTreeBuilder(bytes, file, last).build();
}

TextEdit attributeEdit(const XmlElement& element, std::string_view bytes, std::string_view name, std::string value)
{
  assert(element.attribute(name));
  const std::string_view old = valueIn(bytes.substr(element.place, element.tagSize), name);
  return {static_cast<std::size_t>(old.data() - bytes.data()), old.size(), std::move(value)};
}

std::string toXml(std::string_view text)
{
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

}  // namespace holdfast
