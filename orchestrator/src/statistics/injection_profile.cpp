#include "statistics/injection_profile.h"

#include <cassert>

namespace colloid::statistics {

namespace {

struct Reachable {
  std::vector<double> centre;
  std::vector<double> area;
};

Reachable reachable(const Annuli& annuli, double margin) {
  const double reach = annuli.outer(annuli.size() - 1) - margin;
  Reachable result;
  for (std::size_t i = 0; i < annuli.size() && annuli.centre(i) < reach; ++i) {
    result.centre.push_back(annuli.centre(i));
    result.area.push_back(annuli.area(i));
  }
  return result;
}

}  // namespace

InjectionProfile injection_profile(
    std::size_t order, const std::vector<std::vector<std::array<double, 2>>>& positions,
    const Annuli& annuli, double margin, const BootstrapOptions& options) {
  assert(order >= 1);
  const Reachable fitted = reachable(annuli, margin);
  InjectionProfile profile;
  profile.order = order;
  profile.n = positions.size();
  std::vector<std::size_t> hits(annuli.size(), 0);
  std::vector<std::vector<double>> rows;     // 1 in the annulus of this realisation
  std::vector<std::vector<double>> by_area;  // 1 / area there
  rows.reserve(positions.size());
  by_area.reserve(positions.size());
  for (const auto& retained : positions) {
    std::vector<double> row(fitted.centre.size(), 0.0);
    std::vector<double> per_area(fitted.centre.size(), 0.0);
    if (retained.size() < order) {
      ++profile.n_without;
    } else {
      const std::size_t i = annuli.at(retained[order - 1]);
      ++hits[i];
      if (i < row.size()) {
        row[i] = 1.0;
        per_area[i] = 1.0 / fitted.area[i];
      }
    }
    rows.push_back(std::move(row));
    by_area.push_back(std::move(per_area));
  }
  profile.centre.reserve(annuli.size());
  profile.probability.reserve(annuli.size());
  profile.density.reserve(annuli.size());
  for (std::size_t i = 0; i < annuli.size(); ++i) {
    profile.centre.push_back(annuli.centre(i));
    profile.probability.push_back(clopper_pearson(hits[i], profile.n, options.level));
    profile.density.push_back(profile.probability.back().estimate.value_or(0.0) /
                              annuli.area(i));
  }
  profile.probability_fit = exponential_fit(fitted.centre, rows, options);
  profile.density_fit = exponential_fit(fitted.centre, by_area, options);
  return profile;
}

}  // namespace colloid::statistics
