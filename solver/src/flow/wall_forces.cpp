#include "flow/wall_forces.h"

#include <cmath>

#include "flow/halo.h"
#include "flow/row_balance.h"

namespace colloid {

namespace {

// One row's balance, and how much of it a given-velocity side of the box takes.
struct Balance {
  double total = 0.0;
  double wall_share = 0.0;
  int wall = -1;
};

Balance balance_of(const StokesSolver& solver, const std::vector<double>& p,
                   int component, const std::array<int, 3>& at) {
  const RowBalance row(solver.rows());
  const auto& u = solver.fields().a[static_cast<std::size_t>(component)];
  Balance balance;
  balance.total = row.volume(component, at) * solver.grid_body_force()[component];
  row.visit(
      component, at,
      [&](std::size_t entry, double weight) { balance.total += weight * u[entry]; },
      [&](std::size_t entry, double weight) { balance.total += weight * p[entry]; },
      [&](int face, std::size_t entry, double weight) {
        balance.wall = face;
        balance.wall_share += weight * u[entry];
      });
  return balance;
}

// Pressure with the cells next to open ones filled in by their mean.  Inside one sphere
// the value drops out of the sums; where two spheres share closed cells it should be
// near.
std::vector<double> filled_pressure(const StokesSolver& solver) {
  const Grid& grid = solver.rows().grid();
  const auto& open = solver.rows().coefficients().cell_scale;
  std::vector<double> p = solver.fields().a[pressure];
  for (int k = 0; k < grid.cells[2]; ++k) {
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        const std::size_t q = grid.index(i, j, k);
        if (open[q] > 0.0F) {
          continue;
        }
        double sum = 0.0;
        const std::vector<std::size_t> neighbours =
            open_neighbours(solver.rows(), {i, j, k});
        for (std::size_t n : neighbours) {
          sum += solver.fields().a[pressure][n];
        }
        const auto count = static_cast<double>(neighbours.size());
        p[q] = count > 0 ? sum / count : 0.0;
      }
    }
  }
  return p;
}

}  // namespace

WallForces wall_forces(const StokesSolver& solver) {
  const WallRows& rows = solver.rows();
  const Grid& grid = rows.grid();
  std::vector<double> p = filled_pressure(solver);
  fill_halo(grid, p.data());
  WallForces forces;
  forces.spheres.resize(static_cast<std::size_t>(rows.sphere_count()));

  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < grid.end(c, 2); ++k) {
      for (int j = 0; j < grid.end(c, 1); ++j) {
        for (int i = 0; i < grid.end(c, 0); ++i) {
          const std::array<int, 3> at{i, j, k};
          const Balance balance = balance_of(solver, p, c, at);
          const NearestSurface surface = rows.nearest(c, i, j, k);
          if (rows.on_given_face(c, at)) {
            const auto s = static_cast<std::size_t>(c);
            const std::size_t own = 2 * s + (at[s] == 0 ? 0 : 1);
            forces.faces[own][c] += balance.total;
            continue;
          }
          if (surface.sphere < 0) {
            if (balance.wall >= 0) {
              forces.faces[static_cast<std::size_t>(balance.wall)][c] += balance.total;
            }
            continue;
          }
          if (balance.wall >= 0) {
            forces.faces[static_cast<std::size_t>(balance.wall)][c] += balance.wall_share;
          }
          Vec3 force;
          force[c] = balance.total - balance.wall_share;
          Wrench& wrench = forces.spheres[static_cast<std::size_t>(surface.sphere)];
          wrench.force += force;
          wrench.torque += cross(surface.from_center, force);
        }
      }
    }
  }

  const double length = solver.length_unit();
  const double unit = solver.pressure_unit() * length * length;
  for (Wrench& w : forces.spheres) {
    w.force *= unit;
    w.torque *= unit * length;
  }
  for (Vec3& f : forces.faces) {
    f *= unit;
  }
  return forces;
}

}  // namespace colloid
