#include "holdfast/window/model/selected_vertices.h"

namespace holdfast {

SelectedVertices::Found SelectedVertices::of(const Selection& selection)
{
  if (model_ != editor_.model()) {
    selector_.reset();
    model_ = editor_.model();
    selector_.emplace(model_->mesh, model_->solverMesh, model_->locator());
  }
  try {
    return {selector_->select(selection, {}), {}};
  } catch (const InputError& error) {
    return {{}, error.reason()};
  }
}

const Selection* selectionOf(const Constraint& constraint)
{
  return std::visit(
      [](const auto& what) -> const Selection* {
        if constexpr (requires { what.select; })
          return &what.select;
        else
          return nullptr;
      },
      constraint.what);
}

}  // namespace holdfast
