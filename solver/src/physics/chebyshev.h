// Several smooth functions of one variable in [0, 1] as Chebyshev series.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/constants.h"

namespace colloid {

template <std::size_t kFunctions>
class ChebyshevSeries {
 public:
  using Values = std::array<double, kFunctions>;

  /// Equals `functions`, u -> Values, at the degree + 1 points of Chebyshev.
  template <typename Functions>
  ChebyshevSeries(int degree, Functions functions)
      : coefficients_(static_cast<std::size_t>(degree) + 1, Values{}) {
    const auto points = static_cast<double>(coefficients_.size());
    for (int j = 0; j <= degree; ++j) {
      const double theta = kPi * (j + 0.5) / points;
      const Values values = functions(0.5 * (1.0 + std::cos(theta)));
      for (std::size_t k = 0; k < coefficients_.size(); ++k) {
        const double weight =
            (k == 0 ? 1.0 : 2.0) / points * std::cos(static_cast<double>(k) * theta);
        for (std::size_t i = 0; i < kFunctions; ++i) {
          coefficients_[k][i] += weight * values[i];
        }
      }
    }
  }

  /// By Clenshaw's recurrence.
  Values at(double u) const {
    const double t = 2.0 * u - 1.0;
    Values next{};
    Values after{};
    for (std::size_t k = coefficients_.size(); k-- > 1;) {
      for (std::size_t i = 0; i < kFunctions; ++i) {
        const double here = coefficients_[k][i] + 2.0 * t * next[i] - after[i];
        after[i] = next[i];
        next[i] = here;
      }
    }
    Values sum{};
    for (std::size_t i = 0; i < kFunctions; ++i) {
      sum[i] = coefficients_[0][i] + t * next[i] - after[i];
    }
    return sum;
  }

 private:
  std::vector<Values> coefficients_;
};

}  // namespace colloid
