"""Draws and injections that the tests of random.h and injection_sequence.h expect for ever.

Written from Salmon et al. (2011) and MODEL section I, sharing nothing with the C++ code:
whole-number arithmetic of any size, distances by trying all periodic images.

Usage: python3 injection_reference.py draws|injections
"""
import itertools
import math
import sys

MASK = 2**32 - 1


def philox(counter, key):
    """Philox4x32-10; `counter` and `key` are whole numbers of 128 and 64 bits."""
    x0, x1, x2, x3 = (counter >> (32 * i) & MASK for i in range(4))
    k0, k1 = key & MASK, key >> 32
    for _ in range(10):
        a, b = 0xD2511F53 * x0, 0xCD9E8D57 * x2
        x0, x1, x2, x3 = b >> 32 ^ x1 ^ k0, b & MASK, a >> 32 ^ x3 ^ k1, a & MASK
        k0, k1 = (k0 + 0x9E3779B9) & MASK, (k1 + 0xBB67AE85) & MASK
    return x0 | x1 << 32, x2 | x3 << 32


def bits(seed, purpose, stream, index):
    return philox(index | stream << 64 | purpose << 96, seed)


def uniform(word):
    return (2 * (word >> 12) + 1) / 2**53


def draws():
    for at in [(0, 1, 0, 0), (1, 1, 0, 0), (1, 2, 0, 0), (1, 3, 0, 0), (1, 1, 1, 0),
               (1, 1, 0, 1), (2**64 - 1, 2, 2**32 - 1, 2**64 - 1), (12345, 2, 7, 2**32)]:
        first, second = bits(*at)
        u, v = uniform(first), uniform(second)
        r = math.sqrt(-2 * math.log(u))
        print(f"{{{at[0]}U, {at[1]}, {at[2]}U, {at[3]}U, {first:#018x}, {second:#018x}, "
              f"{-math.log(u)!r}, {r * math.cos(2 * math.pi * v)!r}, "
              f"{r * math.sin(2 * math.pi * v)!r}}},")


# The plan of the test ReproducesTheReference: inlet x-, y periodic, z between walls.
RADIUS, GAP, PHI, SEED = 5e-6, 2e-8, 0.2, 987654321987654321
WIDTH = (60e-6, 50e-6)  # along y, z
LOW, HIGH = (0.0, RADIUS + GAP), (WIDTH[0], WIDTH[1] - RADIUS - GAP)
GRAIN, GRAIN_RADIUS = (9e-6, 1e-6, 25e-6), 12e-6


def least_distance(a, b):
    return min(math.dist(a, (b[0], b[1] + m * WIDTH[0], b[2])) for m in (-1, 0, 1))


def injections(count):
    found = []
    volume = 0.0
    for i in range(count):
        log = math.log(uniform(bits(SEED, 1, i, 0)[0]))
        volume += 4 / 3 * math.pi * RADIUS**3 / PHI * -log
        for draw in itertools.count():
            pair = bits(SEED, 1, i, 1 + draw)
            y, z = (lo + uniform(w) * (hi - lo) for w, lo, hi in zip(pair, LOW, HIGH))
            here = (RADIUS, y, z)
            earlier = [(RADIUS + (volume - v) / (WIDTH[0] * WIDTH[1]), ey, ez)
                       for v, (_, ey, ez), _ in found]
            if (least_distance(here, GRAIN) >= RADIUS + GRAIN_RADIUS + GAP and
                    all(least_distance(here, e) >= 2 * RADIUS + GAP for e in earlier)):
                break
        found.append((volume, here, draw))
    return found


if sys.argv[1:] == ["draws"]:
    draws()
elif sys.argv[1:] == ["injections"]:
    for volume, (_, y, z), redraws in injections(24):
        print(f"{{{volume!r}, {y!r}, {z!r}, {redraws}}},")
else:
    sys.exit(__doc__)
