// What a sub-step of the DEM costs: colloids spread over a box with four grains, or in a
// heap of touching ones.  Counter: seconds per sub-step, of the processor.
#include "tiers/transient/dem.h"

#include <vector>

#include "benchmark/benchmark.h"
#include "dem/dem_case.h"

namespace colloid::dem_test {
namespace {

constexpr double kInterval = 8e-5;  // of the coupling [s]

void advance(benchmark::State& state, const DemOptions& options, double spacing) {
  const double c = 1e-4;
  const double r = 4.83e-5;
  std::vector<Sphere> grains;
  if (spacing > 1.5e-5) {
    grains = {{{0.0, 0.0, c}, r},
              {{2 * c, 0.0, c}, r},
              {{0.0, 2 * c, c}, r},
              {{2 * c, 2 * c, c}, r}};
  }
  Dem dem(options, grains);
  std::vector<DemLoad> loads;
  const auto count = static_cast<int>(state.range(0));
  for (int id = 0; id < count; ++id) {
    const Vec3 place{static_cast<double>(id % 5 - 2), static_cast<double>(id / 5 % 5 - 2),
                     static_cast<double>(id / 25 - 2)};
    dem.add({id, kMiddle + spacing * place, {}, {}});
    // Towards the middle, slowly: what touches stays in touch.
    loads.push_back(stokes_drag(id, {}, -1e-10 * place));
  }
  long steps = 0;
  for (auto _ : state) {
    steps += dem.advance(kInterval, loads).steps;
  }
  state.counters["step"] =
      benchmark::Counter(static_cast<double>(steps),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void spread(benchmark::State& state) {
  advance(state, bonding(), 2.5e-5);
}
void spread_all_forces(benchmark::State& state) {
  DemOptions options = bonding();
  options.long_range_forces = options.lubrication = true;
  options.lubrication_cell = 1.3e-6;
  advance(state, options, 2.5e-5);
}
void heap(benchmark::State& state) {
  advance(state, inert(), 2.0 * kRadius);
}
void bonded(benchmark::State& state) {
  advance(state, bonding(), 2.0 * kRadius + 1e-9);
}
void heap_all_forces(benchmark::State& state) {
  DemOptions options = inert();
  options.long_range_forces = options.lubrication = true;
  options.lubrication_cell = 1.3e-6;
  advance(state, options, 2.0 * kRadius + 1e-8);
}
BENCHMARK(spread)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(spread_all_forces)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(heap)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(bonded)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(heap_all_forces)->Arg(10)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace colloid::dem_test
