// A free sphere in a square duct, finer: see README.md beside this file.
#include <gtest/gtest.h>

#include "duct_case.h"

namespace colloid {
namespace {

TEST(TransientDuct, CarriesAFreeSphereOnAFineGrid) {
  expect_duct(0.4, 0.0, 24);
  expect_duct(0.4, 0.0, 40);
  expect_duct(0.4, 0.15, 40);
}

}  // namespace
}  // namespace colloid
