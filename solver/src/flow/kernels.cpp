#include "flow/kernels.h"

#include <algorithm>

#include "flow/clones.h"

namespace colloid {

// Small loops of a kernel: inlined, so that they are compiled once per instruction set.
#define PORECLOG_INLINE inline __attribute__((always_inline))

namespace {

// Sums are kept in this many parts.
constexpr std::size_t kLanes = 8;

// Whole blocks; written so that the compiler sees the multiple.
std::size_t row_length(const LevelView& m) {
  return static_cast<std::size_t>(m.blocks) * static_cast<std::size_t>(kBlock);
}

}  // namespace

// r = f - M u, with f = 0 if there is no f.  Three components and the divergence, one
// after the other: splitting the loop nest would hide that it is one pass.
template <bool kHasForce, class In, class Out>
// NOLINTNEXTLINE(readability-function-size)
PORECLOG_CLONES void balance_plane(const LevelView& m, const StokesVector<In>& u,
                                   const StokesVector<Out>& f, StokesVector<Out>& r,
                                   int k) {
  const std::ptrdiff_t sy = m.stride_y;
  const std::ptrdiff_t sz = m.stride_z;
  const std::size_t n = row_length(m);
  const Out d = static_cast<Out>(m.diagonal);
  const auto kk = static_cast<std::size_t>(k) + 1;
  for (int j = 0; j < m.end[1]; ++j) {
    const std::size_t q = m.row(j, k);
    const auto jj = static_cast<std::size_t>(j) + 1;
    const In* __restrict p = u[pressure] + q;
    for (std::size_t c = 0; c < 3; ++c) {
      const int component = static_cast<int>(c);
      const In* __restrict x = u[component] + q;
      const Out* __restrict rhs = f[component] + q;
      Out* __restrict out = r[component] + q;
      const float* __restrict a0 = m.link[c][0] + q;
      const float* __restrict a1 = m.link[c][1] + q;
      const float* __restrict a2 = m.link[c][2] + q;
      const float* __restrict scale = m.row_scale[c] + q;
      const float* __restrict x_below = m.below[c][0] + 1;
      const float* __restrict x_above = m.above[c][0] + 1;
      const Out y_below = m.below[c][1][jj];
      const Out y_above = m.above[c][1][jj];
      const Out z_below = m.below[c][2][kk];
      const Out z_above = m.above[c][2][kk];
      if (component == u_x) {
        const float* __restrict g = m.gradient[0] + 1;
#pragma GCC ivdep
        for (std::size_t i = 0; i < n; ++i) {
          const Out viscous =
              Out(a0[i]) *
                  (Out(x_below[i]) * Out(x[i - 1]) + Out(x_above[i]) * Out(x[i + 1])) +
              Out(a1[i]) * (y_below * Out((x - sy)[i]) + y_above * Out((x + sy)[i])) +
              Out(a2[i]) * (z_below * Out((x - sz)[i]) + z_above * Out((x + sz)[i]));
          out[i] = (kHasForce ? rhs[i] : Out(0)) - d * Out(x[i]) + viscous -
                   Out(scale[i]) * Out(g[i]) * (Out(p[i]) - Out(p[i - 1]));
        }
      } else {
        const std::ptrdiff_t s = component == u_y ? sy : sz;
        const Out g = m.gradient[c][component == u_y ? jj : kk];
        const In* __restrict p_below = p - s;
#pragma GCC ivdep
        for (std::size_t i = 0; i < n; ++i) {
          const Out viscous =
              Out(a0[i]) *
                  (Out(x_below[i]) * Out(x[i - 1]) + Out(x_above[i]) * Out(x[i + 1])) +
              Out(a1[i]) * (y_below * Out((x - sy)[i]) + y_above * Out((x + sy)[i])) +
              Out(a2[i]) * (z_below * Out((x - sz)[i]) + z_above * Out((x + sz)[i]));
          out[i] = (kHasForce ? rhs[i] : Out(0)) - d * Out(x[i]) + viscous -
                   Out(scale[i]) * g * (Out(p[i]) - Out(p_below[i]));
        }
      }
    }
    const In* __restrict ux = u[u_x] + q;
    const In* __restrict uy = u[u_y] + q;
    const In* __restrict uz = u[u_z] + q;
    const Out* __restrict rhs = f[pressure] + q;
    Out* __restrict out = r[pressure] + q;
    const float* __restrict dx = m.divergence[0] + 1;
    const Out dy = m.divergence[1][jj];
    const Out dz = m.divergence[2][kk];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
      out[i] =
          (kHasForce ? rhs[i] : Out(0)) -
          (Out(dx[i]) * (Out(ux[i + 1]) - Out(ux[i])) +
           dy * (Out((uy + sy)[i]) - Out(uy[i])) + dz * (Out((uz + sz)[i]) - Out(uz[i])));
    }
  }
}

