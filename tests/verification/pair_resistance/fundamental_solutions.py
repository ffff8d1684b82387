"""Resistance functions of two spheres, MODEL (R7), by rings of Stokeslets.

Shares nothing with the recurrences of Jeffrey & Onishi.  The column `residual` is the largest
error of the velocity on the surfaces, between the points where it was fitted, or of
reciprocity, whichever is larger.

    python3 fundamental_solutions.py > fundamental_solutions.csv
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stokeslet_rings import Rings, Sphere, oseen  # noqa: E402


def resistance(ratio, gap, count):
    a = np.array([1.0, ratio])
    r = (gap + 2) * a.sum() / 2
    centre = np.array([0.0, r])
    distance = (r**2 + a**2 - a[::-1]**2) / (2 * r)  # to the plane xi = 0
    focus = distance - np.sqrt(distance**2 - a**2)
    spheres = [Sphere(*v) for v in zip(a, centre, focus)]

    def only(owner, motion):
        return lambda rho, z, on: tuple(np.where(on == owner, v, 0.0) for v in motion(rho, z))

    axial = Rings(spheres, 0, oseen, count)
    across = Rings(spheres, 1, oseen, count)
    residual = axial.solve(
        [only(i, m) for i in (0, 1) for m in (
            lambda rho, z: (0 * rho, 0 * rho, 1 + 0 * rho),
            lambda rho, z: (0 * rho, rho, 0 * rho))])
    residual = max(residual, across.solve(
        [only(i, m) for i in (0, 1) for m in (
            lambda rho, z: (1 + 0 * rho, -1 + 0 * rho, 0 * rho),
            lambda rho, z, c=centre[i]: (z - c, c - z, -rho))]))
    out = {}
    along = lambda i, j, k: axial.force_and_torque(2 * j + k, i, centre[i])
    aside = lambda i, j, k: across.force_and_torque(2 * j + k, i, centre[i])
    for i, j in ((0, 0), (0, 1), (1, 1)):
        length, label = a[i] + a[j], f"{i + 1}{j + 1}"
        out["xa" + label] = along(i, j, 0)[0][2] / (3 * np.pi * length)
        out["xc" + label] = along(i, j, 1)[1][2] / (np.pi * length**3)
        out["ya" + label] = aside(i, j, 0)[0][0] / (3 * np.pi * length)
        out["yc" + label] = aside(i, j, 1)[1][1] / (np.pi * length**3)
    for i in (0, 1):
        for j in (0, 1):
            # x cross d = -y: the torque on the liquid is -yb along y; d cross y = -x: so is
            # the force of the reciprocal rotation along x.
            area = np.pi * (a[i] + a[j])**2
            out[f"yb{i + 1}{j + 1}"] = -aside(i, j, 0)[1][1] / area
            other = -aside(j, i, 1)[0][0] / area
            residual = max(residual, abs(other - out[f"yb{i + 1}{j + 1}"]))
    return out, residual


NAMES = [f + k for f in ("xa", "ya", "xc", "yc") for k in ("11", "12", "22")] + [
    "yb11", "yb12", "yb21", "yb22"]
print("ratio,gap," + ",".join(NAMES) + ",residual")
for ratio, gap, count in (
        (1, 4.0, 24), (1, 1.0, 36), (1, 0.3, 60), (1, 0.1, 90), (0.3, 1.0, 40),
        (0.3, 0.3, 70), (7.26, 1.0, 40), (7.26, 0.4, 70)):
    values, residual = resistance(ratio, gap, count)
    print(ratio, gap, *(f"{values[n]:.12g}" for n in NAMES), f"{residual:.2e}", sep=",",
          flush=True)
