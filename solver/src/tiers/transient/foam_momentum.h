// The momentum equation with free bodies in it.                          MODEL section T
#pragma once

#include <vector>

#include "tiers/transient/foam.h"
#include "tiers/transient/rigid.h"

namespace colloid {

/// A body as the momentum equation sees it.  All "kinematic": over the fluid's density.
struct MomentumBody {
  bool free = false;
  Six motion = Six::Zero();  ///< of a driven body: given; of a free one: result
  /// Of a free body: (M - M_fluid)/(rho dt), and that times the old motion plus F/rho.
  SixBySix inertia = SixBySix::Zero();
  Six source = Six::Zero();
  /// M/(rho dt): what the preconditioner takes for the body with the liquid inside.
  SixBySix whole_inertia = SixBySix::Zero();
};

struct SolveReport {
  int iterations = 0;
  double initial = 0.0;  ///< residuals: of the pressure 2-norm, of the momentum see there
  double final = 0.0;
};

/// Solves, until the residual over the diagonal, as root mean square over the volume, is
/// `tolerance` times that at the start,
///         (A + lambda) u - lambda V(q) = b,
///         inertia q = source + sum of lambda V^T (u - V(q))
/// for u (in `matrix.psi()`) and the motions of free bodies, by BiCGStab (van der Vorst
/// 1992).  Preconditioner: incomplete LU of A + lambda, plus for each free body the
/// exact inverse on its rigid motions alone, without which these modes, which the strong
/// lambda hides from the first, would each cost an iteration.
SolveReport solve_momentum(Foam::fvVectorMatrix& matrix,
                           const std::vector<ImmersedEntry>& entries,
                           std::vector<MomentumBody>& bodies, double tolerance,
                           int most_iterations);

}  // namespace colloid
