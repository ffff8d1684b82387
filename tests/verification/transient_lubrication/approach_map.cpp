// Prints as CSV what the flow resists with near a surface and what of the exact
// resistance it misses.  Approach: at a wall in units of the pole, (f_exact - f) h/a,
// MODEL (T9); at another sphere what is left when sub-grid lubrication is added.  Sliding
// and turning: f_t, t_t, f_r, t_r of the flow, with sub-grid lubrication, and exact.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "approach_case.h"
#include "sliding_case.h"
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

void map_sliding(Beside beside, int cells, const Place& place, const Vec3& from_other) {
  for (const double gap :
       {0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0}) {
    const Sliding flow = resolved_sliding(beside, cells, gap, place, from_other);
    const Sliding all = flow + sub_grid_sliding(beside, cells, gap, from_other);
    const Sliding exact = exact_sliding(beside, gap * 2.0 / cells);
    std::printf("%d,%g,%g,%g", cells, place[0], place[1], gap);
    for (const auto factor :
         {&Sliding::f_t, &Sliding::t_t, &Sliding::f_r, &Sliding::t_r}) {
      std::printf(",%.4f,%.4f,%.4f", flow.*factor, all.*factor, exact.*factor);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace colloid

int main(int argc, char** argv) {
  using namespace colloid;
  const Runtime runtime(argc, argv);
  const auto is = [&](int n, const char* word) {
    return n < argc && std::strcmp(argv[n], word) == 0;
  };
  const bool sliding = is(1, "sliding");
  const int from = sliding ? 2 : 1;  // the other surface's name
  const bool wall = is(from, "wall");
  const bool known = wall || is(from, "colloid") || is(from, "grain");
  if (!known || argc != from + (wall ? 4 : 7)) {
    std::fputs(
        "usage: approach_map [sliding] wall CELLS_PER_DIAMETER PLACE_X PLACE_Y\n"
        "       approach_map [sliding] colloid|grain CELLS_PER_DIAMETER PLACE_X PLACE_Y "
        "X Y Z\n",
        stderr);
    return 2;
  }
  const auto number = [&](int n) { return std::atof(argv[from + n]); };
  const int cells = std::atoi(argv[from + 1]);
  const Place place{number(2), number(3)};
  const Vec3 along = wall ? Vec3{0.0, 0.0, 1.0} : Vec3{number(4), number(5), number(6)};
  const bool grain = is(from, "grain");
  if (sliding) {
    const Beside other = grain ? Beside::grain : Beside::colloid;
    map_sliding(wall ? Beside::wall : other, cells, place, along);
  } else if (wall) {
    map_wall(cells, place);
  } else {
    map_meeting(grain ? Other::grain : Other::colloid, cells, place, along);
  }
  return 0;
}
