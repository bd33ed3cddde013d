#pragma once
/// \file
/// Ctrl-C and its like leave no half-written file.

namespace holdfast::batch {

/// From now on SIGINT, SIGTERM and SIGHUP remove unfinished outputs before they end the program. A file that grows
/// beyond its limit, and a pipe that is no longer read, are errors of writing instead of signals.
void installSignalHandlers();

}  // namespace holdfast::batch
