// Prints as CSV what the flow resists with near a surface and what of the exact
// resistance it misses: at a wall in units of the pole, (f_exact - f) h/a, MODEL (T9); at
// another sphere what is left when sub-grid lubrication is added.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "approach_case.h"
#include "tiers/transient/runtime.h"

namespace colloid {
namespace {

void map_wall(int cells, const Place& place) {
  const double far = far_walls(cells, place);
  for (const double gap :
       {0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0}) {
    const double found = resolved_approach(cells, gap, place) - far;
    const double exact = wall_resistance(gap * 2.0 / cells).f_n;
    std::printf("%d,%g,%g,%g,%.4f,%.4f,%.4f\n", cells, place[0], place[1], gap, found,
                exact, (exact - found) * 2.0 / cells);
    std::fflush(stdout);
  }
}

void map_meeting(Other other, int cells, const Place& place, const Vec3& along) {
  const double far = far_walls(other, cells, place, along);
  for (const double gap : {0.02, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.5}) {
    const double found = resolved_meeting(other, cells, gap, place, along) - far;
    const double exact = exact_meeting(other, gap * 2.0 / cells);
    const double whole = found + sub_grid_meeting(other, cells, gap);
    std::printf("%d,%g,%g,%g,%.4f,%.4f,%.4f\n", cells, place[0], place[1], gap, found,
                exact, whole / exact - 1.0);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace colloid

int main(int argc, char** argv) {
  using namespace colloid;
  const Runtime runtime(argc, argv);
  const bool wall = argc == 5 && std::strcmp(argv[1], "wall") == 0;
  if (!wall && argc != 8) {
    std::fputs(
        "usage: approach_map wall CELLS_PER_DIAMETER PLACE_X PLACE_Y\n"
        "       approach_map colloid|grain CELLS_PER_DIAMETER PLACE_X PLACE_Y X Y Z\n",
        stderr);
    return 2;
  }
  const int cells = std::atoi(argv[2]);
  const Place place{std::atof(argv[3]), std::atof(argv[4])};
  if (wall) {
    map_wall(cells, place);
  } else {
    map_meeting(std::strcmp(argv[1], "grain") == 0 ? Other::grain : Other::colloid, cells,
                place, {std::atof(argv[5]), std::atof(argv[6]), std::atof(argv[7])});
  }
  return 0;
}
