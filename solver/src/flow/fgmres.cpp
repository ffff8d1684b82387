#include "flow/fgmres.h"

#include <cmath>

#include "core/error.h"
#include "flow/halo.h"
#include "flow/kernels.h"
#include "flow/planes.h"

namespace colloid {

namespace {

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

template <class Real>
void fill_halos(const Grid& grid, Fields<Real>& x) {
  for (int c = 0; c < 4; ++c) {
    fill_halo(grid, x[c]);
  }
}

// Products of w with the first `count` basis vectors, summed over planes in order.
std::vector<double> products(const LevelView& level, const Fields<double>& w,
                             const std::vector<Fields<float>>& basis, std::size_t count,
                             int threads) {
  const int planes = level.end[2];
  std::vector<double> part(static_cast<std::size_t>(planes) * count);
  for_planes(planes, threads, [&](int k) {
    for (std::size_t i = 0; i < count; ++i) {
      part[static_cast<std::size_t>(k) * count + i] = dot_plane(level, w, basis[i], k);
    }
  });
  std::vector<double> sum(count, 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(planes); ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += part[k * count + i];
    }
  }
  return sum;
}

}  // namespace

void true_residual(const WallRows& rows, const LevelView& level, Fields<double>& x,
                   const Fields<double>& b, Fields<double>& r, int threads) {
  fill_halos(rows.grid(), x);
  for_planes(level.end[2], threads, [&](int k) { residual_plane(level, x, b, r, k); });
}

double norm(const LevelView& level, const Fields<double>& r, int threads) {
  return std::sqrt(sum_planes(level.end[2], threads,
                              [&](int k) { return dot_plane(level, r, r, k); }));
}

KrylovStatistics solve_fgmres(
    const WallRows& rows, const Fields<double>& b, Fields<double>& x,
    const std::function<void(const Fields<float>&, Fields<float>&)>& precondition,
    const KrylovOptions& options) {
  const LevelView level = view(rows);
  const std::size_t size = rows.grid().size;
  const int planes = level.end[2];
  const int threads = options.threads;
  const Fields<double> zero(size);
  Fields<double> w(size);
  std::vector<Fields<float>> basis, directions;
  KrylovStatistics statistics;

  true_residual(rows, level, x, b, w, threads);
  statistics.residual = norm(level, w, threads);
  while (statistics.residual > options.target &&
         statistics.iterations < options.max_iterations) {
    const double beta = statistics.residual;
    Rotations rotations(beta);
    double estimate = beta;
    std::size_t j = 0;
    while (estimate > options.target && j < static_cast<std::size_t>(options.restart) &&
           statistics.iterations < options.max_iterations) {
      if (j == directions.size()) {
        basis.emplace_back(size);
        directions.emplace_back(size);
      }
      const double length = j == 0 ? beta : norm(level, w, threads);
      for_planes(planes, threads,
                 [&](int k) { scaled_copy_plane(level, 1.0 / length, w, basis[j], k); });
      precondition(basis[j], directions[j]);
      fill_halos(rows.grid(), directions[j]);
      for_planes(planes, threads,
                 [&](int k) { residual_plane(level, directions[j], zero, w, k); });
      // w = -M z: the signs of the column are turned round.  Classical Gram-Schmidt: all
      // products first, so that w passes through the cache twice, however many vectors.
      std::vector<double> column = products(level, w, basis, j + 1, threads);
      for_planes(planes, threads, [&](int k) {
        for (std::size_t i = 0; i <= j; ++i) {
          axpy_plane(level, -column[i], basis[i], w, k);
        }
      });
      for (double& h : column) {
        h = -h;
      }
      column.push_back(0.0);
      const double rest = norm(level, w, threads);
      if (!std::isfinite(rest)) {
        throw ConvergenceError("Stokes solver: not a number in Krylov iteration " +
                               std::to_string(statistics.iterations + 1));
      }
      column[j + 1] = -rest;
      estimate = rotations.append(column);
      ++statistics.iterations;
      ++j;
      if (rest <= 1e-30 * beta) {
        break;
      }
    }
    const std::vector<double> y = rotations.solve();
    for (std::size_t i = 0; i < y.size(); ++i) {
      for_planes(planes, threads,
                 [&](int k) { axpy_plane(level, y[i], directions[i], x, k); });
    }
    true_residual(rows, level, x, b, w, threads);
    const double before = statistics.residual;
    statistics.residual = norm(level, w, threads);
    if (!(statistics.residual < 0.999 * before)) {
      break;  // stagnation: the caller reports it
    }
  }
  statistics.converged = statistics.residual <= options.target;
  return statistics;
}

}  // namespace colloid
