#pragma once
/// Panels that only show an editor and edit it. The editor outlives them.

#include <QWidget>
#include <functional>
#include <vector>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// What cannot hold together, by how much, and repairs: a card for each conflict. Below them what only repeats.
[[nodiscard]] QWidget* newConflictPanel(Editor& editor);

/// A card for each finding. Its button selects constraints, or calls `showVertices` with vertices of the file.
[[nodiscard]] QWidget* newFindingsPanel(Editor& editor,
                                        const std::function<void(const std::vector<Index>&)>& showVertices);

/// The vertices that a finding names, those of its faces if it names faces, ascending; none for constraints.
[[nodiscard]] std::vector<Index> verticesOf(const Finding& finding, const Mesh& mesh);

/// What is under the cursor, probes and rulers: places, lengths and the values of all fields, now and at rest.
[[nodiscard]] QWidget* newMeasuredPanel(Editor& editor);

/// Saved selections: a list of names, to select, rename and delete.
[[nodiscard]] QWidget* newSelectionsPanel(Editor& editor);

/// How the mesh was solved, and the choice of weights and solver.
[[nodiscard]] QWidget* newReportPanel(Editor& editor);

}  // namespace holdfast
