#include "physics/two_sphere_series.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace colloid {

namespace {

/// Numbers indexed by n >= 1, p >= 0, q >= 0 with n + p + q <= order + 1.  A recurrence
/// sums over (s, q - s, p') at fixed q and p', so those lie next to each other in memory.
class Npq {
 public:
  explicit Npq(int order)
      : size_(order + 2),
        width_(order / 2 + 3),
        values_(static_cast<std::size_t>(size_ * size_ * width_)),
        zeros_(static_cast<std::size_t>(width_)) {}

  double get(int n, int p, int q) const { return row(q, n + p)[n]; }
  void set(int n, int p, int q, double value) {
    values_[offset(q, n + p) + at(n)] = value;
  }

  /// The numbers at (s, sum - s, q) for s = 0 .. last(); zero where they do not exist.
  const double* row(int q, int sum) const {
    return q < 0 || sum < 0 ? zeros_.data() : &values_[offset(q, sum)];
  }
  int last() const { return width_ - 1; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::size_t offset(int q, int sum) const { return at((q * size_ + sum) * width_); }

  int size_;
  int width_;
  std::vector<double> values_;
  std::vector<double> zeros_;
};

/// Coefficients of the recurrences, [n][s]; each holds the binomial coefficient.
class Coefficients {
 public:
  template <typename Formula>
  Coefficients(int last, Formula formula) : last_(last) {
    for (int n = 0; n <= last; ++n) {
      values_.emplace_back(static_cast<std::size_t>(last) + 1);
      for (int s = 1; s <= last && n >= 1; ++s) {
        values_.back()[static_cast<std::size_t>(s)] = formula(n, s);
      }
    }
  }

  /// Sum over s of the coefficients times the numbers at (s, sum - s, q); those beyond
  /// s - 1 = sum - s vanish.  Two partial sums, so that no addition waits for the last.
  double dot(int n, const Npq& numbers, int q, int sum) const {
    const double* factors = values_[static_cast<std::size_t>(n)].data();
    const double* row = numbers.row(q, sum);
    const int end = std::min((sum + 1) / 2, last_);
    double odd = 0.0;
    double even = 0.0;
    int s = 1;
    for (; s < end; s += 2) {
      odd += factors[s] * row[s];
      even += factors[s + 1] * row[s + 1];
    }
    return odd + even + (s == end ? factors[s] * row[s] : 0.0);
  }

