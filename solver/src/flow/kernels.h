// The loops in which the solver spends its time.  Each works on the plane k = const of
// one level, so callers may hand planes to threads; no result depends on who does which
// plane. Halos must be filled (halo.h).  Symbols as in MODEL section F: L the scaled
// viscous operator, G the gradient, D the divergence, S the row scales, d the common
// diagonal.
#pragma once

#include "flow/level.h"

namespace colloid {

/// r = f - (d u - L u + S G p),  r_p = f_p - D u.                                   (F9)
/// Of `u` the planes k-1 .. k+1 are read.
template <class In, class Out>
void residual_plane(const LevelView& m, const StokesVector<In>& u,
                    const StokesVector<Out>& f, StokesVector<Out>& r, int k);

/// w = -M z on one plane: the residual for a right-hand side of zero.
template <class In>
void minus_apply_plane(const LevelView& m, const StokesVector<In>& z,
                       StokesVector<double>& w, int k);

/// First step of the pressure of a Braess-Sarazin sweep: b = D r/d - alpha r_p, and one
/// Jacobi step from zero, q = -omega b / diag.                                      (F12)
void schur_start_plane(const LevelView& m, const StokesVector<float>& r, float alpha,
                       float omega, float* b, float* q, int k);

/// A Jacobi step on D S G q / d = b.                                                (F13)
void schur_step_plane(const LevelView& m, const float* b, float omega, const float* q,
                      float* q_new, int k);

/// u += (r - S G q) / (alpha d),  p += q; `u` is set, not added to, if `from_zero`. (F14)
void correct_plane(const LevelView& m, const StokesVector<float>& r, const float* q,
                   float alpha, bool from_zero, StokesVector<float>& u, int k);

/// Sum of a_i b_i over one plane, accumulated in double in a fixed order.
template <class A, class B>
double dot_plane(const LevelView& m, const StokesVector<A>& a, const StokesVector<B>& b,
                 int k);

/// Sum of squares of S G p over one plane.
double pressure_square_plane(const LevelView& m, const StokesVector<double>& u, int k);

/// sum[i] = dot_plane of w and v[i], i < count: rows of w stay in the cache.
void dots_plane(const LevelView& m, const StokesVector<double>& w,
                const StokesVector<float>* v, std::size_t count, double* sum, int k);

/// y += s[0] v[0] + .. + s[count - 1] v[count - 1] on one plane; returns dot_plane(y, y).
double combine_plane(const LevelView& m, const double* s, const StokesVector<float>* v,
                     std::size_t count, StokesVector<double>& y, int k);

/// y = s x on one plane.
template <class X, class Y>
void scaled_copy_plane(const LevelView& m, double s, const StokesVector<X>& x,
                       StokesVector<Y>& y, int k);

}  // namespace colloid
