#include "holdfast/base/error.h"

#include <utility>

namespace holdfast {
namespace {

std::string sentence(const InputLocation& location, const std::string& reason)
{
  std::string text = location.file;
  if (location.line > 0) text += ":" + std::to_string(location.line);
  if (!location.element.empty()) text += (text.empty() ? "" : ": ") + location.element;
  return text.empty() ? reason : text + ": " + reason;
}

}  // namespace

InputError::InputError(InputLocation location, const std::string& reason)
    : std::runtime_error(sentence(location, reason)), location_(std::move(location)), reason_(reason)
{
}

OutputError::OutputError(std::string path, const std::string& reason)
    : std::runtime_error(path + ": " + reason), path_(std::move(path))
{
}

}  // namespace holdfast
