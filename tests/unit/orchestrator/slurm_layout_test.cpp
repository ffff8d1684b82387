#include "execute/slurm_layout.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace colloid {
namespace {

long ceil_div(long a, long b) {
  return (a + b - 1) / b;
}

Plan plan_of(int workers) {
  Plan plan;
  plan.limits.workers = workers;
  plan.limits.seconds_per_realisation = 600.0;
  plan.limits.seconds_to_stop = 30.0;
  return plan;
}

// What is asked of the layout: indices below MaxArraySize, half of MaxJobCount at most,
// an sbatch per thousand realisations at most, all realisations, no more at once than
// wanted.
TEST(SlurmLayout, KeepsWithinTheSitesLimits) {
  for (const long realisations : {1L, 7L, 999L, 1001L, 100'000L}) {
    for (const long array_size : {2L, 10L, 1001L, 100'001L}) {
      for (const long job_count : {2L, 40L, 10'000L, 1'000'000L}) {
        for (const int workers : {0, 1, 300}) {
          SCOPED_TRACE(testing::Message()
                       << realisations << " realisations, MaxArraySize " << array_size
                       << ", MaxJobCount " << job_count << ", workers " << workers);
          const SlurmLayout layout =
              slurm_layout(plan_of(workers), {array_size, job_count, 0.0}, realisations);
          EXPECT_LE(layout.array_tasks, array_size);
          EXPECT_LE(layout.tasks, job_count / 2);
          EXPECT_GE(layout.tasks * layout.per_task, realisations);
          const long calls = ceil_div(realisations, layout.array_tasks * layout.per_task);
          EXPECT_LE(calls, ceil_div(realisations, 1000));
          if (workers > 0) {
            EXPECT_GE(layout.at_once, 1);
            EXPECT_LE(calls * layout.at_once, workers);
          }
          EXPECT_GE(layout.minutes * 60, layout.per_task * 630);
        }
      }
    }
  }
}

TEST(SlurmLayout, PutsNoMoreInATaskThanItsTimeAllows) {
  const SlurmLayout layout = slurm_layout(plan_of(0), {10, 40, 7200.0}, 100'000);
  EXPECT_GT(layout.per_task, 1);
  EXPECT_LE(layout.minutes, 120);
  EXPECT_THROW(slurm_layout(plan_of(0), {10, 40, 600.0}, 1), InputError);
}

// sbatch(1), --time: minutes, minutes:seconds, hours:minutes:seconds, days-hours,
// days-hours:minutes, days-hours:minutes:seconds.
TEST(SlurmTime, IsReadInAllItsForms) {
  EXPECT_EQ(slurm_seconds("30"), 1800.0);
  EXPECT_EQ(slurm_seconds("30:05"), 1805.0);
  EXPECT_EQ(slurm_seconds("02:30:05"), 9005.0);
  EXPECT_EQ(slurm_seconds("2-12"), 216'000.0);
  EXPECT_EQ(slurm_seconds("2-12:30"), 217'800.0);
  EXPECT_EQ(slurm_seconds("2-12:30:05"), 217'805.0);
  EXPECT_EQ(slurm_seconds("UNLIMITED"), 0.0);
}

// squeue(1), JOB STATE CODES; a word that is not there is not an end.
TEST(SlurmState, IsActiveEndedOrNotKnown) {
  EXPECT_EQ(is_active_state("PENDING"), true);
  EXPECT_EQ(is_active_state("COMPLETING"), true);
  EXPECT_EQ(is_active_state("NODE_FAIL"), false);
  EXPECT_EQ(is_active_state("TIMEOUT"), false);
  EXPECT_EQ(is_active_state("NEW_WORD"), std::nullopt);
}

}  // namespace
}  // namespace colloid
