// What the critical diameter costs: the throat with deposits, and large random packs.
#include "observe/critical_diameter.h"

#include <cmath>

#include "benchmark/benchmark.h"
#include "packings.h"

namespace colloid {
namespace {

// One search from nothing; the deposits of eight seeds in turn.
void search_throat(benchmark::State& state) {
  std::vector<Packing> throats;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    throats.push_back(clogging_throat(static_cast<int>(state.range(0)), seed));
  }
  double cells = 0.0;
  std::size_t next = 0;
  for (auto _ : state) {
    const Packing& throat = throats[next++ % throats.size()];
    const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
    benchmark::DoNotOptimize(found.value);
    cells += found.cells;
  }
  state.counters["cells"] = benchmark::Counter(cells, benchmark::Counter::kAvgIterations);
}
BENCHMARK(search_throat)
    ->Arg(0)
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

// A hundred retentions one by one, each with the result before it: the mean per
// retention.
void follow_throat(benchmark::State& state) {
  const Packing full = clogging_throat(100, 1);
  for (auto _ : state) {
    Packing throat = empty_throat();
    CriticalDiameter before = critical_diameter(throat.box, throat.spheres);
    for (std::size_t i = 4; i < full.spheres.size(); ++i) {
      throat.spheres.push_back(full.spheres[i]);
      CriticalDiameterOptions options;
      options.before = &before;
      before = critical_diameter(throat.box, throat.spheres, options);
    }
    benchmark::DoNotOptimize(before.value);
  }
}
BENCHMARK(follow_throat)->Unit(benchmark::kMillisecond);

void search_pack(benchmark::State& state, const Box& box) {
  Packing pack{box, random_cluster(box.size, static_cast<int>(state.range(0)), 5)};
  for (Sphere& sphere : pack.spheres) {
    sphere.radius *= 0.8;
  }
  double cells = 0.0;
  for (auto _ : state) {
    const CriticalDiameter found = critical_diameter(pack.box, pack.spheres);
    benchmark::DoNotOptimize(found.value);
    cells += found.cells;
    state.counters["blocked"] = found.blocked ? 1.0 : 0.0;
  }
  state.counters["cells"] = benchmark::Counter(cells, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(search_pack, between_walls, flow_box({1, 1, 1}, FaceCondition::wall))
    ->Arg(500)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(search_pack, periodic, periodic_box({1, 1, 1}))
    ->Arg(500)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace colloid
