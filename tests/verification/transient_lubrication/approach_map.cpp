// Prints as CSV what the flow resists with near a wall and what of the exact resistance
// it misses, (f_exact - f) h/a: MODEL (T9).
#include <cstdio>

#include "approach_case.h"
#include "tiers/transient/runtime.h"

int main(int argc, char** argv) {
  using namespace colloid;
  const Runtime runtime(argc, argv);
  if (argc != 4) {
    std::fputs("usage: approach_map CELLS_PER_DIAMETER PLACE_X PLACE_Y\n", stderr);
    return 2;
  }
  const int cells = std::atoi(argv[1]);
  const Place place{std::atof(argv[2]), std::atof(argv[3])};
  const double far = far_walls(cells, place);
  for (const double gap :
       {0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0}) {
    const double found = resolved_approach(cells, gap, place) - far;
    const double exact = wall_resistance(gap * 2.0 / cells).f_n;
    std::printf("%d,%g,%g,%g,%.4f,%.4f,%.4f\n", cells, place[0], place[1], gap, found,
                exact, (exact - found) * 2.0 / cells);
    std::fflush(stdout);
  }
  return 0;
}
