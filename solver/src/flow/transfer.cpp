#include "flow/transfer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "flow/clones.h"

namespace colloid {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool is_coarsened(const Grid& fine, const Grid& coarse, int axis) {
  return coarse.cells[at(axis)] != fine.cells[at(axis)];
}

LineTransfer identity(int count) {
  LineTransfer t;
  t.coarsened = false;
  for (int i = 0; i < count; ++i) {
    t.near.push_back(i);
    t.far.push_back(i);
    t.near_part.push_back(1.0F);
    t.far_part.push_back(0.0F);
    t.first.push_back(i);
    t.part.push_back({1.0F, 0.0F, 0.0F});
  }
  return t;
}

// Faces: coarse face I is fine face 2I, the last one is the last.
LineTransfer face_line(const Grid& fine, const Grid& coarse, int axis) {
  const auto& w = fine.width[at(axis)];
  const auto& W = coarse.width[at(axis)];
  const auto& x = fine.position[at(axis)];
  const auto& X = coarse.position[at(axis)];
  const int n = fine.cells[at(axis)];
  const int count = coarse.cells[at(axis)];
  const bool periodic = fine.periodic[at(axis)];
  assert(n > 0 && count > 0);
  LineTransfer t;
  for (int i = 0; i <= n; ++i) {
    const int cell = std::min(i / 2, count - 1);
    const double share = (X[at(cell + 1)] - x[at(i)]) / W[at(cell)];
    t.near.push_back(share > 0.0 ? cell : cell + 1);
    t.far.push_back(share < 1.0 ? cell + 1 : cell);
    t.near_part.push_back(static_cast<float>(share > 0.0 ? share : 1.0));
    t.far_part.push_back(static_cast<float>(share > 0.0 ? 1.0 - share : 0.0));
  }
  // Overlap of the fine control volumes with the coarse one; cells beyond the box are
  // empty.
  const auto width = [&](int cell) {
    const bool inside = periodic || (cell >= 0 && cell < n);
    return inside ? w[at((cell + n) % n)] : 0.0;
  };
  const auto coarse_width = [&](int cell) {
    const bool inside = periodic || (cell >= 0 && cell < count);
    return inside ? W[at((cell + count) % count)] : 0.0;
  };
  for (int I = 0; I <= count; ++I) {
    const int i = I == count ? n : 2 * I;
    const double low = -0.5 * coarse_width(I - 1);
    const double high = 0.5 * coarse_width(I);
    const std::array<double, 3> place{-width(i - 1), 0.0, width(i)};
    std::array<double, 3> overlap{};
    double sum = 0.0;
    for (int m = 0; m < 3; ++m) {
      const int face = i - 1 + m;
      const double from = place[at(m)] - 0.5 * width(face - 1);
      const double to = place[at(m)] + 0.5 * width(face);
      overlap[at(m)] = std::max(0.0, std::min(high, to) - std::max(low, from));
      sum += overlap[at(m)];
    }
    t.first.push_back(i - 1);
    t.part.push_back({static_cast<float>(overlap[0] / sum),
                      static_cast<float>(overlap[1] / sum),
                      static_cast<float>(overlap[2] / sum)});
  }
  return t;
}

LineTransfer centre_line(const Grid& fine, const Grid& coarse, int axis,
                         const AxisStencil& stencil, bool inject) {
  const int n = fine.cells[at(axis)];
  const int count = coarse.cells[at(axis)];
  const auto& W = coarse.width[at(axis)];
  const auto& w = fine.width[at(axis)];
  assert(n > 0 && count > 0);
  LineTransfer t;
  for (int i = 0; i < n; ++i) {
    const int parent = std::min(i / 2, count - 1);
    const double offset = fine.centre(axis, i) - coarse.centre(axis, parent);
    const int other = parent + (offset > 0.0 ? 1 : -1);
    double share = 1.0;
    if (!inject && offset != 0.0) {
      const bool inside = fine.periodic[at(axis)] || (other >= 0 && other < count);
      if (inside) {
        const double distance = 0.5 * (W[at(parent)] + W[at((other + count) % count)]);
        share = 1.0 - std::abs(offset) / distance;
      } else {
        const Side side = offset > 0.0 ? stencil.at_centre.back().side_above
                                       : stencil.at_centre.front().side_below;
        const double to_wall = 0.5 * W[at(parent)];
        share = side == Side::given_velocity ? 1.0 - std::abs(offset) / to_wall : 1.0;
      }
      t.far.push_back(inside ? other : parent);
      t.far_part.push_back(inside ? static_cast<float>(1.0 - share) : 0.0F);
    } else {
      t.far.push_back(parent);
      t.far_part.push_back(0.0F);
    }
    t.near.push_back(parent);
    t.near_part.push_back(static_cast<float>(share));
  }
  for (int I = 0; I < count; ++I) {
    std::array<float, 3> part{};
    const int cells = I == count - 1 ? n - 2 * I : 2;
    for (int m = 0; m < cells; ++m) {
      part[at(m)] = static_cast<float>(w[at(2 * I + m)] / W[at(I)]);
    }
    t.first.push_back(2 * I);
    t.part.push_back(part);
  }
  return t;
}

// The weights of single unknowns, rearranged for rows.
LineTransfer with_rows(LineTransfer t) {
  const auto length = at(whole_blocks(static_cast<int>(t.first.size()) + 2));
  for (auto* row : {&t.even_here, &t.even_below, &t.odd_here, &t.odd_above, &t.take[0],
                    &t.take[1], &t.take[2], &t.take[3]}) {
    row->assign(length, 0.0F);
  }
  for (std::size_t i = 0; i < t.near.size(); ++i) {
    const std::size_t parent = i / 2;  // of the row's pattern, not always of the grid
    const bool even = i % 2 == 0;
    for (const auto& [index, weight] :
         {std::pair{t.near[i], t.near_part[i]}, std::pair{t.far[i], t.far_part[i]}}) {
      const bool here = index == static_cast<int>(parent);
      (even ? (here ? t.even_here : t.even_below)
            : (here ? t.odd_here : t.odd_above))[parent] += weight;
    }
  }
  for (std::size_t coarse = 0; coarse < t.first.size(); ++coarse) {
    for (std::size_t m = 0; m < 3; ++m) {
      const int offset =
          t.first[coarse] + static_cast<int>(m) - 2 * static_cast<int>(coarse) + 1;
      if (t.part[coarse][m] != 0.0F) {
        t.take[at(offset)][coarse] += t.part[coarse][m];
      }
    }
  }
  return t;
}

const LineTransfer& line(const LevelTransfer& t, int component, int axis) {
  if (component == pressure) {
    return t.cell[at(axis)];
  }
  return component == axis ? t.face[at(axis)] : t.centre[at(axis)];
}

const float* openness(const LevelView& m, int component) {
  return component == pressure ? m.cell_scale : m.row_scale[at(component)];
}

// sum[i + 1] over fine rows, i = -1 ..; sums start at index -1 and are longer than a row.
std::size_t sum_length(const LevelView& fine) {
  return at(whole_blocks(fine.end[0] + 2) + 4 * kBlock);
}

PORECLOG_CLONES void add_row(float weight, const float* __restrict row,
                             float* __restrict sum, std::size_t count) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    sum[i] += weight * row[i];
  }
}

