#pragma once
/// \file
/// A mesh and constraints of the project's data, open in an editor.

#include <string>

#include <holdfast/window/model/editor.h>

namespace holdfast::test {

/// Opens `mesh` and `constraints`, names in the data folder, and waits for the first deformation. False where it does
/// not come.
[[nodiscard]] bool openData(Editor& editor, const std::string& mesh, const std::string& constraints);

/// Opens any mesh with any list.
[[nodiscard]] bool openMesh(Editor& editor, Mesh mesh, ConstraintList list);

/// Waits for the deformation of the state on screen.
[[nodiscard]] bool waitForCurrent(const Editor& editor);

}  // namespace holdfast::test
