// The voxel method on a clogging throat: the resolution of the paper's images.
//
// Reference  grid_search.h at 0.483 um, the voxel edge that Liu, Shikhov & Arns (2024)
// use. Tolerance  none: its bounds are half a voxel below and half a diagonal above.
#include "grid_search.h"
#include "gtest/gtest.h"
#include "observe/critical_diameter.h"

namespace colloid {
namespace {

TEST(Voxels, AgreeOnAThroatWithColloids) {
  const Packing throat = clogging_throat(60, 3);
  const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
  const Bracket voxels = grid_critical_diameter(throat, 200);
  EXPECT_LE(voxels.high - voxels.low, 4.0 * 0.483e-6);
  EXPECT_LE(found.value, voxels.high);
  EXPECT_GE(found.value + found.error, voxels.low);
}

}  // namespace
}  // namespace colloid