PORECLOG_CLONES void restrict_row(const LineTransfer& x, const float* sum,
                                  const float* open, float* out, std::size_t count) {
  const float* __restrict s = sum;  // s[2I] is fine 2I - 1
  const float* __restrict first = x.take[0].data();
  const float* __restrict second = x.take[1].data();
  const float* __restrict third = x.take[2].data();
  const float* __restrict fourth = x.take[3].data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    const float value = first[i] * s[2 * i] + second[i] * s[2 * i + 1] +
                        third[i] * s[2 * i + 2] + fourth[i] * s[2 * i + 3];
    out[i] = open[i] > 0.0F ? value : 0.0F;
  }
}

// `work` holds the interpolated row before closed unknowns are left out.
PORECLOG_CLONES void prolong_row(const LineTransfer& x, const float* sum,
                                 const float* open, float* out, std::size_t count,
                                 float* __restrict work) {
  const float* __restrict s = sum;  // s[I], s[I + 1], s[I + 2]: coarse I - 1, I, I + 1
  const float* __restrict even_here = x.even_here.data();
  const float* __restrict even_below = x.even_below.data();
  const float* __restrict odd_here = x.odd_here.data();
  const float* __restrict odd_above = x.odd_above.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    work[2 * i] = even_here[i] * s[i + 1] + even_below[i] * s[i];
    work[2 * i + 1] = odd_here[i] * s[i + 1] + odd_above[i] * s[i + 2];
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i < 2 * count; ++i) {
    out[i] += open[i] > 0.0F ? work[i] : 0.0F;
  }
}

}  // namespace

