#include "scene/throat.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"

namespace colloid {

void place_throat(Geometry& geometry) {
  const double width = geometry.collector_diameter;
  if (!geometry.height) {
    geometry.height = 1.5 * width;
  }
  const double height = *geometry.height;
  require(height >= width, "/geometry/height",
          fmt::format("is {} m, must be at least the collector diameter, {} m, or the "
                      "collectors stick out of the inlet",
                      shortest(height), shortest(width)));
  geometry.box.size = {width, width, height};
  geometry.box.faces = {FaceCondition::wall, FaceCondition::wall,   FaceCondition::wall,
                        FaceCondition::wall, FaceCondition::outlet, FaceCondition::inlet};
  geometry.spheres.clear();
  for (const double y : {0.0, width}) {
    for (const double x : {0.0, width}) {
      geometry.spheres.push_back({{x, y, 0.5 * width}, 0.5 * width});
    }
  }
}

}  // namespace colloid
