"""Flow that two planes send back to a point force, beyond what each alone would send.

    python3 two_planes.py > ../two_planes_table.h                      (3 minutes)

Planes A, x = 0, and B, normal at the angle psi to x, liquid between them; a unit force at the
height t <= 1 above A and 1 above B; velocities over 1/(8 pi mu).  The flow of the force beside A
alone is Blake's (1971).  What lies on A's liquid side behind B takes away the rest on B: forces
beside A, behind B, least squares on B (method of fundamental solutions).  At t = 0 and psi = 0
only A is felt: there the table is minus what B alone sends.  Printed to stderr: what is left on
B over what was there, root mean square.  Blake's flow is checked first.  Needs numpy.
"""
import sys

import numpy as np

ANGLES = np.arange(0.0, 181.0, 15.0)
RATIOS = [0.0, 0.07, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0]
REACH = 14.0  # of the points on B, graded
FINE = 0.6    # their distances grow beyond this one
DEPTH = 1.3   # of the forces behind B, over their distance from each other
ONE = np.eye(3)


def image(x, y, n):
    """Blake's image beside the plane through the origin: at x, of forces at y."""
    c = (y @ n)[None, :, None, None]
    big = x[:, None, :] - y[None, :, :] + 2 * c[..., 0] * n
    s = np.linalg.norm(big, axis=-1)[..., None, None]
    up = (big @ n)[..., None, None]
    dyad = big[..., :, None] * big[..., None, :]
    doublets = (c * (ONE - 3 / s**2 * dyad) + n[:, None] * big[..., None, :] - up * ONE
                - big[..., :, None] * n + 3 * up / s**2 * dyad)
    return -ONE / s - dyad / s**3 + 2 * c / s**3 * (doublets @ (ONE - 2 * np.outer(n, n)))


def beside(x, y, n):
    d = x[:, None, :] - y[None, :, :]
    r = np.linalg.norm(d, axis=-1)[..., None, None]
    return ONE / r + d[..., :, None] * d[..., None, :] / r**3 + image(x, y, n)


def check_beside():
    """No slip on the plane, reciprocity, a force alone far from the plane."""
    n = np.array([0.6, 0.0, 0.8])
    y, x = np.array([0.4, -0.3, 1.9]), np.array([1.1, 0.7, 0.5])
    def flow(at, force):
        return beside(at[None], force[None], n)[0, 0]
    r = np.linalg.norm(x - y)
    alone = ONE / r + np.outer(x - y, x - y) / r**3
    assert np.abs(flow(x - (x @ n) * n, y)).max() < 1e-14
    assert np.abs(flow(x, y) - flow(y, x).T).max() < 1e-14
    assert np.abs(flow(x + 1e8 * n, y + 1e8 * n) - alone).max() < 1e-7


def graded(first, last, count):
    """Finest around 0; and the distances from each other."""
    u = np.linspace(np.arcsinh(first / FINE), np.arcsinh(last / FINE), 2 * count + 1)
    return FINE * np.sinh(u[1::2]), FINE * np.cosh(u[1::2]) * (u[2] - u[0])


def grid(along, across, foot, whole):
    """Points on B, finest below the force: distances from the edge, along it, from each other."""
    s, ds = graded(-REACH if whole else -foot, REACH, along)
    z, dz = graded(-REACH, REACH, across)
    pairs = [np.meshgrid(a, b, indexing="ij") for a, b in ((s, z), (ds, dz))]
    return pairs[0][0].ravel() + foot, pairs[0][1].ravel(), np.maximum(*pairs[1]).ravel()


def components(flow, place, length):
    """Flow, its strain and Laplacian at the place, by differences."""
    def slope(k, step):
        e = step * ONE[k]
        return (flow(place + e) - flow(place - e)) / (2 * step)
    here = flow(place)
    gradient = [slope(k, 1e-4) for k in range(3)]
    strain = np.array([[0.5 * (gradient[j][i] + gradient[i][j]) for j in range(3)]
                       for i in range(3)])
    step = 0.02 * length
    laplacian = sum(flow(place + step * e) + flow(place - step * e) for e in ONE) - 6 * here
    laplacian /= step**2
    def four(m):
        return [m[0, 0], m[1, 1], m[2, 2], 0.5 * (m[0, 1] + m[1, 0])]
    return np.array(four(here) + four(laplacian)
                    + [strain[0, 0, 0], strain[1, 1, 0], strain[0, 1, 0],
                       strain[0, 0, 1], strain[1, 1, 1], strain[0, 1, 1],
                       strain[0, 2, 2], strain[1, 2, 2]])


