// Times the cases. The time of a case is that of the Boolean alone, with operands that were never
// used before; `import_ms` is the time to make both operands, `peak_MiB` that of the process.
#include <benchmark/benchmark.h>

#include <chrono>
#include <stdexcept>

#include "cases.h"
#include "peak_memory.h"

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

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const Case& tested : sectile::bench::cases())
    benchmark::RegisterBenchmark(tested.name.c_str(), run, tested)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
