#pragma once
/// These functions tell whether there is memory before it is taken. Linux promises more than there is, and ends
/// programs that use it.

#include <cstdint>
#include <new>
#include <string>
#include <string_view>

namespace holdfast {

/// `what()` says what needs how much, what is free and what to do.
class LackOfMemory : public std::bad_alloc {
 public:
  explicit LackOfMemory(std::string message) : message_(std::move(message)) {}

  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// Returns how many bytes of memory and swap the machine has free. Where the system does not say, it returns the
/// largest number. Limits of a container are not seen.
[[nodiscard]] std::uint64_t availableMemory();

/// While one of these lives, `returnFreeMemory` gives free memory of the process back to the system, where the
/// allocator can do that. Else the memory is kept: what is computed again and again would have to wait for it.
class LeastMemory {
 public:
  LeastMemory() noexcept;
  ~LeastMemory();
  LeastMemory(const LeastMemory&) = delete;
  LeastMemory& operator=(const LeastMemory&) = delete;
};

[[nodiscard]] bool isLeastMemoryWanted() noexcept;

void returnFreeMemory();

/// Throws `LackOfMemory` where `user` ("the factor of 1000 unknowns") needs more than is free.
void requireMemory(std::uint64_t bytes, std::string_view user);

}  // namespace holdfast
