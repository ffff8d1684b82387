// What the Stokes solver costs in the reference throat, clean and clogging.
//
// Arguments: cells across the throat (40 is 96,000 cells in all) and retained colloids.
// Counters, means over the iterations of one benchmark:
//
//   ns_per_cell   time over cells [ns]
//   work_units    time over that of one residual evaluation in double precision, which is
//                 measured in turn with it, so that a busy machine slows both
//   iterations_to_1e-6   of FGMRES, one multigrid cycle each
//   setup_ms      before a solve: rows and coarse levels, or their update
//
// Time is processor time of one thread, so other programs disturb it through the caches
// only.  A solve is all of StokesSolver::solve().
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <time.h>

#include "benchmark/benchmark.h"
#include "flow/fgmres.h"
#include "flow/halo.h"
#include "flow/kernels.h"
#include "flow/multigrid.h"
#include "flow_cases.h"

namespace colloid {
namespace {

// Residual evaluations timed for the work unit after each timed piece of work.
constexpr int kReferences = 3;

constexpr int kRetentions = 10;
constexpr std::uint64_t kDepositSeed = 5;

double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor seconds that `work` takes.
template <class Work>
double seconds_of(const Work& work) {
  const double start = processor_time();
  work();
  return processor_time() - start;
}

StokesProblem throat_with(int across, int colloids) {
  StokesProblem problem = cases::throat(across);
  const auto deposit = cases::dropped_deposit(colloids, kDepositSeed);
  problem.spheres.insert(problem.spheres.end(), deposit.begin(), deposit.end());
  return problem;
}

/// Values in [-1, 1) where a row or cell has an unknown, zero elsewhere.
template <class Real>
StokesVector<Real> random_fields(const WallRows& rows) {
  StokesVector<Real> fields(rows.grid().size);
  std::mt19937_64 generator(1);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto& open =
        c < 3 ? rows.coefficients().row_scale[c] : rows.coefficients().cell_scale;
    for (std::size_t q = 0; q < open.size(); ++q) {
      const double value = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
      fields.a[c][q] = open[q] > 0.0F ? static_cast<Real>(value) : Real(0);
    }
  }
  return fields;
}

/// The work unit on one set of rows.
class Reference {
 public:
  explicit Reference(const WallRows& rows)
      : rows_(rows), x_(random_fields<double>(rows)), b_(x_), r_(rows.grid().size) {}

  /// Seconds of one residual evaluation.
  double seconds() {
    const LevelView level = view(rows_);
    return seconds_of([&] {
             for (int n = 0; n < kReferences; ++n) {
               true_residual(rows_, level, x_, b_, r_, 1);
             }
           }) /
           kReferences;
  }

 private:
  const WallRows& rows_;
  StokesVector<double> x_, b_, r_;
};

/// Sums over a benchmark's iterations, and the counters made of them.
struct Cost {
  double seconds = 0.0;
  double residual_seconds = 0.0;

