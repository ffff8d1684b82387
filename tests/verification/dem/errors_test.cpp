// What goes wrong ends as an exception of the project, and nothing is printed.
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "dem_case.h"

namespace colloid::dem_test {
namespace {

using ::testing::HasSubstr;

template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(DemErrors, RefusesAStepBeyondItsLimitAndNamesIt) {
  DemOptions options = bonding();
  const double limit = step_limits(options).largest();
  options.step = 1.01 * limit;
  const std::string message = message_of<InputError>([&] { Dem dem(options, {}); });
  EXPECT_THAT(message, HasSubstr("must be at most"));
  EXPECT_THAT(message, HasSubstr("Rayleigh"));
  options.step = 0.99 * limit;
  EXPECT_EQ(Dem(options, {}).warnings().size(), 1U);
  EXPECT_EQ(advised_step(options), 5e-8);  // of the reference scene
  options.step = 0.49 * limit;
  EXPECT_TRUE(Dem(options, {}).warnings().empty());
}

TEST(DemErrors, NamesTheColloidThatIsNotANumber) {
  Dem dem(inert(), {});
  dem.add({4, kMiddle, {}, {}});
  dem.add({7, {5e-5, 5e-5, 5e-5}, {}, {}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of<ConvergenceError>([&] {
                dem.advance(1e-5, {stokes_drag(7, {nan, 0.0, 0.0})});
              }),
              HasSubstr("colloid 7"));
}

TEST(DemErrors, NamesTheColloidThatIsTooFast) {
  Dem dem(inert(), {});
  dem.add({2, kMiddle, {10.0, 0.0, 0.0}, {}});
  EXPECT_THAT(message_of<ConvergenceError>([&] { dem.advance(1e-5, {}); }),
              HasSubstr("colloid 2"));
}

TEST(DemErrors, NamesTheColloidThatLeavesTheBox) {
  DemOptions options = inert();
  options.box.faces[x_plus] = FaceCondition::outlet;
  Dem dem(options, {});
  dem.add({1, kMiddle, {}, {}});
  dem.add({6, {1.9e-4, 5e-5, 5e-5}, {1.0, 0.0, 0.0}, {}});
  EXPECT_THAT(message_of<ConvergenceError>([&] { dem.advance(1e-4, {}); }),
              HasSubstr("colloid 6"));
}

TEST(DemErrors, OfLiggghtsAreCaught) {
  DemOptions options = inert();
  options.box.size = {1.0, 1.0, 1.0};  // far too many bins for its neighbour lists
  const std::string message = message_of<ConvergenceError>([&] {
    Dem dem(options, {});
    dem.add({0, kMiddle, {}, {}});
    dem.advance(1e-6, {});
  });
  EXPECT_THAT(message, HasSubstr("LIGGGHTS"));
}

TEST(DemErrors, RefusesWhatItCannotSimulate) {
  const auto refused = [](auto change) {
    DemOptions options = inert();
    change(options);
    EXPECT_THROW(Dem(options, {}), InputError);
  };
  refused([](DemOptions& o) { o.restitution = 1.1; });
  refused([](DemOptions& o) { o.friction = -0.1; });
  refused([](DemOptions& o) { o.colloid.young_modulus = 0.0; });
  refused([](DemOptions& o) { o.grain.poisson_ratio = 0.6; });
  refused([](DemOptions& o) { o.lubrication = true; });
}

TEST(DemErrors, RefusesADamagedState) {
  Dem dem(inert(), {});
  const std::string saved = dem.save();
  EXPECT_THROW(dem.restore("short"), InputError);
  EXPECT_THROW(dem.restore(std::string(100, '\xff')), InputError);
  dem.restore(saved);
}

TEST(DemErrors, PrintsNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  {
    Dem one(inert(), {});
    Dem two(inert(), {});
    one.add({0, kMiddle, {}, {}});
    one.advance(1e-6, {});
    two.restore(one.save());
    two.advance(1e-6, {});
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace colloid::dem_test
