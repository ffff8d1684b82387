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

void fill_halos(const Grid& grid, Fields<float>& x) {
  for (int c = 0; c < 4; ++c) {
    fill_halo(grid, x[c]);
  }
}

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
  levels_.emplace_back();
  levels_.back().walls = &finest;
  std::array<bool, 3> along{};
  while (axes_to_coarsen(levels_.back().walls->grid(), along)) {
    const Grid coarse = coarsen(levels_.back().walls->grid(), along);
    levels_.back().transfer = make_transfer(levels_.back().walls->grid(), coarse,
                                            levels_.back().walls->axes());
    levels_.emplace_back();
    levels_.back().rows = std::make_unique<WallRows>(coarse, faces);
    levels_.back().rows->add(spheres);
    levels_.back().walls = levels_.back().rows.get();
  }
  for (Level& level : levels_) {
    const std::size_t size = level.walls->grid().size;
    level.view = view(*level.walls);
    level.r = Fields<float>(size);
    level.b.assign(size, 0.0F);
    level.q.assign(size, 0.0F);
    level.q_next.assign(size, 0.0F);
    if (level.rows) {
      level.u = Fields<float>(size);
      level.f = Fields<float>(size);
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

void Multigrid::residual(Level& level, Fields<float>& u, const Fields<float>& f) {
  fill_halos(level.walls->grid(), u);
  for_planes(level.view.end[2], threads_,
             [&](int k) { residual_plane(level.view, u, f, level.r, k); });
}

void Multigrid::sweep(Level& level, const Fields<float>& f, Fields<float>& u,
                      bool from_zero, int number) {
  const Grid& grid = level.walls->grid();
  const LevelView& m = level.view;
  const int planes = m.end[2];
  const float alpha = options_.alpha[static_cast<std::size_t>(number % 2)];
  if (from_zero) {
    for_planes(planes, threads_,
               [&](int k) { scaled_copy_plane(m, 1.0, f, level.r, k); });
  } else {
    residual(level, u, f);
  }
  for (int c = 0; c < 3; ++c) {
    fill_halo(grid, level.r[c]);
  }
  for_planes(planes, threads_, [&](int k) {
    schur_start_plane(m, level.r, alpha, options_.omega[0], level.b.data(), level.q.data(),
                      k);
  });
  fill_halo(grid, level.q.data());
  for (int step = 1; step < options_.schur_steps; ++step) {
    const float omega = options_.omega[static_cast<std::size_t>(step % 4)];
    for_planes(planes, threads_, [&](int k) {
      schur_step_plane(m, level.b.data(), omega, level.q.data(), level.q_next.data(), k);
    });
    std::swap(level.q, level.q_next);
    fill_halo(grid, level.q.data());
  }
  for_planes(planes, threads_,
             [&](int k) { correct_plane(m, level.r, level.q.data(), alpha, u, k); });
}

void Multigrid::smooth(Fields<float>& u, const Fields<float>& f, bool from_zero,
                       int number) {
  sweep(levels_.front(), f, u, from_zero, number);
}

void Multigrid::cycle(std::size_t index, const Fields<float>& f, Fields<float>& u) {
  Level& level = levels_[index];
  if (index + 1 == levels_.size()) {
    for (int s = 0; s < options_.coarsest_sweeps; ++s) {
      sweep(level, f, u, s == 0, s);
    }
    return;
  }
  for (int s = 0; s < options_.sweeps_before; ++s) {
    sweep(level, f, u, s == 0, s);
  }
  residual(level, u, f);
  fill_halos(level.walls->grid(), level.r);

  Level& coarse = levels_[index + 1];
  for_planes(coarse.view.end[2], threads_, [&](int k) {
    restrict_plane(level.transfer, level.view, coarse.view, level.r, coarse.f, k);
  });
  for (auto& x : coarse.u.a) {
    std::fill(x.begin(), x.end(), 0.0F);
  }
  cycle(index + 1, coarse.f, coarse.u);
  fill_halos(coarse.walls->grid(), coarse.u);
  for_planes(level.view.end[2], threads_, [&](int k) {
    prolong_plane(level.transfer, level.view, coarse.view, coarse.u, u, k);
  });
  for (int s = 0; s < options_.sweeps_after; ++s) {
    sweep(level, f, u, false, s);
  }
}

void Multigrid::apply(const Fields<float>& r, Fields<float>& z) {
  for (auto& x : z.a) {
    std::fill(x.begin(), x.end(), 0.0F);
  }
  cycle(0, r, z);
}

}  // namespace colloid
