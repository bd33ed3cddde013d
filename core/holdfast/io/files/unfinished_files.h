#pragma once
/// \file
/// The list of files to remove if the program is interrupted, in a form that a signal handler may read.

#include <string>

namespace holdfast {

/// Puts `path` on the list and returns its slot; -1 where the list is full or the path too long for it. Thread-safe.
[[nodiscard]] int trackUnfinishedFile(const std::string& path) noexcept;

/// Takes a slot off the list; -1 does nothing.
void forgetUnfinishedFile(int slot) noexcept;

}  // namespace holdfast
