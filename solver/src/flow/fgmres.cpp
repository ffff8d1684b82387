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

// Direction j from basis vector j: the border's unknowns first, then the flow that they
// and the basis vector ask for.  (Block triangular: exact if the flow's part were, and
// the border's scaling too.)
void Fgmres::precondition_bordered(std::size_t j, bool light, const KrylovBorder* border,
                                   const Preconditioner& precondition) {
  if (border == nullptr) {
    fill_halos(rows_.grid(), basis_[j]);
    precondition(basis_[j], directions_[j], light);
    return;
  }
  directions_border_[j] = basis_border_[j];
  right_side_ = basis_[j];
  const int planes = view(rows_).end[2];
  for (int k = 0; k < planes; ++k) {
    border->add_columns(directions_border_[j], right_side_, k);
  }
  fill_halos(rows_.grid(), right_side_);
  precondition(right_side_, directions_[j], light);
}

// Basis vector j from w, direction j from it, and w = M z made orthogonal to the basis:
// classical Gram-Schmidt, so that w passes through the cache twice, however many vectors.
// Returns column j of the Hessenberg matrix, j + 2 entries.
std::vector<double> Fgmres::extend(std::size_t j, double length, bool light,
                                   const KrylovBorder* border,
                                   const Preconditioner& precondition, int threads) {
  const LevelView level = view(rows_);
  const int planes = level.end[2];
  if (j == directions_.size()) {
    basis_.emplace_back(rows_.grid().size);
    directions_.emplace_back(rows_.grid().size);
  }
  if (j == basis_border_.size()) {
    basis_border_.emplace_back();
    directions_border_.emplace_back();
  }
  for_planes(planes, threads,
             [&](int k) { scaled_copy_plane(level, 1.0 / length, w_, basis_[j], k); });
  basis_border_[j] = w_border_ / length;
  precondition_bordered(j, light, border, precondition);
  fill_halos(rows_.grid(), directions_[j]);

  // w = -A z, so all products have the wrong sign; plane sums are added in order.
  const std::size_t count = j + 1;
  std::vector<double> part(static_cast<std::size_t>(planes) * count);
  for_planes(planes, threads, [&](int k) {
    minus_apply_plane(level, directions_[j], w_, k);
    if (border != nullptr) {
      border->add_columns(directions_border_[j], w_, k);
    }
    dots_plane(level, w_, basis_.data(), count,
               part.data() + static_cast<std::size_t>(k) * count, k);
  });
  std::vector<double> column(count + 1, 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(planes); ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      column[i] -= part[k * count + i];
    }
  }
  if (border != nullptr) {
    w_border_ = -border->rows(directions_[j], directions_border_[j]);
    for (std::size_t i = 0; i < count; ++i) {
      column[i] -= w_border_.dot(basis_border_[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      w_border_ += column[i] * basis_border_[i];
    }
  }
  const double square = sum_planes(planes, threads, [&](int k) {
    return combine_plane(level, column.data(), basis_.data(), count, w_, k);
  });
  column[count] = -std::sqrt(square + w_border_.squaredNorm());
  return column;
}

// w = b - A x.
double Fgmres::residual_norm(const StokesVector<double>& b, StokesVector<double>& x,
                             const BorderedPart* part, int threads, double& seconds) {
  const LevelView level = view(rows_);
  const double start = processor_seconds();
  true_residual(rows_, level, x, b, w_, threads);
  seconds = processor_seconds() - start;
  if (part == nullptr) {
    w_border_.resize(0);
    return norm(level, w_, threads);
  }
  for (int k = 0; k < level.end[2]; ++k) {
    part->border.add_columns(part->q, w_, k);
  }
  w_border_ = part->g - part->border.rows(x, part->q);
  return std::hypot(norm(level, w_, threads), w_border_.norm());
}

KrylovStatistics Fgmres::solve(const StokesVector<double>& b, StokesVector<double>& x,
                               BorderedPart* part, const Preconditioner& precondition,
                               const KrylovOptions& options) {
  const LevelView level = view(rows_);
  const int planes = level.end[2];
  const KrylovBorder* border = part == nullptr ? nullptr : &part->border;
  KrylovStatistics statistics;

  const auto evaluate_residual = [&] {
    double seconds = 0.0;
    const double size = residual_norm(b, x, part, options.threads, seconds);
    if (statistics.residual_seconds == 0.0 || seconds < statistics.residual_seconds) {
      statistics.residual_seconds = seconds;
    }
    return size;
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
          extend(j, length, light, border, precondition, options.threads);
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
    if (part != nullptr) {
      for (std::size_t i = 0; i < y.size(); ++i) {
        part->q += y[i] * directions_border_[i];
      }
    }
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
