#pragma once
/// \file
/// Computations that are stopped where they take more than they may.

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace holdfast::paper {

struct Limits {
  unsigned seconds;    ///< of processor time
  unsigned gigabytes;  ///< of addresses, of which the process has some from its start
};

/// How a computation ends. Where it throws std::bad_alloc it lacks memory.
enum class Ending { Done, Failed, LacksMemory };

/// Runs `compute`, which fills the bytes that it is given, in a copy of this process (POSIX: fork), and copies them to
/// `result`. Returns nothing, or why there is no result: "fails", "out of memory at 8 GB", "stopped after 60 s".
/// `compute` must not use threads, which the copy does not have. Throws std::system_error where there can be no copy.
[[nodiscard]] std::string limited(const Limits& limits, std::span<std::byte> result,
                                  const std::function<Ending(std::span<std::byte>)>& compute);

}  // namespace holdfast::paper
