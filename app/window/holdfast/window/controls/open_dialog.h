#pragma once
/// Dialogs come one after the other: what comes by itself waits for the one that is open.

#include <QObject>
#include <functional>

namespace holdfast {

/// Whether a dialog is open that its window waits for.
[[nodiscard]] bool isDialogOpen();

/// Calls `act` now, or once the dialogs that are open have gone; never after `owner`.
void whenNoDialogIsOpen(QObject& owner, std::function<void()> act);

}  // namespace holdfast
