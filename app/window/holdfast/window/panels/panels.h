#pragma once
/// Makes panels that only show an editor and edit it. The editor outlives them.

#include <QWidget>
#include <functional>
#include <vector>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Makes a panel with a card for each conflict. A card says what cannot hold together, by how much, and what repairs
/// it. Below the cards the panel shows constraints that only repeat others.
[[nodiscard]] QWidget* newConflictPanel(Editor& editor);

/// Makes a panel with a card for each finding. The card's button selects constraints, or calls `showVertices` with
/// vertices of the file.
[[nodiscard]] QWidget* newFindingsPanel(Editor& editor,
                                        const std::function<void(const std::vector<Index>&)>& showVertices);

/// Returns the vertices that a finding names, ascending. If it names faces, these are the vertices of the faces. There
/// are none if it names constraints.
[[nodiscard]] std::vector<Index> verticesOf(const Finding& finding, const Mesh& mesh);

/// Makes a panel that shows what is under the cursor, probes and rulers. It shows their places and lengths and the
/// values of all fields, now and at rest.
[[nodiscard]] QWidget* newMeasuredPanel(Editor& editor);

/// Makes a panel that lists the names of saved selections. The user selects, renames and deletes them there.
[[nodiscard]] QWidget* newSelectionsPanel(Editor& editor);

/// Makes a panel that shows how the mesh was solved. The user chooses weights and solver there.
[[nodiscard]] QWidget* newReportPanel(Editor& editor);

}  // namespace holdfast
