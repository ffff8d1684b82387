// What the Stokes solver costs in the reference throat, clean and clogging.
//
// Arguments: cells across the throat (40 is 96,000 cells in all) and retained colloids.
// Counters, means over the iterations of one benchmark:
//
//   ns_per_cell   time over cells [ns]
//   work_units    time over that of one residual evaluation in double precision, which is
//                 measured in turn with it, so that a busy machine slows both
//   iterations_to_1e-6   of FGMRES, one V-cycle each
//   setup_ms      before a solve: rows and coarse levels, or their update
//
// Time is that of one thread.
#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

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

/// Seconds that `work` takes.
template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

StokesProblem throat_with(int across, int colloids) {
  StokesProblem problem = cases::throat(across);
  const auto deposit = cases::dropped_deposit(colloids, kDepositSeed);
  problem.spheres.insert(problem.spheres.end(), deposit.begin(), deposit.end());
  return problem;
}

/// Values in [-1, 1) where a row or cell has an unknown, zero elsewhere.
template <class Real>
Fields<Real> random_fields(const WallRows& rows) {
  Fields<Real> fields(rows.grid().size);
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
  Fields<double> x_, b_, r_;
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

/// Times work(solver) on the throat that the arguments describe.
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

StokesSolver unsolved(const benchmark::State& state) {
  return StokesSolver(
      throat_with(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))),
      StokesOptions{});
}

template <class Real>
void evaluate_residual(benchmark::State& state) {
  const StokesSolver solver = unsolved(state);
  const WallRows& rows = solver.rows();
  const LevelView level = view(rows);
  Fields<Real> u = random_fields<Real>(rows);
  const Fields<Real> f = u;
  Fields<Real> r(rows.grid().size);
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
  const StokesSolver solver = unsolved(state);
  Multigrid multigrid = make_multigrid(solver);
  const Fields<float> f = random_fields<float>(solver.rows());
  Fields<float> u(solver.rows().grid().size);
  int sweep = 0;
  time_kernel(state, solver, [&] { multigrid.smooth(u, f, false, sweep++); });
}

void cycle_once(benchmark::State& state) {
  const StokesSolver solver = unsolved(state);
  Multigrid multigrid = make_multigrid(solver);
  const Fields<float> r = random_fields<float>(solver.rows());
  Fields<float> z(solver.rows().grid().size);
  time_kernel(state, solver, [&] { multigrid.apply(r, z); });
}

/// Solves and adds to the sums; the time is the solver's own, without setting up.
void time_solve(benchmark::State& state, StokesSolver& solver, Cost& cost,
                double& iterations, double& setup) {
  Reference reference(solver.rows());
  const StokesStatistics& found = solver.solve();
  state.SetIterationTime(found.seconds);
  cost.seconds += found.seconds;
  cost.residual_seconds += reference.seconds();
  iterations += found.iterations;
  setup += found.setup_seconds;
}

void report_solves(benchmark::State& state, const StokesSolver& solver, const Cost& cost,
                   double iterations, double setup) {
  const auto runs = static_cast<double>(state.iterations());
  cost.report(state, solver.rows().grid().cell_count());
  state.counters["iterations_to_1e-6"] = iterations / runs;
  state.counters["setup_ms"] = 1e3 * setup / runs;
}

void solve_from_zero(benchmark::State& state) {
  Cost cost;
  double iterations = 0.0;
  double setup = 0.0;
  std::unique_ptr<StokesSolver> solver;
  for (auto _ : state) {
    solver = std::make_unique<StokesSolver>(unsolved(state));
    time_solve(state, *solver, cost, iterations, setup);
  }
  report_solves(state, *solver, cost, iterations, setup);
}

// Retentions one after the other, so the mean is over ten places in the deposit.
void solve_after_retention(benchmark::State& state) {
  const auto colloids = static_cast<std::size_t>(state.range(1));
  const auto deposit =
      cases::dropped_deposit(static_cast<int>(colloids) + kRetentions, kDepositSeed);
  StokesSolver solver = unsolved(state);
  solver.solve();
  Cost cost;
  double iterations = 0.0;
  double setup = 0.0;
  std::size_t next = colloids;
  for (auto _ : state) {
    solver.add_spheres({deposit.at(next++)});
    time_solve(state, solver, cost, iterations, setup);
  }
  report_solves(state, solver, cost, iterations, setup);
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
BENCHMARK(cycle_once)->Apply(throats);
BENCHMARK(solve_from_zero)->Apply(throats);
BENCHMARK(solve_after_retention)->Apply(throats)->Iterations(kRetentions);

}  // namespace
}  // namespace colloid
