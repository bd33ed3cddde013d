#pragma once
/// This small document has something of everything that a picture can show.

#include <holdfast/deform/deform.h>

namespace holdfast {

/// A sheet that is pinned, pulled and rotated. Some of its constraints repeat others, some conflict, and one is
/// disabled.
struct ExampleDocument {
  Model model;
  ConstraintList list;
  DeformResult deformation;
};

/// Makes the document. It takes a few milliseconds.
[[nodiscard]] ExampleDocument exampleDocument();

}  // namespace holdfast
