#include "campaign/target.h"

#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "campaign/key_reader.h"

namespace colloid {

namespace {

// The same names as in statistics/target.h, of which nothing is known here.
const std::vector<std::string> kStatistics{
    "t1", "tc", "tc_minus_t1", "median_s", "restricted_mean_s", "probability_by_end"};
constexpr int kSmallestPilot = 20;  // Chow & Robbins: statistics/stopping.h
constexpr int kMost = 10'000'000;

}  // namespace

Target read_target(const nlohmann::json& value, int realisations) {
  KeyReader read(value, "/statistics/target");
  Target target;
  read.get("statistic");
  read.word("statistic", kStatistics, target.statistic);
  read.get("half_width");
  read.number("half_width", 1e-12, 1e12, target.half_width);
  read.integer("pilot", kSmallestPilot, kMost, target.pilot);
  read.integer("batch", 1, kMost, target.batch);
  read.finish();
  require(target.pilot <= realisations, "/statistics/target/pilot",
          fmt::format("is {}, but there are {} realisations at most: no decision could "
                      "be taken",
                      target.pilot, realisations));
  return target;
}

std::optional<Target> target_of(const nlohmann::json& statistics, int realisations) {
  const auto found = statistics.find("target");
  return found == statistics.end() ? std::nullopt
                                   : std::optional(read_target(*found, realisations));
}

std::string unit_of(const Target& target) {
  return target.statistic == "probability_by_end" ? "" : "s";
}

std::string aim_of(const Target& target) {
  const std::string unit = unit_of(target);
  return fmt::format("the half-width of {} is at most {:g}{}{}", target.statistic,
                     target.half_width, unit.empty() ? "" : " ", unit);
}

}  // namespace colloid
