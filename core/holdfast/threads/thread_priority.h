#pragma once
/// Priorities of threads that share few cores with the thread that answers the user.

#include <string_view>

namespace holdfast {

/// Lowers the priority of the calling thread, and of those that it starts from now on, for good. A thread of the
/// priority before then gets nine tenths of a core that both need. A second call lowers it further.
void computeInBackground() noexcept;

/// Does as `computeInBackground` for every thread of this program but the calling one. These are the pools that
/// libraries have started before `main`.
void letOthersComputeInBackground() noexcept;

/// Puts the threads of this program whose names begin with `name` on the usable cores in turn. It is for pools that
/// wait together for short work, such as drawing without a GPU. While something computes in the background, the system
/// may wake all of them on one core.
void spreadOverCores(std::string_view name) noexcept;

}  // namespace holdfast
