#include "flow/wall_forces.h"

#include <cmath>

#include "flow/halo.h"

namespace colloid {

namespace {

// One row's balance, and how much of it a given-velocity side of the box takes.
struct Balance {
  double total = 0.0;
  double wall_share = 0.0;
  int wall = -1;
};

class RowBalance {
 public:
  RowBalance(const StokesSolver& solver, const std::vector<double>& p)
      : rows_(solver.rows()),
        grid_(rows_.grid()),
        fields_(solver.fields()),
        p_(p),
        force_(solver.grid_body_force()) {}

  Balance operator()(int component, const std::array<int, 3>& at) const {
    const auto c = static_cast<std::size_t>(component);
    const std::size_t q = grid_.index(at[0], at[1], at[2]);
    const auto& u = fields_.a[c];
    Vec3 length;
    for (int a = 0; a < 3; ++a) {
      length[a] = dual_length(component, a, at[static_cast<std::size_t>(a)]);
    }
    const double volume = length.x * length.y * length.z;
    const double area = volume / length[component];
    Balance balance;
    balance.total = volume * force_[component] - area * pressure_step(component, at, q);
    for (int a = 0; a < 3; ++a) {
      const SecondDifference& d = difference(component, a, at);
      const double side_area = volume / length[a];
      for (int side = 0; side < 2; ++side) {
        const double distance = side == 0 ? d.below : d.above;
        const Side kind = side == 0 ? d.side_below : d.side_above;
        const bool own_wall = a == component && at_box_face(component, at, side);
        if (kind == Side::no_shear || own_wall) {
          continue;
        }
        const auto there = static_cast<std::size_t>(
            static_cast<std::ptrdiff_t>(q) + (side == 0 ? -1 : 1) * grid_.stride(a));
        const double pull = side_area * (u[there] - u[q]) / distance;
        if (kind == Side::given_velocity) {
          balance.wall = 2 * a + side;
          balance.wall_share -= pull * d.prefactor * length[a];
        } else {
          balance.total += pull;
        }
      }
    }
    return balance;
  }

 private:
  bool at_box_face(int component, const std::array<int, 3>& at, int side) const {
    const auto c = static_cast<std::size_t>(component);
    return !grid_.periodic[c] && at[c] == (side == 0 ? 0 : grid_.cells[c]);
  }

  // Half a cell on either side of a face, as far as there are cells.
  double dual_length(int component, int axis, int i) const {
    const auto a = static_cast<std::size_t>(axis);
    const auto& w = grid_.width[a];
    const int n = grid_.cells[a];
    if (component != axis) {
      return w[static_cast<std::size_t>(i)];
    }
    const bool periodic = grid_.periodic[a];
    const double below =
        i > 0 || periodic ? w[static_cast<std::size_t>((i + n - 1) % n)] : 0.0;
    const double above = i < n || periodic ? w[static_cast<std::size_t>(i % n)] : 0.0;
    return 0.5 * (below + above);
  }

  // p above minus p below; on the box itself the far value is the given one, and a wall
  // feels the pressure inside alone.
  double pressure_step(int component, const std::array<int, 3>& at, std::size_t q) const {
    const auto below = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(q) -
                                                grid_.stride(component));
    if (at_box_face(component, at, 0) && rows_.on_given_face(component, at)) {
      return p_[q];
    }
    if (at_box_face(component, at, 1) && rows_.on_given_face(component, at)) {
      return -p_[below];
    }
    return p_[q] - p_[below];
  }

  const SecondDifference& difference(int component, int axis,
                                     const std::array<int, 3>& at) const {
    const auto a = static_cast<std::size_t>(axis);
    const AxisStencil& s = rows_.axes()[a];
    return (component == axis ? s.at_face : s.at_centre)[static_cast<std::size_t>(at[a])];
  }

  const WallRows& rows_;
  const Grid& grid_;
  const StokesVector<double>& fields_;
  const std::vector<double>& p_;
  Vec3 force_;
};

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
        const std::array<int, 3> at{i, j, k};
        double sum = 0.0;
        int count = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          for (int step : {-1, 1}) {
            std::array<int, 3> near = at;
            near[a] += step;
            if (grid.periodic[a]) {
              near[a] = (near[a] + grid.cells[a]) % grid.cells[a];
            } else if (near[a] < 0 || near[a] >= grid.cells[a]) {
              continue;
            }
            const std::size_t n = grid.index(near[0], near[1], near[2]);
            if (open[n] > 0.0F) {
              sum += solver.fields().a[pressure][n];
              ++count;
            }
          }
        }
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
  const RowBalance balance_of(solver, p);
  WallForces forces;
  forces.spheres.resize(solver.problem().spheres.size());

  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < grid.end(c, 2); ++k) {
      for (int j = 0; j < grid.end(c, 1); ++j) {
        for (int i = 0; i < grid.end(c, 0); ++i) {
          const std::array<int, 3> at{i, j, k};
          const Balance balance = balance_of(c, at);
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
