#!/usr/bin/python3
"""Sphere in a long duct of square or circular cross-section, by fundamental solutions.

    python3 reference.py > reference.csv            (5 minutes)

Stokeslets outside the walls and inside the sphere, their strengths by least squares of the
velocity on both (numpy only).  The duct is closed far away, so nothing flows through it but what
the sphere takes along: the net flux is held.  Lengths over the width W of the square or the
diameter of the circle, viscosity 1.  Three problems a case, sphere centre at (offset, 0, 0):

    it moves along the axis z at U        force  -K_F U, torque about y  -K_C U, pressure drop
    it turns about y at w                 force  -K_C w, torque          -K_T w, pressure drop
    it is held in the developed flow of largest velocity u_max

force over 6 pi mu a, torque over 8 pi mu a^3 (coupling: over 6 pi mu a^2), pressure drop over mu U/W (the
rise in the direction of the motion; of the held sphere, the drop besides the developed flow's).
`residual`: the largest error of the velocity between the points where it was fitted.  The circle's
rows are checked against the K1 and K2 of a sphere on the axis of a tube (Bungay & Brenner 1973 and
others; zero net flux) before anything is printed.
"""
import sys

import numpy as np

HALF = 1.25  # from the sphere to the closed ends
CASES = [("circle", 0.3, 0.0), ("circle", 0.5, 0.0),
         ("square", 0.1, 0.0), ("square", 0.2, 0.0), ("square", 0.4, 0.0), ("square", 0.6, 0.0),
         ("square", 0.2, 0.2), ("square", 0.3, 0.15), ("square", 0.4, 0.15)]
TUBE = {0.3: (2.3700, 2.2289), 0.5: (5.947, 4.995)}  # K1, K2