  void report(benchmark::State& state, std::size_t cells) const {
    const auto runs = static_cast<double>(state.iterations());
    state.counters["ns_per_cell"] = 1e9 * seconds / runs / static_cast<double>(cells);
    state.counters["work_units"] = seconds / residual_seconds;
  }
};

/// Times work() on the rows of `solver`.
template <class Work>
void time_kernel(benchmark::State& state, const StokesSolver& solver, const Work& work) {
  Reference reference(solver.rows());
  reference.seconds();
  work();  // once for the caches
  Cost cost;
  for (auto _ : state) {
    const double seconds = seconds_of(work);
    state.SetIterationTime(seconds);
    cost.seconds += seconds;
    cost.residual_seconds += reference.seconds();
  }
  cost.report(state, solver.rows().grid().cell_count());
}

StokesProblem problem_of(const benchmark::State& state) {
  return throat_with(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
}

template <class Real>
void evaluate_residual(benchmark::State& state) {
  const StokesSolver solver(problem_of(state), StokesOptions{});
  const WallRows& rows = solver.rows();
  const LevelView level = view(rows);
  StokesVector<Real> u = random_fields<Real>(rows);
  const StokesVector<Real> f = u;
  StokesVector<Real> r(rows.grid().size);
  time_kernel(state, solver, [&] {
    for (int c = 0; c < 4; ++c) {
      fill_halo(rows.grid(), u[c]);
    }
    for (int k = 0; k < level.end[2]; ++k) {
      residual_plane(level, u, f, r, k);
    }
    benchmark::ClobberMemory();
  });
}

Multigrid make_multigrid(const StokesSolver& solver) {
  return Multigrid(solver.rows(), solver.flow_faces(), solver.grid_spheres(),
                   CycleOptions{}, 1);
}

void smooth_once(benchmark::State& state) {
  const StokesSolver solver(problem_of(state), StokesOptions{});
  Multigrid multigrid = make_multigrid(solver);
  const StokesVector<float> f = random_fields<float>(solver.rows());
  StokesVector<float> u(solver.rows().grid().size);
  int sweep = 0;
  time_kernel(state, solver, [&] { multigrid.smooth(u, f, false, sweep++); });
}

void cycle_once(benchmark::State& state, bool light) {
  const StokesSolver solver(problem_of(state), StokesOptions{});
  Multigrid multigrid = make_multigrid(solver);
  const StokesVector<float> r = random_fields<float>(solver.rows());
  StokesVector<float> z(solver.rows().grid().size);
  time_kernel(state, solver, [&] { multigrid.apply(r, z, light); });
}

/// Sums over solves.
struct SolveCost {
  Cost cost;
  double setup_seconds = 0.0;
  double krylov_iterations = 0.0;

  void add_solve(benchmark::State& state, StokesSolver& solver) {
    Reference reference(solver.rows());
    reference.seconds();  // once for the caches
    const double seconds = seconds_of([&] { solver.solve(); });
    state.SetIterationTime(seconds);
    cost.seconds += seconds;
    cost.residual_seconds += reference.seconds();
    krylov_iterations += solver.statistics().iterations;
  }

  void report(benchmark::State& state, const StokesSolver& solver) const {
    const auto runs = static_cast<double>(state.iterations());
    cost.report(state, solver.rows().grid().cell_count());
    state.counters["iterations_to_1e-6"] = krylov_iterations / runs;
    state.counters["setup_ms"] = 1e3 * setup_seconds / runs;
  }
};

void solve_from_zero(benchmark::State& state) {
  SolveCost sum;
  std::unique_ptr<StokesSolver> solver;
  const StokesProblem problem = problem_of(state);
  for (auto _ : state) {
    sum.setup_seconds += seconds_of(
        [&] { solver = std::make_unique<StokesSolver>(problem, StokesOptions{}); });
    sum.add_solve(state, *solver);
  }
  sum.report(state, *solver);
}

// Retentions one after the other, so the mean is over ten places in the deposit.
void solve_after_retention(benchmark::State& state) {
  const auto colloids = static_cast<std::size_t>(state.range(1));
  const auto deposit =
      cases::dropped_deposit(static_cast<int>(colloids) + kRetentions, kDepositSeed);
  StokesSolver solver(problem_of(state), StokesOptions{});
  solver.solve();
  SolveCost sum;
  std::size_t next = colloids;
  for (auto _ : state) {
    sum.setup_seconds += seconds_of([&] { solver.add_spheres({deposit.at(next++)}); });
    sum.add_solve(state, solver);
  }
  sum.report(state, solver);
}

void throats(benchmark::internal::Benchmark* b) {
  b->ArgNames({"across", "colloids"})
      ->ArgsProduct({{20, 40, 80}, {0, 60}})
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(evaluate_residual, double)->Apply(throats);
BENCHMARK_TEMPLATE(evaluate_residual, float)->Apply(throats);
BENCHMARK(smooth_once)->Apply(throats);
BENCHMARK_CAPTURE(cycle_once, full, false)->Apply(throats);
BENCHMARK_CAPTURE(cycle_once, light, true)->Apply(throats);
BENCHMARK(solve_from_zero)->Apply(throats);
BENCHMARK(solve_after_retention)->Apply(throats)->Iterations(kRetentions);

}  // namespace
}  // namespace colloid
