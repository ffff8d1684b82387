// A solver rebuilt from its problem, its batches of spheres and its state goes on as the
// one that gave the state: a run continued from a checkpoint ends in the same bits.
#include <gtest/gtest.h>

#include "core/error.h"
#include "flow/stokes_solver.h"
#include "flow_cases.h"

namespace colloid {
namespace {

// Three batches; a drive held by unit responses where `drive` is mean_velocity.
struct History {
  StokesProblem problem;
  std::array<std::vector<Sphere>, 3> batches;
};

History throat_history() {
  const auto deposit = cases::dropped_deposit(20, 3);
  return {cases::throat(16),
          {{{deposit.begin(), deposit.begin() + 15},
            {deposit.begin() + 15, deposit.begin() + 18},
            {deposit.begin() + 18, deposit.end()}}}};
}

History array_history() {
  StokesProblem problem = cases::simple_cubic_array(0.1, 15);
  problem.drive = FlowDrive{};
  problem.drive.kind = FlowDrive::Kind::mean_velocity;
  problem.drive.mean_velocity = {0.0, 2e-4, 1e-3};
  const double a = 0.07 * cases::kLength;
  const auto at = [&](double x, double y, double z) {
    return Sphere{{x * cases::kLength, y * cases::kLength, z * cases::kLength}, a};
  };
  return {problem, {{{at(0.1, 0.1, 0.2)}, {at(0.85, 0.5, 0.1)}, {at(0.2, 0.9, 0.6)}}}};
}

void continues_bit_for_bit(const History& history) {
  StokesSolver first(history.problem, StokesOptions{});
  first.solve();
  first.add_spheres(history.batches[0]);
  first.solve();
  first.add_spheres(history.batches[1]);
  first.solve();
  const std::vector<double> state = first.state();
  const StokesVector<double> then = first.fields();
  first.add_spheres(history.batches[2]);
  const int iterations = first.solve().iterations;

  StokesSolver second(history.problem, StokesOptions{});
  second.add_spheres(history.batches[0]);
  second.add_spheres(history.batches[1]);
  second.restore(state);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(second.fields().a[c], then.a[c]) << "fields at once, component " << c;
  }
  EXPECT_EQ(second.state(), state);
  second.add_spheres(history.batches[2]);
  EXPECT_EQ(second.solve().iterations, iterations);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(second.fields().a[c], first.fields().a[c]) << "component " << c;
  }
  EXPECT_EQ(second.pressure_drop(), first.pressure_drop());
  EXPECT_EQ(second.state(), first.state());

  // The start matters: from zero the flow agrees to the tolerance, not to the bit.
  StokesSolver cold(history.problem, StokesOptions{});
  for (const auto& batch : history.batches) {
    cold.add_spheres(batch);
  }
  cold.solve();
  EXPECT_NE(cold.state(), first.state());
}

TEST(StokesState, AThroatContinuesBitForBit) {
  continues_bit_for_bit(throat_history());
}

TEST(StokesState, AHeldMeanVelocityContinuesBitForBit) {
  continues_bit_for_bit(array_history());
}

TEST(StokesState, AnotherGridsStateIsRefused) {
  StokesSolver coarse(cases::throat(12), StokesOptions{});
  StokesSolver fine(cases::throat(16), StokesOptions{});
  std::vector<double> state = fine.state();
  EXPECT_THROW(coarse.restore(state), InputError);
  EXPECT_NO_THROW(fine.restore(state));
  state.pop_back();
  EXPECT_THROW(fine.restore(state), InputError);
  EXPECT_THROW(fine.restore({}), InputError);
}

}  // namespace
}  // namespace colloid
