#pragma once
/// \file
/// Ctrl-C and its like leave no half-written file.

namespace holdfast::batch {

/// From now on SIGINT, SIGTERM and SIGHUP remove unfinished outputs before they end the program, and a file that grows
/// beyond its limit is an error of writing instead of a signal.
void installSignalHandlers();

}  // namespace holdfast::batch
