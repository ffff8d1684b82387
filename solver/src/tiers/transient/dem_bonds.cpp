#include "tiers/transient/dem_bonds.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace colloid {

namespace {

constexpr double kDamping = 0.7;  // over the critical

}  // namespace

BondStiffness bond_stiffness(const DemOptions& options) {
  const DemSurface& surface = options.colloid;
  const double nu = surface.poisson_ratio;
  const double modulus = surface.young_modulus / (2.0 * (1.0 - nu * nu));
  const double a = options.radius;
  const double overlap = std::pow(
      options.surfaces.colloid.pull_off / (4.0 / 3.0 * modulus * std::sqrt(0.5 * a)),
      2.0 / 3.0);
  const double mass = options.density * 4.0 / 3.0 * kPi * a * a * a;
  BondStiffness k;
  // Without a pull-off there is no overlap to speak of: a millionth of the radius.
  k.normal = 2.0 * modulus * std::sqrt(0.5 * a * std::max(overlap, 1e-6 * a));
  // Equal frequencies: 2/m along, 7/m across, 5/(m a^2) about are the inverse inertias.
  k.across = 2.0 / 7.0 * k.normal;
  k.about = 2.0 / 5.0 * k.normal * a * a;
  const double rate = std::sqrt(2.0 * k.normal / mass);
  k.normal_damping = 2.0 * kDamping * k.normal / rate;
  k.across_damping = 2.0 * kDamping * k.across / rate;
  k.about_damping = 2.0 * kDamping * k.about / rate;
  return k;
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
