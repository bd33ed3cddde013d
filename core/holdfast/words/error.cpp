#include "holdfast/words/error.h"

#include <utility>

#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

std::string sentence(const InputLocation& location, const std::string& reason)
{
  std::string text = location.file;
  if (location.line > 0) text += ":" + std::to_string(location.line);
  if (!location.element.empty()) text += (text.empty() ? "" : ": ") + location.element;
  return printable(text.empty() ? reason : text + ": " + reason, kLongestPrintedMessage);
}

}  // namespace

InputError::InputError(InputLocation location, const std::string& reason)
    : std::runtime_error(sentence(location, reason)), location_(std::move(location)), reason_(reason)
{
}

OutputError::OutputError(std::string path, const std::string& reason)
    : std::runtime_error(sentence({path, 0, {}}, reason)), path_(std::move(path)), reason_(reason)
{
}

}  // namespace holdfast
