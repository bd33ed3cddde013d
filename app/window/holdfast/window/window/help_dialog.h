#pragma once
/// The most useful gestures, on one page.

namespace holdfast {

/// Shows the page over `window` until the user closes it.

#include <QWidget>
void showHelp(QWidget* window);

}  // namespace holdfast
