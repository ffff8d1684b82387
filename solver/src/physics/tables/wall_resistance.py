"""Coefficients of physics/wall_resistance.cpp, from the exact series; prints the header.

    python3 wall_resistance.py header > ../wall_resistance_coefficients.h      (2 minutes)
    python3 wall_resistance.py reference > tests/verification/wall_resistance/series.csv

Exact series, MODEL (R3)-(R5), gap eps = h/a:
  normal translation   Brenner (1961), eq. (2.19)
  spin about the normal  Jeffery (1915): sum of (sinh(alpha)/sinh(n alpha))^3
  parallel translation, rotation, shear   bispherical solution of O'Neill (1964), Dean &
    O'Neill (1963), Goren & O'Neill (1971).  All three are the tridiagonal system of O'Neill
    for A_n with a right-hand side that is built here from the velocity on the sphere,
        u_x = g(z), u_z = -omega rho cos(phi),
    by the recurrences of the Legendre functions and the equation of continuity; so one
    routine serves any rigid motion and the shear.
  stagnation flow      Stimson & Jeffery's (1926) stream function, whose value and slope on
    the sphere are those of rho^2 z^2 instead of rho^2; the force is linear in them
Fit, for x = 1/(1 + eps), y = 1 - x, t = 2x - 1:
    f / x^m = pole/eps + (a_0 + a_1 y + a_2 y^2) ln(1/y) + polynomial of degree 12 in t.
a_0 and a_1 are the known lubrication coefficients, a_2 and the polynomial are fitted by
least squares of the relative error.  Needs numpy and mpmath.
"""
import math
import sys
from multiprocessing import Pool

import numpy as np
from mpmath import mp, mpf

mp.dps = 40
DEGREE = 12
# name: power m, pole, a_0, a_1.  Cox & Brenner (1967) for f_n; O'Neill & Stewartson (1967)
# and Cooley & O'Neill (1968) for f_t, t_t, t_r (a_1 of t_t holds 4 a_0 more, from x^4);
# f_s and t_s have no logarithm to this order, t_n has -1/2 from its series.
FORMS = {
    "f_n": (0, 1, 1 / 5, 1 / 21),
    "f_t": (0, 0, 8 / 15, 64 / 375),
    "t_t": (4, 0, 1 / 10, 43 / 250 + 4 / 10),
    "t_r": (0, 0, 2 / 5, 66 / 125),
    "f_s": (0, 0, 0, 0),
    "t_s": (0, 0, 0, 0),
    "t_n": (0, 0, 0, -1 / 2),
    "f_e": (0, 0, 0, 0),
}


def brenner(eps):
    alpha = mp.acosh(1 + eps)
    total, n = mpf(0), 1
    while True:
        b = (n + mpf(1) / 2) * alpha
        top = 2 * mp.sinh(2 * b) + (2 * n + 1) * mp.sinh(2 * alpha)
        bottom = 4 * mp.sinh(b)**2 - (2 * n + 1)**2 * mp.sinh(alpha)**2
        term = mpf(n * (n + 1)) / ((2 * n - 1) * (2 * n + 3)) * (top / bottom - 1)
        total += term
        if n * alpha > 5 and abs(term) < mpf("1e-22") * abs(total):
            return mpf(4) / 3 * mp.sinh(alpha) * total
        n += 1


def spin(eps):
    alpha = mp.acosh(1 + eps)
    total, n = mpf(0), 1
    while True:
        term = (mp.sinh(alpha) / mp.sinh(n * alpha))**3
        total += term
        if n > 3 and term < mpf("1e-22") * total:
            return total
        n += 1


def stagnation(eps):
    """Force in u_z = -A z^2, u_rho = A rho z over 6 pi mu a A (h^2 + a^2/3).

    psi = (cosh xi - mu)^(-3/2) sum U_n(xi) V_n(mu); (1 - mu^2) (cosh xi - mu)^(-1/2) has the
    coefficients Q_n.  On the sphere U_n = Q_n for a translation (rho^2), and
    4/3 (Q_n'' - coth xi Q_n') for the stagnation flow (rho^2 z^2, in units of c).
    """
    alpha, h = mp.acosh(1 + eps), 1 + eps
    sinh, coth = mp.sinh(alpha), mp.coth(alpha)
    translation, flow, n = mpf(0), mpf(0), 1
    while True:
        p, q = n - mpf(1) / 2, n + mpf(3) / 2
        ep, eq = mp.exp(-p * alpha), mp.exp(-q * alpha)
        k = mpf(n * (n + 1)) / ((2 * n - 1) * (2 * n + 1) * (2 * n + 3))
        both = k * (2 * n - 1) * (2 * n + 3) / 2
        q0 = k * ((2 * n + 3) * ep - (2 * n - 1) * eq)
        q1 = -both * (ep - eq)
        q2 = both * (p * ep - q * eq)
        q3 = -both * (p**2 * ep - q**2 * eq)
        # U_n = A (cosh p xi - cosh q xi) + B (sinh p xi - p/q sinh q xi): no slip on the plane
        a0, a1 = (1 / ep + ep - 1 / eq - eq) / 2, (p / ep - p * ep - q / eq + q * eq) / 2
        b0 = (1 / ep - ep - p / q * (1 / eq - eq)) / 2
        b1 = p * (1 / ep + ep - 1 / eq - eq) / 2
        of = lambda value, slope: (2 * n + 1) * (1 - p / q) * (
            a0 * slope - a1 * value) / (a0 * b1 - a1 * b0)
        term = of(q2 - coth * q1, q3 - coth * q2 + q1 / sinh**2)
        translation += of(q0, q1)
        flow += term
        if n * alpha > 5 and abs(term) < mpf("1e-22") * abs(flow):
            break
        n += 1
    return brenner(eps) * mpf(4) / 3 * sinh**2 * flow / translation / (h**2 + mpf(1) / 3)