def developed(section, x, y):
    """Velocity of the developed flow over its largest."""
    if section == "circle":
        return 1 - 4 * (x**2 + y**2)

    def series(x, y):
        total = np.zeros_like(x)
        for n in range(1, 40, 2):
            # cosh(n pi y)/cosh(n pi/2) without overflow
            c = np.exp(n * np.pi * (np.abs(y) - 0.5)) * (1 + np.exp(-2 * n * np.pi * np.abs(y))) \
                / (1 + np.exp(-n * np.pi))
            total += (-1)**((n - 1) // 2) / n**3 * (1 - c) * np.cos(n * np.pi * x)
        return total
    return series(x, y) / series(np.zeros(1), np.zeros(1))


def walls(section, spacing, out):
    """Points on the walls, or `out` beyond them, for y > 0 and z > 0."""
    reach = 0.5 + out
    length = HALF + out
    rows = max(2, round(length / spacing))
    z = (np.arange(rows) + 0.5) * length / rows
    if section == "circle":
        n = max(3, round(np.pi * reach / spacing))
        angle = (np.arange(n) + 0.5) * np.pi / n
        rim = np.stack([reach * np.cos(angle), reach * np.sin(angle)], 1)
        rings = max(2, round(reach / spacing))
        face = [reach * (k + 0.5) / rings * np.stack(
            [np.cos(t), np.sin(t)], 1) for k in range(rings) for t in
            [(np.arange(max(2, round(np.pi * reach * (k + 0.5) / rings / spacing))) + 0.5)
             * np.pi / max(2, round(np.pi * reach * (k + 0.5) / rings / spacing))]]
        face = np.concatenate(face)
    else:
        n = max(4, 2 * round(reach / spacing))
        t = (np.arange(n) + 0.5) * 2 * reach / n - reach
        side = np.stack([np.full(n // 2, reach), t[n // 2:]], 1)
        rim = np.concatenate([side, side * [-1, 1], np.stack([t, np.full(n, reach)], 1)])
        face = np.stack(np.meshgrid(t, t[n // 2:], indexing="ij"), -1).reshape(-1, 2)
    side = np.concatenate([np.column_stack([rim, np.full(len(rim), h)]) for h in z])
    return np.concatenate([side, np.column_stack([face, np.full(len(face), length)])])


def ball(count, radius, centre):
    """About `count` points of a whole sphere, those with y > 0 and z > 0."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    p = radius * np.stack([np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar),
                           np.cos(polar)], 1)
    return p[(p[:, 1] > 0) & (p[:, 2] > 0)] + [centre, 0, 0]


# Flow that is even in y, and whose z component is even in z while the others are odd.
IMAGES = [(np.array([1, sy, sz]), np.array([sz, sy * sz, 1])) for sy in (1, -1) for sz in (1, -1)]


def velocity(points, sources):
    """Matrix from the strengths of the sources, with their images, to velocities."""
    out = np.zeros((len(points), 3, len(sources), 3))
    for place, strength in IMAGES:
        d = points[:, None, :] - (sources * place)[None, :, :]
        r = np.linalg.norm(d, axis=2)
        g = d[:, :, :, None] * d[:, :, None, :] / r[:, :, None, None]**3
        g += np.eye(3) / r[:, :, None, None]
        out += np.transpose(g * strength, (0, 2, 1, 3)) / (8 * np.pi)
    return out.reshape(3 * len(points), 3 * len(sources))


def pressure(point, sources, strengths):
    total = 0.0
    for place, sign in IMAGES:
        d = point - sources * place
        total += np.sum(d * (strengths * sign) / np.linalg.norm(d, axis=1)[:, None]**3) / (4 * np.pi)
    return total


def surface_velocity(kind, section, points, centre):
    u = np.zeros_like(points)
    arm = points - [centre, 0, 0]
    if kind == "moves":
        u[:, 2] = 1
    elif kind == "turns":
        u[:, 0], u[:, 2] = arm[:, 2], -arm[:, 0]
    else:
        u[:, 2] = -developed(section, points[:, 0], points[:, 1])
    return u


def solve(section, size, offset, spacing):
    a = size / 2
    gap = 0.5 - a - abs(offset)
    outside = walls(section, spacing, 2.2 * spacing)
    inside = ball(520, a * (1 - min(0.45, 0.6 * gap / a + 0.1)), offset)
    sources = np.concatenate([outside, inside])
    on_wall = walls(section, spacing / 1.6, 0.0)
    on_ball = ball(1400, a, offset)
    points = np.concatenate([on_wall, on_ball])
    # The sphere's surface counts as much as the walls.
    weight = np.repeat(np.concatenate([np.ones(len(on_wall)), np.full(len(on_ball), 2.0)]), 3)
    matrix = velocity(points, sources)
    kinds = ("moves", "turns", "held")
    # Turning velocities are of the order a.
    rhs = np.zeros((3 * len(points), 3))
    for k, kind in enumerate(kinds):
        rhs[3 * len(on_wall):, k] = surface_velocity(kind, section, on_ball, offset).ravel()
    scale = np.linalg.norm(matrix, axis=0)
    x = np.linalg.lstsq(weight[:, None] * matrix / scale, weight[:, None] * rhs, rcond=1e-13)[0]
    x /= scale[:, None]
    check_wall, check_ball = walls(section, spacing / 1.37, 0.0), ball(900, a, offset)
    test = velocity(np.concatenate([check_wall, check_ball]), sources)
    want = np.zeros((len(check_wall) + len(check_ball), 3, 3))
    for k, kind in enumerate(kinds):
        want[len(check_wall):, :, k] = surface_velocity(kind, section, check_ball, offset)
    error = np.abs((test @ x).reshape(want.shape) - want)
    residual = [error[:, :, 0].max(), error[:, :, 1].max() / a, error[:, :, 2].max()]
    out = []
    for k in range(3):
        f = x[:, k].reshape(-1, 3)
        own, arm = f[len(outside):], inside - [offset, 0, 0]
        force = 4 * own[:, 2].sum()
        torque = 4 * (arm[:, 2] * own[:, 0] - arm[:, 0] * own[:, 2]).sum()
        rise = 2 * pressure(np.array([0, 0, 0.8 * HALF]), sources, f)  # odd in z
        out.append((force, torque, rise))
    drag, turn = 6 * np.pi * a, 8 * np.pi * a**3
    moves, turns, held = out
    return {"k_f": moves[0] / drag, "k_c": moves[1] / (drag * a), "k_c2": turns[0] / (drag * a),
            "k_t": turns[1] / turn, "f_held": -held[0] / drag, "t_held": -held[1] / turn,
            "rise_moves": moves[2], "rise_turns": turns[2], "drop_held": -held[2],
            "residual": max(residual)}


def main():
    spacing = float(sys.argv[1]) if len(sys.argv) > 1 else 0.09
    rows = []
    for section, size, offset in CASES:
        r = solve(section, size, offset, spacing)
        rows.append((section, size, offset, r))
        print(section, size, offset, {k: f"{v:.6g}" for k, v in r.items()}, file=sys.stderr,
              flush=True)
        if section == "circle":
            k1, k2 = TUBE[size]
            assert abs(r["k_f"] / k1 - 1) < 1e-3 and abs(r["f_held"] / k2 - 1) < 1e-3, r
    keys = list(rows[0][3])
    print(",".join(["section", "size", "offset"] + keys))
    for section, size, offset, r in rows:
        print(",".join([section, f"{size:g}", f"{offset:g}"] + [f"{r[k]:.6g}" for k in keys]))


if __name__ == "__main__":
    main()