LevelTransfer make_transfer(const Grid& fine, const Grid& coarse,
                            const std::array<AxisStencil, 3>& fine_axes) {
  LevelTransfer t;
  for (int a = 0; a < 3; ++a) {
    if (is_coarsened(fine, coarse, a)) {
      t.face[at(a)] = with_rows(face_line(fine, coarse, a));
      t.centre[at(a)] = with_rows(centre_line(fine, coarse, a, fine_axes[at(a)], false));
      t.cell[at(a)] = with_rows(centre_line(fine, coarse, a, fine_axes[at(a)], true));
    } else {
      t.face[at(a)] = identity(fine.cells[at(a)] + 1);
      t.centre[at(a)] = identity(fine.cells[at(a)]);
      t.cell[at(a)] = t.centre[at(a)];
    }
  }
  return t;
}

void restrict_plane(const LevelTransfer& t, const LevelView& fine,
                    const LevelView& coarse, const StokesVector<float>& r_fine,
                    StokesVector<float>& f_coarse, int K) {
  std::vector<float> sum(sum_length(fine));
  const auto length = at(fine.end[0] + 2);
  for (int c = 0; c < 4; ++c) {
    const LineTransfer& x = line(t, c, 0);
    const LineTransfer& y = line(t, c, 1);
    const LineTransfer& z = line(t, c, 2);
    if (at(K) >= z.first.size()) {
      continue;
    }
    for (int J = 0; at(J) < y.first.size() && J < coarse.end[1]; ++J) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) {
          const float weight = z.part[at(K)][b] * y.part[at(J)][a];
          if (weight != 0.0F) {
            add_row(weight,
                    r_fine[c] +
                        fine.row(y.first[at(J)] + static_cast<int>(a),
                                 z.first[at(K)] + static_cast<int>(b)) -
                        1,
                    sum.data(), length);
          }
        }
      }
      const std::size_t q = coarse.row(J, K);
      float* out = f_coarse[c] + q;
      const float* open = openness(coarse, c) + q;
      const std::size_t count = std::min(x.first.size(), at(coarse.end[0]));
      if (x.coarsened) {
        restrict_row(x, sum.data(), open, out, count);
      } else {
        for (std::size_t i = 0; i < count; ++i) {
          out[i] = open[i] > 0.0F ? sum[i + 1] : 0.0F;
        }
      }
    }
  }
}

void prolong_plane(const LevelTransfer& t, const LevelView& fine, const LevelView& coarse,
                   const StokesVector<float>& u_coarse, StokesVector<float>& u_fine,
                   int k) {
  std::vector<float> sum(sum_length(fine));
  std::vector<float> work(sum_length(fine));
  const auto length = at(coarse.end[0] + 2);
  for (int c = 0; c < 4; ++c) {
    const LineTransfer& x = line(t, c, 0);
    const LineTransfer& y = line(t, c, 1);
    const LineTransfer& z = line(t, c, 2);
    if (at(k) >= z.near.size()) {
      continue;
    }
    const std::array<int, 2> kk{z.near[at(k)], z.far[at(k)]};
    const std::array<float, 2> wk{z.near_part[at(k)], z.far_part[at(k)]};
    for (int j = 0; at(j) < y.near.size() && j < fine.end[1]; ++j) {
      const std::array<int, 2> jj{y.near[at(j)], y.far[at(j)]};
      const std::array<float, 2> wj{y.near_part[at(j)], y.far_part[at(j)]};
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t a = 0; a < 2; ++a) {
          const float weight = wk[b] * wj[a];
          if (weight != 0.0F) {
            add_row(weight, u_coarse[c] + coarse.row(jj[a], kk[b]) - 1, sum.data(),
                    length);
          }
        }
      }
      const std::size_t q = fine.row(j, k);
      float* out = u_fine[c] + q;
      const float* open = openness(fine, c) + q;
      if (x.coarsened) {
        // The last pair may reach one beyond the row: closed there, or a halo.
        prolong_row(x, sum.data(), open, out, (at(fine.end[0]) + 1) / 2, work.data());
      } else {
        const std::size_t count = std::min(x.near.size(), at(fine.end[0]));
        for (std::size_t i = 0; i < count; ++i) {
          out[i] += open[i] > 0.0F ? sum[i + 1] : 0.0F;
        }
      }
    }
  }
}

}  // namespace colloid