class Bispherical:
    """Force and torque on a sphere (a = 1) whose surface moves with u_x = g(z) etc."""

    def __init__(self, eps):
        self.h = 1 + eps
        self.alpha = mp.acosh(self.h)
        self.sinh = self.c = mp.sinh(self.alpha)
        self.coth = mp.coth(self.alpha)
        self.terms = int(35 / self.alpha) + 40
        top = self.terms + 6
        self.e = [mp.exp(-(n + mpf(1) / 2) * self.alpha) for n in range(top)]
        self.sh = [(1 / x - x) / 2 for x in self.e]
        self.k = [(n + mpf(1) / 2) * (1 + self.e[n]**2) / (1 - self.e[n]**2) - self.coth
                  for n in range(top)]

    def inhomogeneous(self, g, beta):
        """What the motion of the surface adds to C_n, E_n, G_n."""
        size = self.terms + 4
        c0, e0, g0 = ([mpf(0)] * size for _ in range(3))
        for n in range(size):
            below, here, above = beta(n - 1), beta(n), beta(n + 1)
            e0[n] = (2 * g(n) + ((n + 1) * (n + 2) * above / (2 * n + 3)
                                 - (n - 1) * n * below / (2 * n - 1)) / self.sinh) / self.sh[n]
            if n >= 1:
                c0[n] = -2 / (self.sinh * self.sh[n]) * (
                    self.h * here - (n - 1) * below / (2 * n - 1)
                    - (n + 2) * above / (2 * n + 3))
            if n >= 2:
                g0[n] = (below / (2 * n - 1) - above / (2 * n + 3)) / (self.sinh * self.sh[n])
        return c0, e0, g0

    def solve(self, c0, e0, g0):
        """O'Neill's tridiagonal system for A_n by Thomas's algorithm."""
        last, k = self.terms, self.k
        upper, right = [mpf(0)] * (last + 2), [mpf(0)] * (last + 2)
        for n in range(1, last + 1):
            p = (2 * n - 1) * k[n - 1] - (2 * n - 3) * k[n]
            q = (2 * n + 5) * k[n] - (2 * n + 3) * k[n + 1]
            low = p * (n - 1) / (2 * n - 1)
            diagonal = -p * n / (2 * n + 1) - q * (n + 1) / (2 * n + 1) - low * upper[n - 1]
            source = (5 * c0[n] - (n - 1) * c0[n - 1] + (n + 2) * c0[n + 1] + 2 * e0[n]
                      - e0[n - 1] - e0[n + 1] - 2 * (n - 1) * (n + 2) * g0[n]
                      + (n - 2) * (n - 1) * g0[n - 1] + (n + 2) * (n + 3) * g0[n + 1]) / 2
            upper[n] = q * (n + 2) / (2 * n + 3) / diagonal
            right[n] = (source - low * right[n - 1]) / diagonal
        a = [mpf(0)] * (last + 3)
        for n in range(last, 0, -1):
            a[n] = right[n] - upper[n] * a[n + 1]
        return a

    def force_and_torque(self, g, beta, vorticity):
        """-F_x / (6 pi mu a U) and T_y / (8 pi mu a^2 U)."""
        c0, e0, g0 = self.inhomogeneous(g, beta)
        a = self.solve(c0, e0, g0)
        force, torque = mpf(0), mpf(0)
        for n in range(self.terms + 1):
            below, here, above = (a[n - 1] if n else mpf(0)), a[n], a[n + 1]
            b = (n - 1) * below - (2 * n + 1) * here + (n + 2) * above if n else mpf(0)
            c = c0[n] - 2 * self.k[n] * ((n - 1) * below / (2 * n - 1) - here
                                         + (n + 2) * above / (2 * n + 3)) if n else mpf(0)
            d = (mpf((n + 1) * (n + 2)) * above - mpf((n - 1) * n) * below) / 2
            e = e0[n] + self.k[n] * ((n - 1) * n * below / (2 * n - 1)
                                     - (n + 1) * (n + 2) * above / (2 * n + 3))
            w, s = self.e[n]**2, 2 * n + 1 - self.coth
            force += e + n * (n + 1) * c
            torque += ((2 + w) * (n * (n + 1) * (2 * here + c * self.coth) - s * e)
                       + (2 - w) * (n * (n + 1) * b * self.coth - s * d))
        return (force * mp.sqrt(2) * self.sinh / 6,
                torque * self.sinh**2 / (12 * mp.sqrt(2)) - vorticity / 3)


