#include "physics/pair_resistance.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/constants.h"
#include "core/error.h"
#include "physics/two_sphere_series.h"

namespace colloid {

namespace {

constexpr int kOrder = kTwoSphereOrder;  // of the series in 2/s

// Functions in the order of the rows: those even in u = 2/s, then the odd ones.
enum Function : int {
  xa11,
  xa22,
  ya11,
  ya22,
  yb12,
  yb21,
  xc11,
  xc22,
  yc11,
  yc22,
  xa12,
  ya12,
  yb11,
  yb22,
  xc12,
  yc12
};
constexpr int kEven = 10;

/// One resistance function: prefactor times (lubrication terms + remainder).
struct Expansion {
  const std::vector<double>* coefficients;  // f_m / (2 (1 + lambda))^m
  double prefactor;
  double pole;  // g_1
  double log;   // g_2
  double xlog;  // g_3
};

/// The lubrication coefficients of JO, lambda = a_2/a_1: (3.17), (4.15), (5.6), (6.10),
/// (7.10); the last of yc12 with the 1/500 of Townsend (2018), arXiv:1802.08226, eq.
/// (30), which the decay of the series' remainder confirms.
struct Lubrication {
  explicit Lubrication(double l)
      : cube((1 + l) * (1 + l) * (1 + l)),
        xa_pole(2 * l * l / cube),
        xa_log(l * (1 + 7 * l + l * l) / (5 * cube)),
        xa_xlog((1 + l * (18 + l * (-29 + l * (18 + l)))) / (42 * cube)),
        ya_log(4 * l * (2 + l + 2 * l * l) / (15 * cube)),
        ya_xlog(2 * (16 + l * (-45 + l * (58 + l * (-45 + l * 16)))) / (375 * cube)),
        yb_log(-l * (4 + l) / (5 * (1 + l) * (1 + l))),
        yb_xlog(-(32 + l * (-33 + l * (83 + l * 43))) / (250 * (1 + l) * (1 + l))),
        xc_xlog(-l * l / (4 * (1 + l))),
        yc_log(2 * l / (5 * (1 + l))),
        yc_xlog((8 + l * (6 + l * 33)) / (125 * (1 + l))),
        yc12_log(l * l / (10 * (1 + l))),
        yc12_xlog(l * (43 + l * (-24 + l * 43)) / (500 * (1 + l))) {}

