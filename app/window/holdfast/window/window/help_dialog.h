#pragma once
/// Shows the most useful gestures on one page, and the manual.

#include <QWidget>

namespace holdfast {

/// Shows the page over `window` until the user closes it.
void showHelp(QWidget* window);

/// Shows docs/window.md beside `window`, which goes on working.
void showManual(QWidget* window);

}  // namespace holdfast
