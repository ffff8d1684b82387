#include "flow/fgmres.h"

#include <cmath>

#include "core/error.h"
#include "flow/clock.h"
#include "flow/halo.h"
#include "flow/kernels.h"
#include "flow/planes.h"

namespace colloid {

namespace {

// Part of the last iteration's gain that a light preconditioner is trusted with.
constexpr double kLight = 0.5;

// Least squares of the Hessenberg matrix by Givens rotations, one column at a time.
class Rotations {
 public:
  explicit Rotations(double beta) : rhs_{beta} {}

  // Takes column j (j + 2 entries); returns the norm of the remaining residual.
  double append(std::vector<double> column) {
    const std::size_t j = columns_.size();
    for (std::size_t i = 0; i < j; ++i) {
      const double above = cosine_[i] * column[i] + sine_[i] * column[i + 1];
      column[i + 1] = -sine_[i] * column[i] + cosine_[i] * column[i + 1];
      column[i] = above;
    }
    const double length = std::hypot(column[j], column[j + 1]);
    cosine_.push_back(length > 0.0 ? column[j] / length : 1.0);
    sine_.push_back(length > 0.0 ? column[j + 1] / length : 0.0);
    column[j] = length;
    rhs_.push_back(-sine_[j] * rhs_[j]);
    rhs_[j] *= cosine_[j];
    columns_.push_back(std::move(column));
    return std::abs(rhs_.back());
  }

  std::vector<double> solve() const {
    std::vector<double> y(columns_.size(), 0.0);
    for (std::size_t i = y.size(); i-- > 0;) {
      double sum = rhs_[i];
      for (std::size_t j = i + 1; j < y.size(); ++j) {
        sum -= columns_[j][i] * y[j];
      }
      y[i] = columns_[i][i] != 0.0 ? sum / columns_[i][i] : 0.0;
    }
    return y;
  }

 private:
  std::vector<std::vector<double>> columns_;
  std::vector<double> cosine_, sine_, rhs_;
};

}  // namespace

void true_residual(const WallRows& rows, const LevelView& level, StokesVector<double>& x,
                   const StokesVector<double>& b, StokesVector<double>& r, int threads) {
  fill_halos(rows.grid(), x);
  for_planes(level.end[2], threads, [&](int k) { residual_plane(level, x, b, r, k); });
}

double norm(const LevelView& level, const StokesVector<double>& r, int threads) {
  return std::sqrt(sum_planes(level.end[2], threads,
                              [&](int k) { return dot_plane(level, r, r, k); }));
}

// Basis vector j from w, direction j from it, and w = M z made orthogonal to the basis:
// classical Gram-Schmidt, so that w passes through the cache twice, however many vectors.
// Returns column j of the Hessenberg matrix, j + 2 entries.
std::vector<double> Fgmres::extend(std::size_t j, double length, bool light,
                                   const Preconditioner& precondition, int threads) {
  const LevelView level = view(rows_);
  const int planes = level.end[2];
  if (j == directions_.size()) {
    basis_.emplace_back(rows_.grid().size);
    directions_.emplace_back(rows_.grid().size);
  }
  for_planes(planes, threads,
             [&](int k) { scaled_copy_plane(level, 1.0 / length, w_, basis_[j], k); });
  fill_halos(rows_.grid(), basis_[j]);
  precondition(basis_[j], directions_[j], light);
  fill_halos(rows_.grid(), directions_[j]);

  // w = -M z, so all products have the wrong sign; plane sums are added in order.
  const std::size_t count = j + 1;
  std::vector<double> part(static_cast<std::size_t>(planes) * count);
  for_planes(planes, threads, [&](int k) {
    minus_apply_plane(level, directions_[j], w_, k);
    dots_plane(level, w_, basis_.data(), count,
               part.data() + static_cast<std::size_t>(k) * count, k);
  });
  std::vector<double> column(count + 1, 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(planes); ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      column[i] -= part[k * count + i];
    }
  }
  const double square = sum_planes(planes, threads, [&](int k) {
    return combine_plane(level, column.data(), basis_.data(), count, w_, k);
  });
  column[count] = -std::sqrt(square);
  return column;
}

KrylovStatistics Fgmres::solve(const StokesVector<double>& b, StokesVector<double>& x,
                               const Preconditioner& precondition,
                               const KrylovOptions& options) {
  const LevelView level = view(rows_);
  const int planes = level.end[2];
  KrylovStatistics statistics;

  const auto evaluate_residual = [&] {
    const double start = processor_seconds();
    true_residual(rows_, level, x, b, w_, options.threads);
    const double seconds = processor_seconds() - start;
    if (statistics.residual_seconds == 0.0 || seconds < statistics.residual_seconds) {
      statistics.residual_seconds = seconds;
    }
    return norm(level, w_, options.threads);
  };
  statistics.residual = evaluate_residual();
  while (statistics.residual > options.target &&
         statistics.iterations < options.max_iterations) {
    const double beta = statistics.residual;
    Rotations rotations(beta);
    double estimate = beta;
    double length = beta;
    double gain = 0.0;  // factor by which the last iteration reduced the residual
    std::size_t j = 0;
    while (estimate > options.target && j < static_cast<std::size_t>(options.restart) &&
           statistics.iterations < options.max_iterations) {
      const bool light = estimate <= kLight * gain * options.target;
      std::vector<double> column =
          extend(j, length, light, precondition, options.threads);
      length = std::abs(column.back());
      if (!std::isfinite(length)) {
        throw ConvergenceError("Stokes solver: not a number in Krylov iteration " +
                               std::to_string(statistics.iterations + 1));
      }
      const double before = estimate;
      estimate = rotations.append(std::move(column));
      gain = before / estimate;
      ++statistics.iterations;
      ++j;
      if (length <= 1e-30 * beta) {
        break;
      }
    }
    const std::vector<double> y = rotations.solve();
    for_planes(planes, options.threads, [&](int k) {
      combine_plane(level, y.data(), directions_.data(), y.size(), x, k);
    });
    const double before = statistics.residual;
    statistics.residual = evaluate_residual();
    if (!(statistics.residual < 0.999 * before)) {
      break;  // stagnation: the caller reports it
    }
  }
  statistics.converged = statistics.residual <= options.target;
  return statistics;
}

}  // namespace colloid
