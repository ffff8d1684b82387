"""Two held spheres in a uniform stream by rings of Stokeslets: what the stream does to the
first, over Faxen's laws in the flow past the second alone.

Shares nothing with the recurrences of Jeffrey & Onishi.  The column `residual` is the largest
error of the velocity on the surfaces, between the points where it was fitted.

    python3 fundamental_solutions.py > fundamental_solutions.csv
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stokeslet_rings import Rings, Sphere, oseen  # noqa: E402


def drive(ratio, gap, count):
    a = np.array([1.0, ratio])
    r = (gap + 2) * a.sum() / 2
    centre = np.array([0.0, r])
    distance = (r**2 + a**2 - a[::-1]**2) / (2 * r)  # to the plane xi = 0
    focus = distance - np.sqrt(distance**2 - a**2)
    spheres = [Sphere(*v) for v in zip(a, centre, focus)]
    axial = Rings(spheres, 0, oseen, count)
    across = Rings(spheres, 1, oseen, count)
    residual = max(axial.solve([lambda rho, z, on: (0 * rho, 0 * rho, 1 + 0 * rho)]),
                   across.solve([lambda rho, z, on: (1 + 0 * rho, -1 + 0 * rho, 0 * rho)]))
    n = axial.force_and_torque(0, 0, 0.0)[0][2] / (6 * np.pi)
    force, torque = across.force_and_torque(0, 0, 0.0)
    b = ratio
    # x cross d = -y
    return [n / (1 - 3 * b / (2 * r) + (b**3 + b) / (2 * r**3)),
            force[0] / (6 * np.pi) / (1 - 3 * b / (4 * r) - (b**3 + b) / (4 * r**3)),
            -torque[1] / (8 * np.pi) / (3 * b / (4 * r**2)), residual]


print("ratio,gap,n,t,r,residual")
for ratio, gap, count in (
        (1, 8.0, 20), (1, 1.0, 36), (1, 0.3, 60), (1, 0.1, 90), (0.3, 1.0, 40),
        (0.3, 0.3, 70), (7.26, 1.0, 40), (7.26, 0.3, 80)):
    print(ratio, gap, *(f"{v:.12g}" for v in drive(ratio, gap, count)), sep=",", flush=True)