template <class In, class Out>
void residual_plane(const LevelView& m, const StokesVector<In>& u,
                    const StokesVector<Out>& f, StokesVector<Out>& r, int k) {
  balance_plane<true>(m, u, f, r, k);
}

template <class In>
void minus_apply_plane(const LevelView& m, const StokesVector<In>& z,
                       StokesVector<double>& w, int k) {
  balance_plane<false>(m, z, w, w, k);
}

PORECLOG_CLONES void schur_start_plane(const LevelView& m, const StokesVector<float>& r,
                                       float alpha, float omega, float* b, float* q,
                                       int k) {
  const std::ptrdiff_t sy = m.stride_y;
  const std::ptrdiff_t sz = m.stride_z;
  const std::size_t n = row_length(m);
  const float inverse = static_cast<float>(1.0 / m.diagonal);
  for (int j = 0; j < m.end[1]; ++j) {
    const std::size_t at = m.row(j, k);
    const float* __restrict rx = r[u_x] + at;
    const float* __restrict ry = r[u_y] + at;
    const float* __restrict rz = r[u_z] + at;
    const float* __restrict rp = r[pressure] + at;
    const float* __restrict scale = m.cell_scale + at;
    const float* __restrict dx = m.divergence[0] + 1;
    const float dy = inverse * m.divergence[1][static_cast<std::size_t>(j) + 1];
    const float dz = inverse * m.divergence[2][static_cast<std::size_t>(k) + 1];
    float* __restrict rhs = b + at;
    float* __restrict out = q + at;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
      const float value = inverse * dx[i] * (rx[i + 1] - rx[i]) +
                          dy * ((ry + sy)[i] - ry[i]) + dz * ((rz + sz)[i] - rz[i]) -
                          alpha * rp[i];
      rhs[i] = value;
      out[i] = -omega * value * scale[i];
    }
  }
}

PORECLOG_CLONES void schur_step_plane(const LevelView& m, const float* b, float omega,
                                      const float* q, float* q_new, int k) {
  const std::ptrdiff_t sy = m.stride_y;
  const std::ptrdiff_t sz = m.stride_z;
  const std::size_t n = row_length(m);
  const float inverse = static_cast<float>(1.0 / m.diagonal);
  const auto kk = static_cast<std::size_t>(k) + 1;
  for (int j = 0; j < m.end[1]; ++j) {
    const std::size_t at = m.row(j, k);
    const auto jj = static_cast<std::size_t>(j) + 1;
    const float* __restrict old = q + at;
    const float* __restrict rhs = b + at;
    float* __restrict out = q_new + at;
    const float* __restrict sx = m.row_scale[0] + at;
    const float* __restrict sv = m.row_scale[1] + at;
    const float* __restrict sw = m.row_scale[2] + at;
    const float* __restrict scale = m.cell_scale + at;
    const float* __restrict dx = m.divergence[0] + 1;
    const float* __restrict gx = m.gradient[0] + 1;
    const float dy = inverse * m.divergence[1][jj];
    const float dz = inverse * m.divergence[2][kk];
    const float gy0 = dy * m.gradient[1][jj];
    const float gy1 = dy * m.gradient[1][jj + 1];
    const float gz0 = dz * m.gradient[2][kk];
    const float gz1 = dz * m.gradient[2][kk + 1];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
      const float here = old[i];
      const float applied = inverse * dx[i] *
                                (gx[i + 1] * sx[i + 1] * (old[i + 1] - here) -
                                 gx[i] * sx[i] * (here - old[i - 1])) +
                            gy1 * (sv + sy)[i] * ((old + sy)[i] - here) -
                            gy0 * sv[i] * (here - (old - sy)[i]) +
                            gz1 * (sw + sz)[i] * ((old + sz)[i] - here) -
                            gz0 * sw[i] * (here - (old - sz)[i]);
      out[i] = here - omega * (rhs[i] - applied) * scale[i];
    }
  }
}

