#pragma once
/// \file
/// Who goes first where threads that compute for long and a thread that answers a user share few cores.

#include <string_view>

namespace holdfast {

/// Lets other threads go before the calling one, and before those that it starts from now on: for work that takes
/// long. Alone on a core it is as quick as before. Where the system has no priorities of threads nothing happens; not
/// taken back, for a program without privileges may not.
void computeInBackground() noexcept;

/// The same for every thread of this program but the calling one: pools that libraries have started before `main`.
void letOthersComputeInBackground() noexcept;

/// Puts each thread of this program whose name begins with `name` on a core of its own, in turn, as far as the program
/// may use cores. For pools that wait together for short work, such as drawing without a GPU: while something computes
/// in the background the system finds no core idle, and may wake all of them on one. Elsewhere than on Linux nothing
/// happens.
void spreadOverCores(std::string_view name) noexcept;

}  // namespace holdfast
