#include "bench/measure.h"

#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace holdfast::bench {
namespace {

/// A line "key:  123 kB" of /proc/self/status in MiB; NaN where there is none.
double statusMiB(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == key && status >> kilobytes) return kilobytes / 1024;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double peakMiB()
{
  return statusMiB("VmHWM:");
}

double startPeak()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream peak("/proc/self/clear_refs");
  peak << 5;
  peak.close();
  return peak ? statusMiB("VmRSS:") : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace holdfast::bench
