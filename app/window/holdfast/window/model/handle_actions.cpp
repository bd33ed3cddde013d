#include "holdfast/window/model/handle_actions.h"

#include <algorithm>
#include <string_view>

#include <holdfast/constraints/handle_validation.h>
#include <holdfast/document/list_edits.h>

namespace holdfast {
namespace {

/// "to y" of ".frame.to.y".
std::string textOf(const std::string& key)
{
  constexpr std::string_view kFrame = ".frame.";
  std::string words = key.substr(key.starts_with(kFrame) ? kFrame.size() : 1);
  std::replace(words.begin(), words.end(), '.', ' ');
  return words;
}

}  // namespace

HandleSetting settingOf(const Editor& editor, const Constraint& handle)
{
  return settingOf(*editor.model(), editor.list(), indexOf(editor.list(), handle.name).value(), {});
}

Constraint restated(const Editor& editor, Constraint handle, Restatement restate)
{
  handle.what = restate(std::get<HandleConstraint>(handle.what), settingOf(editor, handle));
  return handle;
}

void requireValid(const HandleConstraint& handle)
{
  if (const auto error = validateHandle(handle)) throw InputError({}, textOf(error->key) + ": " + error->reason);
}

void requireAxis(const Vector3& axis)
{
  if (axis.isZero(0))
    throw InputError({}, "an axis cannot be zero in x, y and z; type the new direction first, then this 0");
}

}  // namespace holdfast
