// The flow around grains and deposit, as it carries colloids.             MODEL (F), (P1)
#pragma once

#include <memory>
#include <vector>

#include "flow/stokes_solver.h"
#include "particles/ambient_flow.h"
#include "scene/scene.h"

namespace colloid {

class DepositFlow : public AmbientFlow {
 public:
  /// Solves the flow around the clean grains.  Throws what StokesSolver throws.
  DepositFlow(const Scene& scene, const std::array<int, 3>& cells, int threads);

  /// The deposit grew: solves again, from the last solution.
  void add(const std::vector<Sphere>& deposit);
  /// The same without solving: before restore().
  void add_unsolved(const std::vector<Sphere>& deposit);
  /// Nothing passes any more although the drive holds a flux: the liquid stands.
  void block() { blocked_ = true; }

  /// Faxen averages over the colloid's surface, from twelve points (the corners of an
  /// icosahedron: exact for polynomials to the fifth degree).
  AmbientMotion around(const Vec3& centre, double radius) const override;

  double flow_rate() const;     ///< along the flow's axis, positive [m^3/s]
  double permeability() const;  ///< [m^2]
  const StokesSolver& solver() const { return *solver_; }

  long solves() const { return solves_; }
  long iterations() const { return iterations_; }
  double seconds() const { return seconds_; }  ///< of all solves, with set-up
  double work_units() const { return work_units_; }

  /// Everything the next solve depends on, but for the spheres.
  std::vector<double> state() const;
  void restore(const std::vector<double>& state, bool blocked, long solves,
               long iterations);
  bool blocked() const { return blocked_; }

 private:
  void solve();

  std::unique_ptr<StokesSolver> solver_;
  bool blocked_ = false;
  long solves_ = 0;
  long iterations_ = 0;
  double seconds_ = 0.0;
  double work_units_ = 0.0;
};

}  // namespace colloid
