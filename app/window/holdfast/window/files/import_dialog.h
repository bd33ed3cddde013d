#pragma once
/// What the constraints of a file would do to the document, before they are taken in.

#include <filesystem>

#include <holdfast/window/model/editor.h>

class QDialog;
class QWidget;

namespace holdfast {

/// A dialog that reads a constraint file or a point list on a thread of its own and shows it as a table; those that are
/// ticked become one edit, at the end of the list. Points farther from the surface than a tolerance are highlighted,
/// and left out unless the user ticks them. The editor has an open document.
[[nodiscard]] QDialog* newImportDialog(Editor& editor, const std::filesystem::path& path, QWidget* parent = nullptr);

}  // namespace holdfast
