#include "store/curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace colloid {

namespace {

/// Mean and spread of one quantity at every step, by sums of deviations from the first
/// value (sums of squares of the values themselves would cancel).
class Moments {
 public:
  explicit Moments(std::size_t steps)
      : count_(steps), shift_(steps), sum_(steps), square_(steps) {}

  void add(std::size_t step, double value) {
    if (std::isnan(value)) {
      return;
    }
    if (count_[step] == 0) {
      shift_[step] = value;
    }
    const double deviation = value - shift_[step];
    ++count_[step];
    sum_[step] += deviation;
    square_[step] += deviation * deviation;
  }

  std::int64_t count(std::size_t step) const { return count_[step]; }
  double mean(std::size_t step) const {
    const auto n = static_cast<double>(count_[step]);
    return n < 1.0 ? std::nan("") : shift_[step] + sum_[step] / n;
  }
  double deviation(std::size_t step) const {
    const auto n = static_cast<double>(count_[step]);
    return n < 2.0
               ? std::nan("")
               : std::sqrt(std::max(0.0, square_[step] - sum_[step] * sum_[step] / n) /
                           (n - 1.0));
  }

 private:
  std::vector<std::int64_t> count_;
  std::vector<double> shift_;
  std::vector<double> sum_;
  std::vector<double> square_;
};

std::vector<double> times_of(Database& database, std::int64_t grid) {
  Statement read =
      database.prepare("SELECT time_s FROM grid_time WHERE grid = ? ORDER BY step");
  read.bind(1, grid);
  std::vector<double> times;
  while (read.step()) {
    times.push_back(read.real(0));
  }
  return times;
}

/// For each of `times`, the last step of `own` that is not later; -1 before the first.
std::vector<std::int64_t> steps_at(const std::vector<double>& times,
                                   const std::vector<double>& own) {
  std::vector<std::int64_t> steps;
  steps.reserve(times.size());
  for (const double t : times) {
    steps.push_back(std::upper_bound(own.begin(), own.end(), t) - own.begin() - 1);
  }
  return steps;
}

struct Change {
  std::int64_t step;
  double critical_diameter;
  double permeability_ratio;
};

}  // namespace

void write_curve(Database& database, std::int64_t ensemble) {
  Statement runs = database.prepare(
      "SELECT id, grid FROM realisation WHERE ensemble = ? AND status = 'ingested' "
      "ORDER BY idx");
  Statement read = database.prepare(
      "SELECT step, critical_diameter_m, permeability_ratio FROM series_change "
      "WHERE realisation = ? ORDER BY step");
  std::vector<double> times;
  Moments diameter(0);
  Moments ratio(0);
  std::int64_t grid = -1;
  std::vector<std::int64_t> steps;
  runs.bind(1, ensemble);
  while (runs.step()) {
    if (runs.integer(1) != grid) {
      grid = runs.integer(1);
      const std::vector<double> own = times_of(database, grid);
      if (times.empty()) {
        times = own;
        diameter = Moments(times.size());
        ratio = Moments(times.size());
      }
      steps = steps_at(times, own);
    }
    read.reset().bind(1, runs.integer(0));
    std::vector<Change> changes;
    while (read.step()) {
      changes.push_back({read.integer(0), read.real(1), read.real(2)});
    }
    for (std::size_t k = 0, c = 0; k < times.size() && !changes.empty(); ++k) {
      while (c + 1 < changes.size() && changes[c + 1].step <= steps[k]) {
        ++c;
      }
      if (changes[c].step <= steps[k]) {
        diameter.add(k, changes[c].critical_diameter);
        ratio.add(k, changes[c].permeability_ratio);
      }
    }
  }
  database.prepare("DELETE FROM curve WHERE ensemble = ?").bind(1, ensemble).run();
  Statement add = database.prepare(
      "INSERT OR REPLACE INTO curve (ensemble, time_s, n, critical_diameter_m, "
      "critical_diameter_sd_m, permeability_ratio, permeability_ratio_sd) "
      "VALUES (?,?,?,?,?,?,?)");
  for (std::size_t k = 0; k < times.size(); ++k) {
    add.reset()
        .bind(1, ensemble)
        .bind(2, times[k])
        .bind(3, std::max(diameter.count(k), ratio.count(k)))
        .bind(4, diameter.mean(k))
        .bind(5, diameter.deviation(k))
        .bind(6, ratio.mean(k))
        .bind(7, ratio.deviation(k))
        .run();
  }
}

void write_layer_counts(Database& database, std::int64_t ensemble) {
  // Counted here: GROUP BY would sort all retained colloids, at four times the cost.
  std::map<std::pair<std::string, std::string>, std::int64_t> counts;
  Statement read = database.prepare(
      "SELECT d.layer, d.mechanism FROM realisation r "
      "JOIN retained d ON d.realisation = r.id WHERE r.ensemble = ?");
  read.bind(1, ensemble);
  while (read.step()) {
    ++counts[{read.text(0), read.text(1)}];
  }
  database.prepare("DELETE FROM layer_count WHERE ensemble = ?").bind(1, ensemble).run();
  Statement add = database.prepare(
      "INSERT INTO layer_count (ensemble, layer, mechanism, colloids) "
      "VALUES (?, nullif(?, ''), nullif(?, ''), ?)");
  for (const auto& [kind, count] : counts) {
    add.reset()
        .bind(1, ensemble)
        .bind(2, kind.first)
        .bind(3, kind.second)
        .bind(4, count)
        .run();
  }
}

}  // namespace colloid