 private:
  int last_;
  std::vector<std::vector<double>> values_;
};

/// (n + s)! / (k! (n + s - k)!)
double choose(int n_plus_s, int k) {
  double product = 1.0;
  for (int i = 1; i <= k; ++i) {
    product *= static_cast<double>(n_plus_s - k + i) / i;
  }
  return product;
}

/// Calls visit(n, p, q) in an order in which every term of a recurrence is known before
/// it is used: all of them lie at a smaller n + p + q.  Beyond p = n - 1 all numbers
/// vanish.
template <typename Visit>
void ascending(int order, Visit visit) {
  for (int weight = 2; weight <= order + 1; ++weight) {
    for (int n = 1; 2 * n - 1 <= weight; ++n) {
      for (int p = n - 1; n + p <= weight; ++p) {
        visit(n, p, weight - n - p);
      }
    }
  }
}

/// The numbers of one n, which are known to k = order + 1 - n.
std::vector<std::vector<double>> numbers_of(int n, const Npq& numbers, int order,
                                            double factor) {
  std::vector<std::vector<double>> triangle;
  for (int k = 0; k <= order + 1 - n; ++k) {
    triangle.emplace_back();
    for (int q = 0; q <= k; ++q) {
      triangle.back().push_back(factor * numbers.get(n, k - q, q));
    }
  }
  return triangle;
}

/// JO (3.6)-(3.9): motion along the line of centres.
void fill_axial(int order, Npq& p_numbers) {
  Npq v_numbers(order);
  const int last = p_numbers.last();
  const Coefficients above(last, [](double n, double s) {
    return choose(int(n + s), int(n)) * n * (2 * n + 1) * (2 * n * s - n - s + 2) /
           (2 * (n + 1) * (2 * s - 1) * (n + s));
  });
  const Coefficients below(last, [](double n, double s) {
    return -choose(int(n + s), int(n)) * n * (2 * n - 1) / (2 * (n + 1));
  });
  const Coefficients volume(last, [](double n, double s) {
    return -choose(int(n + s), int(n)) * n * (4 * n * n - 1) /
           (2 * (n + 1) * (2 * s + 1));
  });
  p_numbers.set(1, 0, 0, 1.0);
  v_numbers.set(1, 0, 0, 1.0);
  ascending(order, [&](int n, int p, int q) {
    const double from_below = below.dot(n, p_numbers, p - n - 1, q);
    const double sum = above.dot(n, p_numbers, p - n + 1, q) + from_below +
                       volume.dot(n, v_numbers, p - n + 1, q - 2);
    // from_below is -n(2n-1)/(2(n+1)) times the sum that V needs 2n/((n+1)(2n+3)) of.
    p_numbers.set(n, p, q, sum);
    v_numbers.set(n, p, q, sum + 4.0 / ((2.0 * n - 1) * (2 * n + 3)) * from_below);
  });
}

/// JO (4.6)-(4.11): motion across the line of centres and rotation about an axis across
/// it. The caller has set the starting values P_100 = V_100 (translation) or Q_100
/// (rotation).
void fill_transverse(int order, Npq& p_numbers, Npq& v_numbers, Npq& q_numbers) {
  const int last = p_numbers.last();
  const Coefficients above(last, [](double n, double s) {
    return choose(int(n + s), int(n + 1)) * (2 * n + 1) / (2 * (n + 1)) *
           (3 * (n + s) - (n * s + 1) * (2 * n * s - s - n + 2)) /
           (s * (n + s) * (2 * s - 1));
  });
  const Coefficients below(last, [](double n, double s) {
    return choose(int(n + s), int(n + 1)) * n * (2 * n - 1) / (2 * (n + 1));
  });
  const Coefficients volume(last, [](double n, double s) {
    return choose(int(n + s), int(n + 1)) * n * (4 * n * n - 1) /
           (2 * (n + 1) * (2 * s + 1));
  });
  const Coefficients spin(last, [](double n, double s) {
    return -choose(int(n + s), int(n + 1)) * 2 * (4 * n * n - 1) / (3 * (n + 1));
  });
  const Coefficients spin_of_spin(last, [](double n, double s) {
    return choose(int(n + s), int(n + 1)) * s / (n + 1);
  });
  const Coefficients spin_of_force(last, [](double n, double s) {
    return -choose(int(n + s), int(n + 1)) * 3 / (2 * n * s * (n + 1));
  });
  ascending(order, [&](int n, int p, int q) {
    const double from_below = below.dot(n, p_numbers, p - n - 1, q);
    const double sum = above.dot(n, p_numbers, p - n + 1, q) + from_below +
                       volume.dot(n, v_numbers, p - n + 1, q - 2) +
                       spin.dot(n, q_numbers, p - n + 1, q - 1);
    p_numbers.set(n, p, q, sum);
    v_numbers.set(n, p, q, sum + 4.0 / ((2.0 * n - 1) * (2 * n + 3)) * from_below);
    q_numbers.set(n, p, q,
                  spin_of_spin.dot(n, q_numbers, p - n, q - 1) +
                      spin_of_force.dot(n, p_numbers, p - n, q));
  });
}

/// JO (6.6), (6.7): rotation about the line of centres.
void fill_spin(int order, Npq& q_numbers) {
  const Coefficients ways(q_numbers.last(), [](double n, double s) {
    return choose(int(n + s), int(n)) * s / (n + 1);
  });
  q_numbers.set(1, 0, 0, 1.0);
  ascending(order, [&](int n, int p, int q) {
    q_numbers.set(n, p, q, ways.dot(n, q_numbers, p - n, q - 1));
  });
}

/// Sum over q of triangle[k][q] lambda^q / (1 + lambda)^k, as powers of two fractions.
std::vector<double> weighted(const std::vector<std::vector<double>>& triangle,
                             double ratio, bool rotation) {
  const double mine = 1.0 / (1.0 + ratio);
  const double other = ratio / (1.0 + ratio);
  std::vector<double> coefficients;
  for (std::size_t k = 0; k < triangle.size(); ++k) {
    double sum = 0.0;
    for (std::size_t q = 0; q <= k; ++q) {
      if (triangle[k][q] != 0.0) {
        sum += triangle[k][q] * std::pow(other, static_cast<double>(q)) *
               std::pow(mine, static_cast<double>(k - q));
      }
    }
    coefficients.push_back(rotation && k % 2 == 1 ? sum * ratio : sum);
  }
  return coefficients;
}

}  // namespace

TwoSphereRecurrences::TwoSphereRecurrences(int order) : order_(order) {
  {
    Npq p(order);
    fill_axial(order, p);
    xa_ = numbers_of(1, p, order, 1.0);
    along_ = numbers_of(2, p, order, 1.0);
  }
  {
    Npq p(order);
    Npq v(order);
    Npq q(order);
    p.set(1, 0, 0, 1.0);
    v.set(1, 0, 0, 1.0);
    fill_transverse(order, p, v, q);
    ya_ = numbers_of(1, p, order, 1.0);
    across_ = numbers_of(2, p, order, 1.0);
    yb_ = numbers_of(1, q, order, 2.0);
  }
  {
    Npq p(order);
    Npq v(order);
    Npq q(order);
    q.set(1, 0, 0, 1.0);
    fill_transverse(order, p, v, q);
    yc_ = numbers_of(1, q, order, 1.0);
    turning_ = numbers_of(2, p, order, 1.0);
  }
  {
    Npq q(order);
    fill_spin(order, q);
    xc_ = numbers_of(1, q, order, 1.0);
  }
}

TwoSphereSeries TwoSphereRecurrences::series(double ratio) const {
  assert(ratio > 0.0);
  return {weighted(xa_, ratio, false), weighted(ya_, ratio, false),
          weighted(yb_, ratio, false), weighted(xc_, ratio, true),
          weighted(yc_, ratio, true)};
}

StressletSeries TwoSphereRecurrences::stresslets_of_equal_spheres() const {
  return {weighted(along_, 1.0, false), weighted(across_, 1.0, false),
          weighted(turning_, 1.0, false)};
}

const TwoSphereRecurrences& two_sphere_recurrences() {
  static const TwoSphereRecurrences kRecurrences(kTwoSphereOrder);
  return kRecurrences;
}

double sum_without_lubrication(std::vector<double> coefficients, double u) {
  for (int power = 0; power < 2; ++power) {
    for (std::size_t m = coefficients.size() - 1; m > 0; --m) {
      coefficients[m] += coefficients[m - 1];
    }
  }
  double sum = 0.0;
  for (std::size_t m = coefficients.size(); m-- > 0;) {
    sum = sum * u + coefficients[m];
  }
  return sum / ((1.0 + u) * (1.0 + u));
}

}  // namespace colloid
