// Times the cases. The time of a case is that of the Boolean alone, with operands that were never
// used before; `import_ms` is the time to make both operands, `peak_MiB` that of the process.
//   boolean_bench --profile [PART-OF-A-NAME [FOLDER-OF-MESHES [THREADS]]]
// prints instead where the time goes, operands used before, for more cases. With one thread that is
// processor time.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "cases.h"
#include "peak_memory.h"
#include "profile.h"

namespace {

using sectile::bench::Case;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

void run(benchmark::State& state, const Case& tested) {
  const sectile::bench::MakeOperands make = tested.prepare();
  sectile::bench::reset_peak_memory();
  Seconds import{0};
  for (auto _ : state) {
    const auto start = Clock::now();
    const auto [a, b] = make();
    const auto imported = Clock::now();
    const sectile::Solid result = sectile::boolean(a, b, tested.operation);
    const auto end = Clock::now();
    if (result.is_empty()) throw std::logic_error(tested.name + ": the result is empty");
    import += imported - start;
    state.SetIterationTime(Seconds(end - imported).count());
  }
  state.counters["import_ms"] =
      benchmark::Counter(1000 * import.count(), benchmark::Counter::kAvgIterations);
  state.counters["peak_MiB"] = sectile::bench::peak_memory();
}

int profile(int argc, char** argv) {
  sectile::bench::ProfileOptions options;
  if (argc > 2) options.name_part = argv[2];
  if (argc > 3) options.mesh_folder = argv[3];
  const int threads = argc > 4 ? std::atoi(argv[4]) : 0;
  options.processor_time = threads == 1;
  if (argc > 5 || threads < 0) {
    std::fputs("usage: boolean_bench --profile [NAME [FOLDER [THREADS]]]\n", stderr);
    return 2;
  }
  if (threads == 0) {
    sectile::bench::print_profile(options);
  } else {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    sectile::bench::print_profile(options);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--profile") == 0) return profile(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const Case& tested : sectile::bench::cases())
    benchmark::RegisterBenchmark(tested.name.c_str(), run, tested)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
