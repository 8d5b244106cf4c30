#include "peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace sectile::bench {

// getrusage() has one peak for the whole life of the process; Linux can start it again.
void reset_peak_memory() {
  malloc_trim(0);
  std::ofstream clear("/proc/self/clear_refs");
  if (!(clear << "5" << std::flush)) throw std::runtime_error("cannot reset the peak of memory");
}

double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return kibibytes / 1024;
  throw std::runtime_error("/proc/self/status has no VmHWM");
}

}  // namespace sectile::bench