  double cube, xa_pole, xa_log, xa_xlog, ya_log, ya_xlog, yb_log, yb_xlog, xc_xlog,
      yc_log, yc_xlog, yc12_log, yc12_xlog;
};

/// Coefficients of u^m, m = 0 .. kOrder of one parity, in -ln(1 - u^2) (even) or
/// ln((1 + u)/(1 - u)) (odd), and in the same times 1 - u^2 and (1 - u^2)^2.
std::array<std::vector<double>, 3> log_series(int parity) {
  std::array<std::vector<double>, 3> series;
  for (auto& s : series) {
    s.assign(kOrder + 1, 0.0);
  }
  for (int m = parity == 0 ? 2 : 1; m <= kOrder; m += 2) {
    const auto i = static_cast<std::size_t>(m);
    series[0][i] = 2.0 / m;
    for (std::size_t k = 1; k < series.size(); ++k) {
      series[k][i] = series[k - 1][i] - (m >= 2 ? series[k - 1][i - 2] : 0.0);
    }
  }
  return series;
}

/// What the lubrication terms leave of an expansion, as coefficients of u^m.
struct Remainder {
  double x2log;  // coefficient of (1 - u^2)^2 ln, fitted to the last half of the series
  std::vector<double> coefficients;
};

Remainder remainder_of(const Expansion& f, int parity) {
  static const std::array<std::vector<double>, 3> kLogs[2] = {log_series(0),
                                                              log_series(1)};
  const auto& logs = kLogs[parity];
  Remainder rest{0.0, std::vector<double>(kOrder + 1, 0.0)};
  double sum = 0.0;
  int count = 0;
  for (int m = parity; m <= kOrder; m += 2) {
    const auto i = static_cast<std::size_t>(m);
    rest.coefficients[i] =
        (*f.coefficients)[i] - f.pole - f.log * logs[0][i] - f.xlog * logs[1][i];
    if (2 * m > kOrder) {
      sum += rest.coefficients[i] / logs[2][i];
      ++count;
    }
  }
  rest.x2log = sum / count;
  for (int m = parity; m <= kOrder; m += 2) {
    const auto i = static_cast<std::size_t>(m);
    rest.coefficients[i] -= rest.x2log * logs[2][i];
  }
  return rest;
}

/// Sum of coefficients u^m over one parity, divided by u for the odd one; v = u^2.
double sum_in_v(const std::vector<double>& coefficients, int parity, double v) {
  double sum = 0.0;
  for (int m = kOrder - (kOrder - parity) % 2; m >= parity; m -= 2) {
    sum = sum * v + coefficients[static_cast<std::size_t>(m)];
  }
  return sum;
}

/// The polynomial of degree kDegree in t = 2v - 1 that equals the sum at Chebyshev's
/// points, as coefficients of the powers of t.
std::vector<double> polynomial_of(const std::vector<double>& coefficients, int parity) {
  constexpr int kDegree = TwoSphereResistance::kDegree;
  constexpr int kPoints = kDegree + 1;
  std::vector<double> chebyshev(kPoints, 0.0);
  for (int j = 0; j < kPoints; ++j) {
    const double theta = kPi * (j + 0.5) / kPoints;
    const double value = sum_in_v(coefficients, parity, 0.5 * (1.0 + std::cos(theta)));
    for (int k = 0; k < kPoints; ++k) {
      chebyshev[static_cast<std::size_t>(k)] +=
          (k == 0 ? 1.0 : 2.0) / kPoints * value * std::cos(k * theta);
    }
  }
  // T_0 = 1, T_1 = t, T_(k+1) = 2t T_k - T_(k-1), as powers of t.
  std::vector<double> powers(kPoints, 0.0);
  std::vector<double> before(kPoints, 0.0);
  std::vector<double> now(kPoints, 0.0);
  before[1] = 1.0;  // T_(-1) = T_1
  now[0] = 1.0;
  for (std::size_t k = 0; k < kPoints; ++k) {
    std::vector<double> next(kPoints, 0.0);
    for (std::size_t i = 0; i < kPoints; ++i) {
      powers[i] += chebyshev[k] * now[i];
      next[i] = (i > 0 ? 2.0 * now[i - 1] : 0.0) - before[i];
    }
    before = now;
    now = next;
  }
  return powers;
}

}  // namespace

TwoSphereResistance::TwoSphereResistance(double ratio) {
  require(ratio >= 0.05 && ratio <= 20.0, "two spheres",
          "the ratio of their radii must be in [0.05, 20]; beyond, one is a wall");
  const TwoSphereSeries one = two_sphere_recurrences().series(ratio);
  const TwoSphereSeries two = two_sphere_recurrences().series(1.0 / ratio);
  const Lubrication g(ratio);
  const Lubrication h(1.0 / ratio);
  const double l = ratio;
  const double m = 1.0 / ratio;

  // JO (1.9), (3.15): a function 22 or 21 is 11 or 12 at 1/lambda, with yb of changed
  // sign.
  std::array<Expansion, kFunctions> functions{};
  functions[xa11] = {&one.xa, 1.0, g.xa_pole, g.xa_log, g.xa_xlog};
  functions[xa22] = {&two.xa, 1.0, h.xa_pole, h.xa_log, h.xa_xlog};
  functions[xa12] = {&one.xa, -2 / (1 + l), g.xa_pole, g.xa_log, g.xa_xlog};
  functions[ya11] = {&one.ya, 1.0, 0.0, g.ya_log, g.ya_xlog};
  functions[ya22] = {&two.ya, 1.0, 0.0, h.ya_log, h.ya_xlog};
  functions[ya12] = {&one.ya, -2 / (1 + l), 0.0, g.ya_log, g.ya_xlog};
  functions[yb11] = {&one.yb, 1.0, 0.0, g.yb_log, g.yb_xlog};
  functions[yb22] = {&two.yb, -1.0, 0.0, h.yb_log, h.yb_xlog};
  functions[yb12] = {&one.yb, -4 / ((1 + l) * (1 + l)), 0.0, g.yb_log, g.yb_xlog};
  functions[yb21] = {&two.yb, 4 / ((1 + m) * (1 + m)), 0.0, h.yb_log, h.yb_xlog};
  functions[xc11] = {&one.xc, 1.0, 0.0, 0.0, g.xc_xlog};
  functions[xc22] = {&two.xc, 1.0, 0.0, 0.0, h.xc_xlog};
  functions[xc12] = {&one.xc, -8 / g.cube, 0.0, 0.0, g.xc_xlog};
  functions[yc11] = {&one.yc, 1.0, 0.0, g.yc_log, g.yc_xlog};
  functions[yc22] = {&two.yc, 1.0, 0.0, h.yc_log, h.yc_xlog};
  functions[yc12] = {&one.yc, 8 / g.cube, 0.0, g.yc12_log, g.yc12_xlog};

  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Expansion& f = functions[i];
    const int parity = i < kEven ? 0 : 1;
    const Remainder rest = remainder_of(f, parity);
    const std::vector<double> powers = polynomial_of(rest.coefficients, parity);
    pole_[i] = f.prefactor * f.pole;
    log_[0][i] = f.prefactor * f.log;
    log_[1][i] = f.prefactor * f.xlog;
    log_[2][i] = f.prefactor * rest.x2log;
    for (std::size_t k = 0; k < polynomial_.size(); ++k) {
      polynomial_[k][i] = f.prefactor * powers[k];
    }
  }
}

PairResistance TwoSphereResistance::at(double gap) const {
  const double u = 2.0 / (2.0 + gap);
  const double one_minus_u = std::isinf(gap) ? 1.0 : gap / (2.0 + gap);
  const double w = one_minus_u * (1.0 + u);
  const double t = 2.0 * u * u - 1.0;
  const double even_log = -std::log(w);
  const double odd_log = even_log + 2.0 * std::log1p(u);

  Row sum = polynomial_[kDegree];
  for (std::size_t k = kDegree; k-- > 0;) {
    for (std::size_t i = 0; i < kFunctions; ++i) {
      sum[i] = sum[i] * t + polynomial_[k][i];
    }
  }
  Row f{};
  for (std::size_t i = 0; i < kFunctions; ++i) {
    const double log = i < kEven ? even_log : odd_log;
    const double factor = i < kEven ? 1.0 : u;
    f[i] = factor * (sum[i] + pole_[i] / w) +
           log * (log_[0][i] + w * (log_[1][i] + w * log_[2][i]));
  }
  return {f[xa11], f[xa12], f[xa22], f[ya11], f[ya12], f[ya22], f[yb11], f[yb12],
          f[yb21], f[yb22], f[xc11], f[xc12], f[xc22], f[yc11], f[yc12], f[yc22]};
}

}  // namespace colloid
