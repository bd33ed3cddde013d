#pragma once
/// \file
/// Which vertices the selection of a constraint names, on the mesh that an editor holds.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraints/selector.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Selects for panels. What selections share is made when the first one asks for it.
class SelectedVertices {
 public:
  /// `editor` stays alive as long as this.
  explicit SelectedVertices(const Editor& editor) : editor_(editor) {}

  /// The vertices, ascending; or none, and why. A mesh is open. O(N) per node of the expression.
  struct Found {
    std::vector<Index> vertices;
    std::string reason;  ///< why the selection makes no sense; empty where it does
  };
  [[nodiscard]] Found of(const Selection& selection);

 private:
  const Editor& editor_;
  std::shared_ptr<const Model> model_;
  std::optional<Selector> selector_;
};

/// The selection of a fixed, rigid or handle constraint; null of others.
[[nodiscard]] const Selection* selectionOf(const Constraint& constraint);

}  // namespace holdfast
