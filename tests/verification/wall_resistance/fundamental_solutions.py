"""Resistance of a sphere near a wall by rings of Stokeslets with Blake's images.

Shares nothing with the bispherical series.  The last column is the largest error of the
velocity on the surface, between the points where it was fitted.

    python3 fundamental_solutions.py > fundamental_solutions.csv
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stokeslet_rings import Rings, Sphere, blake  # noqa: E402


def resistance(eps, count):
    h = 1 + eps
    sphere = Sphere(1, h, h - np.sqrt(h**2 - 1))
    axial = Rings([sphere], 0, blake, count)
    residual = axial.solve([lambda r, z, on: (0 * r, 0 * r, 1 + 0 * r),
                            lambda r, z, on: (0 * r, r, 0 * r),
                            lambda r, z, on: (r * z / h**2, 0 * r, -z**2 / h**2)])
    across = Rings([sphere], 1, blake, count)
    residual = max(residual, across.solve([
        lambda r, z, on: (1 + 0 * r, -1 + 0 * r, 0 * r),
        lambda r, z, on: (z - h, h - z, -r),
        lambda r, z, on: (z, -z, 0 * r)]))
    lift = axial.force_and_torque(0, 0, h)[0][2] / (6 * np.pi)
    spin = axial.force_and_torque(1, 0, h)[1][2] / (8 * np.pi)
    stagnation = -axial.force_and_torque(2, 0, h)[0][2] * h**2 / (6 * np.pi * (h**2 + 1 / 3))
    parts = [across.force_and_torque(i, 0, h) for i in range(3)]
    force = [p[0][0] / (6 * np.pi) for p in parts]
    torque = [p[1][1] / (8 * np.pi) for p in parts]
    return [lift, force[0], -torque[0], torque[1], force[2] / h, 2 * torque[2], spin,
            stagnation, residual, -force[1]]


print("eps,f_n,f_t,t_t,t_r,f_s,t_s,t_n,f_e,residual,f_r")
for eps, count in ((9.0, 24), (2.0, 24), (0.6, 32), (0.2, 48), (0.05, 90)):
    print(eps, *(f"{v:.12g}" for v in resistance(eps, count)), sep=",", flush=True)