def entry(psi, t, along, across):
    c, s = np.cos(psi), np.sin(psi)
    whole = psi > np.pi - 1e-9
    a, b = ONE[0], np.array([c, s, 0.0])
    x = np.array([t, 0.0 if whole or s < 1e-9 else (1 - t * c) / s, 0.0])
    foot = x - b
    of_b = lambda p: image((p - foot)[None], (x - foot)[None], b)[0, 0]
    if t == 0.0 or psi == 0.0:
        return -components(of_b, x, 1.0)
    edge = np.array([s, -c, 0.0])
    base = np.array([1 + t, 0.0, 0.0]) if whole else np.zeros(3)
    def points(along_edge, z):
        p = base + along_edge[:, None] * edge
        p[:, 2] = z
        return p
    distance, z, spacing = grid(along, across, 0.0 if whole else x @ edge, whole)
    depth = DEPTH * spacing
    if c > 1e-9:
        depth = np.minimum(depth, 0.7 * distance * s / c)  # on A's liquid side
    forces = points(distance, z) - depth[:, None] * b
    distance, z, weight = grid(int(1.6 * along), int(1.6 * across) + 1, 0.0 if whole else x @ edge, whole)
    places = points(distance, z)
    matrix = (beside(places, forces, a) * weight[:, None, None, None]).transpose(0, 2, 1, 3)
    matrix = matrix.reshape(3 * len(places), 3 * len(forces))
    right = -(beside(places, x[None], a)[:, 0] * weight[:, None, None]).reshape(-1, 3)
    scale = np.linalg.norm(matrix, axis=0)
    strengths = np.linalg.lstsq(matrix / scale, right, rcond=1e-11)[0] / scale[:, None]
    left = np.linalg.norm(matrix @ strengths - right) / np.linalg.norm(right)
    print(f"{np.degrees(psi):.0f} {t}: {left:.1e}", file=sys.stderr)
    strengths = strengths.reshape(-1, 3, 3)
    return components(
        lambda p: np.einsum("mij,mjk->ik", beside(p[None], forces, a)[0], strengths) - of_b(p),
        x, t)


def exchanged(row, psi):
    """A and B exchanged at equal heights, seen in the frame of A."""
    c, s = np.cos(psi), np.sin(psi)
    f = np.array([[c, s, 0], [s, -c, 0], [0, 0, -1.0]])  # columns: B's frame; symmetric
    def matrix(v):
        return np.array([[v[0], v[3], 0], [v[3], v[1], 0], [0, 0, v[2]]])
    def four(m):
        return [m[0, 0], m[1, 1], m[2, 2], m[0, 1]]
    e = np.zeros((3, 3, 3))  # e[i]: strain by a force along i
    for i in range(2):
        xx, yy, xy = row[8 + 3 * i:11 + 3 * i]
        e[i] = [[xx, xy, 0], [xy, yy, 0], [0, 0, -xx - yy]]
    e[2] = [[0, 0, row[14]], [0, 0, row[15]], [row[14], row[15], 0]]
    g = np.einsum("ia,jb,kc,abc->ijk", f, f, f, e)
    return np.array(four(f @ matrix(row[:4]) @ f.T) + four(f @ matrix(row[4:8]) @ f.T)
                    + [g[0][0, 0], g[0][1, 1], g[0][0, 1], g[1][0, 0], g[1][1, 1], g[1][0, 1],
                       g[2][0, 2], g[2][1, 2]])


def table(along, across, angles=ANGLES, ratios=RATIOS):
    rows = []
    for angle in angles:
        psi = np.radians(angle)
        for t in ratios:
            row = entry(psi, t, along, across)
            if t == 1.0:
                other = exchanged(row, psi)
                print(f"  exchanged: {np.abs(other - row).max():.1e}", file=sys.stderr)
                row = 0.5 * (row + other)
            rows.append((angle, t, row))
    return rows


def main():
    check_beside()
    rows = table(14, 19)
    print("// Written by particles/tables/two_planes.py; not by hand.\n#pragma once\n\n"
          "namespace colloid {\n\n// clang-format off")
    print(f"constexpr int kPlaneAngles = {len(ANGLES)};  // 0 to 180 degrees, even\n"
          f"constexpr int kPlaneRatios = {len(RATIOS)};\n"
          f"constexpr double kPlaneRatio[kPlaneRatios] = {{{', '.join(map(str, RATIOS))}}};\n"
          "constexpr double kTwoPlanes[kPlaneAngles][kPlaneRatios][16] = {")
    for angle, t, row in rows:
        lines = [", ".join(f"{v:.5f}" for v in row[k:k + 8]) for k in (0, 8)]
        print((" {{" if t == 0 else "  {") + ",\n   ".join(lines) + ("}}," if t == 1 else "},"))
    print("};\n// clang-format on\n\n}  // namespace colloid")


if __name__ == "__main__":
    main()
