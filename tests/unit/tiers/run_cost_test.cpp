#include "tiers/run_cost.h"

#include <gtest/gtest.h>

namespace colloid {
namespace {

TEST(RunCost, HoldsWhatARunHadCostBeforeItsCheckpoint) {
  RunCost cost;
  cost.resume({{"cpu_seconds", 1e6}, {"flow_work_units", 7.0}, {"of_old", 1.0}});
  const NamedNumbers found = cost.so_far({{"flow_work_units", 5.0}, {"of_new", 2.0}});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].first, "wall_seconds");
  EXPECT_GE(found[0].second, 0.0);
  EXPECT_EQ(found[1].first, "cpu_seconds");
  EXPECT_GE(found[1].second, 1e6);
  EXPECT_EQ(found[2], (std::pair<std::string, double>("flow_work_units", 12.0)));
  EXPECT_EQ(found[3], (std::pair<std::string, double>("of_new", 2.0)));
}

}  // namespace
}  // namespace colloid
