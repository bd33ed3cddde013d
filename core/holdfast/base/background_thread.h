#pragma once
/// Threads whose owners may be gone before them.

#include <functional>

namespace holdfast {

/// Runs `work`, which does not throw, on a thread of its own. The thread may outlive its owner inside a factorisation:
/// the program waits for it at its end, so that none runs while its memory is torn down. Threads that have ended are
/// joined at the next call, so that a window that opens one mesh after another does not collect their stacks.
void startBackgroundThread(std::function<void()> work);

}  // namespace holdfast
