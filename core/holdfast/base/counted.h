#pragma once
/// Numbers of things in sentences.

#include <string>

#include <holdfast/base/types.h>

namespace holdfast {

/// "1 normal", "3 normals".
[[nodiscard]] inline std::string counted(Index count, const std::string& singular)
{
  return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

}  // namespace holdfast
