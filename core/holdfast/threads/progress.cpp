#include "holdfast/threads/progress.h"

#include <fmt/format.h>

namespace holdfast {

void StoppableProgress::step(std::string_view description)
{
  proceed(0);
  description_ = description;
  percent_ = 0;
  report_(description_);
}

void StoppableProgress::proceed(double share)
{
  if (isUnwanted_()) throw Cancelled();
  const auto percent = static_cast<int>(100 * share);
  if (percent <= percent_) return;
  percent_ = percent;
  report_(withPercent(description_, percent));
}

std::string withPercent(std::string_view description, int percent)
{
  return fmt::format("{}, {} %", description, percent);
}

}  // namespace holdfast
