// Flexible GMRES (Saad 1993) on the scaled Stokes rows, with the multigrid cycle inside.
//
// The operator acts in double precision; the basis is kept in single precision, which is
// enough because the true residual is formed anew at every restart and at the end.
#pragma once

#include <functional>

#include "flow/level.h"

namespace colloid {

struct KrylovOptions {
  double target = 0.0;  ///< 2-norm of the residual to reach
  int max_iterations = 200;
  int restart = 20;  ///< basis vectors kept; each costs 32 bytes a cell
  int threads = 1;
};

struct KrylovStatistics {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;          ///< true, 2-norm
  double residual_seconds = 0.0;  ///< processor time of the fastest evaluation of it
};

/// The solver and its vectors, which are kept from one solve to the next.
class Fgmres {
 public:
  /// Sets z to about M^-1 r; halos of r are filled.  A cheaper z will do if `light`: half
  /// of what the iteration before gained would reach the target.
  using Preconditioner = std::function<void(const StokesVector<float>& r,
                                            StokesVector<float>& z, bool light)>;

  explicit Fgmres(const WallRows& rows) : rows_(rows), w_(rows.grid().size) {}

  /// Improves x, a solution of M x = b, until |b - M x| <= target.
  KrylovStatistics solve(const StokesVector<double>& b, StokesVector<double>& x,
                         const Preconditioner& precondition,
                         const KrylovOptions& options);

 private:
  std::vector<double> extend(std::size_t j, double length, bool light,
                             const Preconditioner& precondition, int threads);

  const WallRows& rows_;
  StokesVector<double> w_;
  std::vector<StokesVector<float>> basis_;
  std::vector<StokesVector<float>> directions_;
};

/// r = b - M x; halos of x are filled.
void true_residual(const WallRows& rows, const LevelView& level, StokesVector<double>& x,
                   const StokesVector<double>& b, StokesVector<double>& r, int threads);

/// 2-norm over the unknowns.
double norm(const LevelView& level, const StokesVector<double>& r, int threads);

}  // namespace colloid
