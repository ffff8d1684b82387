#include "physics/pair_in_strain.h"

#include <cstddef>
#include <vector>

#include "physics/two_sphere_series.h"

namespace colloid {

namespace {

constexpr int kDegree = 40;

/// Sphere 1 at -s/2, sphere 2 at +s/2 on the z axis, a = 1, held in the strain E about
/// their midpoint.  MODEL (R12), by the reciprocal theorem: the force in the strain is
/// that of the translations of the centres and the first moments of the tractions when
/// sphere 1 moves; the latter's coefficients are scaled by their known leading terms:
///
///     F_z = -6 pi mu a^2 E_zz (s/2) f_along,    f_along  = xa11 - xa12 - 5/s^3 ...
///     F_x = -6 pi mu a^2 E_xz (s/2) f_across,   f_across = ya11 - ya12 - 16/(3 s^5) ...
///     T_y = +8 pi mu a^3 E_xz t,            t = (s/4) (yb11 - yb12) + 5/(2 s^3) ...
ChebyshevSeries<3> held_against_u() {
  const TwoSphereSeries series = two_sphere_recurrences().series(1.0);
  const StressletSeries moment = two_sphere_recurrences().stresslets_of_equal_spheres();
  const double along_scale = -5.0 / 8.0 / moment.along[2];
  const double across_scale = -1.0 / 6.0 / moment.across[4];
  const double torque_scale = 5.0 / 16.0 / moment.turning[3];
  std::vector<double> along = series.xa;
  std::vector<double> across = series.ya;
  std::vector<double> torque;
  torque.reserve(along.size());
  for (std::size_t m = 1; m < along.size(); ++m) {
    along[m] += along_scale * moment.along[m - 1];
    across[m] += across_scale * moment.across[m - 1];
    torque.push_back(0.5 * series.yb[m] + torque_scale * moment.turning[m - 1]);
  }
  return ChebyshevSeries<3>(kDegree, [&](double u) {
    return std::array<double, 3>{sum_without_lubrication(along, u),
                                 sum_without_lubrication(across, u),
                                 sum_without_lubrication(torque, u)};
  });
}

}  // namespace

PairInStrain::PairInStrain() : resistance_(1.0), held_(held_against_u()) {}

StrainHindrance PairInStrain::at(double gap) const {
  const PairResistance r = resistance_.at(gap);
  const auto [along, across, torque] = held_.at(2.0 / (2.0 + gap));
  // No force and no torque on either: they move with -+V E s/2 and turn with w E,
  //   3 s (translation V - across) + 4 coupling w = 0
  //   (s/4) coupling V + rotation w               = torque
  const double translation = r.ya11 - r.ya12;
  const double coupling = r.yb11 - r.yb12;
  const double rotation = r.yc11 + r.yc12;
  const double speed =
      (across - 4.0 / 3.0 * coupling * torque / (rotation * (2.0 + gap))) /
      (translation - coupling * coupling / (3.0 * rotation));
  return {1.0 - along / (r.xa11 - r.xa12), 1.0 - speed};
}

}  // namespace colloid
