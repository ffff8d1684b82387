"""Resistance of a sphere near a wall by the method of fundamental solutions.

Shares nothing with the bispherical series: Stokeslets inside the sphere, with Blake's (1971)
images in the wall, strengths by least squares of the velocity on the surface.  The strengths'
sum is the force, their moment the torque.  The residual printed last, the largest error of
the velocity on other points of the surface, bounds the error.  Needs numpy and scipy.

    python3 fundamental_solutions.py > fundamental_solutions.csv      (half a minute)
"""
import numpy as np
from scipy.linalg import lstsq


def points(count, radius, centre):
    """Fibonacci's spiral on a sphere."""
    i = np.arange(count) + 0.5
    z, phi = 1 - 2 * i / count, np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z**2)
    return radius * np.stack([r * np.cos(phi), r * np.sin(phi), z], 1) + centre


def oseen(d):
    r = np.linalg.norm(d, axis=-1)[..., None, None]
    return (np.eye(3) / r + d[..., :, None] * d[..., None, :] / r**3) / (8 * np.pi)


def blake(x, y):
    """Velocity at x by unit forces at y above the no-slip plane z = 0, mu = 1."""
    image = y * np.array([1, 1, -1])
    d = x[:, None, :] - y[None, :, :]
    big = x[:, None, :] - image[None, :, :]
    h = y[None, :, 2, None, None]
    r = np.linalg.norm(big, axis=-1)[..., None, None]
    delta = np.eye(3)
    outer = big[..., :, None] * big[..., None, :]
    rz = big[..., 2, None, None]
    e3 = np.zeros((3, 1))
    e3[2] = 1
    ri = big[..., :, None]
    rk = big[..., None, :]
    # d/dR_k of [ h R_i/R^3 - (delta_i3/R + R_i R_3/R^3) ]
    source = h * (delta / r**3 - 3 * outer / r**5)
    stokeslet = (-e3 * rk / r**3 + delta * rz / r**3 + ri * e3.T / r**3
                 - 3 * ri * rz * rk / r**5)
    mirror = np.array([1, 1, -1])
    return oseen(d) - oseen(big) + 2 * h * mirror * (source - stokeslet) / (8 * np.pi)


def solve(eps, count):
    centre = np.array([0, 0, 1 + eps])
    inside = 0.5 * (1 + centre[2] - np.sqrt(centre[2]**2 - 1))  # halfway to the images
    sources = points(count, inside, centre)
    surface = points(2 * count + 7, 1, centre)
    check = points(501, 1, centre)
    h = centre[2]

    def motions(p):
        z, zero, one = p[:, 2], 0 * p[:, 2], 1 + 0 * p[:, 2]
        return [np.stack(v, 1) for v in (
            (zero, zero, one), (one, zero, zero), (z - h, zero, -p[:, 0]),
            (z, zero, zero), (-p[:, 1], p[:, 0], zero))]

    flatten = lambda m: m.transpose(0, 2, 1, 3).reshape(3 * m.shape[0], -1)
    matrix = flatten(blake(surface, sources))
    wanted = np.stack([v.ravel() for v in motions(surface)], 1)
    found = lstsq(matrix, wanted, cond=1e-14, lapack_driver="gelsd")[0]
    other = flatten(blake(check, sources))
    residual = np.max(np.abs(other @ found - np.stack([v.ravel() for v in motions(check)], 1)))
    force = found.T.reshape(5, -1, 3)
    total = force.sum(1) / (6 * np.pi)
    arm = sources - centre
    moment = np.cross(arm[None], force).sum(1) / (8 * np.pi)
    return [total[0, 2], total[1, 0], -moment[1, 1], moment[2, 1], total[3, 0] / h,
            2 * moment[3, 1], moment[4, 2], residual, -total[2, 0]]


print("eps,f_n,f_t,t_t,t_r,f_s,t_s,t_n,residual,f_r")
for eps, count in ((9.0, 300), (2.0, 400), (0.6, 700), (0.2, 1100)):
    print(eps, *(f"{v:.10g}" for v in solve(eps, count)), sep=",")
