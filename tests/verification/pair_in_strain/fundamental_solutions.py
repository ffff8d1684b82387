"""Two equal free spheres in a pure strain by rings of Stokeslets: A and B of Batchelor & Green.

Forces and torques in the strain and by each motion are all found by the rings; the free
motion follows from them.  Shares nothing with the recurrences of Jeffrey & Onishi.  The column
`residual` is the largest error of the velocity on the surfaces, between the points where it was
fitted, over the distance of the centres.

    python3 fundamental_solutions.py > fundamental_solutions.csv
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stokeslet_rings import Rings, Sphere, oseen  # noqa: E402


def hindrance(gap, count):
    s = 2 + gap
    centre = np.array([-s / 2, s / 2])
    focus = s / 2 - np.sqrt(s**2 / 4 - 1)
    spheres = [Sphere(1.0, c, focus) for c in centre]

    def only(owner, motion):
        return lambda rho, z, on: tuple(np.where(on == owner, v, 0.0) for v in motion(rho, z))

    axial = Rings(spheres, 0, oseen, count)
    across = Rings(spheres, 1, oseen, count)
    residual = axial.solve(
        [only(i, lambda rho, z: (0 * rho, 0 * rho, 1 + 0 * rho)) for i in (0, 1)]
        + [lambda rho, z, on: (-rho / 2, 0 * rho, z)])
    residual = max(residual, across.solve(
        [only(i, lambda rho, z: (1 + 0 * rho, -1 + 0 * rho, 0 * rho)) for i in (0, 1)]
        + [only(i, lambda rho, z, c=centre[i]: (z - c, c - z, -rho)) for i in (0, 1)]
        + [lambda rho, z, on: (z, -z, rho)]))

    def free(rings, motions, parts):
        """Motions without force and torque in the last, the strain."""
        found = []
        for motion in range(motions + 1):
            both = [rings.force_and_torque(motion, i, centre[i]) for i in (0, 1)]
            found.append([both[i][kind][axis] for kind, axis in parts for i in (0, 1)])
        found = np.array(found).T
        return np.linalg.solve(found[:, :-1], found[:, -1])

    along = free(axial, 2, [(0, 2)])
    aside = free(across, 4, [(0, 0), (1, 1)])
    return [1 - (along[1] - along[0]) / s, 1 - (aside[1] - aside[0]) / s, residual / s]


print("gap,a,b,residual")
for gap, count in ((8.0, 20), (2.0, 28), (1.0, 36), (0.5, 48), (0.2, 72), (0.1, 90), (0.05, 120)):
    print(gap, *(f"{v:.12g}" for v in hindrance(gap, count)), sep=",", flush=True)
