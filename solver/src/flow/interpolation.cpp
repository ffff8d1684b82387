#include "flow/interpolation.h"

#include <algorithm>
#include <cmath>

namespace colloid {

namespace {

// Two neighbouring unknowns along an axis and their weights.  Index -1 and n stand for
// the values beyond the box (halo of a periodic axis, given velocity of a wall).
struct Pair {
  std::array<int, 2> index{};
  std::array<double, 2> weight{};
};

Pair bracket(const Grid& grid, const AxisStencil& stencil, int component, int axis,
             double x) {
  const auto a = static_cast<std::size_t>(axis);
  const int n = grid.cells[a];
  const double spacing = grid.position[a][1];
  Pair pair;
  if (component == axis) {
    const int i = std::clamp(static_cast<int>(std::floor(x / spacing)), 0, n - 1);
    const double t = x / spacing - i;
    pair.index = {i, i + 1};
    pair.weight = {1.0 - t, t};
    return pair;
  }
  const int i = std::clamp(static_cast<int>(std::floor(x / spacing - 0.5)), -1, n - 1);
  double t = x / spacing - 0.5 - i;
  pair.index = {i, i + 1};
  // Between the outermost centre and the box: half a spacing to a given velocity, nothing
  // to interpolate where there is no shear.
  const bool periodic = grid.periodic[a];
  if (i == -1 && !periodic) {
    const bool given = stencil.at_centre.front().side_below == Side::given_velocity;
    t = given ? std::max(0.0, 2.0 * t - 1.0) : 1.0;
  } else if (i == n - 1 && !periodic) {
    const bool given = stencil.at_centre.back().side_above == Side::given_velocity;
    t = given ? std::min(1.0, 2.0 * t) : 0.0;
  }
  pair.weight = {1.0 - t, t};
  return pair;
}

// From the centre of a sphere, or of its nearest image, to x.  Grid units.
Vec3 from_centre(const Sphere& sphere, const Grid& grid, const Vec3& x) {
  Vec3 e = x - sphere.center;
  for (int a = 0; a < 3; ++a) {
    const auto p = static_cast<std::size_t>(a);
    if (grid.periodic[p]) {
      const double length = grid.position[p].back();
      e[a] -= length * std::round(e[a] / length);
    }
  }
  return e;
}

// The nearest to a point of the spheres near these unknowns.
struct NearestSphere {
  int sphere = -1;
  double distance = 1e300;  ///< from its surface
};
NearestSphere nearest_sphere(const StokesSolver& solver, const Grid& grid,
                             const std::vector<int>& near, const Vec3& x) {
  NearestSphere nearest;
  for (int s : near) {
    const Sphere& sphere = solver.sphere_in_rows(s);
    const double distance = norm(from_centre(sphere, grid, x)) - sphere.radius;
    if (distance < nearest.distance) {
      nearest = {s, distance};
    }
  }
  return nearest;
}

Vec3 face_centre(const Grid& grid, int component, const std::array<int, 3>& at) {
  Vec3 x;
  for (int a = 0; a < 3; ++a) {
    const double spacing = grid.position[static_cast<std::size_t>(a)][1];
    x[a] = (at[static_cast<std::size_t>(a)] + (a == component ? 0.0 : 0.5)) * spacing;
  }
  return x;
}

// The eight unknowns around a point, one after the other, then what they say.
// NOLINTNEXTLINE(readability-function-size)
double component_at(const StokesSolver& solver, int component, const Vec3& x) {
  const WallRows& rows = solver.rows();
  const Grid& grid = rows.grid();
  const auto& u = solver.fields().a[static_cast<std::size_t>(component)];
  std::array<Pair, 3> pairs;
  for (int a = 0; a < 3; ++a) {
    pairs[static_cast<std::size_t>(a)] =
        bracket(grid, rows.axes()[static_cast<std::size_t>(a)], component, a, x[a]);
  }

  struct OpenCorner {
    std::array<int, 3> at;
    double value, moment, weight;
  };
  std::vector<OpenCorner> open;
  double plain = 0.0;
  bool beyond = false;  // a corner outside the box: a wall's own value takes part
  std::vector<int> near;
  for (std::size_t m = 0; m < 8; ++m) {
    const std::array<std::size_t, 3> corner{m & 1U, (m >> 1U) & 1U, (m >> 2U) & 1U};
    double weight = 1.0;
    std::array<int, 3> at{};
    bool inside = true;
    std::array<int, 3> raw{};
    for (std::size_t a = 0; a < 3; ++a) {
      weight *= pairs[a].weight[corner[a]];
      raw[a] = pairs[a].index[corner[a]];
      at[a] = raw[a];
      if (grid.periodic[a]) {
        at[a] = (raw[a] + grid.cells[a]) % grid.cells[a];
      } else {
        inside = inside && at[a] >= 0 && at[a] < grid.end(component, static_cast<int>(a));
      }
    }
    if (weight == 0.0) {
      continue;
    }
    if (!inside) {
      beyond = true;
      plain += weight * u[grid.index(raw[0], raw[1], raw[2])];
      continue;
    }
    const double value = u[grid.index(at[0], at[1], at[2])];
    plain += weight * value;
    const double moment = rows.moment(component, at);
    if (!rows.away(component, at)) {
      near.push_back(rows.nearest(component, at[0], at[1], at[2]).sphere);
    }
    if (moment > 0.0 && value != 0.0) {
      open.push_back({at, value, moment, weight});
    }
  }
  if (near.empty()) {
    return plain;
  }
  const NearestSphere nearest = nearest_sphere(solver, grid, near, x);
  const auto wall_velocity = [&](const Vec3& point) {
    return solver.surface_velocity(
        nearest.sphere,
        from_centre(solver.sphere_in_rows(nearest.sphere), grid, point))[component];
  };
  if (nearest.distance <= 0.0) {
    return wall_velocity(x);
  }
  // From half a spacing to a whole one the profile from the wall passes into the plain
  // one; next to a wall of the box the wall's own no slip rules.
  const double spacing = grid.position[0][1];
  const double from_wall =
      beyond || open.empty()
          ? 0.0
          : std::clamp(2.0 - 2.0 * nearest.distance / spacing, 0.0, 1.0);
  if (from_wall == 0.0) {
    return plain;
  }
  // Shear of the velocity relative to the surface.
  double shear = 0.0;
  double open_weight = 0.0;
  for (const OpenCorner& corner : open) {
    shear += corner.weight *
             (corner.value - wall_velocity(face_centre(grid, component, corner.at))) /
             corner.moment;
    open_weight += corner.weight;
  }
  return from_wall * (wall_velocity(x) + nearest.distance * shear / open_weight) +
         (1.0 - from_wall) * plain;
}

}  // namespace

Vec3 velocity_at(const StokesSolver& solver, const Vec3& x) {
  const Grid& grid = solver.rows().grid();
  Vec3 at = x * (1.0 / solver.length_unit());
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    const double length = grid.position[s].back();
    at[a] = grid.periodic[s] ? at[a] - length * std::floor(at[a] / length)
                             : std::clamp(at[a], 0.0, length);
  }
  return Vec3{component_at(solver, u_x, at), component_at(solver, u_y, at),
              component_at(solver, u_z, at)} *
         solver.velocity_unit();
}

}  // namespace colloid
