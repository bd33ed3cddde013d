#pragma once
/// \file
/// Edits of handles that several sections of the inspector offer.

#include <holdfast/document/handle_restated.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// One of those that say the motion of a handle in another way: `byFrames`, ...
using Restatement = HandleConstraint (*)(const HandleConstraint& handle, const HandleSetting& setting);

/// What the motion of a handle of the editor's list depends on. Throws as that of the list.
[[nodiscard]] HandleSetting settingOf(const Editor& editor, const Constraint& handle);

/// A handle of the editor's list, restated; throws as `restate` and `settingOf`.
[[nodiscard]] Constraint restated(const Editor& editor, Constraint handle, Restatement restate);

/// Throws `InputError` with the key at fault and the reason where the handle says what it may not say
/// (`validateHandle`).
void requireValid(const HandleConstraint& handle);

/// Throws `InputError` where the axis is zero.
void requireAxis(const Vector3& axis);

}  // namespace holdfast
