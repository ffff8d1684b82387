"""Force on a sphere held in the flows u_x = x^2 and x^3 near a no-slip plane x = 0.

    python3 cubic_flow.py                                              (1 minute)

Forces beside the plane (Blake 1971) within the sphere, least squares on its surface.  Prints the
force over the Faxen velocity and 6 pi mu a for uniform motion (f_n), x^2 (f_e) and x^3, and the
polynomial of excess_coefficient in hindrance.cpp: a flow with the Faxen velocity u and strain E
along the normal, each combination of the two, exerts f_e u + k (E - E_u), E_u the strain of x^2
with that u; k = -15/16 x^2 (1 + 9/8 x + c2 x^2 + ...), x = a/H.  Needs numpy.
"""
import numpy as np

from two_planes import ONE, beside

HEIGHTS = (1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.75, 1.9, 2.2, 2.5, 3.0, 4.0, 6.0, 10.0)


def sphere(count):
    i = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * i / count), np.pi * (1 + 5**0.5) * i
    return np.stack([np.cos(polar), np.cos(turn) * np.sin(polar),
                     np.sin(turn) * np.sin(polar)], 1)


def power(k):
    """u_x = x^k and the flow across that conserves volume; Stokes flow for k = 0, 2, 3."""
    return lambda p: np.stack([p[:, 0]**k] + [-k / 2 * p[:, 0]**max(k - 1, 0) * p[:, j]
                                              for j in (1, 2)], 1)


def forces(height, count):
    depth = max(0.55, 1 - 1.2 * (height - 1))
    inside, surface = (r * sphere(n) + height * ONE[0] for r, n in ((depth, count), (1, 2 * count)))
    matrix = beside(surface, inside, ONE[0]).transpose(0, 2, 1, 3).reshape(6 * count, 3 * count)
    right = np.stack([power(k)(surface).ravel() for k in (0, 2, 3)], 1)
    strengths = np.linalg.lstsq(matrix, right, rcond=1e-12)[0]
    return 4 / 3 * strengths.reshape(count, 3, 3)[:, 0].sum(0)


def excess(height, count):
    f_n, quadratic, cubic = forces(height, count)
    u2, e2 = height**2 + 1 / 3, 2 * height
    u3, e3 = height**3 + height, 3 * height**2 + 0.6
    return f_n, quadratic / u2, cubic / u3, (cubic - quadratic * u3 / u2) / (e3 - e2 * u3 / u2)


def main():
    x = 1 / np.array(HEIGHTS)
    k = []
    for height in HEIGHTS:
        fine, coarse = excess(height, 350), excess(height, 220)
        k.append(fine[3])
        print(height, *(f"{v:.5f}" for v in fine), f"coarse {coarse[3]:.5f}")
    powers = np.arange(2, 7)
    right = np.array(k) / (-15 / 16 * x**2) - 1 - 9 / 8 * x
    c = np.linalg.lstsq(x[:, None]**powers, right, rcond=None)[0]
    print("c2...", *(f"{v:.4f}" for v in c))
    print("largest error", np.abs(x[:, None]**powers @ c - right).max())


if __name__ == "__main__":
    main()
