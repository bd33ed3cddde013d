#pragma once
/// \file
/// The story in chapters. Each opens what it needs and leaves the window as it found it, but for the document.

#include "stage.h"

namespace holdfast::tour {

/// The empty window, the bracket opened, points under the cursor.
void opening(Stage& stage);
/// A point selected, dragged, undone, typed; what the inspector says.
void moving(Stage& stage);
/// Contradictions and what mends them; findings; the report.
void conflicts(Stage& stage);
/// Colours, ranges, maps, and what is shown beside the surface.
void colors(Stage& stage);
/// The bar that is twisted once around: the sphere of rotations, distributions.
void rotations(Stage& stage);
/// The head: a curve around an eye made rigid; brush, rectangle, lasso, side.
void regions(Stage& stage);
/// Measured points taken in, after a look at them; what is asked before a picture is written.
void dialogs(Stage& stage);
/// Help, dark, small and large windows.
void looks(Stage& stage);
/// A few pictures of everything, for screens of high resolution.
void glance(Stage& stage);
/// Those of the documentation.
void postcards(Stage& stage);

}  // namespace holdfast::tour
