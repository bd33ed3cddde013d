#pragma once
/// A small document with something of everything that a picture can show.

#include <holdfast/deform/deform.h>

namespace holdfast {

/// A sheet that is pinned, pulled and rotated, with constraints that repeat, that conflict, and one that is disabled.
struct ExampleDocument {
  Model model;
  ConstraintList list;
  DeformResult deformation;
};

/// A few milliseconds.
[[nodiscard]] ExampleDocument exampleDocument();

}  // namespace holdfast
