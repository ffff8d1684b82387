#include "tiers/transient/dem_bonds.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace colloid {

namespace {

constexpr double kDamping = 0.15;      // over the critical, of a pair along its line
constexpr double kAcross = 2.0 / 7.0;  // k_t / k: a pair's frequency as along it
constexpr double kAbout = 0.1;         // k_b / (k a^2)

double mass_of(const DemOptions& options) {
  const double a = options.radius;
  return options.density * 4.0 / 3.0 * kPi * a * a * a;
}

}  // namespace

BondStiffness bond_stiffness(const DemOptions& options) {
  const DemSurface& surface = options.colloid;
  const double nu = surface.poisson_ratio;
  const double modulus = surface.young_modulus / (2.0 * (1.0 - nu * nu));
  const double a = options.radius;
  const double overlap = std::pow(
      options.surfaces.colloid.pull_off / (4.0 / 3.0 * modulus * std::sqrt(0.5 * a)),
      2.0 / 3.0);
  BondStiffness k;
  // Without a pull-off there is no overlap to speak of: a millionth of the radius.
  k.normal = 2.0 * modulus * std::sqrt(0.5 * a * std::max(overlap, 1e-6 * a));
  k.across = kAcross * k.normal;
  k.about = kAbout * k.normal * a * a;
  const double rate = std::sqrt(2.0 * k.normal / mass_of(options));
  k.normal_damping = 2.0 * kDamping * k.normal / rate;
  k.across_damping = 2.0 * kDamping * k.across / rate;
  k.about_damping = 2.0 * kDamping * k.about / rate;
  return k;
}

double longest_bond_step(const DemOptions& options) {
  // Stiffness over inertia of any motion is at most (differences squared are at most
  // twice the squares, sums of four at most four times; the sum of n n over twelve bonds
  // is 4)
  //     2 4 k/m + 4 8 k_t/m                        of places
  //     (4 8 k_t + 2 12 k_b/a^2) / (2/5 m)         of spins
  // in units of the pair's 2 k/m:
  const double places = 4.0 + 16.0 * kAcross;
  const double spins = (16.0 * kAcross + 12.0 * kAbout) / 0.4;
  const double most = std::max(places, spins);
  // Leapfrog with damping of the velocity before: 4 - 4 z q s - q s^2 > 0 for the damping
  // z, the ratio q = `most` and the phase s = rate dt.
  const double rate = std::sqrt(2.0 * bond_stiffness(options).normal / mass_of(options));
  return (std::sqrt(4.0 * kDamping * kDamping + 4.0 / most) - 2.0 * kDamping) / rate;
}

BondForce bond_force(Bond& bond, const BondStiffness& k, const Vec3& offset,
                     const BondEnd& first, const BondEnd& second, double step) {
  const double length = norm(offset);
  const Vec3 n = offset * (1.0 / length);
  const double arm = 0.5 * length;
  const Vec3 relative =
      first.velocity - second.velocity - arm * cross(first.spin + second.spin, n);
  const double along = dot(relative, n);
  const Vec3 sliding = relative - along * n;
  // The displacement turns with the pair: into its new plane, as long as before.
  const double before = norm(bond.across);
  bond.across -= dot(bond.across, n) * n;
  const double after = norm(bond.across);
  if (after > 0.0) {
    bond.across *= before / after;
  }
  bond.across += step * sliding;
  bond.tension = k.normal * (length - bond.length);
  bond.largest_tension = std::max(bond.largest_tension, bond.tension);

  BondForce out;
  out.force = -(bond.tension + k.normal_damping * along) * n - k.across * bond.across -
              k.across_damping * sliding;
  out.first_torque = -arm * cross(n, out.force);
  out.second_torque = out.first_torque;
  if (bond.rigid != 0) {
    const Vec3 turning = first.spin - second.spin;
    bond.about += step * (turning + cross(0.5 * (first.spin + second.spin), bond.about));
    const Vec3 moment = -k.about * bond.about - k.about_damping * turning;
    out.first_torque += moment;
    out.second_torque -= moment;
  }
  return out;
}

}  // namespace colloid
