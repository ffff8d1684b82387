// Geometric multigrid for the Stokes system: an approximate inverse in single precision.
//
// Smoother: the inexact Braess-Sarazin sweep (Braess & Sarazin 1997; He & MacLachlan
// 2018, "Local Fourier analysis of block-structured multigrid relaxation schemes for the
// Stokes equations").  Velocities take a Jacobi step; a pressure that keeps them
// divergence-free comes from a few Jacobi steps on D C^-1 G, C the diagonal of the
// momentum rows:
//
//     [ alpha C   S G ] [du]   [ r   ]
//     [   D        0  ] [dp] = [ r_p ]                                         MODEL
//     (F11)
//
// Two alphas in turn damp like two Chebyshev steps.  Chosen against the cell-wise
// diagonal Vanka smoother, which needs fewer sweeps but couples neighbours in sequence:
// Jacobi steps run at the speed of memory, in any order, on any number of threads, with
// one result.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "flow/level.h"
#include "flow/transfer.h"

namespace colloid {

/// What one cycle does on each level.
struct CycleShape {
  int sweeps_before = 0;
  int sweeps_after = 0;
  int coarse_visits = 0;  ///< to each coarser level: 1 is a V-cycle, 2 a W-cycle
};

/// Chosen by processor time on the reference throat, clean and with 60 colloids, among 40
/// combinations.  Two visits to each coarser level (a W-cycle) cost a sixth more and save
/// a fifth of the iterations.
struct CycleOptions {
  CycleShape full{2, 3, 2};
  /// Costs less than half.  For the last iteration of a solve, if little is left to do:
  /// iterations reduce the residual 10 to 20 times, and half of them end far below the
  /// target.
  CycleShape light{1, 1, 1};
  int coarsest_sweeps = 12;
  std::array<float, 2> alpha{0.8F, 1.8F};  ///< of even and odd sweeps [-]
  /// Jacobi factors of the pressure steps: reciprocals of the roots of a Chebyshev
  /// polynomial over the upper part of the spectrum.
  std::array<float, 2> omega{0.6F, 1.6F};
};

class Multigrid {
 public:
  /// `finest` must outlive this.  Coarser levels are made from its grid and `spheres`.
  Multigrid(const WallRows& finest, const FlowFaces& faces,
            const std::vector<Sphere>& spheres, const CycleOptions& options, int threads);

  /// One cycle from zero, full or light: z = approximately M^-1 r.  r and z on the finest
  /// level, halos of r filled.
  void apply(const StokesVector<float>& r, StokesVector<float>& z, bool light);

  /// A sphere was added to the finest level: do the same to the others.
  void add(const std::vector<Sphere>& spheres);
  /// The same for spheres that move: WallRows::set_moving.
  void set_moving(const std::vector<Sphere>& spheres);

  /// One smoothing sweep on the finest level of u for the right-hand side f.
  void smooth(StokesVector<float>& u, const StokesVector<float>& f, bool from_zero,
              int sweep);

 private:
  struct Level {
    std::unique_ptr<WallRows> rows;  ///< empty on the finest level
    const WallRows* walls = nullptr;
    LevelView view;
    StokesVector<float> u, f, r;
    std::vector<float> b;               ///< right-hand side of the pressure steps
    std::vector<std::vector<float>> q;  ///< pressure after each of them
    LevelTransfer transfer;             ///< to the next coarser level
  };

  void sweep(Level& level, const StokesVector<float>& f, StokesVector<float>& u,
             bool from_zero, int number);
  void cycle(const CycleShape& shape, std::size_t index, const StokesVector<float>& f,
             StokesVector<float>& u, bool from_zero);
  void residual(Level& level, StokesVector<float>& u, const StokesVector<float>& f);

  CycleOptions options_;
  int threads_ = 1;
  std::vector<Level> levels_;
};

}  // namespace colloid
