// holdfast-batch: deforms and checks meshes without a window. The only place that turns exceptions into exit codes.

#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <holdfast/io/files/file_descriptor.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/memory/available_memory.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

extern "C" void removeOutputsAndDie(int signal)
{
  removeUnfinishedOutputs();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

ExitCode complain(ExitCode code, const std::string& message)
{
  printMessage(fmt::format("holdfast-batch: {}\n", printable(message, kLongestPrintedMessage)));
  return code;
}

/// Including a thread that gets no stack.
bool isLackOfMemory(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && system->code() == std::errc::resource_unavailable_try_again;
}

ExitCode run(int argc, char** argv)
{
  try {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, removeOutputsAndDie);
    for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);  // errors of the outputs that meet them
    const auto isQuestion = [](std::string_view argument) { return argument == "--help" || argument == "-h"; };
    if (std::any_of(argv, argv + argc, isQuestion)) goOnWithVtk(argv);
    return parseCommandLine(argc, argv)();
  } catch (const UsageError& error) {
    goOnWithVtk(argv);
    return complain(kUsage, error.what());
  } catch (const InputError& error) {
    return complain(kInput, error.what());
  } catch (const OutputError& error) {
    return complain(kOutput, error.what());
  } catch (const std::exception& error) {
    if (dynamic_cast<const LackOfMemory*>(&error) != nullptr) return complain(kNumerical, error.what());
    if (isLackOfMemory(error))
      return complain(kNumerical,
                      "there is not enough memory for a problem of this size; free some or raise its limit");
    return complain(kBug, fmt::format("this is a bug of ours, please report it: {}", error.what()));
  }
}

}  // namespace

void printResult(std::string_view text)
{
  if (text.empty()) return;
  if (const int code = writeAndClose(FileDescriptor(::dup(STDOUT_FILENO)), text); code != 0)
    throw OutputError("standard output",
                      fmt::format("cannot be written ({}): send it where there is room for it", std::strerror(code)));
}

void printMessage(std::string_view text) noexcept
{
  static_cast<void>(writeAndClose(FileDescriptor(::dup(STDERR_FILENO)), text));
}

}  // namespace holdfast::batch

int main(int argc, char** argv)
{
  return holdfast::batch::run(argc, argv);
}
