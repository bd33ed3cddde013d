#pragma once
/// The panel that shows what is selected with all digits, and edits it by typing.

#include <QWidget>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The selected constraints of an editor, which outlives the panel: one in full, of several what they have in common.
[[nodiscard]] QWidget* newInspectorPanel(Editor& editor);

}  // namespace holdfast
