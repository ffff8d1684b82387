"""Writes random_pack.csv: a random sequential packing in a column with side walls.

Grains do not overlap and stay inside the walls and one radius away from inlet and outlet.
Usage: python3 random_pack.py > random_pack.csv      (always the same packing)
"""
import math
import random

WIDTH, HEIGHT = 300e-6, 400e-6    # [m]
DIAMETERS = (50e-6, 70e-6)        # [m] uniform between
GRAINS = 90

rng = random.Random(1)
grains = []
while len(grains) < GRAINS:
    d = rng.uniform(*DIAMETERS)
    x, y = (rng.uniform(d / 2, WIDTH - d / 2) for _ in range(2))
    z = rng.uniform(d, HEIGHT - d)
    if all(math.dist((x, y, z), other[:3]) > (d + other[3]) / 2 for other in grains):
        grains.append((x, y, z, d))
print("x_m,y_m,z_m,diameter_m")
for grain in grains:
    print(",".join(f"{value:.6e}" for value in grain))
