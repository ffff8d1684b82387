"""What a far wall sends back to a force beside a near one, by the method of reflections.

    python3 far_wall.py                                               (20 seconds)

The walls A, z = 0, and B, x = 1, and near the origin, at A, the stresslet that a force along j = x
or y is there: u_i = 12 z x_j x_i/r^5 (Blake 1971).  B answers with minus that on itself, A with minus
what it then sees, B again; each by the half-space solution u_i = 3 X_n/(2 pi) int X_i X_k v_k/X^5.
Behind A, B's data are continued so that A sees no flow along itself (u_z even, the others odd), behind
B A's so that B sees none across.  Then, at A, A's answer makes du_j/dz of B's du_j/dz + du_z/dx_j.
Prints k of B's first answer (exact: 4.5 and 1.5) and the second over it, extrapolated 0.16 and 0.10;
of later ones the quadrature near the edge is no good.  Needs numpy.
"""
import numpy as np

REACH, FINE = 12.0, 0.15  # of the points on both walls, finest at their edge
TO_A, TO_B = np.array([0, 0, 1.0]), np.array([-1.0, 0, 0])  # normals into the liquid


def points(count):
    ends = FINE * np.sinh(np.linspace(0, np.arcsinh(REACH / FINE), count + 1))
    s, ds = 0.5 * (ends[1:] + ends[:-1]), np.diff(ends)
    y, dy = np.concatenate([-s[::-1], s]), np.concatenate([ds[::-1], ds])
    s, y = (v.ravel() for v in np.meshgrid(s, y, indexing="ij"))
    on_a, on_b = np.stack([1 - s, y, 0 * s], 1), np.stack([1 + 0 * s, y, s], 1)
    return on_a, on_b, np.outer(ds, dy).ravel()


def flow(places, wall, velocity, weight, normal):
    x = places[:, None, :] - wall[None]
    kernel = 3 / (2 * np.pi) * (x @ normal) / np.linalg.norm(x, axis=2)**5
    return np.einsum("pq,pqi->pi", kernel * np.einsum("pqk,qk->pq", x, velocity * weight[:, None]), x)


def sent_by_a(places, wall, velocity, weight):
    behind = wall * [-1, 1, 1] + [2, 0, 0]
    return sum(flow(places, w, velocity, weight, TO_A) for w in (wall, behind))


def sent_by_b(places, wall, velocity, weight):
    return (flow(places, wall, velocity, weight, TO_B)
            + flow(places, wall * [1, 1, -1], velocity * [-1, -1, 1], weight, TO_B))


def answers(j, count):
    on_a, on_b, weight = points(count)
    shift, e = 1e-3, np.eye(3)
    seen = np.stack([shift * e[2], -shift * e[2], shift * e[j], -shift * e[j]])
    of_b = -12 * (on_b[:, 2] * on_b[:, j] / np.linalg.norm(on_b, axis=1)**5)[:, None] * on_b
    found = []
    for _ in range(2):
        u = sent_by_b(seen, on_b, of_b, weight)
        found.append(-(u[0, j] - u[1, j] + u[2, 2] - u[3, 2]) / (2 * shift))
        of_a = -sent_by_b(on_a, on_b, of_b, weight) * e[2]
        of_b = -sent_by_a(on_b, on_a, of_a, weight) * [0, 1, 1]
    return found


for j in (0, 1):
    for count in (14, 20, 28):
        first, second = answers(j, count)
        print("xy"[j], count, f"{first:.4f} {second / first:.4f}", flush=True)
