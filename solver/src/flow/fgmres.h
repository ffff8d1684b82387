// Flexible GMRES (Saad 1993) on the scaled Stokes rows, with the multigrid cycle inside.
//
// The operator acts in double precision; the basis is kept in single precision, which is
// enough because the true residual is formed anew at every restart and at the end.
#pragma once

#include <functional>

#include "flow/level.h"

namespace colloid {

struct KrylovOptions {
  double target = 0.0;      ///< 2-norm of the residual to reach
  int max_iterations = 200;
  int restart = 20;         ///< basis vectors kept; each costs 32 bytes a cell
  int threads = 1;
};

struct KrylovStatistics {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  ///< true, 2-norm
};

/// Improves x, a solution of M x = b on `level`, until |b - M x| <= target.
/// `precondition(r, z)` sets z to about M^-1 r.
KrylovStatistics solve_fgmres(
    const WallRows& rows, const Fields<double>& b, Fields<double>& x,
    const std::function<void(const Fields<float>&, Fields<float>&)>& precondition,
    const KrylovOptions& options);

/// r = b - M x; halos of x are filled.
void true_residual(const WallRows& rows, const LevelView& level, Fields<double>& x,
                   const Fields<double>& b, Fields<double>& r, int threads);

/// 2-norm over the unknowns.
double norm(const LevelView& level, const Fields<double>& r, int threads);

}  // namespace colloid
