#include "tiers/deposit_flow.h"

#include <cmath>

#include "flow/interpolation.h"
#include "tiers/flow_problem.h"

namespace colloid {

namespace {

// Corners of an icosahedron on the unit sphere: (0, +-1, +-g) and its rotations, g the
// golden ratio.
std::array<Vec3, 12> icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const double scale = 1.0 / std::sqrt(1.0 + g * g);
  std::array<Vec3, 12> points;
  std::size_t n = 0;
  for (double s : {-1.0, 1.0}) {
    for (double t : {-1.0, 1.0}) {
      points[n++] = Vec3{0.0, s, t * g} * scale;
      points[n++] = Vec3{s, t * g, 0.0} * scale;
      points[n++] = Vec3{t * g, 0.0, s} * scale;
    }
  }
  return points;
}

StokesOptions flow_options(const Scene& scene, int threads) {
  StokesOptions options;
  options.tolerance = scene.fidelity.tolerance;
  options.threads = threads;
  return options;
}

}  // namespace

DepositFlow::DepositFlow(const Scene& scene, const std::array<int, 3>& cells, int threads)
    : solver_(std::make_unique<StokesSolver>(make_flow_problem(scene, {}, cells),
                                             flow_options(scene, threads))) {
  solve();
}

void DepositFlow::solve() {
  const StokesStatistics& s = solver_->solve();
  ++solves_;
  iterations_ += s.iterations;
  seconds_ += s.seconds + s.setup_seconds;
  work_units_ += s.work_units;
}

void DepositFlow::add_unsolved(const std::vector<Sphere>& deposit) {
  solver_->add_spheres(deposit);
}

void DepositFlow::add(const std::vector<Sphere>& deposit) {
  add_unsolved(deposit);
  solve();
}

AmbientMotion DepositFlow::around(const Vec3& centre, double radius) const {
  AmbientMotion motion;
  if (blocked_) {
    return motion;
  }
  static const std::array<Vec3, 12> kPoints = icosahedron();
  Vec3 turn;
  Matrix3 gradient = Matrix3::Zero();
  for (const Vec3& n : kPoints) {
    const Vec3 u = velocity_at(*solver_, centre + n * radius);
    motion.velocity += u;
    turn += cross(n, u);
    gradient += eigen(u) * eigen(n).transpose();
  }
  constexpr double kWeight = 1.0 / 12.0;
  motion.velocity *= kWeight;
  // The mean of n x (w x n) over the sphere is 2/3 w.
  motion.spin = turn * (1.5 * kWeight / radius);
  // That of u n is a third of the gradient.
  gradient *= 3.0 * kWeight / radius;
  motion.strain = 0.5 * (gradient + gradient.transpose());
  return motion;
}

double DepositFlow::flow_rate() const {
  return blocked_ ? 0.0 : std::abs(solver_->flow_rate());
}

double DepositFlow::permeability() const {
  return blocked_ ? 0.0 : solver_->permeability();
}

std::vector<double> DepositFlow::state() const {
  return solver_->state();
}

void DepositFlow::restore(const std::vector<double>& state, bool blocked, long solves,
                          long iterations) {
  solver_->restore(state);
  blocked_ = blocked;
  solves_ = solves;
  iterations_ = iterations;
}

}  // namespace colloid
