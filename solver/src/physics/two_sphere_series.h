// Coefficients of the resistance functions of two spheres in powers of their inverse
// distance: Jeffrey & Onishi (1984), J. Fluid Mech. 139, 261 ("JO").
#pragma once

#include <vector>

namespace colloid {

/// f_m / (2 (1 + lambda))^m for m = 0 .. order, of the function named: with u = (a_1 +
/// a_2)/r the sums over even or odd m of these times u^m are the resistance functions, JO
/// (3.15).
struct TwoSphereSeries {
  std::vector<double> xa, ya, yb, xc, yc;
};

/// The same of the first moments (stresslets) of the tractions on both spheres, equal
/// ones, when one of them moves along or across d or turns about an axis across it: the
/// sums over q of P_{2(k-q)q} at [k], over 2^k.  Even k: on the moving sphere's neighbour
/// for the two translations and on itself for the rotation; odd k: the other way round.
struct StressletSeries {
  std::vector<double> along, across, turning;
};

/// The numbers P_npq, V_npq, Q_npq do not depend on the spheres: computed once (a third
/// of a second at order 200), then summed for any ratio.
class TwoSphereRecurrences {
 public:
  explicit TwoSphereRecurrences(int order);

  /// `ratio` = lambda = a_2 / a_1 > 0.
  TwoSphereSeries series(double ratio) const;
  StressletSeries stresslets_of_equal_spheres() const;

 private:
  /// P_{n(k-q)q} (or Q) of one n for k = 0 .. order, q = 0 .. k, at [k][q].
  using Triangle = std::vector<std::vector<double>>;

  int order_;
  Triangle xa_, ya_, yb_, xc_, yc_;
  Triangle along_, across_, turning_;
};

/// At which all functions made from the series are cut.
constexpr int kTwoSphereOrder = 150;

/// One object of that order for all who need it.
const TwoSphereRecurrences& two_sphere_recurrences();

/// Sum of c_m u^m for 0 <= u <= 1 (contact) of spheres that do not move relative to each
/// other: the poles and logarithms of lubrication cancel, and what the terms still have
/// of them is a singularity at u = -1.  Multiplied by (1 + u)^2 and divided again, the
/// sum converges at contact, to about 3e-5.
double sum_without_lubrication(std::vector<double> coefficients, double u);

}  // namespace colloid
