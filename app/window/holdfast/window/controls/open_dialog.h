#pragma once
/// Lets dialogs come one after the other. A dialog that comes by itself waits for the one that is open.

#include <QObject>
#include <functional>

namespace holdfast {

/// Tells whether a dialog is open that its window waits for.
[[nodiscard]] bool isDialogOpen();

/// Calls `act` now, or once the dialogs that are open have gone. It never calls it after the end of `owner`.
void whenNoDialogIsOpen(QObject& owner, std::function<void()> act);

}  // namespace holdfast