PORECLOG_CLONES void correct_plane(const LevelView& m, const StokesVector<float>& r,
                                   const float* q, float alpha, bool from_zero,
                                   StokesVector<float>& u, int k) {
  const std::size_t n = row_length(m);
  const float factor =
      static_cast<float>(1.0 / (static_cast<double>(alpha) * m.diagonal));
  const float keep = from_zero ? 0.0F : 1.0F;
  const std::array<std::ptrdiff_t, 3> stride{1, m.stride_y, m.stride_z};
  for (int j = 0; j < m.end[1]; ++j) {
    const std::size_t at = m.row(j, k);
    const float* __restrict here = q + at;
    for (std::size_t c = 0; c < 3; ++c) {
      const float* __restrict below = here - stride[c];
      const float* __restrict rhs = r[static_cast<int>(c)] + at;
      const float* __restrict scale = m.row_scale[c] + at;
      float* __restrict x = u[static_cast<int>(c)] + at;
      if (c == 0) {
        const float* __restrict g = m.gradient[0] + 1;
#pragma GCC ivdep
        for (std::size_t i = 0; i < n; ++i) {
          x[i] = keep * x[i] + factor * (rhs[i] - scale[i] * g[i] * (here[i] - below[i]));
        }
      } else {
        const float g = m.gradient[c][static_cast<std::size_t>((c == 1 ? j : k) + 1)];
#pragma GCC ivdep
        for (std::size_t i = 0; i < n; ++i) {
          x[i] = keep * x[i] + factor * (rhs[i] - scale[i] * g * (here[i] - below[i]));
        }
      }
    }
    float* __restrict p = u[pressure] + at;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = keep * p[i] + here[i];
    }
  }
}

// Adds the products of two rows to kLanes sums, in a fixed order.
template <class A, class B>
PORECLOG_INLINE void add_products(const A* x, const B* y, std::size_t n, double* sum) {
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      sum[lane] += static_cast<double>(x[i + lane]) * static_cast<double>(y[i + lane]);
    }
  }
  for (; i < n; ++i) {
    sum[0] += static_cast<double>(x[i]) * static_cast<double>(y[i]);
  }
}

PORECLOG_INLINE double total(const double* sum) {
  double all = 0.0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    all += sum[lane];
  }
  return all;
}

template <class A, class B>
PORECLOG_CLONES double dot_plane(const LevelView& m, const StokesVector<A>& a,
                                 const StokesVector<B>& b, int k) {
  std::array<double, kLanes> sum{};
  const auto n = static_cast<std::size_t>(m.end[0]);  // no halos in sums
  for (int c = 0; c < 4; ++c) {
    for (int j = 0; j < m.end[1]; ++j) {
      const std::size_t at = m.row(j, k);
      add_products(a[c] + at, b[c] + at, n, sum.data());
    }
  }
  return total(sum.data());
}

