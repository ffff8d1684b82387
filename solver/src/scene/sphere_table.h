// Tables of spheres: packings and deposits.  CSV with the columns x_m, y_m, z_m and
// diameter_m named in a header line, in any order; other columns are ignored.
#pragma once

#include <string>
#include <vector>

#include "core/box.h"

namespace colloid {

/// Refuses the first bad line with file and line number, and so a sphere that is entirely
/// outside the box.  A table without rows is an empty deposit; whether that is acceptable
/// is the caller's business.
std::vector<Sphere> read_sphere_table(const std::string& path, const Box& box);

}  // namespace colloid
