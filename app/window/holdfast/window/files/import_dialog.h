#pragma once
/// Shows what the constraints of a file would do to the document, before they are taken in.

#include <QDialog>
#include <QWidget>
#include <filesystem>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Makes a dialog that reads a constraint file or a point list on a thread of its own. What the user ticks becomes one
/// edit, at the end of the list. Points farther from the surface than a tolerance are left out at first. The editor has
/// an open document.
[[nodiscard]] QDialog* newImportDialog(Editor& editor, const std::filesystem::path& path, QWidget* parent = nullptr);

}  // namespace holdfast