PORECLOG_CLONES double pressure_square_plane(const LevelView& m,
                                             const StokesVector<double>& u, int k) {
  std::array<double, kLanes> sum{};
  std::array<double, static_cast<std::size_t>(kBlock)> push{};
  const std::array<std::ptrdiff_t, 3> stride{1, m.stride_y, m.stride_z};
  const auto n = static_cast<std::size_t>(m.end[0]);
  for (int j = 0; j < m.end[1]; ++j) {
    const std::size_t at = m.row(j, k);
    for (std::size_t c = 0; c < 3; ++c) {
      const double* here = u[pressure] + at;
      const double* below = here - stride[c];
      const float* scale = m.row_scale[c] + at;
      const float* g = m.gradient[c] + 1;
      for (std::size_t i = 0; i < n; i += push.size()) {
        const std::size_t count = std::min(push.size(), n - i);
        for (std::size_t b = 0; b < count; ++b) {
          const std::size_t q = i + b;
          const auto weight = static_cast<double>(
              g[c == 0 ? q : static_cast<std::size_t>(c == 1 ? j : k)]);
          push[b] = static_cast<double>(scale[q]) * weight * (here[q] - below[q]);
        }
        add_products(push.data(), push.data(), count, sum.data());
      }
    }
  }
  return total(sum.data());
}

PORECLOG_CLONES void dots_plane(const LevelView& m, const StokesVector<double>& w,
                                const StokesVector<float>* v, std::size_t count,
                                double* sum, int k) {
  std::vector<double> lanes(count * kLanes, 0.0);
  const auto n = static_cast<std::size_t>(m.end[0]);
  for (int c = 0; c < 4; ++c) {
    for (int j = 0; j < m.end[1]; ++j) {
      const std::size_t at = m.row(j, k);
      for (std::size_t i = 0; i < count; ++i) {
        add_products(w[c] + at, v[i][c] + at, n, lanes.data() + i * kLanes);
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    sum[i] = total(lanes.data() + i * kLanes);
  }
}

PORECLOG_CLONES double combine_plane(const LevelView& m, const double* s,
                                     const StokesVector<float>* v, std::size_t count,
                                     StokesVector<double>& y, int k) {
  std::array<double, kLanes> sum{};
  const std::size_t n = row_length(m);
  for (int c = 0; c < 4; ++c) {
    for (int j = 0; j < m.end[1]; ++j) {
      const std::size_t at = m.row(j, k);
      double* __restrict out = y[c] + at;
      for (std::size_t i = 0; i < count; ++i) {
        const float* __restrict in = v[i][c] + at;
        const double factor = s[i];
#pragma GCC ivdep
        for (std::size_t q = 0; q < n; ++q) {
          out[q] += factor * static_cast<double>(in[q]);
        }
      }
      add_products(out, out, static_cast<std::size_t>(m.end[0]), sum.data());
    }
  }
  return total(sum.data());
}

template <class X, class Y>
PORECLOG_CLONES void scaled_copy_plane(const LevelView& m, double s,
                                       const StokesVector<X>& x, StokesVector<Y>& y,
                                       int k) {
  const std::size_t n = row_length(m);
  for (int c = 0; c < 4; ++c) {
    for (int j = 0; j < m.end[1]; ++j) {
      const std::size_t at = m.row(j, k);
      const X* __restrict in = x[c] + at;
      Y* __restrict out = y[c] + at;
#pragma GCC ivdep
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = static_cast<Y>(s * static_cast<double>(in[i]));
      }
    }
  }
}

using F = StokesVector<float>;
using D = StokesVector<double>;

template void residual_plane(const LevelView&, const F&, const F&, F&, int);
template void residual_plane(const LevelView&, const D&, const D&, D&, int);
template double dot_plane(const LevelView&, const D&, const F&, int);
template double dot_plane(const LevelView&, const D&, const D&, int);
template void minus_apply_plane(const LevelView&, const F&, D&, int);
template void minus_apply_plane(const LevelView&, const D&, D&, int);
template void scaled_copy_plane(const LevelView&, double, const D&, F&, int);

}  // namespace colloid
