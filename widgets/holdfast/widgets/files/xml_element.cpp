#include "holdfast/widgets/files/xml_element.h"

#include <algorithm>
#include <sstream>

#include <vtkNew.h>
#include <vtkXMLParser.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtk_error_log.h>

namespace holdfast {
namespace {

/// VTK's parser, by expat. It throws nothing, for what it would throw would pass through functions of C.
class XmlTreeBuilder final : public vtkXMLParser {
 public:
  static XmlTreeBuilder* New()
  {
    auto* const builder = new XmlTreeBuilder;
    builder->InitializeObjectBase();
    return builder;
  }

  [[nodiscard]] bool isTooDeep() const { return isTooDeep_; }
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
    for (; *attributes != nullptr; attributes += 2) element.attributes.emplace_back(attributes[0], attributes[1]);
    // An element has no new siblings while it is open, so that it stays where it is.
    open_.push_back(&element);
  }

  void EndElement(const char* /*name*/) override
  {
    if (!isTooDeep_) open_.pop_back();
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    open_.back()->text.append(data, static_cast<std::size_t>(length));
  }

  int ParsingComplete() override { return isTooDeep_ ? 1 : vtkXMLParser::ParsingComplete(); }

  XmlElement top_;  // its child is the root
  std::vector<XmlElement*> open_;
  bool isTooDeep_ = false;
};

}  // namespace

std::optional<std::string_view> XmlElement::attribute(std::string_view wanted) const
{
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& entry) { return entry.first == wanted; });
  if (found == attributes.end()) return std::nullopt;
  return found->second;
}

const XmlElement* XmlElement::child(std::string_view wanted) const
{
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const XmlElement& child) { return child.name == wanted; });
  return found == children.end() ? nullptr : &*found;
}

XmlElement parseXml(const std::string& text, const std::string& file)
{
  VtkErrorLog log;
  vtkNew<XmlTreeBuilder> builder;
  log.watch(*builder);
  std::istringstream stream(text);
  builder->SetStream(&stream);
  const bool isParsed = builder->Parse() != 0;
  if (builder->isTooDeep()) throw InputError({file, 0, ""}, "its elements are nested too deep; the file is damaged");
  if (!isParsed || !log.isEmpty()) throw InputError({file, 0, ""}, "this is no whole XML file: " + log.first());
  return builder->takeRoot();
}

}  // namespace holdfast
