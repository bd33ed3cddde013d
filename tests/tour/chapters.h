#pragma once
/// \file
/// The story in chapters. Each opens what it needs and leaves the window as it found it, but for the document.

#include "tour_window.h"

namespace holdfast::tour {

/// The empty window, the bracket opened, points under the cursor.
void opening(TourWindow& tour);
/// A point selected, dragged, undone, typed; what the inspector says.
void moving(TourWindow& tour);
/// Contradictions and what mends them; findings; the report.
void conflicts(TourWindow& tour);
/// Colours, ranges, maps, and what is shown beside the surface.
void colors(TourWindow& tour);
/// The bar that is twisted once around: the sphere of rotations, distributions.
void rotations(TourWindow& tour);
/// The head: a curve around an eye made rigid; brush, rectangle, lasso, side.
void regions(TourWindow& tour);
/// Measured points taken in, after a look at them; what is asked before a picture is written.
void dialogs(TourWindow& tour);
/// Help, dark, small and large windows.
void looks(TourWindow& tour);
/// A few pictures of everything, for screens of high resolution.
void glance(TourWindow& tour);
/// Every panel in the smallest window and in one as large as the screen, in light and dark.
void sizes(TourWindow& tour);
/// Takes the pictures of the documentation.
void documentPictures(TourWindow& tour);

}  // namespace holdfast::tour
