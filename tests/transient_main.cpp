// main() of the tests of the tier transient, alone or as one of several ranks.
#include <gtest/gtest.h>

#include "tiers/transient/runtime.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  colloid::Runtime runtime(argc, argv);
  return runtime.end(RUN_ALL_TESTS(), "");
}
