#pragma once
/// \file
/// Words in panels. What is returned is without a parent: a layout takes it.

#include <QString>

class QLabel;

namespace holdfast {

/// In the middle of a panel that has nothing else to show.
[[nodiscard]] QLabel* newHint(const QString& objectName);

/// Lines of plain text, to be selected with the mouse.
[[nodiscard]] QLabel* newText(const QString& objectName);

}  // namespace holdfast
