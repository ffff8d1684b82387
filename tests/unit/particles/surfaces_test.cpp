// Images through periodic faces.
#include "particles/surfaces.h"

#include <cmath>

#include <gtest/gtest.h>

namespace colloid {
namespace {

Box periodic_across() {
  Box box;
  box.size = {30e-6, 60e-6, 90e-6};
  box.faces = {FaceCondition::periodic, FaceCondition::periodic, FaceCondition::wall,
               FaceCondition::wall,     FaceCondition::outlet,   FaceCondition::inlet};
  return box;
}

TEST(Wrapped, IsTheImageInTheBoxAlongPeriodicAxesAlone) {
  const Box box = periodic_across();
  for (double turns : {-2.0, -1.0, 0.0, 1.0, 3.0}) {
    const Vec3 x{7e-6 + turns * box.size.x, -1e-6, 91e-6};
    const Vec3 inside = wrapped(box, x);
    EXPECT_NEAR(inside.x, 7e-6, 1e-15 * box.size.x * (1.0 + std::abs(turns))) << turns;
    EXPECT_EQ(inside.y, x.y);
    EXPECT_EQ(inside.z, x.z);
  }
}

// Half-open, also where adding the period rounds up to it.
TEST(Wrapped, IsBelowTheUpperFace) {
  const Box box = periodic_across();
  const double size = box.size.x;
  for (double x : {-1e-30, -size, 0.0, size, 3.0 * size, std::nextafter(size, 0.0)}) {
    const double inside = wrapped(box, {x, 0.0, 0.0}).x;
    EXPECT_GE(inside, 0.0) << x;
    EXPECT_LT(inside, size) << x;
  }
}

}  // namespace
}  // namespace colloid
