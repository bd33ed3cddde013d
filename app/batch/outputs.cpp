#include "batch/outputs.h"

#include <fmt/format.h>

#include <holdfast/base/printable.h>

namespace holdfast::batch {

void Outputs::commitDirect()
{
  for (OutputFile& file : files_)
    if (file.isDirect()) file.commit();
}

void Outputs::commitAside()
{
  for (OutputFile& file : files_)
    if (!file.isDirect()) file.commit();
}

std::string Outputs::names() const
{
  std::string text;
  for (const OutputFile& file : files_) text += fmt::format("wrote        {}\n", printable(file.path().string()));
  return text;
}

}  // namespace holdfast::batch
