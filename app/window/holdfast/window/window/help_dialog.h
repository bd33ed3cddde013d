#pragma once
/// The most useful gestures, on one page.

class QWidget;

namespace holdfast {

/// Shows the page over `window` until the user closes it.
void showHelp(QWidget* window);

}  // namespace holdfast
