// A free sphere in a square duct, finer: see README.md beside this file.
#include <gtest/gtest.h>

#include "duct_case.h"

namespace colloid {
namespace {

TEST(TransientDuctFine, DragsASphereFixedOnItsAxis) {
  expect_duct_drag(0.4, 40);
  expect_duct_drag(0.4, 50);
}

TEST(TransientDuctFine, CarriesAFreeSphere) {
  expect_duct(0.4, 0.0, 24);
  expect_duct(0.4, 0.0, 40);
  expect_duct(0.4, 0.15, 40);
}

}  // namespace
}  // namespace colloid
