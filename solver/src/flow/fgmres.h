// Flexible GMRES (Saad 1993) on the scaled Stokes rows, with the multigrid cycle inside.
//
// The operator acts in double precision; the basis is kept in single precision, which is
// enough because the true residual is formed anew at every restart and at the end.
#pragma once

#include <functional>

#include <Eigen/Core>

#include "flow/level.h"

namespace colloid {

struct KrylovOptions {
  double target = 0.0;  ///< 2-norm of the residual to reach
  int max_iterations = 200;
  int restart = 20;  ///< basis vectors kept; each costs 32 bytes a cell
  int threads = 1;
};

/// A few unknowns q and equations besides those of the flow:
///
///     [ M  -G ] [x]   [f]
///     [ B   C ] [q] = [g],      with B and C scaled so that about C - B M^-1 (-G) = I.
class KrylovBorder {
 public:
  KrylovBorder() = default;
  KrylovBorder(const KrylovBorder&) = delete;
  KrylovBorder& operator=(const KrylovBorder&) = delete;
  virtual ~KrylovBorder() = default;

  virtual std::size_t size() const = 0;
  /// w += G q on the plane k.
  virtual void add_columns(const Eigen::VectorXd& q, StokesVector<double>& w,
                           int k) const = 0;
  virtual void add_columns(const Eigen::VectorXd& q, StokesVector<float>& w,
                           int k) const = 0;
  /// B x + C q; halos of x are filled.
  virtual Eigen::VectorXd rows(const StokesVector<double>& x,
                               const Eigen::VectorXd& q) const = 0;
  virtual Eigen::VectorXd rows(const StokesVector<float>& x,
                               const Eigen::VectorXd& q) const = 0;
};

/// The border's right-hand side and unknowns.
struct BorderedPart {
  const KrylovBorder& border;
  Eigen::VectorXd g;
  Eigen::VectorXd q;
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
                         const KrylovOptions& options) {
    return solve(b, x, nullptr, precondition, options);
  }
  /// The same with a border; q of `part` is improved with x.  The residual's norm is that
  /// of both parts.
  KrylovStatistics solve(const StokesVector<double>& b, StokesVector<double>& x,
                         BorderedPart* part, const Preconditioner& precondition,
                         const KrylovOptions& options);

 private:
  std::vector<double> extend(std::size_t j, double length, bool light,
                             const KrylovBorder* border,
                             const Preconditioner& precondition, int threads);
  void precondition_bordered(std::size_t j, bool light, const KrylovBorder* border,
                             const Preconditioner& precondition);
  double residual_norm(const StokesVector<double>& b, StokesVector<double>& x,
                       const BorderedPart* part, int threads, double& seconds);

  const WallRows& rows_;
  StokesVector<double> w_;
  StokesVector<float> right_side_;  ///< of the flow's part of a preconditioned vector
  std::vector<StokesVector<float>> basis_;
  std::vector<StokesVector<float>> directions_;
  Eigen::VectorXd w_border_;  ///< the border's part of w_, basis_ and directions_
  std::vector<Eigen::VectorXd> basis_border_;
  std::vector<Eigen::VectorXd> directions_border_;
};

/// r = b - M x; halos of x are filled.
void true_residual(const WallRows& rows, const LevelView& level, StokesVector<double>& x,
                   const StokesVector<double>& b, StokesVector<double>& r, int threads);

/// 2-norm over the unknowns.
double norm(const LevelView& level, const StokesVector<double>& r, int threads);

}  // namespace colloid
