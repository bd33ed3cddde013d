#include <algorithm>
#include <sstream>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtk_error_log.h>
#include <holdfast/widgets/files/vtp_reader.h>

namespace holdfast {
namespace {

/// VTK's parser, by expat. It throws nothing, for what it would throw would pass through functions of C.
class XmlTreeBuilder final : public vtkXMLParser {
 public:
  static XmlTreeBuilder* New();

  [[nodiscard]] bool isTooDeep() const { return isTooDeep_; }
  [[nodiscard]] bool isTooLong() const { return textSize_ > mostText_; }
  /// Characters between tags, of all elements together, at most.
  void allowText(std::size_t most) { mostText_ = most; }
  [[nodiscard]] XmlElement takeRoot() { return std::move(top_.children.at(0)); }

 private:
  XmlTreeBuilder() { open_.push_back(&top_); }

  void StartElement(const char* name, const char** attributes) override
  {
    constexpr std::size_t kMostLevels = 32;
    isTooDeep_ = isTooDeep_ || open_.size() > kMostLevels;
    if (isTooDeep_) return;
    XmlElement& element = open_.back()->children.emplace_back();
    element.name = name;
    element.place = static_cast<std::size_t>(GetXMLByteIndex());
    for (; *attributes != nullptr; attributes += 2) element.attributes.emplace(attributes[0], attributes[1]);
    // An element has no new siblings while it is open, so that it stays where it is.
    open_.push_back(&element);
  }

  void EndElement(const char* /*name*/) override
  {
    if (!isTooDeep_) open_.pop_back();
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    textSize_ += static_cast<std::size_t>(length);
    if (!isTooLong()) open_.back()->text.append(data, static_cast<std::size_t>(length));
  }

  int ParsingComplete() override { return isTooDeep_ ? 1 : vtkXMLParser::ParsingComplete(); }

  XmlElement top_;  // its child is the root
  std::vector<XmlElement*> open_;
  bool isTooDeep_ = false;
  std::size_t textSize_ = 0;
  std::size_t mostText_ = 0;
};

vtkStandardNewMacro(XmlTreeBuilder);

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

XmlElement parseXml(const std::string& text, const std::string& file)
{
  VtkErrorLog log;
  vtkNew<XmlTreeBuilder> builder;
  log.watch(*builder);
  std::istringstream stream(text);
  builder->SetStream(&stream);
  builder->allowText(text.size());
  const bool isParsed = builder->Parse() != 0;
  if (builder->isTooDeep()) throw InputError({file, 0, ""}, "its elements are nested too deep; the file is damaged");
  if (builder->isTooLong())
    throw InputError({file, 0, ""}, "its entities make it longer than it is; write it anew without them");
  if (!isParsed || !log.isEmpty()) throw InputError({file, 0, ""}, "this is no whole XML file: " + log.first());
  return builder->takeRoot();
}

}  // namespace holdfast