def exact(eps):
    sphere = Bispherical(eps)
    root2, c, h, e = mp.sqrt(2), sphere.c, sphere.h, sphere.e
    none = lambda n: mpf(0)
    f_t, t_t = sphere.force_and_torque(lambda n: root2 * e[n], none, mpf(0))
    f_r, t_r = sphere.force_and_torque(
        lambda n: root2 * e[n] * (c * (2 * n + 1) - h),
        lambda n: 2 * root2 * c * e[n] if n >= 1 else mpf(0), mpf(1))
    f_s, t_s = sphere.force_and_torque(
        lambda n: c * root2 * (2 * n + 1) * e[n], none, mpf(1) / 2)
    assert abs(f_r / t_t + mpf(4) / 3) < mpf("1e-9"), "reciprocity"
    return {"eps": eps, "f_n": brenner(eps), "f_t": f_t, "t_t": t_t, "t_r": -t_r,
            "f_s": f_s / h, "t_s": -2 * t_s, "t_n": spin(eps), "f_e": stagnation(eps)}


def sample_gaps():
    near = [mpf(10)**(mpf(-6) + mpf(i) / 4) for i in range(17)]
    x = [(1 + math.cos(math.pi * (j + 0.5) / 56)) / 2 for j in range(56)]
    return near + [mpf(1 / v - 1) for v in x if 1 / v - 1 > 1e-2]


def fit(name, rows):
    m, pole, a_0, a_1 = FORMS[name]
    eps = np.array([float(r["eps"]) for r in rows])
    x, y = 1 / (1 + eps), eps / (1 + eps)
    log = -np.log(y)
    value = np.array([float(r[name]) for r in rows]) / x**m
    rest = value - pole / eps - (a_0 + a_1 * y) * log
    columns = np.array([y**2 * log] + [np.polynomial.chebyshev.chebval(2 * x - 1, unit)
                                       for unit in np.eye(DEGREE + 1)]).T
    weight = 1 / np.abs(value)
    found, *_ = np.linalg.lstsq(columns * weight[:, None], rest * weight, rcond=None)
    error = np.max(np.abs((columns @ found - rest) * weight))
    print(f"{name}: largest relative error at the fitted gaps {error:.1e}", file=sys.stderr)
    return found[0], np.polynomial.chebyshev.cheb2poly(found[1:])


def print_header(rows):
    fits = {name: fit(name, rows) for name in FORMS}
    print("// Written by physics/tables/wall_resistance.py from the exact series; not by hand.\n"
          "#pragma once\n\nnamespace colloid {\n")
    print("// " + ", ".join(FORMS) + ".\n"
          f"constexpr int kWallFunctions = {len(FORMS)};")
    print(f"constexpr int kWallDegree = {DEGREE};\n")
    for row, label in enumerate(("ln(1/y)", "y ln(1/y)", "y^2 ln(1/y)")):
        numbers = [(f[2], f[3], fits[name][0])[row] for name, f in FORMS.items()]
        print(f"/// Coefficients of {label}.")
        print(f"constexpr double kWallLog{row}[kWallFunctions] = {{"
              + ", ".join(f"{v:.17g}" for v in numbers) + "};\n")
    print("/// Polynomials in t = 2x - 1; rows: power of t, columns: function.\n"
          "constexpr double kWallPolynomial[kWallDegree + 1][kWallFunctions] = {")
    for power in range(DEGREE + 1):
        print("{" + ", ".join(f"{fits[name][1][power]:.17g}" for name in FORMS) + "},")
    print("};\n\n}  // namespace colloid")


def print_reference(rows):
    print("eps," + ",".join(FORMS))
    for r in rows:
        print(",".join(mp.nstr(r[name], 15) for name in ["eps", *FORMS]))


if __name__ == "__main__":
    with Pool(2) as pool:
        if sys.argv[1:] == ["header"]:
            print_header(pool.map(exact, sample_gaps(), chunksize=1))
        elif sys.argv[1:] == ["reference"]:
            # Between the fitted gaps, from 1.3e-6 to 6e2.
            gaps = [mpf(mp.nstr(mpf(10)**(mpf(-47) / 8 + mpf(i) / 3), 12)) for i in range(27)]
            print_reference(pool.map(exact, gaps, chunksize=1))
        else:
            sys.exit("usage: wall_resistance.py header|reference")
