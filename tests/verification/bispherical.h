// The bispherical solutions of Stimson & Jeffery (1926) and Maude (1961) for two spheres
// that move along their line of centres and of Jeffery (1915) for spin about it, summed
// in long double: references that share nothing with the code under test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace colloid {

using Real = long double;

/// Solves a 4 x 4 system by elimination with pivoting.
inline std::array<Real, 4> solve4(std::array<std::array<Real, 5>, 4> m) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < 4; ++r) {
      best = std::abs(m[r][c]) > std::abs(m[best][c]) ? r : best;
    }
    std::swap(m[c], m[best]);
    for (std::size_t r = 0; r < 4; ++r) {
      const Real factor = r == c ? 0.0L : m[r][c] / m[c][c];
      for (std::size_t k = c; k < 5; ++k) {
        m[r][k] -= factor * m[c][k];
      }
    }
  }
  std::array<Real, 4> x{};
  for (std::size_t c = 0; c < 4; ++c) {
    x[c] = m[c][4] / m[c][c];
  }
  return x;
}

/// Bispherical coordinates of two spheres: xi = alpha on sphere 1 (radius 1), -beta on 2.
struct Bispherical {
  Real alpha, beta, c;

  Bispherical(double ratio, double gap) {
    const Real r = (gap + 2.0L) * (1.0L + ratio) / 2.0L;
    const Real h1 = (r * r + 1.0L - Real(ratio) * ratio) / (2.0L * r);
    c = std::sqrt(h1 * h1 - 1.0L);
    alpha = std::asinh(c);
    beta = std::asinh(c / ratio);
  }
};

struct Forces {
  Real on_1, on_2;
};

/// Forces over 6 pi mu a_1 that resist the velocities v1, v2 along the line of centres.
/// Stream function: sum of U_n(xi) with the four exponentials exp(+-(n-1/2) xi),
/// exp(+-(n+3/2) xi); each is scaled to 1 where it is largest.
inline Forces axial(const Bispherical& b, Real v1, Real v2) {
  Forces sum{0.0L, 0.0L};
  for (int n = 1; n * std::min(b.alpha, b.beta) < 45.0L; ++n) {
    const Real p = n - 0.5L;
    const Real q = n + 1.5L;
    const Real k = n * (n + 1.0L) / ((2.0L * n - 1) * (2.0L * n + 1) * (2.0L * n + 3));
    const auto value = [&](Real x) {
      return -k * ((2.0L * n + 3) * std::exp(-p * x) - (2.0L * n - 1) * std::exp(-q * x));
    };
    const auto slope = [&](Real x) {
      return k * (2.0L * n - 1) * (2.0L * n + 3) / 2.0L *
             (std::exp(-p * x) - std::exp(-q * x));
    };
    const Real width = b.alpha + b.beta;
    const Real ep = std::exp(-p * width);
    const Real eq = std::exp(-q * width);
    const std::array<Real, 4> x = solve4({{
        {1.0L, ep, 1.0L, eq, v1 * value(b.alpha)},
        {p, -p * ep, q, -q * eq, v1 * slope(b.alpha)},
        {ep, 1.0L, eq, 1.0L, v2 * value(b.beta)},
        {p * ep, -p, q * eq, -q, -v2 * slope(b.beta)},
    }});
    sum.on_1 +=
        (2.0L * n + 1) * (x[0] * std::exp(-p * b.alpha) + x[2] * std::exp(-q * b.alpha));
    sum.on_2 +=
        (2.0L * n + 1) * (x[1] * std::exp(-p * b.beta) + x[3] * std::exp(-q * b.beta));
  }
  // U_n carries c^2/sqrt(2), the force 2 sqrt(2) pi mu / c times twice the sums.
  const Real scale = -2.0L / 3.0L * b.c;
  return {scale * sum.on_1, scale * sum.on_2};
}

/// Torques over 8 pi mu a_1^3 that resist spins w1, w2 about the line of centres.
inline Forces spin(const Bispherical& b, Real w1, Real w2) {
  Forces sum{0.0L, 0.0L};
  for (int n = 1; n * std::min(b.alpha, b.beta) < 45.0L; ++n) {
    const Real m = n + 0.5L;
    const Real far = std::exp(-m * (b.alpha + b.beta));
    const Real one = w1 * std::exp(-m * b.alpha);
    const Real two = w2 * std::exp(-m * b.beta);
    const Real determinant = 1.0L - far * far;
    sum.on_1 += n * (n + 1.0L) * (one - far * two) / determinant * std::exp(-m * b.alpha);
    sum.on_2 += n * (n + 1.0L) * (two - far * one) / determinant * std::exp(-m * b.beta);
  }
  const Real scale = 4.0L * b.c * b.c * b.c;
  return {scale * sum.on_1, scale * sum.on_2};
}

}  // namespace colloid
