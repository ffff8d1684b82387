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

/// The numbers P_npq, V_npq, Q_npq do not depend on the spheres: computed once (a third
/// of a second at order 200), then summed for any ratio.
class TwoSphereRecurrences {
 public:
  explicit TwoSphereRecurrences(int order);

  /// `ratio` = lambda = a_2 / a_1 > 0.
  TwoSphereSeries series(double ratio) const;

 private:
  /// P_{1(k-q)q} (or Q) for k = 0 .. order, q = 0 .. k, at [k][q].
  using Triangle = std::vector<std::vector<double>>;

  int order_;
  Triangle xa_, ya_, yb_, xc_, yc_;
};

}  // namespace colloid
