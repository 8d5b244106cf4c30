// Prints the cases of the benchmarks side by side: Sectile, and CGAL's corefinement on the same
// operands as triangles, which is ended after two minutes. One cold run each; an argument picks the
// cases whose name contains it.
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>

#include "cases.h"
#include "corefinement.h"
#include "limited_run.h"
#include "peak_memory.h"

namespace {

using namespace sectile::bench;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr unsigned most_seconds = 120;  // for a run of CGAL

Measured sectile_run(const MakeOperands& make, sectile::Operation operation) {
  reset_peak_memory();
  Measured measured;
  const auto start = Clock::now();
  const auto [a, b] = make();
  const auto imported = Clock::now();
  const sectile::Solid result = sectile::boolean(a, b, operation);
  const auto end = Clock::now();
  measured.made = true;
  measured.import_seconds = Seconds(imported - start).count();
  measured.boolean_seconds = Seconds(end - imported).count();
  measured.peak_memory = peak_memory();
  measured.volume = result.volume();
  return measured;
}

void print(const char* engine, const Measured& m) {
  std::printf("  %-8s %10.2f ms  %10.2f ms  %8.0f MiB  ", engine, 1000 * m.import_seconds,
              1000 * m.boolean_seconds, m.peak_memory);
  if (m.made)
    std::printf("volume %.15g\n", m.volume);
  else
    std::printf("refused\n");
  std::fflush(stdout);
}

void compare(const Case& tested) {
  std::printf("%s\n", tested.name.c_str());
  const MakeOperands make = tested.prepare();
  print("Sectile", sectile_run(make, tested.operation));
  const auto [a, b] = make();
  const auto measured = limited_run(most_seconds, [&, &a = a, &b = b] {
    return corefinement(a.to_mesh(), b.to_mesh(), tested.operation);
  });
  if (measured)
    print("CGAL", *measured);
  else
    std::printf("  %-8s not done after %u s\n", "CGAL", most_seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    std::fprintf(stderr, "usage: sectile_compare [PART-OF-A-NAME]\n");
    return 2;
  }
  try {
    std::printf("  %-8s %13s  %13s  %12s\n", "", "import", "Boolean", "peak memory");
    for (const Case& tested : cases())
      if (argc < 2 || tested.name.find(argv[1]) != std::string::npos) compare(tested);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sectile_compare: %s\n", error.what());
    return 1;
  }
}
