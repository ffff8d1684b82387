"""Resistance functions of two spheres by the method of fundamental solutions.

Shares nothing with the recurrences of Jeffrey & Onishi: Stokeslets inside both spheres, the
strengths by least squares of the velocity on the surfaces.  The functions are read from
forces and torques by MODEL (R7).  The column `residual` is the largest error of the velocity
on other points of the surfaces.  Needs numpy and scipy.

    python3 fundamental_solutions.py > fundamental_solutions.csv      (two minutes)
"""
import numpy as np
from scipy.linalg import lstsq


def points(count, radius, centre):
    """Fibonacci's spiral on a sphere."""
    i = np.arange(count) + 0.5
    z, phi = 1 - 2 * i / count, np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z**2)
    return radius * np.stack([r * np.cos(phi), r * np.sin(phi), z], 1) + centre


def matrix(x, y):
    d = x[:, None, :] - y[None, :, :]
    r = np.linalg.norm(d, axis=-1)[..., None, None]
    g = (np.eye(3) / r + d[..., :, None] * d[..., None, :] / r**3) / (8 * np.pi)
    return g.transpose(0, 2, 1, 3).reshape(3 * len(x), 3 * len(y))


def solve(ratio, gap, counts):
    a = np.array([1.0, ratio])
    r = (gap + 2) * a.sum() / 2
    centre = np.array([[0, 0, 0], [0, 0, r]])
    # Foci of the bispherical coordinates: where the images pile up.
    height = (r**2 + a**2 - a[::-1]**2) / (2 * r)
    focus = height - np.sqrt(height**2 - a**2)
    inner = 0.5 * (a + focus)
    sources = [points(n, s, c) for n, s, c in zip(counts, inner, centre)]
    surface = [points(2 * n + 7, s, c) for n, s, c in zip(counts, a, centre)]
    check = [points(301, s, c) for s, c in zip(a, centre)]

    def motions(p):
        """Velocity of the surfaces when one of them moves or turns along x, y or z."""
        columns = []
        for moving in (0, 1):
            for axis in np.eye(3):
                for turning in (False, True):
                    v = [np.zeros_like(q) for q in p]
                    arm = p[moving] - centre[moving]
                    v[moving] = np.cross(axis, arm) if turning else axis + 0 * arm
                    columns.append(np.concatenate(v).ravel())
        return np.stack(columns, 1)

    y = np.concatenate(sources)
    found = lstsq(matrix(np.concatenate(surface), y), motions(surface), cond=1e-13,
                  lapack_driver="gelsy")[0]
    residual = np.max(np.abs(matrix(np.concatenate(check), y) @ found - motions(check)))
    strength = found.T.reshape(12, -1, 3)
    n0 = counts[0]
    parts = [strength[:, :n0], strength[:, n0:]]
    # Force and torque ON THE LIQUID, [sphere][motion][component]; motion = 6 sphere + 2 axis
    # + turning.
    force = [s.sum(1) for s in parts]
    torque = [np.cross((q - c)[None], s).sum(1) for s, q, c in zip(parts, sources, centre)]
    move = lambda sphere, axis: 6 * sphere + 2 * axis
    turn = lambda sphere, axis: 6 * sphere + 2 * axis + 1
    pi, out = np.pi, {}
    for i, j in ((0, 0), (0, 1), (1, 1)):
        label = f"{i + 1}{j + 1}"
        length = a[i] + a[j]
        out["xa" + label] = force[i][move(j, 2), 2] / (3 * pi * length)
        out["ya" + label] = force[i][move(j, 0), 0] / (3 * pi * length)
        out["xc" + label] = torque[i][turn(j, 2), 2] / (pi * length**3)
        out["yc" + label] = torque[i][turn(j, 0), 0] / (pi * length**3)
    for i in (0, 1):
        for j in (0, 1):
            # x cross d = -y: the torque on the liquid along y is -yb.
            out[f"yb{i + 1}{j + 1}"] = -torque[i][move(j, 0), 1] / (pi * (a[i] + a[j])**2)
            # d cross y = -x: the force of a rotation, by reciprocity the same function.
            check = -force[j][turn(i, 1), 0] / (pi * (a[i] + a[j])**2)
            residual = max(residual, abs(check - out[f"yb{i + 1}{j + 1}"]))
    return out, residual


NAMES = [f + k for f in ("xa", "ya", "xc", "yc") for k in ("11", "12", "22")] + [
    "yb11", "yb12", "yb21", "yb22"]
print("ratio,gap," + ",".join(NAMES) + ",residual")
for ratio, gap, counts in (
        (1, 4.0, (300, 300)), (1, 1.0, (400, 400)), (1, 0.3, (700, 700)),
        (0.3, 1.0, (400, 300)), (0.3, 0.3, (800, 400)), (7.26, 1.0, (300, 600)),
        (7.26, 0.4, (350, 900))):
    values, residual = solve(ratio, gap, counts)
    print(ratio, gap, *(f"{values[n]:.10g}" for n in NAMES), f"{residual:.2e}", sep=",",
          flush=True)
