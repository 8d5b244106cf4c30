#include "profile.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <numeric>

#include "sectile/boolean.h"
#include "sectile/errors.h"
#include "sequences.h"

namespace sectile::bench {
namespace {

double now_in_milliseconds(bool processor_time) {
  if (processor_time) return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

// A Boolean says how far it is whenever a phase is done.
struct Phase {
  const char* name;
  double done;
};
constexpr Phase phases[] = {{"load", 0.1},  {"reduce", 0.4}, {"null edges", 0.5}, {"join", 0.6},
                            {"label", 0.7}, {"glue", 0.9},   {"clean, splice", 1}};
constexpr std::size_t phase_count = std::size(phases);
using Milliseconds = std::array<double, phase_count>;

double total(const Milliseconds& of) {
  return std::accumulate(of.begin(), of.end(), 0.0);
}

Milliseconds measured(const std::function<void(const Boolean&)>& work, bool processor_time) {
  Milliseconds spent{};
  work([&](const Solid& a, const Solid& b, Operation operation) {
    double last = now_in_milliseconds(processor_time);
    BooleanOptions options;
    options.progress = [&](double done) {
      const double now = now_in_milliseconds(processor_time);
      std::size_t phase = 0;
      while (phase + 1 < phase_count && phases[phase].done < done - 1e-9) ++phase;
      spent[phase] += now - last;
      last = now;
    };
    return boolean(a, b, operation, options);
  });
  return spent;
}

void print(const Sequence& sequence, const ProfileOptions& options) {
  std::function<void(const Boolean&)> work;
  try {
    work = sequence.prepare();
  } catch (const InvalidSolid& error) {
    std::printf("%-44s is left out: %s\n", sequence.name.c_str(), error.what());
    return;
  }
  Milliseconds best = measured(work, options.processor_time);
  for (int i = 1; i < options.repetitions; ++i)
    if (const Milliseconds again = measured(work, options.processor_time);
        total(again) < total(best))
      best = again;
  std::printf("%-44s %10.3f", sequence.name.c_str(), total(best));
  for (const double ms : best) std::printf(" %10.3f", ms);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

void print_profile(const ProfileOptions& options) {
  std::printf("%-44s %10s", "ms", "total");
  for (const Phase& phase : phases) std::printf(" %10s", phase.name);
  std::printf("\n");
  std::vector<Sequence> all = sequences();
  if (!options.mesh_folder.empty())
    for (Sequence& each : real_pairs(options.mesh_folder)) all.push_back(std::move(each));
  for (const Sequence& each : all)
    if (each.name.find(options.name_part) != std::string::npos) print(each, options);
}

}  // namespace sectile::bench
