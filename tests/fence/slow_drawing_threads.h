#pragma once
/// \file
/// Threads of the system as this program, and every library in it, sees them: those that draw are held up where they
/// may not be overtaken.

#include <chrono>

namespace holdfast::test {

/// From now on a thread of Mesa's software renderer sleeps whenever it has told others that it is done with a picture,
/// before it lets go of the lock around that and begins the next. The test never waits for that time to pass: it is the
/// moment in which those threads may be overtaken, made long enough to be met each time.
void holdUpDrawingThreads(std::chrono::microseconds time);

/// How often one was held up so.
[[nodiscard]] long drawingThreadsHeldUp();

/// How many locks were destroyed while a thread held them, after which it would write into memory that is free. The
/// thread is waited for, so that this program goes on unharmed.
[[nodiscard]] long locksDestroyedWhileHeld();

}  // namespace holdfast::test
