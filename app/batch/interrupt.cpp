#include "batch/interrupt.h"

#include <csignal>

#include <holdfast/io/files/output_file.h>

namespace holdfast::batch {
namespace {

extern "C" void removeOutputsAndDie(int signal)
{
  removeUnfinishedOutputs();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void installSignalHandlers()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, removeOutputsAndDie);
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
}

}  // namespace holdfast::batch
