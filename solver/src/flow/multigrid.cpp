#include "flow/multigrid.h"

#include <algorithm>

#include "flow/halo.h"
#include "flow/kernels.h"
#include "flow/planes.h"

namespace colloid {

namespace {

// Coarsening ends when no axis has more cells than this.
constexpr int kCoarsest = 4;

// An axis is coarsened while its cells are at most this much wider than the narrowest:
// strongly stretched cells first become cubes.
constexpr double kStretch = 1.5;

// Cells longer than this are smoothed so badly that a second visit to the coarse levels
// does harm; there the V-cycle converges.
constexpr double kNeedle = 20.0;

bool axes_to_coarsen(const Grid& grid, std::array<bool, 3>& along) {
  double narrowest = 1e300;
  for (std::size_t a = 0; a < 3; ++a) {
    if (grid.cells[a] > kCoarsest) {
      narrowest = std::min(narrowest, grid.width[a].front());
    }
  }
  bool any = false;
  for (std::size_t a = 0; a < 3; ++a) {
    along[a] = grid.cells[a] > 2 && grid.width[a].front() <= kStretch * narrowest;
    any = any || (along[a] && grid.cells[a] > kCoarsest);
  }
  return any;
}

}  // namespace

Multigrid::Multigrid(const WallRows& finest, const FlowFaces& faces,
                     const std::vector<Sphere>& spheres, const CycleOptions& options,
                     int threads)
    : options_(options), threads_(threads) {
  const auto& width = finest.grid().width;
  const auto [narrow, wide] =
      std::minmax({width[0].front(), width[1].front(), width[2].front()});
  if (wide > kNeedle * narrow) {
    options_.full.coarse_visits = 1;
  }
  levels_.emplace_back();
  levels_.back().walls = &finest;
  std::array<bool, 3> along{};
  while (axes_to_coarsen(levels_.back().walls->grid(), along)) {
    const Grid coarse = coarsen(levels_.back().walls->grid(), along);
    levels_.back().transfer =
        make_transfer(levels_.back().walls->grid(), coarse, levels_.back().walls->axes());
    levels_.emplace_back();
    levels_.back().rows = std::make_unique<WallRows>(coarse, faces);
    levels_.back().rows->add(spheres);
    levels_.back().walls = levels_.back().rows.get();
  }
  for (Level& level : levels_) {
    const std::size_t size = level.walls->grid().size;
    level.view = view(*level.walls);
    level.r = StokesVector<float>(size);
    level.b.assign(size, 0.0F);
    level.q.assign(options_.omega.size(), std::vector<float>(size, 0.0F));
    if (level.rows) {
      level.u = StokesVector<float>(size);
      level.f = StokesVector<float>(size);
    }
  }
}

void Multigrid::add(const std::vector<Sphere>& spheres) {
  for (Level& level : levels_) {
    if (level.rows) {
      level.rows->add(spheres);
    }
  }
}

void Multigrid::set_moving(const std::vector<Sphere>& spheres) {
  for (Level& level : levels_) {
    if (level.rows) {
      level.rows->set_moving(spheres);
    }
  }
}

void Multigrid::residual(Level& level, StokesVector<float>& u,
                         const StokesVector<float>& f) {
  fill_halos(level.walls->grid(), u);
  for_planes(level.view.end[2], threads_,
             [&](int k) { residual_plane(level.view, u, f, level.r, k); });
}

// The stages of a sweep, plane by plane:
//
//   0            r = f - M u                      needs u  of planes k-1, k, k+1
//   1            right-hand side, first q         needs r  of k, k+1
//   2 .. steps   a Jacobi step on q               needs q  of k-1, k, k+1
//   last         u and p corrected                needs q  of k-1, k; u no longer needed
//
// On one thread they follow each other at two planes' distance, so that a plane passes
// through all of them while it is in the cache; stage s starts at plane s and ends at
// plane s - 1, which makes the order right for a periodic axis too.  On several threads
// each stage is finished before the next: the same operations on the same numbers.
void Multigrid::sweep(Level& level, const StokesVector<float>& f, StokesVector<float>& u,
                      bool from_zero, int number) {
  const Grid& grid = level.walls->grid();
  const LevelView& m = level.view;
  const int planes = m.end[2];
  const float alpha = options_.alpha[static_cast<std::size_t>(number % 2)];
  const StokesVector<float>& r = from_zero ? f : level.r;
  const int steps = static_cast<int>(options_.omega.size());

  if (!from_zero) {
    fill_halos(grid, u);
  }
  const auto stage = [&](int s, int k) {
    if (s == 0) {
      if (!from_zero) {
        residual_plane(m, u, f, level.r, k);
        for (int c = 0; c < 3; ++c) {
          fill_halo_of_plane(grid, level.r[c], k);
        }
      }
    } else if (s == 1) {
      schur_start_plane(m, r, alpha, options_.omega[0], level.b.data(), level.q[0].data(),
                        k);
      fill_halo_of_plane(grid, level.q[0].data(), k);
    } else if (s <= steps) {
      const auto step = static_cast<std::size_t>(s - 1);
      schur_step_plane(m, level.b.data(), options_.omega[step], level.q[step - 1].data(),
                       level.q[step].data(), k);
      fill_halo_of_plane(grid, level.q[step].data(), k);
    } else {
      correct_plane(m, r, level.q[static_cast<std::size_t>(steps - 1)].data(), alpha,
                    from_zero, u, k);
    }
  };
  const int last = steps + 1;
  if (threads_ > 1 || planes < 2 * last) {
    for (int s = 0; s <= last; ++s) {
      for_planes(planes, threads_, [&](int k) { stage(s, k); });
    }
    return;
  }
  for (int time = 0; time < planes + 2 * last; ++time) {
    for (int s = 0; s <= last; ++s) {
      const int order = time - 2 * s;
      if (order >= 0 && order < planes) {
        stage(s, (order + s) % planes);
      }
    }
  }
}

void Multigrid::smooth(StokesVector<float>& u, const StokesVector<float>& f,
                       bool from_zero, int number) {
  sweep(levels_.front(), f, u, from_zero, number);
}

void Multigrid::cycle(const CycleShape& shape, std::size_t index,
                      const StokesVector<float>& f, StokesVector<float>& u,
                      bool from_zero) {
  Level& level = levels_[index];
  if (index + 1 == levels_.size()) {
    for (int s = 0; s < options_.coarsest_sweeps; ++s) {
      sweep(level, f, u, from_zero && s == 0, s);
    }
    return;
  }
  for (int s = 0; s < shape.sweeps_before; ++s) {
    sweep(level, f, u, from_zero && s == 0, s);
  }
  residual(level, u, f);
  fill_halos(level.walls->grid(), level.r);

  Level& coarse = levels_[index + 1];
  for_planes(coarse.view.end[2], threads_, [&](int k) {
    restrict_plane(level.transfer, level.view, coarse.view, level.r, coarse.f, k);
  });
  fill_halos(coarse.walls->grid(), coarse.f);
  const int visits = index + 2 < levels_.size() ? shape.coarse_visits : 1;
  for (int visit = 0; visit < visits; ++visit) {
    cycle(shape, index + 1, coarse.f, coarse.u, visit == 0);
  }
  fill_halos(coarse.walls->grid(), coarse.u);
  for_planes(level.view.end[2], threads_, [&](int k) {
    prolong_plane(level.transfer, level.view, coarse.view, coarse.u, u, k);
  });
  for (int s = 0; s < shape.sweeps_after; ++s) {
    sweep(level, f, u, false, s);
  }
}

void Multigrid::apply(const StokesVector<float>& r, StokesVector<float>& z, bool light) {
  cycle(light ? options_.light : options_.full, 0, r, z, true);
}

}  // namespace colloid
